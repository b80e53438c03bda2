"""What is read off a body as it is loaded: force and displacement of the driven region, and gauges."""

from collections.abc import Mapping

import numpy as np

from bondem._checks import instance
from bondem._types import Floats
from bondem.errors import InputError
from bondem.model.boundary import Drive, Load
from bondem.model.loads import Pressure, facet_numbers
from bondem.model.model import Model
from bondem.quasistatic.damaged_body import Loaded
from bondem.specimen.regions import Region


class Reading:
    """Force and displacement of the region that is driven or loaded, at a load factor of 1."""

    def __init__(self, model: Model, drive: Region) -> None:
        """Find the conditions of a region.

        Raises:
            InputError: no wall that moves and no load on this region.
        """
        assert model.cells is not None
        motion, force = np.zeros(3), np.zeros(3)
        for condition in model.boundary:
            if getattr(condition, "region", None) != drive:
                continue
            if isinstance(condition, Drive):
                for axis, schedule, _ in condition.motion:
                    if axis < 3:
                        motion[axis] += schedule.final
            elif isinstance(condition, Load | Pressure):
                _, values = condition.on_facets(model.lattice)
                force += condition.schedule.final * values.sum(axis=0)
        self._size = float(np.linalg.norm(motion))
        self._walls = self._size > 0.0
        way = motion if self._walls else force
        if not way.any():
            raise InputError(
                "solve_quasistatic: nothing drives or loads drive= along a way; give the region of a bd.Drive or bd.Load"
                " of the model"
            )
        self._way = way / np.linalg.norm(way)
        facets = facet_numbers(drive, model.lattice)
        self._force = float(np.linalg.norm(force))
        if self._walls:
            self._held = np.isin(model.cell_constants.grips.holds.facet, facets)
        else:
            assert model.lattice.cells is not None
            free = model.lattice.cells.free
            self._cell = model.layout.rank[free.cell[facets]]
            self._lever = (free.centroid - model.lattice.cells.centroid[free.cell])[facets]
            self._weight = free.area[facets] / free.area[facets].sum()

    def read(self, found: Loaded, motion: Floats) -> tuple[float, float]:
        """Load [N] and displacement [m]."""
        if self._walls:
            return float(found.wall[self._held].sum(axis=0) @ self._way), self._size
        own = motion.reshape(-1, 6)[self._cell]
        moved = own[:, :3] + np.cross(own[:, 3:], self._lever)
        return self._force, float(self._weight @ moved @ self._way)


class Gauges:
    """Displacements between two regions, mean over the elements of each."""

    def __init__(self, model: Model, gauges: Mapping[str, tuple[Region, Region]]) -> None:
        """Find the elements."""
        instance("solve_quasistatic", "gauges", gauges, Mapping, '{"CMOD": (bd.Within(...), bd.Within(...))}')
        self._ends = {}
        for name, ends in gauges.items():
            wanted = "two regions"
            if not (isinstance(ends, tuple) and len(ends) == 2 and all(isinstance(one, Region) for one in ends)):
                raise InputError(f"solve_quasistatic: gauge '{name}' needs {wanted}, such as (bd.Face('x_min'), bd.Face('x_max'))")
            self._ends[name] = tuple(model.layout.rank[one.select(model.lattice)] for one in ends)

    def read(self, motion: Floats) -> dict[str, Floats]:
        """How far each second region has moved from its first [m], (3,) each."""
        moved = motion.reshape(-1, 6)[:, :3]
        return {name: moved[b].mean(axis=0) - moved[a].mean(axis=0) for name, (a, b) in self._ends.items()}
