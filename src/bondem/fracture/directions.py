"""Unit vectors of directions that users give."""

import numpy as np

from bondem._checks import vector
from bondem._types import Floats
from bondem.errors import InputError


def unit_vector(owner: str, name: str, value: object) -> Floats:
    """Return a direction as a unit vector, (3,); raise InputError if it is not finite or has no length."""
    found = np.array(vector(owner, name, value))
    size = float(np.linalg.norm(found))
    if size == 0.0:
        raise InputError(f"{owner}: {name} has no length; give a direction such as (1, 0, 0)")
    return found / size
