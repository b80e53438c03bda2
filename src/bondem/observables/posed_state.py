"""State of a model that has moved by a static solution."""

from bondem.geometry.rotations import turned_further
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import SmallMotion


def posed(model: Model, motion: SmallMotion) -> State:
    """Return the state at rest whose elements have moved and turned by a solution.

    Args:
        model: model of the state.
        motion: displacements and rotation vectors of its elements, of any size.
    """
    state, order = State(model), model.layout.order
    state.pose[:, :3] += motion.displacement[order]
    state.pose[:, 4:] = turned_further(state.pose[:, 4:], motion.rotation[order])
    return state
