"""Plane faces of shapes with the whole shape on one side, and rotations about an axis."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from bondem._types import Floats, PerElement, PerElement3, Vector

#: Plane faces by name: a point [m] and the outward normal, (3,) each.
Planes = dict[str, tuple[Vector, Vector]]


def box_side(face: str) -> tuple[int, int]:
    """Return the axis (0 … 2) and the end (0 or 1) of a side of a box, "x_min" … "z_max"."""
    return "xyz".index(face[0]), int(face.endswith("max"))


def depth_below_side(bounds: tuple[Vector, Vector], face: str, points: PerElement3) -> PerElement:
    """Return the distance of points (n, 3) from a side of a box with corners `bounds`, positive inside [m], (n,)."""
    axis, end = box_side(face)
    x = np.atleast_2d(points)[:, axis]
    return bounds[1][axis] - x if end else x - bounds[0][axis]


def box_planes(bounds: tuple[Vector, Vector], faces: Sequence[str]) -> Planes:
    """Return the planes of a box for the named `faces`, some of "x_min" … "z_max"."""
    found = {}
    for face in faces:
        (axis, end), out = box_side(face), np.zeros(3)
        out[axis] = 2.0 * end - 1.0
        found[face] = (bounds[end], out)
    return found


def placed(planes: Planes, turn: Floats, by: Vector) -> Planes:
    """Return planes rotated by a matrix (3, 3) about the origin and then moved by (3,) [m]."""
    return {name: (turn @ point + by, turn @ out) for name, (point, out) in planes.items()}


def shared(some: Planes, others: Mapping[str, tuple[Vector, Vector]], tiny: float) -> set[str]:
    """Return the names of the planes that coincide with one of `others`, to `tiny` [m], with the same normal."""
    return {
        name for name, (point, out) in some.items()
        if any(out @ other > 1.0 - 1e-12 and abs((point - at) @ other) < tiny for at, other in others.values())
    }  # fmt: skip


def turn_about(axis: str, angle: float) -> Floats:
    """Return the matrix of a right-handed rotation by an angle [rad] about "x", "y" or "z", exact at right angles."""
    c, s = (np.rint(v) if abs(v - np.rint(v)) < 1e-15 else v for v in (math.cos(angle), math.sin(angle)))
    turn = np.eye(3)
    j, k = ((1, 2), (2, 0), (0, 1))["xyz".index(axis)]
    turn[j, j], turn[j, k], turn[k, j], turn[k, k] = c, -s, s, c
    return turn
