"""States of a model in the pose of a static solution."""

from bondem.boundary.frozen_conditions import frozen_conditions
from bondem.geometry.rotations import turned_further
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import SmallMotion


def posed(model: Model, motion: SmallMotion) -> State:
    """Return the state at rest in the pose of a static solution.

    Args:
        model: model of the state.
        motion: displacements and rotation vectors of its elements, of any size.
    """
    state, order = State(model), model.layout.order
    state.pose[:, :3] += motion.displacement[order]
    state.pose[:, 4:] = turned_further(state.pose[:, 4:], motion.rotation[order])
    return state


def in_equilibrium(model: Model, motion: SmallMotion, factor: float = 1.0) -> State:
    """Return the state at rest in an equilibrium under `factor` times the final conditions of a model.

    The model of the returned state has conditions that are constant at these values. A run of that model begins with
    the walls, loads and strains of the equilibrium.

    Args:
        model: model that is in equilibrium.
        motion: displacements and rotation vectors of its elements, of any size.
        factor: factor of the values at the end of all schedules [-].
    """
    frozen = frozen_conditions(model.boundary, factor)
    return posed(model if frozen == model.boundary else model.with_boundary(frozen), motion)
