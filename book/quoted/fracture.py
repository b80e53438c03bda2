"""Strength and fracture energy: bars, loading paths, discs, a crack that runs."""

from collections.abc import Iterator
from statistics import fmean
from typing import Any

from book.chapters.concrete import CONCRETE
from book.chapters.rapid_fracture import BRANCHING, LOSSES
from book.forms import Form
from book.quoting import Quoted
from book.results import Measurement, record

PATHS = record("loading_paths", takes="3 h")
#: The same with the rule of cracks that equilibria have, whose cases are kept.
BEFORE = Measurement(
    "loading_paths_before", "python -m validation loading_paths --out benchmarks/results/loading_paths_before.json"
)
MEASUREMENTS = (PATHS, BEFORE)

RATIO, FINE, MPA = Form(style=".2f"), Form(style=".3f"), Form("MPa", 1e6, ".1f")
#: Work of a bar over that of one crack, beyond which it has more than one crack [-].
_ONE_CRACK = 1.05
#: Cells of the bodies in compact tension whose work is quoted, and the measured strength of the concrete [Pa].
_COMPACT, _CONCRETE = 400, 4e6


def quoted() -> Iterator[Quoted]:
    """All quoted numbers of fracture."""
    yield from (*_bars(), *_bodies(), *_paths(), *_discs(), *_running())


def _rows(name: str, of: Measurement = PATHS, task: str = "") -> list[dict[str, Any]]:
    cases = [case for case in of.at("cases") if task in ("", case["task"])]
    return [row for case in cases for row in case["rows"] if row["name"] == name]


def _size(rows: list[dict[str, Any]], what: str = "bars") -> str:
    counts = sorted({row["count"] for row in rows})
    cells = str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
    return f"{cells} cells, {len({row['seed'] for row in rows})} packings, {len(rows)} {what}"


def _ratios(rows: list[dict[str, Any]]) -> tuple[float, ...]:
    """What was found for all packings, over what was expected."""
    return tuple(row["measured"] / row["expected"] for row in rows)


def _bars() -> Iterator[Quoted]:
    bars = _rows("plain bar: G_f", task="plain")
    work = [row["measured"] for row in bars]
    strength = [row["measured"] for row in _rows("plain bar: f_t", task="plain")]
    peaks = f"strength of plain bars over f_t ({len(strength)} bars)"
    energies = f"work of plain bars over G_f and the section ({len(work)} bars)"
    twice = sum(one > _ONE_CRACK for one in work)
    for name, says, value, form in (
        ("count", "plain bars in tension", len(work), Form()),
        ("least_strength", f"{peaks}: least of all", min(strength), FINE),
        ("work", f"{energies}: mean", fmean(work), RATIO),
        ("largest_work", f"{energies}: largest of all", max(work), RATIO),
        ("twice", f"plain bars whose work exceeds {_ONE_CRACK:g} G_f", twice, Form()),
    ):
        yield Quoted(f"bars.{name}", says, _size(bars), PATHS, (value,), form)


def _bodies() -> Iterator[Quoted]:
    """Bodies beside a pressure, and in compact tension."""
    names = (f"equilibria, pressure {share} f_t along the crack: G_f" for share in (0, 1, 3, 6, 10))
    rows = [row for name in names for row in _rows(name)]
    says = "dissipation of cubes in equilibria beside a pressure of 0 to 10 f_t, over G_f and the section"
    yield Quoted("pressed.equilibria", says, _size(rows), PATHS, _ratios(rows), RATIO)
    for name, of, words, pick in (
        ("work", PATHS, "mean", fmean), ("largest_work", PATHS, "largest of all", max),
        ("former", BEFORE, "mean, with the rule of equilibria", fmean),
    ):  # fmt: skip
        rows = [row for row in _rows("compact tension: G_f", of) if row["count"] == _COMPACT]
        says = f"work of compact-tension bodies over G_f and the ligament: {words}"
        work = pick([row["measured"] for row in rows])
        yield Quoted(f"compact.{name}", says, _size(rows, "bodies"), of, (work,), RATIO)


def _paths() -> Iterator[Quoted]:
    """Numbers of the loading paths that are those of one case: all packings of it."""
    shear, flat = "cubes after {} f_t/E along x: largest σ1 in shear, over f_t", "flat, opened by 0.3, slid by 1.5: "
    slid = "flat blocks, opened by 0.3 and slid by 1.5 last openings: "
    cube = "Rankine, 80 mm, after {} f_t/E along x: largest σ1 in shear"
    bar = "work of a {} bar in an explicit run over that of load factors"
    disc = "Brazilian, G_f = {} J/m²: strength over f_t"
    strength = "Brazilian strength of a concrete disc over f_t, G_f = {} J/m²"
    for name, says, case, what, form in (
        ("first.shear_soon", shear.format("1.02"), cube.format("1.02"), "cubes", RATIO),
        ("first.shear", shear.format("2"), cube.format("2"), "cubes", RATIO),
        ("flat.work", f"{slid}dissipated over G_f", f"{flat}dissipated over G_f", "blocks", RATIO),
        ("flat.shear", f"{slid}shear over f_t", f"{flat}shear over f_t", "blocks", RATIO),
        ("solvers.plain", bar.format("plain"), "plain bar: work", "bars", RATIO),
        ("solvers.notched", bar.format("notched"), "notched bar: work", "bars", FINE),
        ("discs.energy5", strength.format(5), disc.format(5), "discs", RATIO),
        ("discs.energy80", strength.format(80), disc.format(80), "discs", RATIO),
    ):
        rows = _rows(case)
        yield Quoted(name, says, _size(rows, what), PATHS, tuple(row["measured"] for row in rows), form)


def _discs() -> Iterator[Quoted]:
    case = "E G_f / f_t² = {} D: strength over f_t"
    near, tough = [_rows(case.format(length)) for length in ("0.25", "1")], _rows(case.format("4"))
    yield Quoted("discs.elements", "strength of discs of E G_f/f_t² = D/4 and D over that of finite elements",
        _size(near[0], "discs of each"), PATHS, _ratios(near[0] + near[1]), RATIO)  # fmt: skip
    yield Quoted("discs.tough", "strength of discs of E G_f/f_t² = 4 D over f_t", _size(tough, "discs"), PATHS,
        tuple(row["measured"] for row in tough), RATIO)  # fmt: skip
    discs = [one for one in CONCRETE.at("cases") if (one["kind"], one["count"]) == ("brazilian", 2000)]
    yield Quoted("discs.concrete",
        f"Brazilian strength of concrete with a measured strength of {_CONCRETE / 1e6:g} MPa, mean",
        f"2000 cells, {len(discs)} packings", CONCRETE, (fmean(one["peak"] for one in discs),), MPA)  # fmt: skip


def _running() -> Iterator[Quoted]:
    plates = [one for one in BRANCHING.at("runs") if one["case"] == "A"]
    counts = sorted(one["count"] for one in plates)
    size = f"{counts[0]} to {counts[-1]} cells, {len(plates)} plates"
    branched = sum(one["branched"] is not None for one in plates)
    yield Quoted("branching.plates", "plates A whose crack may branch", size, BRANCHING, (len(plates),))
    yield Quoted("branching.branched", "plates A whose crack branches", size, BRANCHING, (branched,))
    yield Quoted("branching.fastest", "fastest 10 µs of a crack in plates A over the celerity of Rayleigh", size,
        BRANCHING, tuple(one["over"] for one in plates), RATIO)  # fmt: skip
    balls = LOSSES.at("impacts")
    counts = sorted({one["count"] for one in balls})
    yield Quoted("impacts.ledger",
        "error of the energy balance of softening balls that hit a wall, over its largest entry",
        f"{counts[0]} and {counts[-1]} cells, {len(balls)} impacts", LOSSES, tuple(one["ledger"] for one in balls),
        Form("%", 1e-2, ".2f"))  # fmt: skip
    strips = _rows("curvature")
    yield Quoted("bimetal.curvature", "curvature of a heated bimetal strip over Timoshenko's",
        _size(strips, "strips"), PATHS, _ratios(strips), FINE)  # fmt: skip
