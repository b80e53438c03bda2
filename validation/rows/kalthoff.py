"""Kalthoff and Winkler's plate, struck between its notches, as rows of a study: the way that its crack takes."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.errors import InputError, UnstableRunError
from validation.frame.files import plain, rounded
from validation.frame.request import Request

#: Until when a run goes on [s].
DURATION = 90e-6
# In what time the edge gets its speed [s].
_RISE = 1e-6
# Facets with less integrity are of the crack, its angle of those from so many cells to so far from the tip [m].
_BROKEN, _NEAREST, _FARTHEST = 0.1, 2.0, 30e-3


@dataclass(frozen=True)
class Plate:
    """The upper half of the plate: y from its plane of symmetry, x from the edge that is struck.

    Attributes:
        length, width, thickness: of the half [m].
        notch: its length, distance from the plane of symmetry, and width [m].
        E, nu, rho: of the material [Pa, -, kg/m³].
        fracture_energy: G [J/m²].
        speed: of the edge below the notch [m/s].
    """

    length: float = 0.1
    width: float = 0.1
    thickness: float = 9e-3
    notch: tuple[float, float, float] = (50e-3, 25e-3, 0.5e-3)
    E: float = 190e9
    nu: float = 0.3
    rho: float = 8000.0
    fracture_energy: float = 22.13e3
    speed: float = 16.5

    @property
    def tip(self) -> tuple[float, float]:
        """End of the notch [m]."""
        return self.notch[:2]

    @property
    def shape(self) -> bd.Shape:
        """The half of it, with its notch."""
        deep, at, wide = self.notch
        slot = bd.Box((2.0 * deep, wide, 3.0 * self.thickness)).moved((-deep, at - 0.5 * wide, -self.thickness))
        return bd.Box((self.length, self.width, self.thickness)).cut(slot, name="notch")

    def body(self, size: float, seed: int) -> bd.Lattice:
        """Its cells, of a size [m]."""
        shape = self.shape
        return bd.connect(
            bd.pack(shape, count=round(shape.volume / size**3), method="even", seed=seed), method="laguerre"
        )

    def struck(self, size: float) -> bd.Region:
        """The edge between the notches."""
        _, at, wide = self.notch
        return bd.Face("x_min") & bd.Within(bd.Box((3.0 * size, at - 0.5 * wide, self.thickness)))

    def model(self, body: bd.Lattice, tension: float, size: float) -> bd.Model:
        """The test on a body of a strength [Pa], of cells of a size [m]."""
        failure = bd.Rankine(tension=tension, fracture_energy=self.fracture_energy)
        return bd.Model(
            body, bd.CellBond(E=self.E, nu=self.nu), self.rho, failure=failure, boundary=self.conditions(size)
        )

    def conditions(self, size: float) -> list[bd.BoundaryCondition]:
        """The plane of symmetry, and what strikes elements of a size [m]."""
        return [
            bd.Fix(bd.Face("y_min"), translation="y", rotation=""),
            bd.Drive(self.struck(size), vx=bd.Ramp(0.0, self.speed, _RISE)),
        ]

    def angle(self, place: Floats, area: Floats, size: float) -> float:
        """Mean direction of a crack from the tip, against the notch, weighted by area [degrees].

        Args:
            place: of its facets [m], (k, 3).
            area: of these [m²], (k,).
            size: of the cells [m].

        Raises:
            InputError: no crack there.
        """
        way = place[:, :2] - np.array(self.tip)
        far = np.hypot(way[:, 0], way[:, 1])
        counts = (far > _NEAREST * size) & (far < _FARTHEST) & (way > -size).all(axis=1)
        if not counts.any():
            raise InputError(f"no crack within {_FARTHEST:g} m of the notch; weaken the plate, or make cells smaller")
        along, up = area[counts] @ way[counts]
        return float(np.degrees(np.arctan2(up, along)))


@dataclass(frozen=True)
class KalthoffRun(Request):
    """A plate of a strength, struck.

    Attributes:
        plate: what is struck.
        tension: its strength [Pa].
        size: of cells [m].
        seed: of the packing.
    """

    plate: Plate
    tension: float
    size: float
    seed: int

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units, angles in degrees."""
        plate, body = self.plate, self.plate.body(self.size, self.seed)
        model = plate.model(body, self.tension, self.size)
        run = bd.solve_explicit(model, duration=DURATION, every=50)
        if run.status is not bd.Status.COMPLETED:
            raise UnstableRunError(run.message)
        assert body.facets is not None
        broken = np.flatnonzero(run.state.bond_integrity < _BROKEN)
        place, area = body.facets.centroid[broken], body.facets.area[broken]
        return plain({
            "count": len(body.particles), "residual": run.residual, "angle": plate.angle(place, area, self.size),
            "x": rounded(place[:, 0], 4), "y": rounded(place[:, 1], 4),
        })  # fmt: skip
