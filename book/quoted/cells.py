"""Cells: uniform stresses, waves, thin bodies, and what a step of cracked bodies costs."""

from collections.abc import Sequence

from book.chapters.cells import UNIFORM, WAVES
from book.chapters.cost import TOUCHING_CELLS
from book.chapters.second_order import FOUND as SECOND_ORDER
from book.forms import Form
from book.quoting import Quoted, ceiling
from book.results import Measurement

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
MEASUREMENTS = (SHARES, AGAINST, TURNING)

RATIO, FINE, ONE = Form(style=".1f"), Form(style=".2f"), Form("%", 1e-2, ".1f")
#: Cells of the larger of two bodies.
_LARGE = 100_000
#: How far a thickness in cells may be from the one that is asked for.
_THICKNESS = 0.1


def quoted() -> Sequence[Quoted]:
    """All quoted numbers of cells."""
    return [*_uniform(), *_waves(), *_thin(), *_costs(), *_turning()]


def _uniform() -> list[Quoted]:
    zeros = UNIFORM.at("zeros")
    nu = [one["nu"] for one in zeros]
    seeds = zeros[0]["seeds"]
    size = f"{UNIFORM.at('count')} cells, {len({one['body'] for one in zeros})} bodies, {seeds} packings each"
    worst = ceiling(max(max(one["balanced"].values()) for one in zeros))
    return [
        Quoted(name="cells.uniform", says="largest error of E, K, ν, tractions of facets and stresses of cells under "
               "uniform stress", size=size, record=UNIFORM, values=(worst,), form=Form(style=".0e")),
        Quoted(name="cells.nu", says="range of ν of these bodies", size=size, record=UNIFORM,
               values=(min(nu), max(nu))),
    ]  # fmt: skip


def _waves() -> list[Quoted]:
    found = []
    for name, nu in (("waves.p20", 0.2), ("waves.p40", 0.4)):
        rows = [one for one in WAVES.at("rows") if (one["wave"], one["nu"], one["mass"]) == ("P", nu, "lumped")]
        ten = min(rows, key=lambda one: abs(one["elements"] - 10.0))
        found.append(Quoted(
            name=name, says=f"P wave of ten cells, ν = {nu}, lumped masses: how much too slow", form=ONE,
            size=f"{WAVES.at('count')} cells, one packing", record=WAVES, values=(1.0 - ten["ratio"],),
        ))  # fmt: skip
    return found


def _thin() -> list[Quoted]:
    modes = [one for one in SECOND_ORDER.at("modes") if one["law"] == "bondem"]

    def bodies(body: str, kind: str, thick: float) -> list[dict]:
        mine = [one for one in modes if (one["name"], one["kind"]) == (body, kind)]
        return [one for one in mine if not thick or abs(one["thick"] - thick) < _THICKNESS]

    def errors(body: str, kind: str, *, torsion: bool | None = None, thick: float = 0.0) -> tuple[float, ...]:
        return tuple(
            error for one in bodies(body, kind, thick)
            for error, is_torsion in zip(one["errors"], one["torsion"], strict=True)
            if torsion is None or is_torsion is torsion
        )  # fmt: skip

    def size(body: str, kind: str, thick: float = 0.0) -> str:
        counts = sorted({one["cells"] for one in bodies(body, kind, thick)})
        packings = {one["seed"] for one in bodies(body, kind, thick)}
        return f"{' or '.join(map(str, counts))} cells, {len(packings)} packing{'s' * (len(packings) > 1)}"

    bar = "first frequency of torsion of a square bar, {} cells thick: error"
    strip = "torsion of a strip of 2 × 3 {} across: how much too low"
    return [
        Quoted(name="thin.bar35", says=bar.format(3.5), size=size("beam", "quench", 3.5), form=ONE,
               record=SECOND_ORDER, values=errors("beam", "quench", torsion=True, thick=3.5)),
        Quoted(name="thin.bar44", says=bar.format(4.4), size=size("beam", "quench", 4.4), form=ONE,
               record=SECOND_ORDER, values=errors("beam", "quench", torsion=True, thick=4.4)),
        Quoted(name="thin.strip", says=strip.format("unequal cells"), size=size("strip of two layers", "moved"),
               record=SECOND_ORDER, form=ONE,
               values=tuple(-one for one in errors("strip of two layers", "moved", torsion=True))),
        Quoted(name="thin.cubes", says=strip.format("cubes"), size=size("strip of two layers", "cubes"),
               record=SECOND_ORDER, form=ONE,
               values=tuple(-one for one in errors("strip of two layers", "cubes", torsion=True))),
        Quoted(name="thin.layer", says="strips of one layer of unequal cells: largest error of six frequencies",
               size=size("strip", "moved"), record=SECOND_ORDER, form=ONE,
               values=(max(map(abs, errors("strip", "moved"))),)),
        Quoted(name="thin.layers", says="sheets of two layers: largest error of six frequencies", form=ONE,
               size=f"{size('sheet of two layers', 'cubes')}", record=SECOND_ORDER,
               values=(max(map(abs, errors("sheet of two layers", "cubes") +
                               errors("sheet of two layers", "moved"))),)),
    ]  # fmt: skip


def _costs() -> list[Quoted]:
    found = [
        Quoted(name=f"cost.{name}", says=f"step of a body in {where}, in elastic steps", record=TOUCHING_CELLS,
               size=f"{TOUCHING_CELLS.at('elements')} cells, one thread", form=RATIO,
               values=(TOUCHING_CELLS.at(f"in {where}", "median_ratio"),))
        for name, where in (("pieces", "pieces"), ("dust", "dust"))
    ]  # fmt: skip
    found += [
        Quoted(name=f"shares.over_cut{'_large' * large}", says="time to balance the shares over that of the cut",
               size=f"{one['elements']} cells, {SHARES.at('threads')} threads", record=SHARES, form=RATIO,
               values=(one["over_cut"]["median"],))
        for one in SHARES.at("rows") for large in [one["elements"] == _LARGE]
    ]  # fmt: skip
    (machine,) = AGAINST.data.values()
    gains = [one["gain"] for one in machine["rates"] if one["kind"] == "cells" and one["elements"] == _LARGE]
    found.append(Quoted(
        name="shares.step", says="elastic step with gradients of the dilatation, in steps without", record=AGAINST,
        size=f"{_LARGE} cells, one and two threads", form=FINE, values=tuple(1.0 / gain for gain in gains),
    ))  # fmt: skip
    return found


def _turning() -> list[Quoted]:
    rows = [one for one in TURNING.at("rows") if one["name"] == "now"]
    breaks = [one for one in rows if one["kind"] in ("brittle", "softening")]
    size = f"{len(breaks)} runs of bars that turn and break"
    return [
        Quoted(name="turning.largest", says="largest error of the energy balance of a bar that turns and breaks",
               size=size, record=TURNING, form=ONE, values=(max(one["largest"] for one in breaks),)),
        Quoted(name="turning.runs", says="runs of bars that turn and break", size=size, record=TURNING,
               values=(len(breaks),)),
    ]  # fmt: skip
