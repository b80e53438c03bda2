"""The linear system of a lattice, K u = f, six degrees of freedom (u, θ) an element, and how it is solved.

Every element's unknowns are scaled by an inverse root S of its own diagonal block, restricted to what is free:
Sᵀ K S has unit blocks on its diagonal, translations and rotations in one measure, and nothing at all where
elements are held or rattle. Small lattices and chains are eliminated; else conjugate
gradients, preconditioned by `Clumps`, run to a residual so small that it does not show.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.sparse import bsr_array, csc_array
from scipy.sparse.linalg import splu

from bondem._types import Floats, Mask
from bondem.errors import ConvergenceError
from bondem.kernels.block_matvec import block_matvec
from bondem.model.matrices import stiffness_matrix
from bondem.model.model import Model
from bondem.solve.clumps import Clumps, clump_motions, clump_of

# Up to this many elements, or in a lattice that is little more than a chain, elimination wins.
_DIRECT = 1500
_CHAIN = 1.5
_ROUNDS = 5000

Solve = Callable[..., Floats]


@dataclass(frozen=True, eq=False)
class System:
    """The matrix of a model and what its supports leave free, in the kernels' order.

    Attributes:
        matrix: K of all degrees of freedom [N/m, N, N·m], (6 n, 6 n).
        position: centres [m], shape (n, 3).
        length: R̄, by which rotations become displacements [m].
        free: degrees of freedom neither held nor a rattler's, shape (n, 6).
        loose: rigid motions (u, θ) that the supports permit, orthonormal with u·u + R̄² θ·θ, shape (6 n, k).
    """

    matrix: bsr_array
    position: Floats
    length: float
    free: Mask
    loose: Floats

    @classmethod
    def of(cls, model: Model) -> "System":
        """The matrix and supports of a model."""
        lattice, order = model.lattice, model.layout.order
        connected = lattice.connected[order]
        position = lattice.particles.position[order]
        held = model.constraints.held(len(order)) & connected[:, None]
        metric = np.tile(np.repeat([1.0, lattice.particles.mean_radius], 3), len(order))
        loose = rigid_motions(position, lattice.particles.period is not None) * connected[:, None, None]
        loose = np.linalg.qr(loose.reshape(len(metric), -1) * metric[:, None])[0]
        if held.any():
            grip = np.linalg.qr(loose[held.ravel()], mode="r")
            _, size, turn = np.linalg.svd(grip)
            gripped = int((size > 1e-9 * size[0]).sum())
            loose = loose @ turn[gripped:].T
        return cls(
            matrix=stiffness_matrix(model),
            position=position,
            length=lattice.particles.mean_radius,
            free=connected[:, None] & ~held,
            loose=loose / metric[:, None],
        )

    def without_rigid_motion(self, motion: Floats) -> Floats:
        """A motion (6 n,) without its part along `loose`."""
        if self.loose.shape[1] == 0:
            return motion
        weight = np.tile(np.repeat([1.0, self.length**2], 3), len(self.free))
        return motion - self.loose @ (self.loose.T @ (weight * motion))


def rigid_motions(position: Floats, periodic: bool) -> Floats:
    """Translations along and rotations about the axes through the centroid as (u, θ), shape (n, 6, 6 or 3)."""
    motions = clump_motions(position, np.zeros(len(position), dtype=np.int64))
    return motions[:, :, :3] if periodic else motions


def solver(system: System) -> Solve:
    """What solves K u = f for one system and many right-hand sides.

    Returns:
        solve(load, *, guess=None, rtol=1e-10): u (6 n,) for a load (6 n,), zero where held and without rigid
        motion. `load` must do no work on `system.loose`; what acts on held degrees of freedom is ignored.

    Raises:
        ConvergenceError: (on solving) no bond resists the load.
    """
    n = len(system.free)
    bonds = (len(system.matrix.indices) - n) // 2
    if n <= _DIRECT or bonds <= _CHAIN * n:
        return _eliminating(system)
    return _iterating(system)


def _eliminating(system: System) -> Solve:
    """LU of what is free; where the specimen is free to move, one degree of freedom a motion is grounded."""
    free = system.free.ravel().copy()
    loose = system.loose * np.tile(np.repeat([1.0, system.length], 3), len(system.free))[:, None]
    for _ in range(loose.shape[1]):
        grip = np.argmax((loose**2).sum(axis=1) * free)
        free[grip] = False
        turn = np.linalg.svd(loose[grip][None])[2]
        loose = loose @ turn[1:].T
    live = np.flatnonzero(free)
    matrix = csc_array(system.matrix.tocsc())[:, live][live]
    scale = 1.0 / np.sqrt(np.maximum(matrix.diagonal(), 1e-300))
    matrix = csc_array(matrix.multiply(scale[:, None]).multiply(scale))
    try:
        factors = splu(
            matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )
    except RuntimeError:  # singular: a mechanism, on which the load need not work
        return _iterating(system)
    iterate: list[Solve] = []

    def solve(load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> Floats:
        right = scale * load[live]
        x = factors.solve(right)
        x += factors.solve(right - matrix @ x)
        if not np.linalg.norm(right - matrix @ x) <= 1e-6 * np.linalg.norm(right):
            iterate or iterate.append(_iterating(system))
            return iterate[0](load, guess=guess, rtol=rtol)
        solution = np.zeros_like(load)
        solution[live] = scale * x
        return system.without_rigid_motion(solution)

    return solve


def _iterating(system: System) -> Solve:
    """Conjugate gradients on Sᵀ K S with the coarse correction of clumps."""
    K = system.matrix
    root, back = element_roots(K, system.free)
    row = np.repeat(np.arange(len(root)), np.diff(K.indptr))
    turned = np.ascontiguousarray(np.swapaxes(root, 1, 2))
    scaled = bsr_array((turned[row] @ K.data @ root[K.indices], K.indices, K.indptr), shape=K.shape)
    clump = clump_of(system.position)
    coarse = Clumps(scaled, back @ clump_motions(system.position, clump), clump)

    def by_element(blocks: Floats, values: Floats) -> Floats:
        return np.einsum("nij,nj->ni", blocks, values.reshape(-1, 6)).ravel()

    def solve(load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> Floats:
        start = np.zeros_like(load) if guess is None else np.where(system.free.ravel(), guess, 0.0)
        right = by_element(turned, load)
        residual = right if guess is None else right - by_element(turned, K @ start)
        x = conjugate_gradients(scaled, lambda r: r + coarse(r), residual, rtol * np.sqrt(dot(right, right)))
        return system.without_rigid_motion(start + by_element(root, x))

    return solve


def element_roots(matrix: bsr_array, free: Mask) -> tuple[Floats, Floats]:
    """S with Sᵀ K_ee S = 1 on the free part of every diagonal block, zero elsewhere, and its pseudo-inverse.

    Each (n, 6, 6). Motions of an element that its block does not resist are left out.
    """
    row = np.repeat(np.arange(len(free)), np.diff(matrix.indptr))
    blocks = matrix.data[matrix.indices == row] * (free[:, :, None] & free[:, None, :])
    size = np.sqrt(np.einsum("nii->ni", blocks))
    size[size == 0.0] = 1.0
    value, vector = np.linalg.eigh(blocks / size[:, :, None] / size[:, None, :])
    vector *= free[:, :, None]
    length = np.sqrt(np.where(value > 1e-12, value, 0.0))
    inverse = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0.0)
    return (
        vector * inverse[:, None, :] / size[:, :, None],
        np.swapaxes(vector * length[:, None, :] * size[:, :, None], 1, 2).copy(),
    )


def conjugate_gradients(
    matrix: bsr_array, precondition: Callable[[Floats], Floats], residual: Floats, stop: float
) -> Floats:
    """x with |residual - K x| <= stop."""
    x = np.zeros_like(residual)
    r = residual.copy()
    p = np.zeros_like(r)
    Kp = np.empty_like(r)
    rho = 1.0
    for _ in range(_ROUNDS):
        if np.sqrt(dot(r, r)) <= stop:
            return x
        z = precondition(r)
        rho, old = dot(r, z), rho
        p *= rho / old
        p += z
        block_matvec(matrix.indptr, matrix.indices, matrix.data, p.reshape(-1, 6), Kp.reshape(-1, 6))
        curvature = dot(p, Kp)
        if not curvature > 0.0:
            break
        x += (rho / curvature) * p
        r -= (rho / curvature) * Kp
    raise ConvergenceError(
        "the static solution did not converge: the load moves a mechanism that no bond resists (elements"
        " free to roll under bonds without moments, or too few bonds); fix more, or choose a law with moments"
    )


def dot(a: Floats, b: Floats) -> float:
    """a·b summed in one order whatever the number of threads, as BLAS does not."""
    return float(np.einsum("i,i->", a, b))
