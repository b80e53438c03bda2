"""Published fracture tests, each run a row: curves, peak, work, and where the crack went.

The work of the load is counted to the last event at `until` of the peak or more: what events have dissipated by
then, and what is stored. Beyond it a hinge bears a load that falls with the square of its way, whose work is P δ of
that event (Elices, Guinea and Planas 1992): the tail. Displacements are small in `bd.solve_quasistatic`, so that a
crack's last cells become a hinge that bears ever more where a real one folds: events at which the line has gone by
more than `FOLDED` of the height of the body, and all later ones, are not counted.

Beside it stands what the path itself dissipates until its end, with what is stored there: no tail is supposed.
"""

from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from bondem._types import Floats, PerBond
from bondem.specimen.lattice import Lattice
from bondem.statics.quasistatic.quasistatic_run import QuasistaticResult, solve_quasistatic
from validation.cases.case import Case
from validation.cases.path_case import LOST
from validation.frame.files import plain, rounded
from validation.frame.request import Request

#: Largest way of the pushed line of events that count, over the largest height of the body [-].
FOLDED = 0.05
#: Digits that are kept of curves and cracks.
DIGITS = 6


@dataclass(frozen=True)
class FractureRun(Request):
    """A case on one packing.

    Attributes:
        case: what is tested.
        seed: of the packing.
        finer: how many times smaller cells are than the case has them.
        curve: how cracks soften: "bilinear", or "straight".
    """

    case: Case
    seed: int
    finer: float = 1.0
    curve: str = "bilinear"

    def measured(self, folder: Path) -> dict[str, Any]:
        case = self.case
        body = case.body(self.seed, self.finer)
        model, driven = case.model(body, self.curve)
        begun = perf_counter()
        path = solve_quasistatic(
            model, driven, ripple=case.ripple, together=case.together, until=case.until, gauges=case.gauges(body)
        )
        way = case.way(path)
        peak, last = counted(path.load, way, case.until, FOLDED * float(np.ptp(body.particles.position[:, 1])))
        stored = 0.5 * path.load[last] * way[last]
        return plain({
            "count": len(body.particles), "facets": len(body.pairs), "events": len(path.load),
            "failures": len(path.bond), "iterations": path.iterations, "end": path.end,
            "run_seconds": round(perf_counter() - begun, 1),
            "peak": path.load[peak], "displacement": way[peak], "work": path.energy[:last].sum() + stored,
            "tail": path.load[last] * way[last], "dissipated": path.energy.sum() + 0.5 * path.load[-1] * way[-1],
            "area": _torn(body, path.bond_integrity),
            "curve": _curve(case, path), "crack": crack_of(body, path.bond_integrity),
        })  # fmt: skip


def counted(load: Floats, way: Floats, until: float, farthest: float) -> tuple[int, int]:
    """Events of the peak, and of the last load of at least `until` of it, among those before any goes too far.

    Args:
        load: of events [N], (e,).
        way: how far the pushed line has gone by then [m], (e,).
        until: share of the peak.
        farthest: ways that are too far [m]; nothing after the first such event counts.
    """
    far = np.flatnonzero(way > farthest)
    load = load[: far[0]] if far.size else load
    peak = int(np.argmax(load))
    return peak, int(np.flatnonzero(load >= until * load[peak])[-1])


def _curve(case: Case, path: QuasistaticResult) -> dict[str, list[float]]:
    """Of each event: how far the pushed line has gone [m], load [N], and how far the crack's mouth is open [m]."""
    curve = {"displacement": case.way(path), "load": path.load}
    if case.mouth is not None:
        curve["CMOD"] = path.gauge["CMOD"][:, 0]
    return {name: rounded(values, DIGITS) for name, values in curve.items()}


def _cracked(integrity: PerBond) -> np.ndarray:
    return np.flatnonzero(integrity < 1.0 - LOST)


def _torn(body: Lattice, integrity: PerBond) -> float:
    """Area of the facets of the crack [m²]."""
    assert body.facets is not None
    return float(body.facets.area[_cracked(integrity)].sum())


def crack_of(body: Lattice, integrity: PerBond) -> dict[str, list[float]]:
    """Facets of the crack: centre [m], normal [-], area [m²], and the integrity that is left [-]."""
    assert body.facets is not None
    facets, torn = body.facets, _cracked(integrity)
    found = {axis: facets.centroid[torn, k] for k, axis in enumerate("xyz")}
    found |= {f"normal_{axis}": facets.normal[torn, k] for k, axis in enumerate("xyz")}
    found |= {"area": facets.area[torn], "integrity": integrity[torn]}
    return {name: rounded(values, DIGITS) for name, values in found.items()}
