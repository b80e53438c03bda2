"""Dashpots of bonds, and the fastest decay rate of motions by them, which bounds the time step."""

from typing import Any

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.linalg import LinearOperator, eigsh

from bondem._blas import one_blas_thread
from bondem._types import Floats
from bondem.dynamics.damping import DampingTerms
from bondem.model.model import Model

# Relative tolerance of the eigenvalue. The result is raised by twice as much, to be an upper bound.
_TOLERANCE = 1e-3


def bond_dashpots(model: Model, terms: DampingTerms) -> Floats:
    """Return dashpot coefficients cn, cs [N·s/m], cb, ct [N·m·s] of each bond, internal order, shape (4, m)."""
    layout, bonds = model.layout, model.bonds
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    m, I = (1.0 / (1.0 / v[layout.i] + 1.0 / v[layout.j]) for v in (mass, inertia))
    stiffness = np.array([bonds.kn, bonds.ks, bonds.kb, bonds.kt])
    return 2.0 * terms.eta * np.sqrt(stiffness * np.array([m, m, I, I])) + terms.beta * stiffness


@one_blas_thread
def fastest_decay(model: Model, terms: DampingTerms) -> float:
    """Return an upper bound of the largest eigenvalue of M⁻¹ C of the dashpots of bonds [1/s], 0 without dashpots.

    The largest c / k times ω²_max is a bound, too. For a share of the critical damping, however, c / k grows as 1 /
    √k, so that the smallest facet would determine the bound, although it transmits hardly any force.
    """
    cn, cs, cb, ct = bond_dashpots(model, terms)
    layout, table, order = model.layout, model.bonds, model.layout.order
    m, n = len(layout.i), len(order)
    if not m or not (cn.any() or cs.any() or cb.any() or ct.any()):
        return 0.0
    root = 1.0 / np.sqrt(np.repeat(np.column_stack([model.mass[order], model.inertia[order]]), 3, axis=1))
    normal = np.ascontiguousarray(table.direction.T)
    lever = np.column_stack([table.lever, table.length - table.lever]).ravel()
    ends, starts = np.column_stack([layout.i, layout.j]).ravel(), np.arange(0, 2 * m + 1, 2)
    apart = csr_array((np.tile([-1.0, 1.0], m), ends, starts), shape=(m, n))
    levers = csr_array((lever, ends, starts), shape=(m, n))

    def answer(vector: Floats) -> Floats:
        motion = vector.reshape(n, 6) * root
        opening = apart @ motion[:, :3] - np.cross(levers @ motion[:, 3:], normal)
        turning = apart @ motion[:, 3:]
        force = _split(opening, normal, cn, cs)
        moment = _split(turning, normal, ct, cb)
        found = np.hstack([apart.T @ force, levers.T @ np.cross(force, normal) + apart.T @ moment])
        return (found * root).ravel()

    resisted = sum(np.bincount(end, weights=cn + cs, minlength=n) for end in (layout.i, layout.j))
    resisted *= root[:, 0] ** 2
    start = np.random.default_rng(0).standard_normal((n, 6)) * (resisted / resisted.max())[:, None] ** 2
    operator: Any = LinearOperator((6 * n, 6 * n), matvec=answer, dtype=float)
    return largest_eigenvalue(operator, start.ravel())


def largest_eigenvalue(operator: Any, start: Floats) -> float:
    """Return an upper bound of the largest eigenvalue of a symmetric operator (k, k), iterated from `start`, (k,)."""
    options = {"tol": _TOLERANCE, "v0": start, "return_eigenvectors": False}
    found = np.asarray(eigsh(operator, k=1, which="LA", **options))
    return (1.0 + 2.0 * _TOLERANCE) * float(found[0])


def _split(vector: Floats, normal: Floats, along: Floats, across: Floats) -> Floats:
    """Multiply vectors, row by row, by one factor along the normals and by another one across them."""
    part = np.einsum("mk,mk->m", vector, normal)
    return across[:, None] * vector + ((along - across) * part)[:, None] * normal
