"""Tests with plates of Celigueta et al. (2020), each run a row: stress over strain, and what broke.

A cylinder between two rigid plates, one of which stands still; in shear the moving plate is a piston, which pushes
the core out of a cylinder with ring borings, and the other one has a hole. Stresses are those of the force on the
moving plate, over the section, by eq (7) over π R L, or over the surface between both borings; a run ends when that
has fallen to `FALLEN` of its peak.
"""

import functools
import math
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

import bondem as bd
from bondem._types import Floats
from validation.frame.files import plain, rounded
from validation.frame.request import Request

#: The specimen [m] and the concrete [Pa, -, kg/m³]; the paper gives no density.
RADIUS, LENGTH = 0.05, 0.2
E, NU, RHO = 40e9, 0.2, 2400.0
#: Relative speed of the plates [m/s], and elements of the paper.
SPEED = {"compression": 0.05, "splitting": 0.1, "shear": 0.1}
COUNT = {"compression": 12_000, "splitting": 9_000, "shear": 161_000}
#: The core of the shear test [m]: height of the specimen, mean diameter and depth of its borings, radii of the piston
#: and of the hole, which the paper does not print: the inner and the outer edge of a boring.
HEIGHT, RING, DEPTH, PISTON, HOLE = 0.08, 45e-3, 10e-3, 20.5e-3, 24.5e-3
#: A run ends at this share of its peak, or when the plates have come nearer by these lengths [m].
FALLEN = 0.5
_FARTHEST = {"compression": 0.8e-3, "splitting": 0.25e-3, "shear": 0.8e-3}
#: Friction between elements, and of plates unless given [-].
FRICTION = 0.1
#: What the paper leaves open: damping of elements, dashpots of contacts, reach of the authors' bonds.
DAMPING, DASHPOT, REACH = 0.3, 0.1, 1.3
#: What runs record of both plates.
PLATES: dict[str, bd.AnyGauge] = {
    "still": bd.WallGauge(0, "force"), "moving": bd.WallGauge(1, "force"), "way": bd.WallGauge(1, "displacement"),
}  # fmt: skip
# The plates get going in this time [s].
_START = 2e-4
# Stresses, over the peak, between which E is read.
_ELASTIC = (0.2, 0.5)


def criterion(name: str) -> bd.Criterion:
    """The paper's, by name; the cone of Mohr and Coulomb with its tip and no strength in tension beside."""
    if name == "Rankine":
        return bd.Rankine(tension=6e6)
    angle = math.radians(60.0)
    return bd.MohrCoulomb(tension=14.5e6 / math.tan(angle), cohesion=14.5e6, friction_angle=angle)


@dataclass(frozen=True)
class CeliguetaRun(Request):
    """A test on one packing.

    Attributes:
        test: "compression", "splitting" or "shear".
        failure: "Rankine" or "Mohr-Coulomb".
        areas: "weighted", the authors' construction, or "facet".
        count: elements.
        seed: of the packing.
        slower: by how much plates are slower than the paper's.
        friction: of the plates; that between elements is 0.1.
    """

    test: str
    failure: str
    areas: str
    count: int
    seed: int
    slower: float = 1.0
    friction: float = FRICTION

    @property
    def weight(self) -> float:
        return self.count ** (4 / 3) * self.slower / SPEED[self.test]

    def body(self) -> bd.Lattice:
        """The specimen, bonded."""
        particles = bd.pack(self.shape, count=self.count, spread=0.25, seed=self.seed)
        return (
            bd.connect(particles, method="laguerre") if self.areas == "facet" else bd.connect(particles, reach=REACH)
        )

    def run(
        self, model: bd.Model, *, damping: float = DAMPING, callback: bd.Callback | None = None
    ) -> bd.ExplicitResult:
        """Press until the force on the moving plate has fallen, with forces of both plates and its way."""
        return bd.solve_explicit(
            model, duration=_FARTHEST[self.test] / (SPEED[self.test] / self.slower), every=200,
            damping=bd.LocalDamping(damping), gauges=PLATES, callback=callback,
            until=bd.LoadDrop({"moving": tuple(np.eye(3)[self.axis])}, FALLEN, 0.3e6 * self.section),
        )  # fmt: skip

    def model(self, body: bd.Lattice) -> bd.Model:
        """Between its plates; spheres are as heavy as the concrete that they stand for."""
        speed, axis = SPEED[self.test] / self.slower, self.axis
        low, high = (float(bound[axis]) for bound in self.shape.bounds)
        law = bd.NonLocal(E=E, nu=NU)
        density = RHO
        if self.areas == "weighted":
            law = bd.NonLocal(E=E, nu=NU, areas="weighted", lever="contact")
            density = RHO * self.shape.volume / float(body.particles.volume.sum())
        direction = np.eye(3)[axis]
        along: dict[str, Any] = {"v" + "xyz"[axis]: bd.Ramp(0.0, -speed, _START)}
        motion = bd.Driven(**along)
        hole, piston = (HOLE, PISTON) if self.test == "shear" else (0.0, None)
        walls = [
            bd.PlaneWall(tuple(low * direction), tuple(direction), friction=self.friction, inner=hole),
            bd.PlaneWall(tuple(high * direction), tuple(-direction), motion, self.friction, piston),
        ]
        contact = bd.LinearContact(E=E, friction=FRICTION, kappa=2.0 * (1.0 + NU), damping=DASHPOT)
        return bd.Model(body, law, density, failure=criterion(self.failure), contact=contact, walls=walls)

    @property
    def shape(self) -> bd.Shape:
        """Of the specimen."""
        return _specimen(self.test)

    @property
    def axis(self) -> int:
        """Along which the plates press."""
        return 2 if self.test == "splitting" else 0

    @property
    def section(self) -> float:
        """What a force is divided by [m²]: π R², π R L of eq (7), or π D h between the borings."""
        if self.test == "shear":
            return math.pi * RING * (HEIGHT - 2.0 * DEPTH)
        return math.pi * RADIUS * (RADIUS if self.test == "compression" else LENGTH)

    @property
    def length(self) -> float:
        """Between the plates [m]."""
        lower, upper = self.shape.bounds
        return float((upper - lower)[self.axis])

    def measured(self, folder: Path) -> dict[str, Any]:
        body = self.body()
        begun = perf_counter()
        run = self.run(self.model(body))
        seconds = perf_counter() - begun
        self.keep(folder, {"position": body.centre, "displacement": run.state.displacement,
                           "broken": run.events.position, "radius": body.particles.radius})  # fmt: skip
        return plain(self.read(body, run) | {"run_seconds": round(seconds, 1)})

    def whole(self, folder: Path) -> bool:
        return self.kept_file(folder).exists()

    def read(self, body: bd.Lattice, run: bd.ExplicitResult) -> dict[str, Any]:
        """Peak [Pa], force on the other plate over that at the peak, E of the curve [Pa], and the curve."""
        history, axis = run.history, self.axis
        stress, still = (np.abs(history[name][:, axis]) / self.section for name in ("moving", "still"))
        strain = np.abs(history["way"][:, axis]) / self.length
        peak = int(np.argmax(stress))
        found = {
            "z": 2.0 * len(body.pairs) / len(body.particles), "status": run.status.value, "broken": len(run.events),
            "peak": stress[peak], "other": still[peak] / stress[peak],
            "curve": {name: rounded(values, 5) for name, values in (
                ("strain", strain), ("stress", stress), ("time", history.time),
            )},
        }  # fmt: skip
        if self.test == "compression":
            found["E_plates"] = _slope(strain, stress, peak)
        return found


@functools.cache
def _specimen(test: str) -> bd.Shape:
    return bd.labtests.punch_specimen() if test == "shear" else bd.Cylinder(radius=RADIUS, length=LENGTH)


def _slope(strain: Floats, stress: Floats, peak: int) -> float | None:
    """Of stress over strain on its way up [Pa]."""
    low, high = (share * stress[peak] for share in _ELASTIC)
    first, last = (int(np.flatnonzero(stress[: peak + 1] >= level)[0]) for level in (low, high))
    if last - first < 3:
        return None
    return float(np.polyfit(strain[first : last + 1], stress[first : last + 1], 1)[0])
