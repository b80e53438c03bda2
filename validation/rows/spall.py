"""A bar of granite that spalls from its free end, as rows of a study."""

from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any

import bondem as bd
from validation.frame.files import plain, rounded, thinned
from validation.frame.request import Request

# How long a run goes on [s].
_DURATION = 130e-6
# The pull-back ends where the velocity has come up by so much again [m/s].
_REBOUND = 0.3
# Bins of a profile, of 3 mm.
_BINS = 47


@dataclass(frozen=True)
class Bar:
    """A bar of granite along x, struck at x = 0 by a pulse of pressure and free elsewhere.

    Attributes:
        length, diameter: [m].
        E, nu, rho: of the granite [Pa, -, kg/m³].
        pressure: of the crest [Pa].
        crest, end: when the pulse is highest and over [s].
    """

    length: float = 0.14
    diameter: float = 45e-3
    E: float = 43.6e9
    nu: float = 0.15
    rho: float = 2660.0
    pressure: float = 41.5e6
    crest: float = 35e-6
    end: float = 55e-6

    @property
    def section(self) -> float:
        """[m²]."""
        return 0.25 * pi * self.diameter**2

    @property
    def thin(self) -> bd.labtests.ThinBar:
        """What a thin elastic bar does under the same pulse."""
        return bd.labtests.ThinBar(self.E, self.rho, self.pressure, self.crest, self.end - self.crest)

    def body(self, size: float, seed: int) -> bd.Lattice:
        """Its cells, of a size [m]."""
        shape = bd.Cylinder(radius=0.5 * self.diameter, length=self.length)
        count = round(self.section * self.length / size**3)
        return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")

    def struck(self, body: bd.Lattice, failure: bd.Rankine | None) -> bd.labtests.SpallTest:
        """The test on a body."""
        return bd.labtests.spall(
            body, bd.CellBond(E=self.E, nu=self.nu), failure, density=self.rho, pressure=self.pressure,
            rise=self.crest, fall=self.end - self.crest, duration=_DURATION, rebound=_REBOUND, bins=_BINS,
        )  # fmt: skip


@dataclass(frozen=True)
class SpallRun(Request):
    """A bar of a strength, struck.

    Attributes:
        bar: what is struck.
        tension: its strength [Pa].
        fracture_energy: [J/m²].
        size: of cells [m].
        seed: of the packing.
    """

    bar: Bar
    tension: float
    fracture_energy: float
    size: float
    seed: int

    @property
    def weight(self) -> float:
        return self.size**-4

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units, places from the free end."""
        body = self.bar.body(self.size, self.seed)
        test = self.bar.struck(body, bd.Rankine(tension=self.tension, fracture_energy=self.fracture_energy))
        return plain({
            "count": len(body.particles), "residual": test.residual, "highest": test.highest,
            "pull_back": test.pull_back, "first": test.first, "lengths": rounded(test.lengths, 4),
            "profile": test.profile,
            "curve": {"time": thinned(test.time), "velocity": thinned(test.velocity)},
        })  # fmt: skip
