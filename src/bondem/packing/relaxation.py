"""Soft spheres at rest: the state that the packing kernel advances, and its neighbour lists."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._compile import threads
from bondem._types import Floats
from bondem.kernels import packing as kernels
from bondem.kernels.cells import neighbours
from bondem.packing.walls import walls
from bondem.specimen.geometry import Shape

# Gap up to which spheres enter the neighbour list, over the mean radius: wide while they still wander.
_SKIN_WANDERING, _SKIN_SETTLED = 0.5, 0.15

# Spheres from which on threads pay: a step of fewer is too short to wait for each other.
_THREADED = 2000

# Mean overlap below which spheres do not press on each other, over the mean radius.
_LOOSE = 2e-5


@dataclass(frozen=True)
class Rest:
    """What a relaxation ended with.

    Attributes:
        coordination_number: 2 contacts / spheres, over all spheres [-].
        mean_overlap: over the contacts, in mean radii [-].
        largest_overlap: in mean radii [-].
        steps: minimisation steps taken.
        settled: True when the forces balance, False for spheres that do not press on each other or did not
            come to rest in the steps allowed.
    """

    coordination_number: float
    mean_overlap: float
    largest_overlap: float
    steps: int
    settled: bool


class SoftSpheres:
    """Spheres in a shape, relaxed at one scale of their radii after another.

    Attributes:
        sphere: centres and radii [m], shape (n, 4).
    """

    def __init__(self, shape: Shape, centre: Floats, radius: Floats) -> None:
        self.sphere = np.column_stack([centre, radius])
        self._unit = radius.copy()
        self._velocity = np.zeros((len(radius), 3))
        self._force = np.zeros((len(radius), 3))
        self._lower, self._upper = shape.bounds
        self._period = np.zeros(3) if shape.period is None else shape.period.copy()
        self._wall = walls(shape, radius)
        self._skin = _SKIN_WANDERING

    @property
    def mean_radius(self) -> float:
        """R̄ at the present scale [m]."""
        return float(self.sphere[:, 3].mean())

    def relax(self, scale: float, *, tolerance: float, steps: int, progress: Callable[[int], None]) -> Rest:
        """Bring the spheres to rest with their radii `scale` times the first ones.

        Args:
            scale: factor on the radii the object was made with [-].
            tolerance: rms force over mean contact force at which they count as at rest [-].
            steps: give up after this many.
            progress: told the steps taken, now and then.
        """
        self.sphere[:, 3] = scale * self._unit
        self._velocity[:] = 0.0
        fire = np.array([kernels.DT_START, kernels.ALPHA, 0.0])
        report = np.zeros(5)
        loose = _LOOSE * self.mean_radius
        taken = 0
        with threads(1 if len(self.sphere) < _THREADED else None):
            while True:
                start, neighbour = self._list()
                slack = 0.499 * self._skin * self.mean_radius
                status = kernels.relax(
                    self.sphere, self._velocity, self._force, self._period, self._wall, start, neighbour,
                    self.sphere[:, :3].copy(), slack, fire, tolerance, loose, steps - taken, report,
                )  # fmt: skip
                taken += int(report[4]) + (status == kernels.STALE)
                progress(taken)
                if status != kernels.STALE:
                    break
        self._skin = _SKIN_SETTLED
        mean = self.mean_radius
        z = 2.0 * float(report[2]) / len(self.sphere)
        return Rest(z, report[1] / mean, report[3] / mean, taken, status == kernels.CONVERGED)

    def _list(self) -> tuple[np.ndarray, np.ndarray]:
        periodic = self._period > 0.0
        self.sphere[:, :3][:, periodic] %= self._period[periodic]
        return neighbours(self.sphere, self._lower, self._upper, self._period, self._skin * self.mean_radius)
