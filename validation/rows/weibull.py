"""Bars whose strengths scatter after Weibull, pulled apart, as rows of a study."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import UnstableRunError
from validation.frame.files import plain
from validation.frame.request import Request

# Packings of a bar; fields of strengths take them in turn.
_PACKINGS = 3
# Load over its peak at which a run ends, and load factors that count as one.
_UNTIL, _TOGETHER = 0.7, 0.01
# How far the bar is pulled at a load factor of 1 [m]: nothing depends on it.
_WAY = 1e-6
# Of spheres: modulus [Pa] and strength [Pa] that a packing of these bonds is expected to have; traverses of sound
# until then, share of the rise in which the speed grows, of critical damping, and of the peak at which a run ends.
_MACRO, _EXPECTED, _TRAVERSES, _BEGIN, _DAMPING, _ENDING = 5e9, 3e6, 40.0, 0.2, 0.05, 0.5


@dataclass(frozen=True)
class Ceramic:
    """Material with strengths after Weibull.

    Attributes:
        E, nu, rho: alumina's [Pa, -, kg/m³].
        tension: s₀, what a volume V₀ survives with probability 1/e [Pa].
        volume: V₀ [m³].
        modulus: m [-].
        energy: G_f of the softening [J/m²]; 0 for brittle facets.
    """

    E: float = 380e9
    nu: float = 0.22
    rho: float = 3900.0
    tension: float = 300e6
    volume: float = 1e-6
    modulus: float = 10.0
    energy: float = 0.0

    def expected(self, volume: float) -> float:
        """Mean strength of a weakest link of some volume [m³] over s₀ [-]."""
        return math.gamma(1.0 + 1.0 / self.modulus) * (self.volume / volume) ** (1.0 / self.modulus)

    def scatter(self, seed: int, reach: float) -> bd.Weibull:
        """Strengths of a seed, with flaws that reach so far [m]; 0 for independent ones."""
        return bd.Weibull(modulus=self.modulus, volume=self.volume, seed=seed, correlation=reach or None)


@dataclass(frozen=True)
class WeibullRun(Request):
    """A bar of cells twice as long as wide, and a field of strengths.

    Attributes:
        ceramic: material.
        bar: volume of the bar [m³].
        size: size of its cells [m].
        reach: correlation length of the strengths [m]; 0 for independent ones.
        seed: seed of the strengths.
    """

    ceramic: Ceramic
    bar: float
    size: float
    reach: float
    seed: int

    @property
    def asked(self) -> dict[str, Any]:
        return {
            "bonds": "cells", "modulus": self.ceramic.modulus, "energy": self.ceramic.energy, "bar": self.bar,
            "size": self.size, "reach": self.reach, "seed": self.seed, "count": round(self.bar / self.size**3),
        }  # fmt: skip

    @property
    def width(self) -> float:
        """Edge of its section [m]."""
        return float((0.5 * self.bar) ** (1.0 / 3.0))

    def body(self) -> bd.Lattice:
        """Its cells."""
        shape = bd.Box((2.0 * self.width, self.width, self.width))
        packed = bd.pack(shape, count=self.asked["count"], method="even", seed=1 + self.seed % _PACKINGS)
        return bd.connect(packed, method="laguerre")

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: strength over s₀, the stress of the first failure and the weakest facet over s₀."""
        ceramic, body = self.ceramic, self.body()
        ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=_WAY)]
        failure = bd.Rankine(
            tension=ceramic.tension, fracture_energy=ceramic.energy or None,
            scatter=ceramic.scatter(self.seed, self.reach),
        )  # fmt: skip
        model = bd.Model(body, bd.CellBond(E=ceramic.E, nu=ceramic.nu), ceramic.rho, failure=failure, boundary=ends)
        path = bd.solve_quasistatic(model, bd.Face("x_max"), together=_TOGETHER, until=_UNTIL)
        unit = self.width**2 * ceramic.tension
        assert model.softening is not None
        return plain({
            "strength": path.peak / unit, "first": path.load[0] / unit, "events": len(path.load), "end": path.end,
            "weakest": float(model.softening.strength.min()) / ceramic.tension,
        })  # fmt: skip


@dataclass(frozen=True)
class WeibullSpheres(Request):
    """A bar of bonded spheres three times as long as wide, and a field of strengths; explicit and damped.

    Bonds of a random packing carry unequal stresses, so that the strength is taken over that of the same packing with
    equal bonds.

    Attributes:
        ceramic: of which only V₀ and m count.
        count: number of spheres.
        reach: correlation length of the strengths over the mean length of bonds [-]; 0 for independent ones.
        seed: seed of the strengths.
    """

    ceramic: Ceramic
    count: int
    reach: float
    seed: int

    @property
    def asked(self) -> dict[str, Any]:
        return {
            "bonds": "spheres", "modulus": self.ceramic.modulus, "energy": 0.0, "bar": 3.0 * self.width**3,
            "size": 0.0, "reach": self.reach, "seed": self.seed, "count": self.count,
        }  # fmt: skip

    @property
    def width(self) -> float:
        """Edge of its section [m]; spheres are as large in every bar."""
        return float(0.01 * (self.count / 1000.0) ** (1.0 / 3.0))

    def measured(self, folder: Path) -> dict[str, Any]:
        """See `Request`: strength over that of the same packing with equal bonds."""
        shape = bd.Box((3.0 * self.width, self.width, self.width))
        body = bd.connect(bd.pack(shape, count=self.count, seed=1 + self.seed % _PACKINGS))
        scatter = self.ceramic.scatter(self.seed, self.reach * float(body.length.mean()))
        equal, found = (self._pulled(body, one) for one in (None, scatter))
        return plain({"strength": found / equal, "equal": equal})

    def _pulled(self, body: bd.Lattice, scatter: bd.Weibull | None) -> float:
        length, density = 3.0 * self.width, 2500.0
        sound = math.sqrt(_MACRO / (0.63 * density))
        rise = _TRAVERSES * length / sound
        speed = _EXPECTED / _MACRO * length / rise
        failure = bd.PeripheralStress(tension=50e6, shear=100e6, scatter=scatter)
        law = bd.EulerBernoulli(E=60e9, nu=0.3, radius_ratio=0.5)
        model = bd.Model(body, law, density, failure=failure, boundary=[
            bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
            bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, speed, _BEGIN * rise)),
        ])  # fmt: skip
        run = bd.solve_explicit(
            model, duration=6.0 * rise, every=20, gauges={"end": bd.Gauge(bd.Face("x_max"), "force")},
            until=bd.LoadDrop({"end": (1.0, 0.0, 0.0)}, _ENDING, 0.3 * _EXPECTED * self.width**2),
            damping=bd.MassDamping(alpha=2.0 * _DAMPING * math.pi * sound / length),
        )  # fmt: skip
        if run.status.failed:
            raise UnstableRunError(run.message)
        return float(np.max(run.history["end"][:, 0])) / self.width**2
