"""The core of a specimen: what lies away from its walls, and how dense it is there."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerElement3
from bondem.specimen.geometry import Ball, BoundingBox, Box, Cell, Cylinder, Shape
from bondem.specimen.particles import Particles
from bondem.specimen.quasirandom import ball_points, points_inside, spread_rotations

_SAMPLES = 1 << 16
_SOLID_POINTS = 1 << 19
_SOLID_MOST = 256
# Distances from surfaces and from shapes put together take µs each.
_SLOW_SHARE = 4
_SLOW_MOST = 32


def region(particles: Particles) -> Shape:
    """What the particles fill: their shape, their periodic cell or, without either, their bounding box."""
    if particles.period is None:
        return particles.envelope
    a, b, c = map(float, particles.period)
    return Cell((a, b, c))


def samples(shape: Shape, count: int) -> int:
    """How many points to take in a shape: `count`, or a quarter where the distance from its walls is slow to find."""
    return count if _simple(shape) else count // _SLOW_SHARE


def _simple(shape: Shape) -> bool:
    return isinstance(shape, Cylinder | Ball | Box | BoundingBox | Cell)


def core_volume(shape: Shape, depth: float) -> float:
    """Volume of what lies `depth` or more from every wall [m³].

    Exact for cylinder, box, ball and cell; for any other shape by 16 384 evenly spread points (± 0.5 % or so).

    Args:
        shape: the shape.
        depth: distance from the walls [m].
    """
    match shape:
        case Cell():
            return shape.volume
        case Cylinder(radius=radius, length=length):
            return math.pi * max(radius - depth, 0.0) ** 2 * max(length - 2.0 * depth, 0.0)
        case Ball(radius=radius):
            return 4.0 / 3.0 * math.pi * max(radius - depth, 0.0) ** 3
        case Box() | BoundingBox():
            lower, upper = shape.bounds
            return float(np.prod(np.maximum(upper - lower - 2.0 * depth, 0.0)))
    points, share = points_inside(shape, samples(shape, _SAMPLES), depth)
    return len(points) * share


@dataclass(frozen=True, eq=False)
class Solid:
    """The volume of spheres as points, so that it can be counted in any region.

    Attributes:
        position: points inside the spheres [m], shape (n · k, 3), k to a sphere.
        volume: what each stands for [m³], shape (n · k,).
    """

    position: PerElement3
    volume: Floats


def solid(particles: Particles, shape: Shape) -> Solid:
    """Spheres as evenly spread points: 256 each (32 in shapes slow to measure), fewer above 2048 spheres, at least 8.

    A sphere cut by a plane is counted with an error of 1 % (8 points: 8 %) of its volume, of either sign; over the
    many spheres that a wall of the core cuts, these cancel.
    """
    count = _points_each(particles, shape)
    position = _points(particles, count)
    return Solid(position.reshape(-1, 3), np.repeat(particles.volume / count, count))


def core_solid(particles: Particles, shape: Shape, depth: float) -> Solid:
    """The part of spheres `depth` or more from every wall; only those its border cuts are looked at by points."""
    count = _points_each(particles, shape)
    position = _points(particles, count)
    far = shape.depth(particles.position)
    inside = np.repeat((far >= depth)[:, None], count, axis=1)
    cut = np.flatnonzero(np.abs(far - depth) < particles.radius)
    if len(cut):
        inside[cut] = (shape.depth(position[cut].reshape(-1, 3)) >= depth).reshape(-1, count)
    volume = np.broadcast_to((particles.volume / count)[:, None], inside.shape)
    return Solid(position[inside], volume[inside])


def _points_each(particles: Particles, shape: Shape) -> int:
    most = _SOLID_MOST if _simple(shape) else _SLOW_MOST
    return min(max(_SOLID_POINTS // len(particles), 8), most) // 2 * 2


def _points(particles: Particles, count: int) -> Floats:
    """Points in the spheres, shape (n, count, 3)."""
    # Each sphere turns the points its own way: in a crystal they would add up their errors.
    offset = np.einsum("nij,kj->nki", spread_rotations(len(particles)), ball_points(count), optimize=True)
    position = particles.position[:, None] + particles.radius[:, None, None] * offset
    return position if particles.period is None else np.mod(position, particles.period)


def solid_fraction(shape: Shape, core: Solid, depth: float) -> float:
    """Volume fraction of what lies `depth` or more from every wall [-]; NaN where nothing does."""
    volume = core_volume(shape, depth)
    return float(core.volume.sum()) / volume if volume > 0.0 else math.nan
