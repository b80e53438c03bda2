"""Soft spheres at rest: the state that the packing kernel advances, and its neighbour lists."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._compile import threads
from bondem._types import Floats
from bondem.kernels import packing as kernels
from bondem.kernels.neighbour_grid import neighbours
from bondem.packing.walls import walls
from bondem.specimen.geometry import Shape

# Gap up to which spheres enter the neighbour list, over the mean radius: wide while they still wander.
_SKIN_WANDERING, _SKIN_SETTLED = 0.5, 0.15

# Spheres from which on threads pay: a step of fewer is too short to wait for each other.
_THREADED = 2000

# Mean overlap below which spheres do not press on each other, over the mean radius.
LOOSE = 2e-5


@dataclass(frozen=True)
class Rest:
    """What a relaxation ended with.

    Attributes:
        coordination_number: 2 contacts / spheres, over all spheres [-].
        mean_overlap: over the contacts, in mean radii [-].
        largest_overlap: in mean radii [-].
        steps: minimisation steps taken.
        settled: whether the forces balance; neither so nor loose, the spheres did not come to rest in time.
        loose: whether the spheres do not press on each other.
    """

    coordination_number: float
    mean_overlap: float
    largest_overlap: float
    steps: int
    settled: bool
    loose: bool


class SoftSpheres:
    """Spheres in a shape, relaxed at one scale of their radii after another.

    Attributes:
        sphere: centres and radii [m], shape (n, 4).
        unit: radii at scale 1 [m], (n,).
        scale: factor on the radii they were made with [-].
        steps: minimisation steps taken so far.
        wall: walls in the form the kernels take.
        period: periodic edge lengths [m], (3,), 0 where there is none.
        on_step: told `steps`, now and then.
    """

    def __init__(self, shape: Shape, centre: Floats, radius: Floats) -> None:
        self.scale, self.steps = 1.0, 0
        self.on_step: Callable[[int], None] = lambda steps: None
        self._shape = shape
        self.sphere = np.column_stack([centre, radius])
        self.unit = radius.copy()
        self._velocity = np.zeros((len(radius), 3))
        self._force = np.zeros((len(radius), 3))
        self._lower, self._upper = shape.bounds
        self.period = np.zeros(3) if shape.period is None else shape.period.copy()
        self.wall = walls(shape, radius)
        self._skin = _SKIN_WANDERING

    def __str__(self) -> str:
        return f"{len(self.sphere)} spheres in {self._shape}"

    @property
    def mean_radius(self) -> float:
        """R̄ at the present scale [m]."""
        return float(self.sphere[:, 3].mean())

    def scale_for(self, volume_fraction: float) -> float:
        """Scale at which the spheres have this share of the volume of the shape [-]."""
        solid = 4.0 / 3.0 * np.pi * float((self.unit**3).sum())
        return float(np.cbrt(volume_fraction * self._shape.volume / solid))

    def relax(self, scale: float, *, tolerance: float, steps: int, loose: float = LOOSE) -> Rest:
        """Bring the spheres to rest with their radii `scale` times the first ones.

        Args:
            scale: factor on the radii the object was made with [-].
            tolerance: rms force over mean contact force at which they count as at rest [-].
            steps: give up after this many.
            loose: mean overlap below which they count as not pressing on each other, over the mean radius [-].
        """
        self.scale = scale
        self.sphere[:, 3] = scale * self.unit
        self._velocity[:] = 0.0
        fire = np.array([kernels.DT_START, kernels.ALPHA, 0.0])
        report = np.zeros(5)
        barely = loose * self.mean_radius
        taken = 0
        with threads(1 if len(self.sphere) < _THREADED else None):
            while True:
                start, neighbour = self.near(self._skin * self.mean_radius)
                slack = 0.499 * self._skin * self.mean_radius
                status = kernels.relax(
                    self.sphere, self._velocity, self._force, self.period, self.wall, start, neighbour,
                    self.sphere[:, :3].copy(), slack, fire, tolerance, barely, steps - taken, report,
                )  # fmt: skip
                done = int(report[4]) + (status == kernels.STALE)
                taken += done
                self.steps += done
                self.on_step(self.steps)
                if status != kernels.STALE:
                    break
        self._skin = _SKIN_SETTLED
        mean = self.mean_radius
        z = 2.0 * float(report[2]) / len(self.sphere)
        free = bool(report[1] < barely)  # no forces at all count as balanced for the kernel
        settled = status == kernels.CONVERGED and not free
        return Rest(z, report[1] / mean, report[3] / mean, taken, settled, free)

    def near(self, skin: float) -> tuple[np.ndarray, np.ndarray]:
        """Neighbours with gaps up to `skin` [m], as `neighbour_grid.neighbours` has them; centres enter the cell."""
        periodic = self.period > 0.0
        self.sphere[:, :3][:, periodic] %= self.period[periodic]
        return neighbours(self.sphere, self._lower, self._upper, self.period, skin)
