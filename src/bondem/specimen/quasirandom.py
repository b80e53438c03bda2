"""Reproducible points, spread evenly and without a pattern, for integrals over shapes and balls."""

from functools import cache

import numpy as np

from bondem._types import Floats
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.particles import freeze

# Root of x³ = x + 1: the additive sequence of low discrepancy in two dimensions (Roberts 2018).
_PLASTIC = 1.3247179572447460


@cache
def spread_points(count: int) -> Floats:
    """Return points spread evenly over the unit cube, shape (count, 3), by Hammersley's sequence."""
    first = (np.arange(count) + 0.5) / count
    return freeze(np.column_stack([first, _mirrored_digits(count, 2), _mirrored_digits(count, 3)]))


def _mirrored_digits(count: int, base: int) -> Floats:
    """Return 1, 2, ... `count` with their digits in `base` mirrored at the point (van der Corput), (count,)."""
    left, value, place = np.arange(1, count + 1), np.zeros(count), 1.0
    while left.any():
        place /= base
        value += place * (left % base)
        left //= base
    return value


@cache
def ball_points(count: int) -> Floats:
    """Return points spread evenly over the unit ball, (count, 3), `count` even, with the mirror image of each point.

    The share of points on one side of a plane is then that of the ball, on average over all planes. It is one half
    for a plane through the centre.
    """
    u, v, w = spread_points(count // 2).T
    height, angle, distance = 2.0 * u - 1.0, 2.0 * np.pi * v, np.cbrt(w)
    across = np.sqrt(1.0 - height**2)
    half = distance[:, None] * np.column_stack([across * np.cos(angle), across * np.sin(angle), height])
    return freeze(np.concatenate([half, -half]))


@cache
def spread_directions(count: int) -> Floats:
    """Return unit vectors spread evenly over the sphere, shape (count, 3)."""
    u, v = np.mod(0.5 + np.arange(1, count + 1)[:, None] * _PLASTIC ** -np.arange(1.0, 3.0), 1.0).T
    across, angle = 2.0 * np.sqrt(u - u**2), 2.0 * np.pi * v
    return freeze(np.column_stack([across * np.cos(angle), across * np.sin(angle), 2.0 * u - 1.0]))


def spread_rotations(count: int) -> Floats:
    """Return rotation matrices spread evenly over all rotations, shape (count, 3, 3), by Shoemake's quaternions."""
    u, v, w = spread_points(count).T
    a, b = 2.0 * np.pi * v, 2.0 * np.pi * w
    c, s = np.sqrt(1.0 - u), np.sqrt(u)
    x, y, z, q = c * np.sin(a), c * np.cos(a), s * np.sin(b), s * np.cos(b)
    rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * q), 2.0 * (x * z + y * q)],
        [2.0 * (x * y + z * q), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * q)],
        [2.0 * (x * z - y * q), 2.0 * (y * z + x * q), 1.0 - 2.0 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def points_inside(shape: Shape, count: int, depth: float) -> tuple[Floats, float]:
    """Return evenly spread points inside a shape, and the volume that each represents.

    Args:
        shape: shape to sample.
        count: number of points in its bounding box, reduced by `depth` on all sides for a large shape with faces.
        depth: smallest distance from every wall [m].

    Returns:
        Points [m], (k, 3), and the volume of this box over `count` [m³].
    """
    lower, upper = shape.bounds
    # A point of this depth in the shape is at least as deep in its bounding box.
    margin = depth if np.all(upper - lower > 2.0 * depth) and shape.faces else 0.0
    lower, upper = lower + margin, upper - margin
    points = lower + (upper - lower) * spread_points(count)
    return points[shape.depth(points) >= depth], float(np.prod(upper - lower)) / count
