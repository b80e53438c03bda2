"""Convex polygons in space: rows of an array of corners, counter-clockwise seen against their normal."""

import math
from typing import Any

import numpy as np

from bondem._compile import loop

#: Most corners of one polygon; a buffer that `clip` writes to has at least as many rows.
MOST_CORNERS = 512
#: The first row, and the corners of a triangle and of a square. Plain numbers in their place would make a variant of
#: each function that they are handed to, compiled for this number alone.
ROW, TRIANGLE, SQUARE = np.int64(0), np.int64(3), np.int64(4)


@loop(parallel=False)
def clip(source, start, size, target, a, b, c, d):
    """Cut a polygon by a plane: the part with a x + b y + c z <= d.

    Args:
        source: corners (v, 3), of which the polygon has the rows from `start` on.
        start: first row of the polygon.
        size: number of its rows.
        target: array to fill from row 0 on, different from `source`.
        a, b, c, d: the plane.

    Returns:
        Number of corners written; below three the polygon is empty.
    """
    written = 0
    last = start + size - 1
    px, py, pz = source[last, 0], source[last, 1], source[last, 2]
    sp = a * px + b * py + c * pz - d
    for k in range(start, start + size):
        qx, qy, qz = source[k, 0], source[k, 1], source[k, 2]
        sq = a * qx + b * qy + c * qz - d
        if written + 2 > target.shape[0]:
            break
        if (sp <= 0.0) != (sq <= 0.0):
            t = sp / (sp - sq)
            target[written, 0] = px + t * (qx - px)
            target[written, 1] = py + t * (qy - py)
            target[written, 2] = pz + t * (qz - pz)
            written += 1
        if sq <= 0.0:
            target[written, 0], target[written, 1], target[written, 2] = qx, qy, qz
            written += 1
        px, py, pz, sp = qx, qy, qz, sq
    return written if written >= 3 else 0


@loop(parallel=False)
def square(a, b, c, d, half, target):
    """Write a square of half-width `half` on the plane a x + b y + c z = d, around the foot of the origin."""
    if abs(a) < 0.6:
        ux, uy, uz = 0.0, c, -b
    else:
        ux, uy, uz = -c, 0.0, a
    size = half / math.sqrt(ux * ux + uy * uy + uz * uz)
    ux, uy, uz = ux * size, uy * size, uz * size
    wx, wy, wz = b * uz - c * uy, c * ux - a * uz, a * uy - b * ux
    for k in range(4):
        s = 1.0 if k in (0, 3) else -1.0
        t = 1.0 if k < 2 else -1.0
        target[k, 0] = d * a + s * ux + t * wx
        target[k, 1] = d * b + s * uy + t * wy
        target[k, 2] = d * c + s * uz + t * wz


@loop(parallel=False)
def height(source, start, size, a, b, c, d):
    """Return the lowest and highest value of a x + b y + c z - d over the corners of a polygon [m]."""
    low, high = np.inf, -np.inf
    for k in range(start, start + size):
        s = a * source[k, 0] + b * source[k, 1] + c * source[k, 2] - d
        low, high = min(low, s), max(high, s)
    return low, high


@loop(parallel=False)
def area(source, start, size):
    """Return the area of a polygon [m²]."""
    ox, oy, oz = source[start, 0], source[start, 1], source[start, 2]
    x, y, z = 0.0, 0.0, 0.0
    for k in range(start + 1, start + size - 1):
        px, py, pz = source[k, 0] - ox, source[k, 1] - oy, source[k, 2] - oz
        qx, qy, qz = source[k + 1, 0] - ox, source[k + 1, 1] - oy, source[k + 1, 2] - oz
        x += py * qz - pz * qy
        y += pz * qx - px * qz
        z += px * qy - py * qx
    return 0.5 * math.sqrt(x * x + y * y + z * z)


@loop(parallel=False)
def copy(source, start, size, target, at):
    """Copy the corners of a polygon to rows of `target` from `at` on."""
    for k in range(size):
        for c in range(3):
            target[at + k, c] = source[start + k, c]


@loop(parallel=False)
def reverse(source, size):
    """Reverse the corners of the polygon in the first rows, and thereby its normal."""
    for k in range(size // 2):
        for c in range(3):
            source[k, c], source[size - 1 - k, c] = source[size - 1 - k, c], source[k, c]


@loop(parallel=False)
def roomy(values, needed) -> Any:
    """Return the same rows, (k, c), or a longer copy if there are fewer than `needed`."""
    if values.shape[0] >= needed:
        return values
    longer = np.empty((2 * needed, values.shape[1]), values.dtype)
    for k in range(values.shape[0]):
        for c in range(values.shape[1]):
            longer[k, c] = values[k, c]
    return longer


@loop(parallel=False)
def roomy_list(values, needed) -> Any:
    """Return the same numbers, (k,), or a longer copy if there are fewer than `needed`."""
    if values.shape[0] >= needed:
        return values
    longer = np.empty(2 * needed, values.dtype)
    for k in range(values.shape[0]):
        longer[k] = values[k]
    return longer
