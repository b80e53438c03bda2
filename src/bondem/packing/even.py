"""Centres for cells, spread evenly and at random through a shape, each at the centroid of its own cell.

From random places, soft spheres push each other apart for a while; they need not reach equilibrium. Then every centre
moves to the centroid of its Voronoi cell, several times (Lloyd). The cells are round and of nearly equal size. The
spheres need not jam, because facets carry the load of a body of cells.
"""

from collections.abc import Callable

import numpy as np
from scipy.spatial import KDTree

from bondem._types import Floats, Ints, PerElement
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.start import random_centres, thrown
from bondem.specimen.particles import Particles, filled
from bondem.specimen.tessellation.cutting import cell_centroids

# Volume fraction at which soft spheres push each other apart, and their initial depth inside walls over their radius.
_PUSHED, _START = 0.64, 0.6
# Rms force over mean contact force at which relaxation ends, its largest number of steps, and Lloyd's steps.
_ROUGH, _STEPS, _LLOYD = 0.1, 300, 6
# Radius over half the distance of the nearest two centres, and over the depth of the centre nearest to a wall: cells
# need centres at least a third of a radius inside.
_TOUCHING, _INSIDE = 1.1, 3.0
# Least depth of centres inside walls while they move, over the usual radius.
_MARGIN = 0.4
# Distance below which two centres count as one, over the usual radius.
_ONTO = 1e-3


def even(shape: Shape, count: int, random: np.random.Generator, report: Callable[[float], None]) -> Particles:
    """Pack equal spheres, no two of which overlap by more than a tenth of their diameter.

    Args:
        shape: shape to fill.
        count: number of spheres.
        random: random generator.
        report: function called with the completed share.

    Raises:
        InputError: The spheres are too large for the shape, or a part of it received no centre.
    """
    spheres = thrown(shape, np.ones(count), _PUSHED, random, inside=_START)
    spheres.relax(1.0, tolerance=_ROUGH, steps=_STEPS)
    width = spheres.mean_radius
    margin = np.full(count, _MARGIN * width)
    x = moved_inside(shape, spheres.sphere[:, :3], spheres.sphere[:, :3], margin)
    lost = _lost(shape, x, width)
    if lost.size:
        x[lost] = random_centres(shape, np.full(lost.size, _START * width), random)
    for step in range(_LLOYD):
        report((step + 1) / (_LLOYD + 2))
        x = moved_inside(shape, cell_centroids(points_of(shape, x, width)), x, margin)
    return filled(Particles(x, usual_radius(shape, x, width), shape.period), shape)


def _lost(shape: Shape, x: Floats, width: float) -> Ints:
    """Return the indices of centres that lie outside the shape, or that walls pushed onto another centre."""
    close = KDTree(x, boxsize=shape.period).query_pairs(_ONTO * width, output_type="ndarray")
    return np.union1d(np.flatnonzero(shape.depth(x) < 0.0), close.max(axis=1, initial=-1))


def points_of(shape: Shape, x: Floats, width: float) -> Particles:
    """Return particles at centres `x` (n, 3) [m] of radius 1e-3 `width` [m], so small that they cannot overlap."""
    return filled(Particles(x, 1e-3 * width, shape.period), shape)


def moved_inside(shape: Shape, x: Floats, before: Floats, margin: PerElement) -> Floats:
    """Return centres `x` (n, 3) [m], changed where walls are nearer than `margin` (n,) [m].

    Such a centre moves only half-way from `before` (n, 3) [m], or not at all, and is pushed inwards if that is not
    enough. In a periodic cell centres are only wrapped into it.
    """
    if shape.period is not None:
        return np.mod(x, shape.period)
    x = x.copy()
    for share in (0.5, 0.0):
        close = np.flatnonzero(shape.depth(x) < margin)
        x[close] = before[close] + share * (x[close] - before[close])
    for _ in range(10):
        depth = shape.depth(x)
        close = np.flatnonzero(depth < margin)
        if not close.size:
            break
        wanted, at = margin[close], depth[close]
        tiny = 1e-3 * wanted
        slope = np.column_stack([
            (shape.depth(x[close] + tiny[:, None] * axis) - at) / tiny for axis in np.eye(3)
        ])  # fmt: skip
        steep = np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 0.1)
        pushed = x[close] + (1.01 * wanted - at)[:, None] * slope / steep**2
        deeper = shape.depth(pushed) > at
        x[close[deeper]] = pushed[deeper]
    return x


def usual_radius(shape: Shape, x: Floats, width: float) -> float:
    """Return the radius of equal spheres at `x` (n, 3), as large as neighbours and walls allow [m].

    A single sphere has at most the radius `width` [m].
    """
    if len(x) == 1:
        return float(min(width, shape.depth(x)[0]))
    nearest = float(KDTree(x, boxsize=shape.period).query(x, k=2)[0][:, 1].min())
    radius = 0.5 * _TOUCHING * nearest
    return float(min(radius, _INSIDE * shape.depth(x).min()))
