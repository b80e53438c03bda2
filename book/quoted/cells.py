"""Cells: uniform stresses, waves, thin bodies, and what a step of cracked bodies costs."""

from collections.abc import Iterator

from book.chapters.cells import DAMPING, FIELDS, UNIFORM, WAVES
from book.chapters.cost import TOUCHING_CELLS
from book.chapters.second_order import FOUND as SECOND_ORDER
from book.forms import Form
from book.quoting import Quoted, ceiling
from book.results import Measurement, grouped

SHARES = Measurement("shares", "python benchmarks/shares.py", "2 min")
AGAINST = Measurement(
    "cells_against",
    'python benchmarks/against.py speed --revision 3f7e4bbd --kinds cells "cells, may break" --elements 10000 100000'
    " --repeat 5 --output benchmarks/results/cells_against.json",
    "30 min",
)
TURNING = Measurement(
    "turning_energy", "python -m validation turning_energy --name now --kinds brittle,softening,elastic", "1 h"
)
SLIDING = Measurement("sliding", "python -m validation sliding", "5 min")
MEASUREMENTS = (SHARES, AGAINST, TURNING, SLIDING)

RATIO, FINE, ONE = Form(style=".1f"), Form(style=".2f"), Form("%", 1e-2, ".1f")
THIRD = Form(style=".3f")
#: Cells of the larger of two bodies.
_LARGE = 100_000
#: How far a thickness in cells may be from the one that is asked for.
_THICKNESS = 0.1


def quoted() -> Iterator[Quoted]:
    """All quoted numbers of cells."""
    yield from (*_uniform(), *_waves(), *_thin(), *_costs(), *_turning(), *_fields(), *_damping(), *_sliding())


def _uniform() -> Iterator[Quoted]:
    zeros = UNIFORM.at("zeros")
    nu = [one["nu"] for one in zeros]
    seeds = zeros[0]["seeds"]
    size = f"{UNIFORM.at('count')} cells, {len({one['body'] for one in zeros})} bodies, {seeds} packings each"
    worst = ceiling(max(max(one["balanced"].values()) for one in zeros))
    yield Quoted("cells.uniform", "largest error of E, K, ν, tractions of facets and stresses of cells under "
        "uniform stress", size, UNIFORM, (worst,), Form(style=".0e"))  # fmt: skip
    yield Quoted("cells.nu", "range of ν of these bodies", size, UNIFORM, (min(nu), max(nu)))


def _waves() -> Iterator[Quoted]:
    for name, nu in (("waves.p20", 0.2), ("waves.p40", 0.4)):
        rows = [one for one in WAVES.at("rows") if (one["wave"], one["nu"], one["mass"]) == ("P", nu, "lumped")]
        ten = min(rows, key=lambda one: abs(one["elements"] - 10.0))
        yield Quoted(name, f"P wave of ten cells, ν = {nu}, lumped masses: how much too slow",
            f"{WAVES.at('count')} cells, one packing", WAVES, (1.0 - ten["ratio"],), ONE)  # fmt: skip


def _thin() -> Iterator[Quoted]:
    modes = [one for one in SECOND_ORDER.at("modes") if one["law"] == "bondem"]

    def bodies(body: str, kind: str, thick: float = 0.0) -> list[dict]:
        mine = [one for one in modes if (one["name"], one["kind"]) == (body, kind)]
        return [one for one in mine if not thick or abs(one["thick"] - thick) < _THICKNESS]

    def twist(some: list[dict]) -> list[float]:
        return [error for one in some for error, own in zip(one["errors"], one["torsion"], strict=True) if own]

    def worst(some: list[dict]) -> list[float]:
        return [max(abs(error) for one in some for error in one["errors"])]

    bar = "first frequency of torsion of a square bar, {} cells thick: error"
    strip = "torsion of a strip of 2 × 3 {} across: how much too low"
    bars = {thick: bodies("beam", "quench", thick) for thick in (3.5, 4.4)}
    strips, layers = (
        {kind: bodies(f"{body} of two layers", kind) for kind in ("moved", "cubes")} for body in ("strip", "sheet")
    )
    single = bodies("strip", "moved")
    for name, says, some, values in (
        ("bar35", bar.format(3.5), bars[3.5], twist(bars[3.5])),
        ("bar44", bar.format(4.4), bars[4.4], twist(bars[4.4])),
        ("strip", strip.format("unequal cells"), strips["moved"], [-one for one in twist(strips["moved"])]),
        ("cubes", strip.format("cubes"), strips["cubes"], [-one for one in twist(strips["cubes"])]),
        ("layer", "strips of one layer of unequal cells: largest error of six frequencies", single, worst(single)),
        ("layers", "sheets of two layers: largest error of six frequencies", layers["cubes"],
         worst(layers["cubes"] + layers["moved"])),
    ):  # fmt: skip
        counts, packings = sorted({one["cells"] for one in some}), {one["seed"] for one in some}
        size = f"{' or '.join(map(str, counts))} cells, {len(packings)} packing{'s' * (len(packings) > 1)}"
        yield Quoted(f"thin.{name}", says, size, SECOND_ORDER, tuple(values), ONE)


def _costs() -> Iterator[Quoted]:
    for where in ("pieces", "dust"):
        yield Quoted(f"cost.{where}", f"step of a body in {where}, in elastic steps",
            f"{TOUCHING_CELLS.at('elements')} cells, one thread", TOUCHING_CELLS,
            (TOUCHING_CELLS.at(f"in {where}", "median_ratio"),), RATIO)  # fmt: skip
    for one in SHARES.at("rows"):
        large = "_large" * (one["elements"] == _LARGE)
        yield Quoted(f"shares.over_cut{large}", "time to balance the shares over that of the cut",
            f"{one['elements']} cells, {SHARES.at('threads')} threads", SHARES, (one["over_cut"]["median"],),
            RATIO)  # fmt: skip
    (machine,) = AGAINST.data.values()
    gains = [one["gain"] for one in machine["rates"] if one["kind"] == "cells" and one["elements"] == _LARGE]
    yield Quoted("shares.step", "elastic step with gradients of the dilatation, in steps without",
        f"{_LARGE} cells, one and two threads", AGAINST, tuple(1.0 / gain for gain in gains), FINE)  # fmt: skip


def _turning() -> Iterator[Quoted]:
    rows = [one for one in TURNING.at("rows") if one["name"] == "now"]
    breaks = [one for one in rows if one["kind"] in ("brittle", "softening")]
    size = f"{len(breaks)} runs of bars that turn and break"
    yield Quoted("turning.largest", "largest error of the energy balance of a bar that turns and breaks", size,
        TURNING, (max(one["largest"] for one in breaks),), ONE)  # fmt: skip
    yield Quoted("turning.runs", "runs of bars that turn and break", size, TURNING, (len(breaks),))


def _fields() -> Iterator[Quoted]:
    for (count,), mine in grouped(FIELDS.at("cases"), "count").items():
        size = f"{count} cells, {len({one['seed'] for one in mine})} packings, ν = 0.2 and 0.45"
        which = "coarse" if count == min(one["count"] for one in FIELDS.at("cases")) else "fine"
        yield Quoted(f"fields.{which}", "curvature of a free bar under a linear field of strain over that of theory",
            size, FIELDS, tuple(one[key] for one in mine for key in ("along", "across")), FINE)  # fmt: skip
        yield Quoted(f"fields.stress_{which}", "largest stress of its cells over E ε of its face", size, FIELDS,
            tuple(one["stress"] for one in mine), FINE)  # fmt: skip


def _damping() -> Iterator[Quoted]:
    cases = DAMPING.at("cases")
    counts = " or ".join(str(count) for (count,) in grouped(cases, "count"))
    zero, others = ([one for one in cases if (one["nu"] == 0.0) is same] for same in (True, False))
    for name, some in (("zero", zero), ("others", others)):
        nu = " and ".join(f"{nu:g}" for (nu,) in grouped(some, "nu"))
        yield Quoted(f"damping.{name}", f"damping of six modes by dashpots of bonds over β ω / 2, ν = {nu}",
            f"{counts} cells, {len({one['seed'] for one in some})} packings", DAMPING,
            tuple(value for one in some for value in one["modes"]), FINE)  # fmt: skip


def _sliding() -> Iterator[Quoted]:
    joints, blocks = SLIDING.at("joints"), SLIDING.at("blocks")
    packings = len({one["seed"] for one in joints})
    counts = " and ".join(map(str, sorted({one["cells"] for one in joints})))
    size = f"{counts} cells per 30 mm of a bar 12 mm thick, {packings} packings each"
    for name, degrees in (("joints", (45, 60)), ("steep_joints", (70,))):
        some = [one for one in joints if one["degrees"] in degrees]
        angles = " and ".join(f"{one}°" for one in degrees)
        yield Quoted(f"{name}.flat", f"joint whose normal is at {angles} to the load: flat share of the section",
            size, SLIDING, tuple(one["flat"] for one in some), THIRD)  # fmt: skip
        yield Quoted(f"{name}.peak", "the same: strength in compression over Jaeger's", size, SLIDING,
            tuple(one["peak"] for one in some), FINE)  # fmt: skip
    for under, what in (("block", "a block of cells"), ("wall", "a plane wall"), ("joint", "a joint in one body")):
        some = [one["moved"] / one["rigid"] for one in blocks if one["under"] == under]
        yield Quoted(f"blocks.{under}",
            f"path of a flat block of cells on {what}, over that of a rigid one (μ = 0 on 15°, μ = 0.5 on 35°)",
            f"blocks of cells of 3 mm, {len(some)} runs", SLIDING, tuple(some), THIRD if under == "block" else FINE,
        )  # fmt: skip
