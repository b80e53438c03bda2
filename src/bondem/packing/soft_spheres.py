"""Soft spheres that a compiled pass relaxes to rest, and their neighbour lists."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._checks import shown
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.columns import RelaxationReport
from bondem._tables.packing_tables import Near, Spheres
from bondem._threads import current_threads
from bondem._types import Floats
from bondem.geometry.elementary_shapes import Shape
from bondem.geometry.morton import morton_order
from bondem.geometry.neighbours import neighbours
from bondem.packing.packing_tables import new_relaxing
from bondem.packing.wall_contacts import walls

# Gap up to which spheres enter the neighbour list, over the mean radius, in the first relaxation and later ones.
_SKIN_WANDERING, _SKIN_SETTLED = 0.5, 0.15

# Number of spheres from which threads are used: steps of fewer are too short for synchronisation.
_THREADED = 2000

# Mean overlap below which spheres do not press on each other, over the mean radius.
LOOSE = 2e-5


@dataclass(frozen=True)
class Rest:
    """Result of a relaxation.

    Attributes:
        coordination_number: 2 contacts / spheres, over all spheres [-].
        mean_overlap: mean overlap of the contacts, in mean radii [-].
        largest_overlap: largest overlap, in mean radii [-].
        steps: number of minimisation steps.
        settled: True if forces act and balance. If neither `settled` nor `loose`, the spheres did not come to rest.
        loose: True if the spheres do not press on each other.
    """

    coordination_number: float
    mean_overlap: float
    largest_overlap: float
    steps: int
    settled: bool
    loose: bool


class SoftSpheres:
    """Spheres in a shape, in Morton order, relaxed at a sequence of scales of their radii.

    Attributes:
        shape: the shape that they fill.
        table: centres, radii and velocities of the spheres, for the compiled passes.
        walls: walls of the shape, for the compiled passes.
        scale: factor on the initial radii [-].
        steps: number of minimisation steps so far.
        on_step: function called repeatedly with `steps`.
    """

    def __init__(self, shape: Shape, centre: Floats, radius: Floats) -> None:
        self.scale, self.steps = 1.0, 0
        self.on_step: Callable[[int], None] = lambda steps: None
        self.shape = shape
        self._lower, self._upper = shape.bounds
        period = np.zeros(3) if shape.period is None else shape.period.copy()
        n, sphere = len(radius), np.column_stack([centre, radius])[morton_order(centre)]
        self.table = Spheres(sphere, sphere[:, 3].copy(), np.zeros((n, 3)), np.zeros((n, 3)), period, np.ones(n))
        self.walls = walls(shape, self.unit)
        self._skin = _SKIN_WANDERING

    def __str__(self) -> str:
        return f"{len(self.sphere)} spheres in {shown(self.shape)}"

    @property
    def sphere(self) -> Floats:
        """Centres and radii [m], shape (n, 4)."""
        return self.table.sphere

    @property
    def unit(self) -> Floats:
        """Radii at scale 1 [m], (n,)."""
        return self.table.unit

    @property
    def mean_radius(self) -> float:
        """Mean radius R̄ at the present scale [m]."""
        return float(self.sphere[:, 3].mean())

    @property
    def weighed(self) -> bool:
        """True if large spheres have larger masses."""
        return bool((self.table.ease < 1.0).any())

    def weigh(self, radius: float) -> None:
        """Give spheres larger than `radius` [m] a mass that grows with their surface."""
        self.table.ease[:] = np.minimum(radius / self.unit, 1.0)

    def scale_for(self, volume_fraction: float) -> float:
        """Return the scale of the radii at which the spheres have a volume fraction in the shape [-]."""
        solid = 4.0 / 3.0 * np.pi * float((self.unit**3).sum())
        return float(np.cbrt(volume_fraction * self.shape.volume / solid))

    def relax(self, scale: float, *, tolerance: float, steps: int, loose: float = LOOSE) -> Rest:
        """Bring the spheres to rest with their radii `scale` times the initial ones.

        Args:
            scale: factor on the initial radii [-].
            tolerance: rms force over mean contact force below which the spheres count as at rest [-].
            steps: largest number of minimisation steps.
            loose: mean overlap over the mean radius below which the spheres count as loose [-].
        """
        self.scale = scale
        self.sphere[:, 3] = scale * self.unit
        self.table.velocity[:] = 0.0
        initial = new_relaxing(len(self.sphere), float(tolerance), float(loose * self.mean_radius))
        threads = 1 if len(self.sphere) < _THREADED else current_threads()
        taken, ended = 0, "out_of_date"
        while ended == "out_of_date":
            near = self.near(self._skin * self.mean_radius, 0.499, threads=threads)
            relaxing = initial._replace(steps=steps - taken)
            ended = run_pass(calls.relax_spheres(self.table, self.walls, near, relaxing), threads=threads)
            done = int(initial.report[RelaxationReport.STEPS]) + (ended == "out_of_date")
            taken += done
            self.steps += done
            self.on_step(self.steps)
        self._skin = _SKIN_SETTLED
        mean = self.mean_radius
        _, overlap, contacts, largest, _ = initial.report.tolist()
        z = 2.0 * contacts / len(self.sphere)
        free = overlap < initial.loose  # the pass counts spheres without forces as balanced
        settled = ended == "converged" and not free
        return Rest(z, overlap / mean, largest / mean, taken, settled, free)

    def deepest(self) -> float:
        """Return the largest overlap of two spheres, over the smaller of their radii [-]."""
        near = self.near(0.0, 0.0)
        i = np.repeat(np.arange(len(self.sphere)), np.diff(near.start))
        j = near.neighbour[: len(i)].astype(np.int64)
        branch = self.sphere[j, :3] - self.sphere[i, :3]
        period = self.table.period
        branch -= period * np.rint(branch / np.where(period > 0.0, period, np.inf))
        radius = self.sphere[:, 3]
        overlap = radius[i] + radius[j] - np.linalg.norm(branch, axis=1)
        return float(np.max(overlap / np.minimum(radius[i], radius[j]), initial=0.0))

    def near(self, skin: float, share: float, *, threads: int = 1) -> Near:
        """Return neighbours with gaps up to `skin` [m], valid until a centre has moved by `share` of `skin`.

        Centres are wrapped into the periodic cell first.
        """
        periodic = self.table.period > 0.0
        self.sphere[:, :3][:, periodic] %= self.table.period[periodic]
        start, neighbour = neighbours(self.sphere, self._lower, self._upper, self.table.period, skin, threads=threads)
        return Near(start, neighbour, self.sphere[:, :3].copy(), share * skin)
