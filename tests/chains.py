"""A chain of touching spheres: the specimen whose closed forms are those of a bar."""

import numpy as np

import bondem as bd

R = 0.5e-3  # m


def chain(count: int) -> bd.Lattice:
    """Touching equal spheres of radius R along x that fill a cylinder of their own radius from face to face."""
    x = R * (1.0 + 2.0 * np.arange(count))
    position = np.stack([x, np.zeros(count), np.zeros(count)], axis=1)
    shape = bd.Cylinder(radius=R, length=2.0 * R * count)
    pairs = np.stack([np.arange(count - 1), np.arange(1, count)], axis=1)
    return bd.Lattice(bd.Particles(position, R, shape=shape), pairs)
