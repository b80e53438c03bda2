"""Check of pressures that keep their direction although their face has turned."""

import warnings

import numpy as np

from bondem._names import users_line
from bondem.boundary.loads import Pressure
from bondem.errors import TurnedPressureWarning
from bondem.model.model import Model
from bondem.model.state import State

# Angle [rad] by which a tenth of the elements under a pressure turn before it warns: the force is off by as much.
_TURN = 0.1


class PressureCheck:
    """Check of the rotation of elements under pressures that keep their direction."""

    def __init__(self, model: Model) -> None:
        dead = (one for one in model.boundary if isinstance(one, Pressure) and not one.follows)
        self._pressed = [one.region.select(model.lattice) for one in dead]

    def examine(self, state: State) -> None:
        """Issue a warning if elements have rotated too far from the reference configuration.

        Warns:
            TurnedPressureWarning: A tenth of the elements under a pressure have turned by 0.1 rad; issued once.
        """
        turns = [2.0 * np.arccos(np.minimum(np.abs(state.orientation[on, 0]), 1.0)) for on in self._pressed]
        if not turns or max(np.quantile(one, 0.9) for one in turns) < _TURN:
            return
        self._pressed = []
        warnings.warn(
            f"elements under a bd.Pressure have turned by more than {_TURN} rad at t = {state.time:.6g} s, but it"
            " keeps the direction of the reference, so that it may drive the body round and pull on it; give"
            " follows=True (bodies of cells), or hold the body with bd.Fix",
            TurnedPressureWarning, stacklevel=users_line(),
        )  # fmt: skip
