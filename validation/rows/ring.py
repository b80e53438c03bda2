"""A ring that flies apart, as rows of a study: how many pieces at which rate."""

from dataclasses import dataclass
from functools import cached_property
from math import asin, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.files import plain, rounded
from validation.frame.request import Request

# Pieces of fewer cells are chips: no section of the ring.
_CHIP = 4
# How long a run goes on: times until the strength is reached, and passages of sound through the section.
_UNTIL, _PASSAGES = 3.0, 40.0


@dataclass(frozen=True)
class Ring:
    """A brittle ring of square section.

    Attributes:
        circumference: of its middle [m].
        side: of its section [m].
        E, nu, rho: of the material [Pa, -, kg/m³].
        tension: σ_c [Pa].
        fracture_energy: G [J/m²].
    """

    circumference: float = 50e-3
    side: float = 0.3e-3
    E: float = 275e9
    nu: float = 0.3
    rho: float = 2750.0
    tension: float = 300e6
    fracture_energy: float = 100.0

    @cached_property
    def celerity(self) -> float:
        """c = √(E/ρ) [m/s]."""
        return sqrt(self.E / self.rho)

    @property
    def length(self) -> float:
        """s₀ = E G / σ_c² [m]."""
        return self.E * self.fracture_energy / self.tension**2

    @property
    def rate(self) -> float:
        """ε̇₀ = c σ_c³ / (E² G) [1/s]."""
        return self.celerity * self.tension**3 / (self.E**2 * self.fracture_energy)

    def size(self, rate: float) -> float:
        """Mean size of fragments at a rate of strain [m]: s₀ · 4.5 / (1 + 4.5 (ε̇/ε̇₀)^(2/3))."""
        return float(self.length * 4.5 / (1.0 + 4.5 * (rate / self.rate) ** (2.0 / 3.0)))

    def braked(self, rate: float) -> tuple[float, float]:
        """When the hoop stress of a thin elastic ring is σ_c, and its rate of strain then [s, 1/s].

        The stress brakes it: ε = ε̇/ω sin ωt with ω = c/r, as a ring breathes; slower ones stop before.

        Args:
            rate: at the beginning [1/s].
        """
        omega = 2.0 * pi * self.celerity / self.circumference
        sine = min(omega * self.tension / self.E / rate, 1.0)
        return asin(sine) / omega, rate * sqrt(1.0 - sine**2)

    def body(self, size: float, seed: int) -> bd.Lattice:
        """Its cells, of a size [m]."""
        radius, side = self.circumference / (2.0 * pi), self.side
        bore = bd.Cylinder(radius=radius - 0.5 * side, length=3.0 * side).moved((-side, 0.0, 0.0))
        shape = bd.Cylinder(radius=radius + 0.5 * side, length=side).cut(bore, name="bore")
        count = round(self.circumference * side**2 / size**3)
        return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


@dataclass(frozen=True)
class RingRun(Request):
    """A ring whose cells are given radial velocities.

    Attributes:
        ring: what flies apart.
        rate: of strain at the beginning [1/s].
        size: of cells [m].
        seed: of the packing.
    """

    ring: Ring
    rate: float
    size: float
    seed: int

    @property
    def weight(self) -> float:
        return self.size**-4 / self.rate

    def measured(self, folder: Path) -> dict[str, Any]:
        ring, body = self.ring, self.ring.body(self.size, self.seed)
        failure = bd.Rankine(tension=ring.tension, fracture_energy=ring.fracture_energy)
        model = bd.Model(body, bd.CellBond(E=ring.E, nu=ring.nu), ring.rho, failure=failure)
        state = model.state()
        velocity = self.rate * body.centre
        velocity[:, 0] = 0.0
        state.set_motion(velocity=velocity)
        duration = _UNTIL * ring.tension / ring.E / self.rate + _PASSAGES * ring.side / ring.celerity
        run = bd.solve_explicit(model, duration=duration, every=5, state=state)
        pieces = bd.fragments(body, run.state)
        cells = np.bincount(pieces.label)
        whole = cells >= _CHIP
        mass = np.sort(pieces.mass[whole])[::-1]
        until, slowed = ring.braked(self.rate)
        energy = run.history.energy
        moving = energy["translation"] + energy["rotation"]
        torn = len(mass) * ring.side**2 * ring.fracture_energy
        return plain({
            "count": len(body.particles), "steps": run.state.step, "residual": run.residual, "pieces": len(mass),
            "over": ring.circumference / len(mass) / ring.length, "formula": ring.size(self.rate) / ring.length,
            "slowed": self.rate * sqrt(float(np.interp(until, run.history.time, moving) / moving[0])),
            "slowed_thin": slowed, "dissipated": float(run.history.released[-1]) / torn,
            "mass": rounded(mass / mass.mean(), 4),
        })  # fmt: skip
