"""Published cases with beam bonds between spheres in place of cells, slowly and damped, or struck."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.errors import InputError, UnstableRunError
from validation.cases.beam_bonds import BeamBonds, beam_bonds
from validation.cases.case import Case, Line
from validation.frame.files import plain, rounded, thinned
from validation.frame.request import Request
from validation.rows.kalthoff import DURATION, Plate

# Share of the critical damping of the first axial vibration, and of the time to the expected peak in which the speed
# grows; the load ends a run at this share of its peak, and what is spared is stronger by this factor.
_DAMPING, _BEGIN, _ENDING, _STRONG = 0.05, 0.2, 0.2, 1e3
# A line bears a row of spheres: within these shares of the mean diameter along x and y.
_ACROSS, _ABOVE = 0.6, 0.9


def _implied(model: bd.Model) -> dict[str, float]:
    found = model.implied_fracture
    assert found is not None
    return {"implied_energy": found.fracture_energy, "toughness": found.toughness, "length": found.length}


def _calibrated(bonds: BeamBonds) -> dict[str, float]:
    return {"E_mu": bonds.law.E, "radius_ratio": bonds.law.radius_ratio or math.nan, "density": bonds.density,
            "bond_tension": bonds.failure.tension, "factor": bonds.factor, "tension": bonds.tension}  # fmt: skip


def _completed(run: bd.ExplicitResult) -> bd.ExplicitResult:
    if run.status.failed:
        raise UnstableRunError(run.message)
    return run


def _broken(body: bd.Lattice, state: bd.State) -> Floats:
    """Middles of the bonds that have broken [m], (k, 3)."""
    chosen = np.flatnonzero(state.bond_integrity <= 0.0)
    return body.centre[body.pairs[chosen, 0]] + 0.5 * body.branch[chosen]


@dataclass(frozen=True)
class SlowBeamsRun(Request):
    """A slow case on one packing of spheres.

    Attributes:
        case: what is tested.
        way: of the driven line at the expected peak [m].
        reach: at which the run ends at the latest [m].
        seed: of the packing.
        count: of spheres.
        traverses: of sound along the longest edge until `way`.
    """

    case: Case
    way: float
    reach: float
    seed: int
    count: int = 1000
    traverses: float = 400.0

    @property
    def weight(self) -> float:
        return self.count * self.traverses

    def measured(self, folder: Path) -> dict[str, Any]:
        case = self.case
        bonds = beam_bonds(case.E, case.nu, case.rho, case.tension)
        body = bd.connect(bd.pack(case.shape, count=self.count, seed=self.seed))
        size = float(np.ptp(case.shape.bounds, axis=0).max())
        sound = math.sqrt(case.E / case.rho)
        rise = self.traverses * size / sound
        speed, begin = self.way / rise, _BEGIN * rise
        line, sign = case.driven
        driven = _row(body, line)
        boundary: list[bd.BoundaryCondition] = [bd.Fix(bd.Face(name)) for name in case.clamped]
        boundary += [bd.Fix(_row(body, one), translation="y", rotation="") for one in case.held]
        boundary.append(bd.Drive(driven, vy=bd.Ramp(0.0, sign * speed, begin)))
        model = bd.Model(body, bonds.law, bonds.density, boundary=boundary, failure=self._failure(body, bonds))
        run = _completed(bd.solve_explicit(
            model, duration=self.reach / speed + 0.5 * begin, every=20,
            until=bd.LoadDrop({"load": (0.0, sign, 0.0)}, _ENDING, 0.3 * case.claim.low),
            damping=bd.MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / size),
            gauges={"load": bd.Gauge(driven, "force"), "way": bd.Gauge(driven, "displacement")},
        ))  # fmt: skip
        load, way = (sign * run.history[name][:, 1] for name in ("load", "way"))
        place = _broken(body, run.state)
        return plain({
            "residual": run.residual, "peak": load.max(), "displacement": way[np.argmax(load)],
            "broken": len(run.events), "given_energy": case.fracture_energy, "E": case.E,
            **_calibrated(bonds), **_implied(bd.Model(body, bonds.law, bonds.density, failure=bonds.failure)),
            "curve": {"displacement": thinned(way), "load": thinned(load)},
            "x": rounded(place[:, 0], 4), "y": rounded(place[:, 1], 4),
        })  # fmt: skip

    def _failure(self, body: bd.Lattice, bonds: BeamBonds) -> dict[Any, bd.PeripheralStress]:
        """Brittle beams, and those near rollers that do not break."""
        strong = bd.PeripheralStress(tension=_STRONG * bonds.failure.tension, shear=_STRONG * bonds.failure.shear)
        found: dict[Any, bd.PeripheralStress] = {bd.Everything(): bonds.failure}
        near = np.zeros(len(body.particles), dtype=bool)
        for line, reach in self.case.spared:
            near |= np.hypot(body.centre[:, 0] - line.x, body.centre[:, 1] - line.y) < reach
        if near.any():
            found[bd.Index(np.flatnonzero(near))] = strong
        return found


def _row(body: bd.Lattice, line: Line) -> bd.Index:
    """The row of spheres at a line.

    Raises:
        InputError: none there.
    """
    wide = 2.0 * body.particles.mean_radius
    x, y = body.centre[:, 0] - line.x, body.centre[:, 1] - line.y
    chosen = np.flatnonzero((np.abs(x) < _ACROSS * wide) & (np.abs(y) < _ABOVE * wide) & body.connected)
    if not len(chosen):
        raise InputError(f"no sphere lies at {line}; take more of them")
    return bd.Index(chosen)


@dataclass(frozen=True)
class StruckBeamsRun(Request):
    """Kalthoff's plate of spheres with a strength, struck.

    Attributes:
        plate: what is struck.
        strength: of its material in direct tension [Pa].
        seed: of the packing.
        count: of spheres.
    """

    plate: Plate
    strength: float
    seed: int
    count: int = 8000

    @property
    def asked(self) -> dict[str, Any]:
        return {"case": "kalthoff", "strength": self.strength, "seed": self.seed, "count": self.count}

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units, angles in degrees; None where no crack is near the notch."""
        plate = self.plate
        bonds = beam_bonds(plate.E, plate.nu, plate.rho, self.strength)
        body = bd.connect(bd.pack(plate.shape, count=self.count, seed=self.seed))
        size = 2.0 * body.particles.mean_radius
        model = bd.Model(body, bonds.law, bonds.density, boundary=plate.conditions(size), failure=bonds.failure)
        run = _completed(bd.solve_explicit(model, duration=DURATION, every=50))
        place = _broken(body, run.state)
        try:
            angle = plate.angle(place, np.ones(len(place)), size)
        except InputError:
            angle = None
        return plain({
            "residual": run.residual, "angle": angle, "broken": len(place),
            "given_energy": plate.fracture_energy, "E": plate.E, **_calibrated(bonds), **_implied(model),
            "x": rounded(place[:, 0], 4), "y": rounded(place[:, 1], 4),
        })  # fmt: skip
