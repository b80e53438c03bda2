"""Forces of loads on the free facets of cells."""

from dataclasses import replace

import numpy as np

from bondem._types import Floats
from bondem.boundary.conditions import Load
from bondem.boundary.loads import Pressure
from bondem.geometry.rotations import turned_vectors
from bondem.model.model import Model


def loads_on_facets(model: Model, time: float | None = None, orientation: Floats | None = None) -> Floats:
    """Return the forces of loads on free facets [N], (k, 3), at `time` [s]; None means the end of all schedules.

    Given orientations (n, 4), following pressures and the forces of moments rotate with their cells. Without
    orientations these forces are in the axes of their cells.
    """
    law, cell = model.interaction, model.lattice.elements.surface
    force = np.zeros((len(cell), 3))
    for condition in model.boundary:
        if isinstance(condition, Load | Pressure):
            numbers, values = law.facet_forces(condition)
            schedule = condition.schedule
            if orientation is not None and isinstance(condition, Pressure) and condition.follows:
                values = turned_vectors(orientation[cell[numbers]], values)
            if orientation is not None and isinstance(condition, Load) and any(condition.moment):
                _, turning = law.facet_forces(replace(condition, force=(0.0, 0.0, 0.0)))
                values = values - turning + turned_vectors(orientation[cell[numbers]], turning)
            force[numbers] += (schedule.final if time is None else schedule.at(time)) * values
    return force
