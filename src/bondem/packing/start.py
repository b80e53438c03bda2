"""Initial state of a packing: spheres at random places."""

import math

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.geometry.morton import morton_code
from bondem.packing.soft_spheres import SoftSpheres

# A periodic cell must be this many largest radii wide at the highest density, or a sphere meets another twice.
_WIDTH, _DENSEST = 5.2, 0.75


def thrown(
    shape: Shape, relative_radius: Floats, fraction: float, random: np.random.Generator, *, inside: float = 1.0
) -> SoftSpheres:
    """Place spheres at random in a shape, with overlaps, in Morton order.

    Args:
        shape: shape to fill.
        relative_radius: radii up to a common factor, (n,).
        fraction: volume of the spheres over that of the shape [-].
        random: random generator.
        inside: smallest distance of centres from walls, over the radius [-].

    Raises:
        InputError: The spheres are too large for the shape.
    """
    solid = 4.0 / 3.0 * math.pi * float((relative_radius**3).sum())
    radius = relative_radius * (fraction * shape.volume / solid) ** (1.0 / 3.0)
    densest = float(radius.max()) * max(_DENSEST / fraction, 1.0) ** (1.0 / 3.0)
    if shape.period is not None and shape.period.min() < _WIDTH * densest:
        raise InputError(
            f"{len(radius)} spheres are too large for the periodic {shape}; ask for more, or make its edges more"
            " alike"
        )
    centre = _random_centres(shape, inside * radius, random)
    order = np.argsort(morton_code(centre), kind="stable")
    return SoftSpheres(shape, centre[order], radius[order])


def _random_centres(shape: Shape, radius: Floats, random: np.random.Generator) -> Floats:
    """Return centres [m], uniform over the part of `shape` that is deeper than `radius` (n,) [m], (n, 3).

    Raises:
        InputError: The largest sphere does not fit.
    """
    lower, upper = shape.bounds
    centre = np.empty((len(radius), 3))
    missing = np.arange(len(radius))
    for _ in range(1000):
        centre[missing] = lower + (upper - lower) * random.random((len(missing), 3))
        missing = missing[shape.depth(centre[missing]) < radius[missing]]
        if not missing.size:
            return centre
    raise InputError(
        f"spheres of radius {radius.max():.3g} m do not fit into {shape}; ask for more spheres or a larger shape"
    )
