"""Coarse aggregates of a grading curve at random places of a shape, and centres of cells that end on their surfaces.

Directions are spread evenly about the centre of each ball. On each direction two centres lie half the size of a cell
inside and outside of a sphere about the ball's centre. The plane half-way between them touches this sphere. Each
point of the sphere is nearest to the two centres of the direction closest to it, so that cells end on these planes
alone. The sphere has the radius at which the polyhedron of all planes has the volume of the ball.
"""

import math
from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from bondem._checks import count as whole
from bondem._checks import instance, number
from bondem._progress import staged
from bondem._types import Floats, PerElement3
from bondem.errors import InputError, PackingError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.even import usual_radius
from bondem.packing.free_centres import MARGIN, settled_free, thrown_free, without_twins
from bondem.packing.sizes import Sieve
from bondem.packing.start import thrown
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.particles import Particles, filled

# Largest volume fraction of the balls with half their gaps that can be pushed apart, and the share of the gap that
# may be missing in the end.
_DENSEST, _CLOSER = 0.55, 0.1
_SETTLED, _STEPS = 5e-3, 20_000
# Smallest radius of a ball over the size of a cell, and least number of directions.
_LEAST, _DIRECTIONS = 1.25, 12
# Distances over the size of a cell: of free centres from a surface, and between centres in the layers of two balls
# below which one of them is removed.
_CLEAR, _APART = 0.85, 0.5


@staged("placing aggregates")
def aggregates(shape: Shape, sieve: Sieve, *, fraction: float, gap: float, seed: int = 1) -> Aggregates:
    """Place balls of a grading curve in a shape, at random and apart from each other.

    Args:
        shape: shape of the body, not periodic.
        sieve: grading curve, with diameters in metres.
        fraction: volume of the balls over that of the shape, above 0 and below 0.6 [-]. Few balls of a wide grading
            curve occupy less, because the largest sizes are missing: 12 % less for 50 balls of 2 to 16 mm.
        gap: least gap between two balls, above 0 and accurate to 10 % [m]; half of it remains between balls and
            walls. For cells of volume h³ give at least 1.2 h.
        seed: number that selects one of the random arrangements [-].

    Returns:
        The balls, as a region.

    Raises:
        InputError: An argument is out of range, or the balls with their gaps do not fit into the shape.
        PackingError: The balls could not be separated by 90 % of the gap.
    """
    instance("aggregates", "shape", shape, Shape, "a shape such as bd.Box((60e-3, 40e-3, 40e-3))")
    instance("aggregates", "sieve", sieve, Sieve, "bd.Sieve(diameters=..., mass_passing=...), in metres")
    advice = "a share of the volume above 0 and below 0.6"
    fraction = number("aggregates", "fraction", fraction, above=0.0, below=0.6, advice=advice)
    gap = number("aggregates", "gap", gap, unit="m", above=0.0)
    seed = whole("aggregates", "seed", seed, advice="a whole number from 0 up")
    if shape.period is not None:
        raise InputError("aggregates: a periodic cell has no walls; give a bd.Box of its size")
    random = np.random.Generator(np.random.Philox(seed))
    radius = radii_with_room(shape, sieve, fraction, gap)
    random.shuffle(radius)
    wide = radius + 0.5 * gap
    filled_part = _part(wide, shape)
    spheres = thrown(shape, wide, filled_part, random, by_count=False)
    wide = spheres.sphere[:, 3] * 1.0
    spheres.relax(1.0, tolerance=_SETTLED, steps=_STEPS)
    found = Aggregates(spheres.sphere[:, :3], wide - 0.5 * gap)
    if found.gap < (1.0 - _CLOSER) * gap:
        raise PackingError(
            f"aggregates: gap = {gap:g} m: only {found.gap:.3g} m were reached between two balls; give a smaller"
            " fraction= or gap=, or another seed="
        )
    return found


def radii_with_room(shape: Shape, sieve: Sieve, fraction: float, gap: float) -> Floats:
    """Return the radii of balls of a grading curve for a volume fraction and a gap [m], ascending [m], (k,).

    Raises:
        InputError: There are no balls or too many, or they do not fit into the shape with their gaps.
    """
    mean = 4.0 / 3.0 * math.pi * float((sieve.quantile((np.arange(1000) + 0.5) / 1000) ** 3).mean())
    count = round(fraction * shape.volume / mean)
    if not 1 <= count <= 100_000:
        raise InputError(
            f"aggregates: {count} balls of {sieve.diameters[0]:g} to {sieve.diameters[-1]:g} m have {fraction:g} of"
            f" {shape.volume:.3g} m³; check the unit of the sieves (metres), or give another fraction="
        )
    radius = sieve.quantile((np.arange(count) + 0.5) / count)
    taken = _part(radius + 0.5 * gap, shape)
    if taken > _DENSEST:
        raise InputError(
            f"aggregates: with half their gaps of {gap:.3g} m the balls occupy {taken:.2f} of the shape, and"
            f" at most {_DENSEST:g} fits; give a smaller fraction= or gap=, or larger balls"
        )
    return radius


def _part(radius: Floats, shape: Shape) -> float:
    """Return the volume of balls of radii (k,) [m] over that of the shape [-]."""
    return 4.0 / 3.0 * math.pi * float((radius**3).sum()) / shape.volume


def least_count(shape: Shape, radius: float) -> int:
    """Return the least number of equal cells in a shape that are small enough for balls of `radius` [m]."""
    return math.ceil(shape.volume * (_LEAST / radius) ** 3)


def around_balls(
    shape: Shape, count: int, balls: Aggregates, random: np.random.Generator, report: Callable[[float], None]
) -> Particles:
    """Pack equal spheres for cells that end on the surfaces of balls.

    Args:
        shape: shape to fill.
        count: number of spheres.
        balls: balls inside the shape.
        random: random generator.
        report: function called with the completed share.

    Raises:
        InputError: The cells are too large for the balls or too few, or balls lie partly outside the shape.
    """
    h = float(np.cbrt(shape.volume / count))
    centre, radius = np.array(balls.position), np.array(balls.radius)
    if radius.min() < _LEAST * h:
        raise InputError(
            f"pack: cells of {h:.3g} m are too large for balls of radius {radius.min():.3g} m; ask for"
            f" {least_count(shape, float(radius.min()))} cells or more, or leave out smaller balls"
        )
    if (shape.depth(centre) < radius * (1.0 - 1e-9)).any():
        raise InputError("pack: around= has balls that reach out of the shape; make them by bd.aggregates(shape, …)")
    pins = _layers(shape, centre, radius, h, random)
    free = count - len(pins)
    if free < len(radius):
        raise InputError(f"pack: the surfaces of {len(radius)} balls need more than {count} cells; ask for more")
    free_centres = thrown_free(shape, free, lambda x: np.abs(balls.depth(x)), _CLEAR * h, h, random)
    x = settled_free(shape, pins, free_centres, h, report)
    return filled(Particles(x, usual_radius(shape, x, 0.5 * h), None), shape)


def _layers(shape: Shape, centre: PerElement3, radius: Floats, h: float, random: np.random.Generator) -> PerElement3:
    """Return the centres of cells inside and outside the surfaces of all balls [m], (k, 3)."""
    inner, outer, whose = [], [], []
    for k, (at, R) in enumerate(zip(centre, radius, strict=True)):
        n = max(_DIRECTIONS, round(4.0 * math.pi * (R / h) ** 2))
        way = Rotation.from_quat(random.standard_normal(4)).apply(_directions(n))
        # a polyhedron that touches a ball with n planes has 1 + 3/n of its volume, to the first order
        R *= (1.0 + 3.0 / n) ** (-1.0 / 3.0)
        inner.append(at + (R - 0.5 * h) * way)
        outer.append(at + (R + 0.5 * h) * way)
        whose.append(np.full(n, k))
    beyond, owner = np.concatenate(outer), np.concatenate(whose)
    retained = shape.depth(beyond) >= MARGIN * h
    # between two balls close to each other, one layer serves both
    return np.concatenate([*inner, beyond[without_twins(beyond, _APART * h, retained, owner)]])


def _directions(count: int) -> Floats:
    """Return unit vectors spread evenly over the sphere, on a spiral of golden angles, (count, 3)."""
    z = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = math.pi * (3.0 - math.sqrt(5.0)) * np.arange(count)
    r = np.sqrt(1.0 - z * z)
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z])
