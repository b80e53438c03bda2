"""The Brazilian test on a disc with two flats (Wang et al. 2004), pressed between smooth platens.

The stress at the centre is σ = k 2P / (π D t) in plane
stress, with k = (2 cos³α + cos α + sin α/α)² / (8 (cos α + sin α/α)) · α/sin α, 0.960 for flats of 2α = 20°.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

import bondem as bd
from bondem._types import Floats
from bondem.errors import UnstableRunError

#: α, half the angle of a flat [rad].
HALF = math.radians(10.0)
# Traverses of sound until the expected peak, and the share of that time in which the flats get their speed; the test
# ends at this share of the peak, at the latest after this many times until the expected one; strength over E by which
# the flats have come together at the peak [-].
_TRAVERSES, _BEGIN, _ENDING, _LONGEST, _STRAIN = 100.0, 0.1, 0.5, 4.0, 8.0
# The density of a test [kg/m³]: nothing depends on it, as speeds are shares of that of sound.
_DENSITY = 2000.0
#: Whether a test ends, by its state and what it has recorded.
Ended = Callable[[bd.State, bd.History], bool]


@dataclass(frozen=True, eq=False)
class BrazilianTest:
    """Result of a test.

    Attributes:
        peak: stress at the centre by elasticity at the largest load [Pa].
        curve: approach of the flats over the diameter [-] and that stress [Pa], (k, 2).
        asymmetry: largest difference of both forces until the peak, over the peak [-].
        residual: of the energy ledger, over its largest entry [-].
        state: the broken disc.
    """

    peak: float
    curve: Floats
    asymmetry: float
    residual: float
    state: bd.State


@dataclass(frozen=True)
class FlattenedDisc:
    """A disc with its axis along x, and the flats "top" and "bottom" across y.

    Attributes:
        diameter, thickness: [m].
    """

    diameter: float
    thickness: float

    @property
    def factor(self) -> float:
        """k: stress at the centre over that of a whole disc [-]."""
        c, s = math.cos(HALF), math.sin(HALF) / HALF
        return (2.0 * c**3 + c + s) ** 2 / (8.0 * (c + s)) / s

    def stress(self, force: Floats) -> Floats:
        """At the centre [Pa] under a force on the flats [N]."""
        return 2.0 * self.factor * force / (math.pi * self.diameter * self.thickness)

    def body(self, count: int, seed: int) -> bd.Lattice:
        """Its cells."""
        flat, thick = 0.5 * self.diameter * math.cos(HALF), self.thickness
        shape: bd.Shape = bd.Cylinder(radius=0.5 * self.diameter, length=thick)
        block = bd.Box((3.0 * thick, self.diameter, 2.0 * self.diameter))
        for name, y in (("top", flat), ("bottom", -flat - self.diameter)):
            shape = shape.cut(block.moved((-thick, y, -self.diameter)), name=name)
        return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")

    def loaded(
        self, body: bd.Lattice, law: bd.CellBond, failure: bd.Criterion | None, expected: float, *, density: float,
        ended: Ended | None = None, until: tuple[bd.Event, ...] = (),
    ) -> bd.ExplicitResult:  # fmt: skip
        """Flats that come together by some 8 σ / E of the height until the expected stress σ, with forces of both.

        Args:
            body: of this disc.
            law, failure: its material.
            expected: stress at the centre at the peak [Pa], which gives the speed.
            density: [kg/m³].
            ended: whether to stop, asked at each record.
            until: events that end it.
        """
        sound = math.sqrt(law.E / density)
        rise, speed = self._pace(law, expected, density)
        boundary: list[bd.BoundaryCondition] = [
            bd.Drive(bd.Face(name), vy=bd.Ramp(0.0, sign * speed, _BEGIN * rise))
            for name, sign in (("top", -1), ("bottom", 1))
        ]
        model = bd.Model(body, law, density, failure=failure, boundary=boundary)
        return bd.solve_explicit(
            model, duration=_LONGEST * rise, every=40, callback=ended, until=until,
            damping=bd.MassDamping(alpha=0.1 * math.pi * sound / self.diameter),
            gauges={name: bd.Gauge(bd.Face(name), "force") for name in ("top", "bottom")},
        )  # fmt: skip

    def _pace(self, law: bd.CellBond, expected: float, density: float) -> tuple[float, float]:
        """When the expected stress is reached [s], and the speed of each flat [m/s]."""
        rise = _TRAVERSES * self.diameter / math.sqrt(law.E / density)
        return rise, 0.5 * _STRAIN * expected / law.E * self.diameter / rise

    def press(self, body: bd.Lattice, law: bd.CellBond, failure: bd.Criterion, expected: float) -> BrazilianTest:
        """Press a disc until its load has fallen to half of its peak.

        Args:
            body: of this disc.
            law, failure: its material.
            expected: stress at the centre at the peak [Pa], which gives the speed.

        Raises:
            UnstableRunError: the run became unstable.
        """
        rise, speed = self._pace(law, expected, _DENSITY)
        falls = bd.LoadDrop({"top": (0.0, -1.0, 0.0)}, _ENDING, 0.3 * expected / self.stress(np.ones(1)).item())
        run = self.loaded(body, law, failure, expected, density=_DENSITY, until=(falls,))
        if run.status.failed:
            raise UnstableRunError(run.message)
        begin = _BEGIN * rise
        time, both = run.history.time, [-run.history["top"][:, 1], run.history["bottom"][:, 1]]
        moved = np.where(time < begin, 0.5 * time**2 / begin, time - 0.5 * begin) * 2.0 * speed
        force = 0.5 * (both[0] + both[1])
        peak = int(np.argmax(force))
        return BrazilianTest(
            peak=float(self.stress(force[peak])), curve=np.column_stack([moved / self.diameter, self.stress(force)]),
            asymmetry=float(np.abs(both[0] - both[1])[: peak + 1].max() / force[peak]), residual=run.residual,
            state=run.state,
        )  # fmt: skip
