"""Notched plates of glass that are pulled until their crack branches, as rows of a study."""

from dataclasses import dataclass
from functools import cached_property
from math import sqrt
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.errors import InputError, UnstableRunError
from validation.frame.files import plain, rounded, thinned
from validation.frame.request import Request

#: The fastest advance of a crack is its mean over so long a time [s].
WINDOW = 10e-6
# Facets with less integrity are of the crack; strips across it in which branches are counted [m]; branches are this
# far apart, in cells; and a crack has branched where this many strips in turn have two or more.
_BROKEN, _STRIP, _APART, _RUN = 0.1, 2e-3, 3.0, 3
# Pieces of fewer cells are crumbs.
_CRUMB = 10


@dataclass(frozen=True)
class NotchedPlate:
    """A plate with a notch from its edge x = 0 to its middle, pulled on its long sides from t = 0 on.

    Attributes:
        length, height, thickness: of the plate [m].
        slot: width of the notch [m].
        E, nu, rho: of the material [Pa, -, kg/m³].
        tension: f_t [Pa].
        fracture_energy: G_f [J/m²].
        stress: on both long sides, held [Pa].
        duration: of a run [s].
    """

    E: float
    nu: float
    rho: float
    tension: float
    fracture_energy: float
    stress: float
    duration: float
    slot: float
    length: float = 0.1
    height: float = 0.04
    thickness: float = 2e-3

    @property
    def tip(self) -> tuple[float, float, float]:
        """End of the notch [m]."""
        return 0.5 * self.length, 0.5 * self.height, 0.0

    @property
    def longest(self) -> float:
        """2 E G / f_t², above which elements snap back [m]."""
        return 2.0 * self.E * self.fracture_energy / self.tension**2

    @cached_property
    def rayleigh(self) -> float:
        """c_R of a half-space, as published limits have it [m/s]; in plane stress it is 0.6 % less at ν = 0.2."""
        shear = sqrt(0.5 * self.E / (1.0 + self.nu) / self.rho)
        share = 0.5 * (1.0 - 2.0 * self.nu) / (1.0 - self.nu)  # (c_s / c_p)²
        # x³ - 8x² + (24 - 16 share) x - 16 (1 - share) = 0 for x = (c_R / c_s)²
        roots = np.roots([1.0, -8.0, 24.0 - 16.0 * share, -16.0 * (1.0 - share)])
        (x,) = (root.real for root in roots if abs(root.imag) < 1e-9 and 0.0 < root.real < 1.0)
        return shear * sqrt(x)

    def body(self, count: int, seed: int) -> bd.Lattice:
        """Its cells."""
        wide = self.slot
        slot = bd.Box((self.length, wide, 3.0 * self.thickness))
        placed = slot.moved((-0.5 * self.length, 0.5 * (self.height - wide), -self.thickness))
        shape = bd.Box((self.length, self.height, self.thickness)).cut(placed, name="notch")
        return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")

    def model(self, body: bd.Lattice) -> bd.Model:
        """The test on a body."""
        sides = [bd.Pressure(bd.Face(name), -self.stress) for name in ("y_min", "y_max")]
        failure = bd.Rankine(tension=self.tension, fracture_energy=self.fracture_energy)
        return bd.Model(body, bd.CellBond(E=self.E, nu=self.nu), self.rho, failure=failure, boundary=sides)


@dataclass(frozen=True)
class BranchingRun(Request):
    """A plate on one packing.

    Attributes:
        case: its name.
        plate: what is pulled.
        count: of cells.
        seed: of the packing.
    """

    case: str
    plate: NotchedPlate
    count: int
    seed: int

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units, places from the tip of the notch."""
        plate = self.plate
        body = plate.body(self.count, self.seed)
        run = bd.solve_explicit(plate.model(body), duration=plate.duration, every=50)
        if run.status is not bd.Status.COMPLETED:
            raise UnstableRunError(run.message)
        assert body.facets is not None
        broken = np.flatnonzero(run.state.bond_integrity < _BROKEN)
        place, size = body.facets.centroid[broken] - plate.tip, float(np.cbrt(plate_volume(body) / self.count))
        events = run.events
        row: dict[str, Any] = {
            "residual": run.residual, "size": size, "rayleigh": plate.rayleigh, "longest": plate.longest,
            "area": body.facets.area[broken].sum(), "onset": None,
            "pieces": int((bd.fragments(body, run.state).size >= _CRUMB).sum()),
            "onset_x": None, "onset_y": None, "speed": None, "low": None, "high": None,
            "fastest": None, "branched": branching(place[:, 0], place[:, 1], size), "branched_at": None,
            "x": rounded(place[:, 0], 4), "y": rounded(place[:, 1], 4),
        }  # fmt: skip
        if len(events):
            first = int(np.argmin(events.time))
            row |= {"onset": events.time[first], "onset_x": events.position[first, 0] - plate.tip[0],
                    "onset_y": events.position[first, 1] - plate.tip[1]}  # fmt: skip
        return plain(row | _grown(plate, events, row["branched"]))


def plate_volume(body: bd.Lattice) -> float:
    """Of all cells [m³]."""
    assert body.cells is not None
    return float(body.cells.volume.sum())


def _grown(plate: NotchedPlate, events: bd.BrokenBonds, branched: float | None) -> dict[str, Any]:
    """Speeds of the front along x, and of what is farthest from the tip."""
    try:
        growth = bd.crack_speed(events, plate.tip, (1.0, 0.0, 0.0))
    except InputError:  # it has not come far enough
        return {"front": {"time": [], "length": []}}
    far = np.maximum.accumulate(np.hypot(*(events.position - plate.tip)[:, :2].T))
    past = growth.time[growth.length >= branched] if branched is not None else []
    return {
        "speed": growth.speed, "low": growth.interval[0], "high": growth.interval[1],
        "fastest": fastest(events.time, far), "branched_at": past[0] if len(past) else None,
        "front": _front(growth),
    }  # fmt: skip


def _front(growth: bd.CrackGrowth) -> dict[str, Floats]:
    return {"time": thinned(growth.time), "length": thinned(growth.length)}


def fastest(time: Floats, length: Floats) -> float | None:
    """Largest mean speed of a front over `WINDOW` [m/s]; None if it grows for a shorter time.

    Args:
        time: of its advances, rising [s], (k,).
        length: after each [m], (k,).
    """
    if not len(time) or time[-1] - time[0] < WINDOW:
        return None
    ends = time[time >= time[0] + WINDOW]
    before = length[np.searchsorted(time, ends - WINDOW, side="right") - 1]
    after = length[np.searchsorted(time, ends, side="right") - 1]
    return float(np.max(after - before) / WINDOW)


def branching(x: Floats, y: Floats, size: float) -> float | None:
    """Where a crack along x has become two: the first of three strips in turn with two branches or more.

    Args:
        x, y: of its facets, from the tip [m], (k,).
        size: of the cells [m]; branches have a gap of three between them.

    Returns:
        Middle of the strip [m], or None.
    """
    strips = np.floor(x / _STRIP).astype(int)
    found = 0
    for strip in range(int(strips.max(initial=-1)) + 1):
        here = np.sort(y[strips == strip])
        found = found + 1 if (np.diff(here) > _APART * size).any() else 0
        if found == _RUN:
            return (strip - _RUN + 1.5) * _STRIP
    return None
