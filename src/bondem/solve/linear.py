"""Large sparse symmetric systems of a lattice: supports, scaling, rigid motions, and how K u = f is solved.

Unknowns are scaled to lengths, (u, R̄ θ), so that residuals of forces and of torques over R̄ compare and the
matrix is well conditioned. Held degrees of freedom keep their place with a unit row.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import bsr_array, csc_array
from scipy.sparse.linalg import splu

from bondem._types import Floats
from bondem.errors import ConvergenceError
from bondem.model.matrices import stiffness_matrix
from bondem.model.model import Model

# Below this many elements, or in a lattice that is little more than a chain, elimination wins.
_DIRECT_BELOW = 1500
_CHAIN = 1.5


@dataclass(frozen=True, eq=False)
class System:
    """The scaled matrix of a model and what its supports leave free, internal order.

    Attributes:
        matrix: K of all degrees of freedom, scaled, without supports, (6 n, 6 n).
        reduced: the same with a diagonal in place of held rows and columns.
        scale: metres (1) or radians (1/R̄) per unit of each unknown, shape (6 n,).
        free: 1 where a degree of freedom is free, 0 where it is held or a rattler's, shape (6 n,).
        rigid: orthonormal rigid motions of the specimen, (6 n, 6); (6 n, 3) of a periodic one.
        loose: orthonormal rigid motions that the supports permit, (6 n, k).
    """

    matrix: bsr_array
    reduced: bsr_array
    scale: Floats
    free: Floats
    rigid: Floats
    loose: Floats

    @classmethod
    def of(cls, model: Model) -> "System":
        """Assemble and reduce the matrix of a model."""
        lattice, order = model.lattice, model.layout.order
        n = len(order)
        scale = np.tile(np.repeat([1.0, 1.0 / lattice.particles.mean_radius], 3), n)
        matrix = stiffness_matrix(model)
        block = np.outer(scale[:6], scale[:6])
        matrix = bsr_array((matrix.data * block, matrix.indices, matrix.indptr), shape=matrix.shape)
        connected = lattice.connected[order]
        free = ~model.constraints.held(n) & connected[:, None]
        rigid = rigid_motions(lattice.particles.position[order], lattice.particles.period is not None)
        rigid = rigid * connected[:, None, None]
        flat = np.linalg.qr(rigid.reshape(6 * n, -1) / scale[:, None])[0]
        held = connected[:, None] & ~free
        _, sizes, turns = np.linalg.svd(flat[held.ravel()], full_matrices=True)
        rank = int((sizes > 1e-9 * np.sqrt(max(held.sum(), 1) / (6.0 * n))).sum())
        loose = flat @ turns[rank:].T
        return cls(matrix, _reduce(matrix, free), scale, free.ravel().astype(float), flat, loose)


def rigid_motions(position: Floats, periodic: bool) -> Floats:
    """Translations along and rotations about the axes through the centroid, as (u, θ), shape (n, 6, 6 or 3)."""
    arm = position - position.mean(axis=0)
    motions = np.zeros((len(position), 6, 3 if periodic else 6))
    motions[:, range(3), range(3)] = 1.0
    if not periodic:
        for axis in range(3):
            motions[:, :3, 3 + axis] = np.cross(np.eye(3)[axis], arm)
            motions[:, 3 + axis, 3 + axis] = 1.0
    return motions


def _reduce(matrix: bsr_array, free: np.ndarray) -> bsr_array:
    """The matrix with held rows and columns emptied but for the mean of the free diagonal."""
    n = len(free)
    row = np.repeat(np.arange(n), np.diff(matrix.indptr))
    keep = free.astype(float)
    data = matrix.data * keep[row][:, :, None] * keep[matrix.indices][:, None, :]
    diagonal = np.flatnonzero(matrix.indices == row)
    typical = matrix.data[diagonal][:, range(6), range(6)][free]
    data[diagonal[:, None], range(6), range(6)] += (1.0 - keep) * (typical.mean() if typical.size else 1.0)
    return bsr_array((data, matrix.indices, matrix.indptr), shape=matrix.shape)


def solve_linear(system: System, load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> Floats:
    """Solution of the reduced, scaled system, without the motions the supports permit.

    Args:
        system: matrix and supports.
        load: right-hand side, zero where held and balanced with respect to `system.loose`, shape (6 n,).
        guess: where to start.
        rtol: residual over load.

    Raises:
        ConvergenceError: the residual does not fall below `rtol`.
    """
    size = np.sqrt(_dot(load, load))
    if size == 0.0:
        return np.zeros_like(load)
    n = len(load) // 6
    bonds = (len(system.reduced.indices) - n) // 2
    if system.loose.shape[1] == 0 and (n <= _DIRECT_BELOW or bonds <= _CHAIN * n):
        return _eliminate(system, load, rtol)
    return _conjugate_gradients(system, load, guess, rtol)


def _eliminate(system: System, load: Floats, rtol: float) -> Floats:
    try:
        factors = splu(
            csc_array(system.reduced), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )  # fmt: skip
    except RuntimeError:  # singular: a mechanism, which iteration tells from a load it cannot carry
        return _conjugate_gradients(system, load, None, rtol)
    solution = factors.solve(load)
    solution += factors.solve(load - system.reduced @ solution)
    if not np.isfinite(solution).all():
        return _conjugate_gradients(system, load, None, rtol)
    return solution


def _dot(a: Floats, b: Floats) -> float:
    """a·b in an order that does not depend on the number of threads, as BLAS's does."""
    return float(np.einsum("i,i->", a, b))


def block_inverse(matrix: bsr_array) -> Floats:
    """Pseudo-inverses of the diagonal blocks, shape (n, 6, 6)."""
    row = np.repeat(np.arange(matrix.shape[0] // 6), np.diff(matrix.indptr))
    return np.linalg.pinv(matrix.data[matrix.indices == row], rcond=1e-12, hermitian=True)


def _conjugate_gradients(system: System, load: Floats, guess: Floats | None, rtol: float) -> Floats:
    inverse = block_inverse(system.reduced)

    def precondition(r: Floats) -> Floats:
        return np.einsum("nij,nj->ni", inverse, r.reshape(-1, 6)).ravel()

    def project(v: Floats) -> Floats:
        return v - system.loose @ (system.loose.T @ v)

    K = system.reduced
    x = np.zeros_like(load) if guess is None else guess * system.free
    r = project(load - K @ x)
    stop = rtol * np.sqrt(_dot(load, load))
    z = project(precondition(r))
    p = z
    rho = _dot(r, z)
    for _ in range(20 * len(load)):
        if np.sqrt(_dot(r, r)) <= stop:
            return project(x)
        Kp = K @ p
        curvature = _dot(p, Kp)
        if not curvature > 0.0:
            break
        alpha = rho / curvature
        x = x + alpha * p
        r = r - alpha * Kp
        z = project(precondition(r))
        rho, old = _dot(r, z), rho
        p = z + (rho / old) * p
    raise ConvergenceError(
        "the static solution did not converge: the load moves a mechanism that no bond resists (elements"
        " free to roll under bonds without moments, or too few bonds); fix more, or choose a law with moments"
    )
