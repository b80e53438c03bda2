"""Initial state of a packing: spheres at random places."""

import math

import numpy as np

from bondem._checks import shown
from bondem._types import Floats, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.packing.soft_spheres import SoftSpheres

# Least width of a periodic cell in largest radii, at the densest volume fraction, so that no pair touches twice.
_WIDTH, _DENSEST = 5.2, 0.75
# Volume fraction of packings at rest, and least depth of a shape over the largest radius: for two spheres beside each
# other, which reach the usual targets, and for cells that extend from wall to wall.
_AT_REST, ACROSS, _CELLS_ACROSS = 0.62, 2.0, 0.7
# Draws after which evenly spread places are checked for sufficient depth, their number, and the quantile of their
# depths that stands for the depth of the shape. The steps between the places are those of Roberts' sequence.
_SOON, _PLACES, _USUAL = 20, 50_000, 0.97
_STEPS_OF_PLACES = np.array([0.8191725133961645, 0.6710436067037893, 0.5497004779019703])


def thrown(
    shape: Shape, relative_radius: Floats, fraction: float, random: np.random.Generator, *, inside: float = 1.0,
    by_count: bool = True,
) -> SoftSpheres:  # fmt: skip
    """Place spheres at random in a shape, with overlaps, in Morton order.

    Args:
        shape: shape to fill.
        relative_radius: radii up to a common factor, (n,).
        fraction: volume of the spheres over that of the shape [-].
        random: random generator.
        inside: smallest distance of centres from walls, over the radius [-].
        by_count: True if the radii follow from the number of spheres; it decides on the advice of an error.

    Raises:
        InputError: The spheres are too large for the shape.
    """
    solid = 4.0 / 3.0 * math.pi * float((relative_radius**3).sum())
    radius = relative_radius * (fraction * shape.volume / solid) ** (1.0 / 3.0)
    densest = float(radius.max()) * max(_DENSEST / fraction, 1.0) ** (1.0 / 3.0)
    if shape.period is not None and shape.period.min() < _WIDTH * densest:
        raise InputError(
            f"{len(radius)} spheres are too large for the periodic {shown(shape)}; ask for more, or make its edges"
            " more alike"
        )
    try:
        centre = random_centres(shape, inside * radius, random)
    except InputError as error:
        advice = "give smaller ones, or a larger shape"
        if by_count:
            # cells may reach from wall to wall; spheres need room to lie beside each other
            at_rest = radius * (_AT_REST / fraction) ** (1.0 / 3.0)
            count, mean = enough(shape, at_rest, _CELLS_ACROSS if inside < 1.0 else ACROSS)
            advice = f"give count={count} or more, with a mean radius of {mean:.3g} m, or a larger shape"
        raise InputError(
            f"{len(radius)} spheres of radius {radius.max():.3g} m do not fit into {shown(shape)}; {advice}"
        ) from error
    return SoftSpheres(shape, centre, radius)


def random_centres(shape: Shape, depth: PerElement, random: np.random.Generator) -> PerElement3:
    """Draw centres [m], (n, 3), each uniform over the part of `shape` that is deeper than its `depth` [m], (n,).

    Raises:
        InputError: The shape has no place of this depth.
    """
    lower, upper = shape.bounds
    centre = np.empty((len(depth), 3))
    missing = np.arange(len(depth))
    for tried in range(1000):
        centre[missing] = lower + (upper - lower) * random.random((len(missing), 3))
        missing = missing[shape.depth(centre[missing]) < depth[missing]]
        if not missing.size:
            return centre
        if tried == _SOON and not (depths_inside(shape) >= depth[missing].min()).any():
            break
    raise InputError(f"no place in {shown(shape)} is {depth.max():.3g} m from its walls")


def depths_inside(shape: Shape) -> PerElement:
    """Return the depths of places spread evenly over a shape [m], (k,)."""
    lower, upper = shape.bounds
    # a fixed sequence, not random numbers, so that the check changes no packing
    place = np.mod(0.5 + np.arange(_PLACES)[:, None] * _STEPS_OF_PLACES, 1.0)
    depth = shape.depth(lower + (upper - lower) * place)
    return depth[depth > 0.0]


def enough(shape: Shape, radius: PerElement, across: float) -> tuple[int, float]:
    """Return the number of spheres that fit if those of `radius` (n,) [m] are too large, and their mean radius [m].

    The 97 % quantile of depths in the shape is then `across` largest radii. In a periodic cell any number fits.
    """
    if shape.period is not None:
        return len(radius), float(radius.mean())
    usual = float(np.quantile(depths_inside(shape), _USUAL))
    smaller = usual / (across * float(radius.max()))
    count = math.ceil(len(radius) / min(smaller, 1.0) ** 3)
    return count, float(radius.mean()) * (len(radius) / count) ** (1.0 / 3.0)
