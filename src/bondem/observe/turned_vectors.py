"""Rotation of vectors with their elements."""

import numpy as np

from bondem._types import Floats
from bondem.kernels.turning import turn_vectors


def turned_vectors(quaternion: Floats, vectors: Floats) -> Floats:
    """Return vectors (k, 3), each rotated by its unit quaternion (w, x, y, z), (k, 4)."""
    return turn_vectors(np.ascontiguousarray(quaternion), np.ascontiguousarray(vectors))
