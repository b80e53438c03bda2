"""A bar of granite that spalls from its free end, as rows of a study."""

from dataclasses import dataclass
from math import pi, sqrt
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from bondem._types import Floats
from bondem.errors import UnstableRunError
from bondem.fracture.fragments import Fragments, fragments
from bondem.laws.cell_bond import CellBond
from bondem.laws.failure.rankine import Rankine
from bondem.model.gauges import Gauge
from bondem.model.loads import Pressure
from bondem.model.model import Model
from bondem.model.schedules import Table
from bondem.packing import EVEN, pack
from bondem.run import solve_explicit
from bondem.solve.plan import Status
from bondem.specimen.bonding import connect
from bondem.specimen.geometry import Cylinder
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face
from validation.frame.files import plain, thinned
from validation.frame.request import Request

# How long a run goes on [s].
_DURATION = 130e-6
# The pull-back ends where the velocity has come up by so much again [m/s].
_REBOUND = 0.3
# Pieces of less of the mass are crumbs [-]; facets with less integrity are broken; width of bins of a profile [m].
_CRUMB, _BROKEN, _BIN = 0.01, 0.1, 3e-3


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
    def celerity(self) -> float:
        """Of waves in a thin bar [m/s]."""
        return sqrt(self.E / self.rho)

    @property
    def velocity(self) -> float:
        """Largest of the free end of a thin elastic bar, 2 p / ρ c [m/s]."""
        return 2.0 * self.pressure / (self.rho * self.celerity)

    def pull_back(self, tension: float) -> float:
        """Fall of that velocity which goes with a strength, 2 f_t / ρ c [m/s]."""
        return 2.0 * tension / (self.rho * self.celerity)

    def place(self, tension: float) -> float:
        """Distance from the free end at which tension first reaches a strength in a thin elastic bar [m].

        The crest has come back when the fall of the pulse, of the length 2 d / c, has f_t less.
        """
        return 0.5 * self.celerity * tension / self.pressure * (self.end - self.crest)

    def body(self, size: float, seed: int) -> Lattice:
        """Its cells, of a size [m]."""
        shape = Cylinder(radius=0.5 * self.diameter, length=self.length)
        count = round(self.section * self.length / size**3)
        return connect(pack(shape, count=count, method=EVEN, seed=seed), method="laguerre")

    def model(self, body: Lattice, failure: Rankine | None) -> Model:
        """The test on a body."""
        pulse = Table((0.0, self.crest, self.end), (0.0, 1.0, 0.0))
        load = Pressure(Face("x_min"), self.pressure, schedule=pulse)
        return Model(body, CellBond(E=self.E, nu=self.nu), self.rho, failure=failure, boundary=[load])


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
    def readable(self) -> str:
        """See `Request`."""
        kind = f"{1e-6 * self.tension:g}MPa_{self.fracture_energy:g}Jm2"
        return f"spall_{kind}_{1e6 * self.size:g}um_seed{self.seed}"

    @property
    def weight(self) -> float:
        """See `Request`."""
        return self.size**-4

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`."""
        return {"tension": self.tension, "fracture_energy": self.fracture_energy, "size": self.size,
                "seed": self.seed, "count": 0, "spread": 0.0}  # fmt: skip

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: SI units, places from the free end."""
        bar, body = self.bar, self.bar.body(self.size, self.seed)
        model = bar.model(body, Rankine(tension=self.tension, fracture_energy=self.fracture_energy))
        begun = perf_counter()
        run = solve_explicit(
            model, duration=_DURATION, every=2, gauges={"end": Gauge(Face("x_max"), "velocity")}
        )
        if run.status is not Status.COMPLETED:
            raise UnstableRunError(run.message)
        time, velocity = run.history.time, run.history["end"][:, 0]
        highest, fallen = pulled_back(velocity)
        assert body.facets is not None
        broken = np.flatnonzero(run.state.bond_integrity < _BROKEN)
        place = bar.length - body.facets.centroid[broken, 0]
        area = body.facets.area[broken] * np.abs(body.facets.normal[broken, 0])
        bins = np.arange(0.0, bar.length + 0.5 * _BIN, _BIN)
        return plain({
            "count": len(body.particles), "steps": run.state.step, "run_seconds": round(perf_counter() - begun, 1),
            "residual": run.residual, "highest": highest, "pull_back": fallen,
            "first": float(run.events.time.min()) if len(run.events) else None,
            "lengths": lengths(fragments(body, run.state), bar),
            "profile": np.histogram(place, bins, weights=area)[0] / bar.section,
            "curve": {"time": thinned(time), "velocity": thinned(velocity)},
        })  # fmt: skip


def pulled_back(velocity: Floats) -> tuple[float, float | None]:
    """Highest velocity of a free end, and how far it falls until it comes up again [m/s]; None if it does not.

    Args:
        velocity: over time, (k,).
    """
    top = int(np.argmax(velocity))
    least = np.minimum.accumulate(velocity[top:])
    again = np.flatnonzero(velocity[top:] > least + _REBOUND)
    return float(velocity[top]), float(velocity[top] - least[again[0]]) if again.size else None


def lengths(pieces: Fragments, bar: Bar) -> list[float]:
    """Lengths of the pieces, by their mass, from the free end on [m]; no crumbs."""
    whole = pieces.mass > _CRUMB * pieces.mass.sum()
    order = np.argsort(-pieces.position[whole, 0])
    return [float(f"{one:.4g}") for one in (pieces.mass[whole][order] / (bar.rho * bar.section)).tolist()]
