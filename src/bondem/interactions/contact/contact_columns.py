"""Columns of the memory of contacts of elements in a state."""

import numpy as np

from bondem._types import Floats

# Tangential stretch [m] and dashpot force [N], three each; where the contact starts: for spheres, the distance of the
# centres [m] if it is less than that of others, else 0, and for faces of cells, the overlap that does not count [m];
# the kind of contact: the normal stiffness of faces [N/m], 0 for spheres, or one of the two below; and the two faces.
START, KIND, FACES = 6, 7, 8
CONTACT_COLUMNS = 9
# Columns that the core keeps of a pair in one line of the cache.
LINE_COLUMNS = 8
# Faces lie between the two cells, which do not touch inside their spheres; and spheres that do not touch yet.
BETWEEN, NOT_YET = -1.0, -2.0


def in_contact(stretch: Floats) -> np.ndarray:
    """Return a mask of the pairs that touch, given the memory of all."""
    return stretch[:, KIND] >= 0.0
