"""The geode: the unit sphere in 320 triangles, on which directions are counted (André et al. 2012, fig. 4).

It is an icosahedron whose faces are divided into four, twice, and projected onto the sphere. Its faces are not equal:
their solid angles deviate by up to 19 % from the mean.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from bondem._types import Floats, Ints
from bondem.specimen.particles import freeze

_LEVELS = 2


@dataclass(frozen=True, eq=False)
class DirectionSphere:
    """Unit sphere divided into 320 spherical triangles, on which directions are counted.

    Attributes:
        vertices: unit vectors, shape (162, 3).
        faces: vertices of each triangle, counter-clockwise seen from outside, shape (320, 3).
        solid_angle: solid angle of each face [sr], shape (320,); their sum is 4π.
        opposite: antipodal face of each face, shape (320,).
    """

    vertices: Floats
    faces: Ints
    solid_angle: Floats
    opposite: Ints

    def face_of(self, direction: Floats) -> Ints:
        """Return the face that each unit vector (m, 3) points into, shape (m,)."""
        face = np.argmax(direction @ _corners(0).sum(axis=1).T, axis=1)
        for level in range(_LEVELS):
            outside = np.einsum("mkc,mc->mk", _cuts(level)[face], direction) < 0.0
            face = 4 * face + np.where(outside.any(axis=1), np.argmax(outside, axis=1), 3)
        return face


def _unit(vector: Floats) -> Floats:
    return vector / np.linalg.norm(vector, axis=-1, keepdims=True)


@cache
def _corners(level: int) -> Floats:
    """Return the corners of the faces after `level` divisions, counter-clockwise seen from outside, (f, 3, 3)."""
    if level == 0:
        return _icosahedron()
    a, b, c = np.moveaxis(_corners(level - 1), 1, 0)
    ab, bc, ca = _unit(a + b), _unit(b + c), _unit(c + a)
    children = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.stack([np.stack(child, axis=1) for child in children], axis=1).reshape(-1, 3, 3)


@cache
def _cuts(level: int) -> Floats:
    """Return the normals of the planes that separate part k = 0, 1, 2 of each divided face from part 3, (f, 3, 3)."""
    corner = _corners(level)
    middle = _unit(corner + np.roll(corner, -1, axis=1))
    return np.cross(np.roll(middle, 1, axis=1), middle)


def _icosahedron() -> Floats:
    golden = 0.5 * (1.0 + np.sqrt(5.0))
    corner = np.array([(0.0, s, t * golden) for s in (1.0, -1.0) for t in (1.0, -1.0)])
    corner = _unit(np.concatenate([np.roll(corner, k, axis=1) for k in range(3)]))
    near = corner @ corner.T > 0.4
    a, b, c = np.nonzero(near[:, :, None] & near[:, None, :] & near[None, :, :])
    once = (a < b) & (b < c)
    triangles = corner[np.stack([a, b, c], axis=1)[once]]
    inward = np.linalg.det(triangles) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    return triangles


@cache
def direction_sphere() -> DirectionSphere:
    """Return the unit sphere in 320 triangles (geode), which is built only once."""
    corner = _corners(_LEVELS)
    rounded = np.round(corner.reshape(-1, 3), 9) + 0.0
    _, first, number = np.unique(rounded, axis=0, return_index=True, return_inverse=True)
    a, b, c = np.moveaxis(corner, 1, 0)
    # Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983).
    dot = np.einsum("fc,fc->f", a, b) + np.einsum("fc,fc->f", b, c) + np.einsum("fc,fc->f", c, a)
    solid_angle = 2.0 * np.arctan2(np.linalg.det(corner), 1.0 + dot)
    centre = _unit(corner.sum(axis=1))
    return DirectionSphere(
        vertices=freeze(corner.reshape(-1, 3)[first]),
        faces=freeze(number.reshape(-1, 3).astype(np.int64)),
        solid_angle=freeze(solid_angle),
        opposite=freeze(np.argmax(-centre @ centre.T, axis=1)),
    )
