"""Plane polygons cut into triangles by clipping ears, also where they are not convex.

A fan from one corner, which common readers use, covers places outside of a polygon that is not convex.
Reference: Meisters, Am. Math. Monthly 82 (1975) 648–651.
"""

import numpy as np

from bondem._types import Floats, Ints


def ears(corner: Floats) -> Ints:
    """Return k - 2 triangles of a polygon with corners (k, 3), as numbers of its corners, (k - 2, 3)."""
    count = len(corner)
    if count == 3:
        return np.array([[0, 1, 2]])
    flat = _flat(corner)
    left, found = list(range(count)), []
    while len(left) > 3:
        at = _ear(flat, left)
        found.append((left[at - 1], left[at], left[(at + 1) % len(left)]))
        del left[at]
    return np.array([*found, tuple(left)])


def _flat(corner: Floats) -> Floats:
    """Project a polygon (k, 3) onto the coordinate plane nearest to it, so that it runs counter-clockwise, (k, 2)."""
    arm = corner - corner[0]
    normal = np.cross(arm, np.roll(arm, -1, axis=0)).sum(axis=0)
    axis = int(np.abs(normal).argmax())
    flat = arm[:, [(axis + 1) % 3, (axis + 2) % 3]]
    return flat if normal[axis] > 0.0 else flat[:, ::-1]


def _ear(flat: Floats, left: list[int]) -> int:
    """Return the index in `left` of a convex corner with no other corner in its triangle, else of the most convex."""
    b = flat[left]
    a, c = np.roll(b, 1, axis=0), np.roll(b, -1, axis=0)
    turn = _turn(a, b, c)
    bent = np.flatnonzero(turn < 0.0)
    for k in np.argsort(-turn, kind="stable"):
        if turn[k] <= 0.0:
            break
        inside = bent[(bent != (k - 1) % len(b)) & (bent != (k + 1) % len(b))]
        p = b[inside]
        sides = [_turn(a[k], b[k], p), _turn(b[k], c[k], p), _turn(c[k], a[k], p)]
        same = np.zeros(len(p), dtype=bool)  # a seam to a hole lists its corners twice
        for own in (a[k], b[k], c[k]):
            same |= (p == own).all(axis=1)
        if not (np.all(np.array(sides) >= 0.0, axis=0) & ~same).any():
            return int(k)
    return int(turn.argmax())  # crossed or without area: any triangle is as good


def _turn(a: Floats, b: Floats, c: Floats) -> Floats:
    """Return twice the area of the triangles a, b, c in the plane, positive if counter-clockwise."""
    u, v = b - a, c - a
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
