"""Rotations: rotated vectors, rotation vectors, products of quaternions, and moments of forces about centres."""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.cell_tables import MomentsOfForces, TurnedVectors
from bondem._types import Floats, Ints


def turned_vectors(quaternion: Floats, vectors: Floats) -> Floats:
    """Return vectors (k, 3), each rotated by its unit quaternion (w, x, y, z), (k, 4)."""
    turned = np.empty((len(vectors), 3))
    run_pass(calls.turn_vectors(TurnedVectors(_contiguous(quaternion), _contiguous(vectors), turned)))
    return turned


def add_force_moments(moment: Floats, owner: Ints, arm: Floats, force: Floats, sign: float) -> None:
    """Add sign · sym(b⊗f) of arms b [m] and forces f [N] to `moment` (n, 6) of each owner: xx, yy, zz, xy, yz, zx."""
    own = np.ascontiguousarray(owner, dtype=np.int64)
    run_pass(calls.add_moments(MomentsOfForces(moment, own, _contiguous(arm), _contiguous(force), sign)))


def rotation_vector(quaternion: Floats) -> Floats:
    """Return the rotation vectors of unit quaternions (n, 4), of length at most π [rad], shape (n, 3)."""
    q = np.where(quaternion[:, :1] < 0.0, -quaternion, quaternion)
    sine = np.linalg.norm(q[:, 1:], axis=1, keepdims=True)
    ratio = np.divide(2.0 * np.arctan2(sine, q[:, :1]), sine, out=np.full_like(sine, 2.0), where=sine > 1e-150)
    return q[:, 1:] * ratio


def turned_further(quaternion: Floats, rotation: Floats) -> Floats:
    """Return unit quaternions (n, 4), rotated further by rotation vectors in the fixed frame [rad], (n, 3)."""
    half = 0.5 * np.linalg.norm(rotation, axis=1, keepdims=True)
    vector = 0.5 * rotation * np.sinc(half / np.pi)
    w, v = quaternion[:, :1], quaternion[:, 1:]
    scalar = np.cos(half) * w - (vector * v).sum(axis=1, keepdims=True)
    product = np.concatenate([scalar, np.cos(half) * v + w * vector + np.cross(vector, v)], axis=1)
    return product / np.linalg.norm(product, axis=1, keepdims=True)


def relative_rotations(p: Floats, q: Floats) -> tuple[Floats, Floats]:
    """Return scalar part ≥ 0, (k,), and vector part, (k, 3), of p* q for unit quaternions p and q, (k, 4)."""
    scalar = (p * q).sum(axis=1)
    vector = p[:, :1] * q[:, 1:] - q[:, :1] * p[:, 1:] - np.cross(p[:, 1:], q[:, 1:])
    sign = np.where(scalar < 0.0, -1.0, 1.0)
    return sign * scalar, sign[:, None] * vector


def cross_matrices(vectors: Floats) -> Floats:
    """Return the matrices [v]× of vectors (k, 3), for which [v]× b = v × b, (k, 3, 3)."""
    matrix = np.zeros((len(vectors), 3, 3))
    for row, column, axis in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        matrix[:, row, column], matrix[:, column, row] = -vectors[:, axis], vectors[:, axis]
    return matrix


def _contiguous(values: Floats) -> Floats:
    return np.ascontiguousarray(values, dtype=float)
