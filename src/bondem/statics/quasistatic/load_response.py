"""Response of a body during loading: force and displacement of the driven region, and gauges."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, vstack

from bondem._types import Floats, Ints, Mask
from bondem.boundary.conditions import Drive, Load
from bondem.boundary.loads import Pressure, facet_numbers
from bondem.boundary.wall_constraints import supports_facets
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded


class Reading:
    """Force and displacement of the region that is driven or loaded, at a load factor of 1."""

    def __init__(self, body: DamagedBody, drive: Region) -> None:
        """Collect the conditions on the region `drive` that move or load it.

        Raises:
            InputError: No condition drives or loads this region.
        """
        self._body, model = body, body.model
        motion, force, on_elements = np.zeros(3), np.zeros(3), False
        for condition in model.boundary:
            if getattr(condition, "region", None) != drive:
                continue
            if isinstance(condition, Drive):
                for axis, schedule, _ in condition.motion:
                    if axis < 3:
                        on_elements = on_elements or not supports_facets(condition)
                        motion[axis] += schedule.final
            elif isinstance(condition, Load | Pressure):
                _, values = condition.nodal(model.lattice)
                force += condition.schedule.final * values[:, :3].sum(axis=0)
        self._size = float(np.linalg.norm(motion))
        self._driven = self._size > 0.0
        way = motion if self._driven else force
        if not way.any():
            raise InputError(
                "solve_quasistatic: the region drive= is neither driven nor loaded; give the region of a bd.Drive or"
                " bd.Load of the model"
            )
        self._way, self._force = way / np.linalg.norm(way), float(np.linalg.norm(force))
        self._element = model.layout.rank[drive.select(model.lattice)]
        self._wall: Mask | None = None
        if self._driven and not on_elements:
            self._wall = np.isin(model.interaction.supports.fixed.facet, facet_numbers(drive, model.lattice))

    def read(self, found: Loaded, motion: Floats) -> tuple[float, float]:
        """Return load [N] and displacement [m] along the direction of the drive or load, at a factor of 1."""
        if not self._driven:
            moved = motion.reshape(-1, 6)[self._element, :3].mean(axis=0)
            return self._force, float(moved @ self._way)
        if self._wall is not None:
            return float(found.wall[self._wall].sum(axis=0) @ self._way), self._size
        unbalanced = (self._body.matrix.force(motion) - self._body.right).reshape(-1, 6)
        return float(unbalanced[self._element, :3].sum(axis=0) @ self._way), self._size


@dataclass(frozen=True, eq=False)
class MeasuringPoints(Region):
    """Material points whose mean displacement is measured; each moves rigidly with its element.

    Attributes:
        element: element of each point, user's order, (k,).
        position: points in the reference [m], (k, 3).
        weight: share of each point in the mean, with the sum 1 [-], (k,).
    """

    element: Ints
    position: Floats
    weight: Floats

    def mask(self, lattice: Lattice) -> Mask:
        """Return a mask of the elements that carry points, (n,)."""
        return np.isin(np.arange(len(lattice.particles)), self.element)

    @classmethod
    def of(cls, region: Region, lattice: Lattice) -> "MeasuringPoints":
        """Return the centres of the elements of a region, equally weighted, or given measuring points unchanged."""
        if isinstance(region, MeasuringPoints):
            return region
        element = region.select(lattice)
        return cls(element, lattice.centre[element], np.full(len(element), 1.0 / len(element)))


class PointGauges:
    """Gauges of the displacement between two regions, each the mean of the centres of its elements or of points."""

    def __init__(self, model: Model, gauges: Mapping[str, tuple[Region, Region]]) -> None:
        """Compute the matrix that gives all displacements from the motions of elements.

        Raises:
            InputError: A gauge is not a pair of regions.
        """
        self._names, rows = list(gauges), [csr_array((0, 6 * len(model.layout.order)))]
        for name, ends in gauges.items():
            pair = isinstance(ends, tuple) and len(ends) == 2
            if not (pair and all(isinstance(one, Region) for one in ends)):
                raise InputError(
                    f"solve_quasistatic: gauge '{name}' needs two regions, such as"
                    " (bd.Face('x_min'), bd.Face('x_max'))"
                )
            first, second = (_mean_motion(model, MeasuringPoints.of(one, model.lattice)) for one in ends)
            rows.append(csr_array(second - first))
        self._matrix = csr_array(vstack(rows))

    def read(self, motion: Floats) -> dict[str, Floats]:
        """Return by gauge the displacement of its second region from its first at small rotations [m], (3,)."""
        return dict(zip(self._names, (self._matrix @ motion).reshape(-1, 3), strict=True))


def _mean_motion(model: Model, points: MeasuringPoints) -> csr_array:
    """Return the matrix (3, 6 n) that gives the mean of u + θ × arm over points from motions (6 n,)."""
    arm = points.position - model.lattice.centre[points.element]
    first, weight = 6 * model.layout.rank[points.element], points.weight
    entries = [(a, a, weight) for a in range(3)]
    for a, b, c in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):  # (θ × arm)_a = θ_b arm_c - θ_c arm_b
        entries += [(a, 3 + b, weight * arm[:, c]), (a, 3 + c, -weight * arm[:, b])]
    rows = np.repeat([a for a, _, _ in entries], len(first))
    columns = np.concatenate([first + b for _, b, _ in entries])
    values = np.concatenate([value for _, _, value in entries])
    return csr_array((values, (rows, columns)), shape=(3, 6 * len(model.layout.order)))
