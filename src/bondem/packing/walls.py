"""Rigid walls of a shape, in the form the packing kernel takes."""

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.specimen.geometry import Ball, Box, Cell, Cylinder, Shape


def walls(shape: Shape) -> Floats:
    """Walls of `shape`: a box, infinite where it has no wall, and a round wall.

    Returns:
        Lower corner [m] (3), upper corner [m] (3), weight of each axis in the distance from the centre line
        or centre of the round wall (3), radius of the round wall [m]; together (10,).

    Raises:
        InputError: a shape that cannot be packed.
    """
    none, everywhere = np.full(3, -np.inf), np.full(3, np.inf)
    lower, upper = shape.bounds
    match shape:
        case Box():
            return np.concatenate([lower, upper, np.zeros(3), [np.inf]])
        case Cylinder():
            box = [lower[0], -np.inf, -np.inf, upper[0], np.inf, np.inf]
            return np.array([*box, 0.0, 1.0, 1.0, shape.radius])
        case Ball():
            return np.concatenate([none, everywhere, np.ones(3), [shape.radius]])
        case Cell():
            return np.concatenate([none, everywhere, np.zeros(3), [np.inf]])
    raise InputError(f"pack knows Cylinder, Box, Ball and Cell, not {shape!r}; pack one and bd.carve the rest")
