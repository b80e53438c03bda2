"""Rotation of vectors with their elements."""

from bondem._types import Floats
from bondem.model.turned_frames import turned_rows


def turned_vectors(quaternion: Floats, vectors: Floats) -> Floats:
    """Return vectors (k, 3), each rotated by its unit quaternion (w, x, y, z), (k, 4)."""
    return turned_rows(quaternion, vectors)
