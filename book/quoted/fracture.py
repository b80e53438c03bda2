"""Strength and fracture energy: bars, loading paths, discs, a crack that runs."""

from collections.abc import Sequence
from statistics import fmean

from book.chapters.concrete import CONCRETE
from book.chapters.rapid_fracture import BRANCHING
from book.forms import Form
from book.quoting import Quoted
from book.results import Measurement, record

PATHS = record("loading_paths", takes="3 h")
#: The same with the rule of cracks that equilibria have, whose cases are kept.
BEFORE = Measurement(
    "loading_paths_before", "python -m validation loading_paths --out benchmarks/results/loading_paths_before.json"
)
MEASUREMENTS = (PATHS, BEFORE)

RATIO, FINE, COARSE, MPA = Form(style=".2f"), Form(style=".3f"), Form("%", 1e-2, ".0f"), Form("MPa", 1e6, ".1f")
_CONCRETE = 4e6


def quoted() -> Sequence[Quoted]:
    """All quoted numbers of fracture."""
    return [
        *_bars(), *_pressed(), *_compact(), *_sheared(), *_slid(), *_solvers(), *_discs(), *_running(), _bimetal(),
    ]  # fmt: skip


def _rows(name: str, *, task: str = "") -> list[dict]:
    cases = [case for case in PATHS.at("cases") if task in ("", case["task"])]
    return [row for case in cases for row in case["rows"] if row["name"] == name]


def _measured(*names: str, task: str = "") -> tuple[float, ...]:
    """What was found for all packings, as a ratio."""
    return tuple(row["measured"] for name in names for row in _rows(name, task=task))


def _size(name: str, *, task: str = "", what: str = "bars") -> str:
    rows = _rows(name, task=task)
    counts = sorted({row["count"] for row in rows})
    seeds = len({row["seed"] for row in rows})
    cells = str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
    return f"{cells} cells, {seeds} packings, {len(rows)} {what}"


def _bars() -> list[Quoted]:
    strength, work = _measured("plain bar: f_t", task="plain"), _measured("plain bar: G_f", task="plain")
    peaks = f"strength of plain bars over f_t ({len(strength)} bars)"
    energies = f"work of plain bars over G_f and the section ({len(work)} bars)"
    size = _size("plain bar: G_f", task="plain")
    twice = tuple(one for one in work if one > _ONE_CRACK)
    return [
        Quoted(name="bars.count", says="plain bars in tension", size=size, record=PATHS, values=(len(work),)),
        Quoted(name="bars.least_strength", says=f"{peaks}: least of all", size=size, record=PATHS, form=FINE,
               values=(min(strength),)),
        Quoted(name="bars.work", says=f"{energies}: mean", size=size, record=PATHS, form=RATIO,
               values=(sum(work) / len(work),)),
        Quoted(name="bars.largest_work", says=f"{energies}: largest of all", size=size, record=PATHS, form=RATIO,
               values=(max(work),)),
        Quoted(name="bars.twice", says=f"plain bars whose work exceeds {_ONE_CRACK:g} G_f", size=size, record=PATHS,
               values=(len(twice),)),
    ]  # fmt: skip


#: Work of a bar over that of one crack, beyond which it has more than one crack [-].
_ONE_CRACK = 1.05


def _pressed() -> list[Quoted]:
    found = []
    for pressure in (3, 6):
        case = f"pressure {pressure} f_t held by platens: G_f"
        rows = [row for one in BEFORE.at("cases") for row in one["rows"] if row["name"] == case]
        found.append(Quoted(
            name=f"pressed.before{pressure}", says=f"dissipation of a crack beside a pressure of {pressure} f_t, "
            "over G_f and the section, with the rule of equilibria in explicit runs", record=BEFORE, form=RATIO,
            size=f"{rows[0]['count']} cells, {len(rows)} packings",
            values=tuple(row["measured"] / row["expected"] for row in rows),
        ))  # fmt: skip
    return found


def _compact() -> list[Quoted]:
    case = "compact tension: G_f"
    found = []
    for name, of, words, pick in (
        ("work", PATHS, "mean", fmean), ("largest_work", PATHS, "largest of all", max),
        ("former", BEFORE, "mean, with the rule of equilibria", fmean),
    ):  # fmt: skip
        rows = [row for one in of.at("cases") for row in one["rows"] if row["name"] == case]
        rows = [row for row in rows if row["count"] == _COMPACT]
        packings = len({row["seed"] for row in rows})
        found.append(Quoted(
            name=f"compact.{name}", says=f"work of compact-tension bodies over G_f and the ligament: {words}",
            size=f"{_COMPACT} cells, {packings} packings, {len(rows)} bodies", record=of, form=RATIO,
            values=(pick([row["measured"] for row in rows]),),
        ))  # fmt: skip
    return found


#: Cells of the bodies in compact tension whose work is quoted.
_COMPACT = 400


def _sheared() -> list[Quoted]:
    found = []
    for name, reach in (("first.shear_soon", "1.02"), ("first.shear", "2")):
        case = f"Rankine, 80 mm, after {reach} f_t/E along x: largest σ1 in shear"
        found.append(Quoted(
            name=name, says=f"cubes after {reach} f_t/E along x: largest σ1 in shear, over f_t", record=PATHS,
            form=RATIO, size=_size(case, what="cubes"), values=_measured(case),
        ))  # fmt: skip
    return found


def _slid() -> list[Quoted]:
    found = []
    for name, words in (("work", "dissipated over G_f"), ("shear", "shear over f_t")):
        case = f"flat, opened by 0.3, slid by 1.5: {words}"
        found.append(Quoted(
            name=f"flat.{name}", says=f"flat blocks, opened by 0.3 and slid by 1.5 last openings: {words}",
            record=PATHS, form=RATIO, size=_size(case, what="blocks"), values=_measured(case),
        ))  # fmt: skip
    return found


def _solvers() -> list[Quoted]:
    return [
        Quoted(name=f"solvers.{kind}", says=f"work of a {kind} bar in an explicit run over that of load factors",
               size=_size(f"{kind} bar: work"), record=PATHS, form=form, values=_measured(f"{kind} bar: work"))
        for kind, form in (("plain", RATIO), ("notched", FINE))
    ]  # fmt: skip


def _discs() -> list[Quoted]:
    found = []
    for energy in (5, 80):
        case = f"Brazilian, G_f = {energy} J/m²: strength over f_t"
        found.append(Quoted(
            name=f"discs.energy{energy}", says=f"Brazilian strength of a concrete disc over f_t, G_f = {energy} J/m²",
            size=_size(case, what="discs"), record=PATHS, form=RATIO, values=_measured(case),
        ))  # fmt: skip
    near = ("E G_f / f_t² = 0.25 D: strength over f_t", "E G_f / f_t² = 1 D: strength over f_t")
    tough = "E G_f / f_t² = 4 D: strength over f_t"
    found += [
        Quoted(name="discs.elements", says="strength of discs of E G_f/f_t² = D/4 and D over that of finite elements",
               size=_size(near[0], what="discs of each"), record=PATHS, form=RATIO,
               values=tuple(row["measured"] / row["expected"] for name in near for row in _rows(name))),
        Quoted(name="discs.tough", says="strength of discs of E G_f/f_t² = 4 D over f_t",
               size=_size(tough, what="discs"), record=PATHS, form=RATIO, values=_measured(tough)),
    ]  # fmt: skip
    discs = [one for one in CONCRETE.at("cases") if (one["kind"], one["count"]) == ("brazilian", 2000)]
    found.append(Quoted(
        name="discs.concrete", says=f"Brazilian strength of concrete with a measured strength of {_CONCRETE / 1e6:g} "
        "MPa, mean", size=f"2000 cells, {len(discs)} packings", record=CONCRETE, form=MPA,
        values=(sum(one["peak"] for one in discs) / len(discs),),
    ))  # fmt: skip
    return found


def _running() -> list[Quoted]:
    plates = [one for one in BRANCHING.at("runs") if one["case"] == "A"]
    counts = sorted(one["count"] for one in plates)
    size = f"{counts[0]} to {counts[-1]} cells, {len(plates)} plates"
    return [
        Quoted(name="branching.plates", says="plates A whose crack may branch", size=size, record=BRANCHING,
               values=(len(plates),)),
        Quoted(name="branching.branched", says="plates A whose crack branches", size=size, record=BRANCHING,
               values=(sum(one["branched"] is not None for one in plates),)),
        Quoted(name="branching.fastest", says="fastest 10 µs of a crack in plates A over the celerity of Rayleigh",
               size=size, record=BRANCHING, form=RATIO, values=tuple(one["over"] for one in plates)),
    ]  # fmt: skip


def _bimetal() -> Quoted:
    return Quoted(
        name="bimetal.curvature", says="curvature of a heated bimetal strip over Timoshenko's", form=FINE,
        size=_size("curvature", what="strips"), record=PATHS,
        values=tuple(row["measured"] / row["expected"] for row in _rows("curvature")),
    )
