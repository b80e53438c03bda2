"""Columns of the memory of contacts of elements in a state."""

import numpy as np

from bondem._types import Floats

# First tangential stretch [m] and dashpot force [N], three columns each. START: for spheres, the distance of centres
# at which the contact starts [m] if it is less than usual, else 0; for faces of cells, the overlap that does not
# count [m]. KIND: the normal stiffness of faces [N/m], 0 for spheres, or one of the two numbers below. FACES: code of
# the two faces.
START, KIND, FACES = 6, 7, 8
CONTACT_COLUMNS = 9
# Columns that the core keeps of a pair in one line of the cache.
LINE_COLUMNS = 8
# Kinds of pairs that do not touch: cells with faces between them that are apart, and spheres that are apart.
BETWEEN, NOT_YET = -1.0, -2.0


def in_contact(stretch: Floats) -> np.ndarray:
    """Return a mask of the pairs that touch, given the memory of all stored pairs, (c, CONTACT_COLUMNS)."""
    return stretch[:, KIND] >= 0.0
