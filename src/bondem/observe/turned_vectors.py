"""Vectors that turn with their elements."""

import numpy as np

from bondem._types import Floats
from bondem.laws.rotations import rotate


def turned_vectors(quaternion: Floats, vectors: Floats) -> Floats:
    """Vectors (k, 3), each turned by its unit quaternion (w, x, y, z), (k, 4)."""
    return np.stack(rotate(*quaternion.T, *vectors.T), axis=1)
