"""Linear system K u = f of a lattice, with six degrees of freedom (u, θ) per element, and its solvers.

The unknowns of every element are scaled by an inverse root S of its own diagonal block, restricted to its free part.
Sᵀ K S has unit blocks on its diagonal, translations and rotations in one measure, and zeros for fixed elements and
rattlers. Small lattices and chains are solved by elimination. Others use conjugate gradients, preconditioned by
`Clumps`, to a negligible residual.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from scipy.sparse import csc_array

from bondem._types import Floats, Ints, Mask, PerBond
from bondem.errors import ConvergenceError, InputError
from bondem.interactions.stiffness import Stiffness
from bondem.model.model import Model
from bondem.statics.coarse_space import Clumps, clump_motions, clump_of, parted, symmetric_factors
from bondem.statics.floating import refuse_floating

# Largest number of spheres, and of cells, up to which elimination is faster than iteration; bonds per element up to
# which it is faster at any size, because the lattice is hardly more than a chain.
_DIRECT, _DIRECT_CELLS = 500, 150
_CHAIN = 1.5
# Pivot below which a matrix with unit diagonal has a mechanism.
_SINGULAR = 1e-13
_ROUNDS = 5000
MECHANISM = (
    "the static solution did not converge: the load moves a mechanism that no bond resists (elements free to"
    " roll under bonds without moments, or too few bonds); fix more, or choose a law with moments"
)


def require_lasting(model: Model, advice: str) -> None:
    """Raise InputError if a model has contacts or walls, or bonds that break."""
    if model.contact is not None:
        raise InputError(f"contacts and walls act in explicit runs only; {advice}")
    if model.failure is not None:
        raise InputError("bonds break in solve_explicit and solve_quasistatic; leave failure= out of the model")


@dataclass(frozen=True, eq=False)
class System:
    """Stiffness matrix of a model, with its free degrees of freedom, in internal order.

    Attributes:
        matrix: K of all degrees of freedom [N/m, N, N·m], (6 n, 6 n).
        position: centres, with rattlers at the centroid [m], shape (n, 3).
        length: R̄, which converts rotations to displacements [m].
        free: mask of the degrees of freedom that are not fixed or driven, nor those of a rattler, shape (n, 6).
        loose: rigid motions (u, θ) that the supports permit, orthonormal with u·u + R̄² θ·θ, shape (6 n, k).
    """

    matrix: Stiffness
    position: Floats
    length: float
    free: Mask
    loose: Floats

    @classmethod
    def of(cls, model: Model) -> "System":
        """Return the matrix and supports of a model.

        Raises:
            InputError: The model has contacts or walls, which have no matrix, a failure criterion, or no bonds.
            FloatingBodyError: A body of a scene can move rigidly.
        """
        require_lasting(
            model, "leave contact= and walls= out of the model, and hold or load faces with bd.Fix and bd.Load"
        )
        if len(model.lattice.pairs) == 0:
            raise InputError("elements without bonds have no stiffness; bond them, or use solve_explicit")
        lattice, order = model.lattice, model.layout.order
        connected = lattice.connected[order]
        position = lattice.centre[order]
        position[~connected] = position[connected].mean(axis=0)
        prescribed = model.constraints.prescribed(len(order)) & connected[:, None]
        refuse_floating(model, position, prescribed)
        metric = np.tile(np.repeat([1.0, lattice.particles.mean_radius], 3), len(order))
        loose = rigid_motions(position, lattice.particles.period is not None) * connected[:, None, None]
        loose = orthonormal(loose.reshape(len(metric), -1) * metric[:, None])
        constrained = loose[prescribed.ravel()]
        by_user = (loose / metric[:, None]).reshape(len(order), 6, loose.shape[1])[model.layout.rank]
        constrained = np.concatenate([constrained, model.interaction.supports.constraint(by_user)])
        if len(constrained):
            size, turn = np.linalg.eigh(constrained.T @ constrained)
            loose = loose @ turn[:, size <= 1e-12 * size[-1]]
        free = connected[:, None] & ~prescribed
        length = lattice.particles.mean_radius
        return cls(model.interaction.stiffness(), position, length, free, loose / metric[:, None])

    def without_rigid_motion(self, motion: Floats) -> Floats:
        """Return a motion (6 n,) without its part along `loose`."""
        if self.loose.shape[1] == 0:
            return motion
        return motion - self.loose @ (self.loose.T @ (self._weight * motion))

    def balanced(self, load: Floats) -> Floats:
        """Return a load (6 n,) [N, N·m] without its part that does work on the rigid motions `loose`.

        For a load in equilibrium this part is a rounding error.
        """
        if self.loose.shape[1] == 0:
            return load
        return load - self._weight * (self.loose @ (self.loose.T @ load))

    @cached_property
    def _weight(self) -> Floats:
        return np.tile(np.repeat([1.0, self.length**2], 3), len(self.free))


def orthonormal(vectors: Floats) -> Floats:
    """Return an orthonormal basis (rows, k) of the span of independent vectors (rows, k)."""
    for _ in range(2):
        vectors = vectors / np.sqrt(np.einsum("nk,nk->k", vectors, vectors))
        vectors = vectors @ normalising(vectors.T @ vectors)
    return vectors


def spanning(vectors: Floats, least: float = 0.0) -> Floats:
    """Return an orthonormal basis of the span of vectors (rows, k), which may be dependent, (rows, ≤ k).

    Vectors, or combinations of them, of a norm below `least` count as zero.
    """
    if vectors.shape[1] == 0:
        return vectors
    size, turn = np.linalg.eigh(vectors.T @ vectors)
    return orthonormal(vectors @ turn[:, size > max(1e-14 * size[-1], least**2)])


def normalising(product: Floats) -> Floats:
    """Return the matrix T with Tᵀ A T = 1, (k, k), for a positive definite `product` A, (k, k)."""
    return np.asarray(np.linalg.inv(np.linalg.cholesky(product)).T, dtype=float)


def rigid_motions(position: Floats, periodic: bool) -> Floats:
    """Return the rigid motions (u, θ) of elements, (n, 6, 6); only translations, (n, 6, 3), of a periodic lattice."""
    motions = clump_motions(position, np.zeros(len(position), dtype=np.int64))
    return motions[:, :, :3] if periodic else motions


class Solver(Protocol):
    """Interface of solvers of K u = f for one system and many right-hand sides."""

    def solve(self, load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> tuple[Floats, int]:
        """Return displacements and rotations u (6 n,), without rigid motion, and the number of iterations.

        Args:
            load: forces and torques [N, N·m], (6 n,), that do no work on `System.loose`; ignored where motions are
                prescribed.
            guess: initial displacements and rotations of an iteration [m, rad], (6 n,); None for zero.
            rtol: residual over load at which the iteration ends.

        Raises:
            ConvergenceError: No bond resists the load.
        """
        ...


def solver(system: System) -> Solver:
    """Return the solver that is faster for a system: `Elimination` or `Iteration`."""
    return Elimination(system) if prefers_elimination(system) else Iteration(system)


def prefers_elimination(system: System) -> bool:
    """Return True if a lattice is so small, or has so few bonds per element, that elimination is faster."""
    n = len(system.free)
    bonds = system.matrix.neighbours // 2
    return n <= (_DIRECT if system.matrix.forms is None else _DIRECT_CELLS) or bonds <= _CHAIN * n


class Elimination:
    """Solver by LU decomposition; for each free rigid motion of the specimen, it fixes one degree of freedom."""

    def __init__(self, system: System) -> None:
        self._system = system
        free = system.free.ravel().copy()
        loose = system.loose * np.tile(np.repeat([1.0, system.length], 3), len(system.free))[:, None]
        for _ in range(loose.shape[1]):
            pinned = np.argmax((loose**2).sum(axis=1) * free)
            free[pinned] = False
            loose = loose @ np.linalg.svd(loose[pinned][None])[2][1:].T
        self._live = np.flatnonzero(free)
        matrix = csc_array(csc_array(system.matrix.tocsc()[:, self._live])[self._live])
        turning = system.matrix.diagonal_blocks()[:, range(3, 6), range(3, 6)]
        singular = bool((_weak(turning) & system.free[:, 3:]).any())
        self._scale = 1.0 / np.sqrt(np.maximum(matrix.diagonal(), 1e-300))
        self._matrix = csc_array(matrix.multiply(self._scale[:, None]).multiply(self._scale))
        try:
            self._factors = symmetric_factors(self._matrix)
            singular |= bool(np.abs(self._factors.U.diagonal()).min(initial=1.0) < _SINGULAR)
        except RuntimeError:
            singular = True
        # a load may do no work on the mechanism, which only the iteration shows
        self._iteration = Iteration(system) if singular else None

    def solve(self, load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> tuple[Floats, int]:
        """Return the solution by elimination, as `Solver.solve`; `guess` and `rtol` only count if K is singular."""
        if self._iteration is not None:
            return self._iteration.solve(load, guess=guess, rtol=rtol)
        right = self._scale * load[self._live]
        x = self._factors.solve(right)
        x += self._factors.solve(right - self._matrix @ x)
        solution = np.zeros_like(load)
        solution[self._live] = self._scale * x
        return self._system.without_rigid_motion(solution), 1


class Iteration:
    """Solver by conjugate gradients on Sᵀ K S, preconditioned by the coarse correction of clusters.

    Attributes:
        root: scaling matrix S of each element, shape (n, 6, 6).
        scaled: Sᵀ K S.
        coarse: coarse correction of the scaled matrix.
        rigid: rigid motions that the supports permit, in scaled unknowns, orthonormal, (6 n, r).
    """

    def __init__(self, system: System, lost: tuple[Ints, Ints, PerBond] | None = None) -> None:
        """Prepare the preconditioner.

        Args:
            system: the matrix and its free part.
            lost: elements on both sides of bonds, and the share of stiffness that these lost, (m,) each, or None.
        """
        self._system = system
        K = system.matrix
        self.root, self._back = element_roots(K, system.free)
        self._turned = np.ascontiguousarray(np.swapaxes(self.root, 1, 2))
        self.scaled = K.scaled(self.root)
        clump = clump_of(system.position)
        if lost is not None:
            clump = parted(clump, system.position, *lost)
        self.coarse = Clumps(self.scaled, self._back @ clump_motions(system.position, clump), clump)
        mean = np.linalg.norm(self._back / np.repeat([1.0, system.length], 3)) / math.sqrt(len(system.loose))
        self.rigid = spanning(self.unscaled(system.loose), 1e-7 * float(mean))

    def solve(self, load: Floats, *, guess: Floats | None = None, rtol: float = 1e-10) -> tuple[Floats, int]:
        """Return the solution by conjugate gradients, as `Solver.solve`."""
        system = self._system
        start = np.zeros_like(load) if guess is None else np.where(system.free.ravel(), guess, 0.0)
        load = system.balanced(load)
        right = self.turned(load)
        residual = right if guess is None else right - self.turned(system.matrix @ start)
        stop = rtol * float(np.linalg.norm(right))
        x, rounds = conjugate_gradients(self.scaled, self.approximate, residual, stop)
        solution = system.without_rigid_motion(start + _by_element(self.root, x))
        # motions that an element's own block does not resist are left out of S: a load on them shows here
        measure = np.where(system.free, [1.0] * 3 + [1.0 / system.length] * 3, 0.0).ravel()
        rest = np.linalg.norm(measure * (load - system.matrix @ solution))
        if rest > 1e-4 * np.linalg.norm(measure * load) + 1e-9 * np.linalg.norm(load):
            raise ConvergenceError(MECHANISM)
        return solution, rounds

    def approximate(self, residual: Floats) -> Floats:
        """Return an approximation of (Sᵀ K S)⁻¹ r for residuals r in scaled unknowns, (6 n,) or (6 n, k)."""
        z = residual + self.coarse(residual)
        # the clusters hardly resist rigid motion of the whole: rounding errors along it in a residual would grow a
        # billionfold, and iterations on a free specimen would stall or diverge near 1e-10
        return z - self.rigid @ (self.rigid.T @ z)

    def turned(self, load: Floats) -> Floats:
        """Return loads in the scaled unknowns, Sᵀ f with the root S of each element, (6 n,) or (6 n, k)."""
        return _by_element(self._turned, load)

    def displacement(self, unknowns: Floats) -> Floats:
        """Return displacements and rotations S x of scaled unknowns x [m, rad], (6 n,) or (6 n, k)."""
        return _by_element(self.root, unknowns)

    def unscaled(self, displacement: Floats) -> Floats:
        """Return scaled unknowns S⁻¹ u of displacements and rotations u [m, rad], (6 n,) or (6 n, k)."""
        return _by_element(self._back, displacement)


def _by_element(blocks: Floats, values: Floats) -> Floats:
    return np.matmul(blocks, values.reshape(len(blocks), 6, -1)).reshape(values.shape)


def element_roots(matrix: Stiffness, free: Mask) -> tuple[Floats, Floats]:
    """Return S with Sᵀ K_ee S = 1 on the free part of every diagonal block, zero elsewhere, and its pseudo-inverse.

    Both have the shape (n, 6, 6). Motions of an element that its block does not resist are left out.
    """
    blocks = matrix.diagonal_blocks() * (free[:, :, None] & free[:, None, :])
    size = np.einsum("nii->ni", blocks).copy()
    size[:, 3:] = np.where(_weak(size[:, 3:]), size[:, 3:].max(axis=1, keepdims=True), size[:, 3:])
    size = np.sqrt(size)
    size[size == 0.0] = 1.0
    value, vector = np.linalg.eigh(blocks / size[:, :, None] / size[:, None, :])
    vector *= free[:, :, None]
    length = np.sqrt(np.where(value > 1e-12, value, 0.0))
    inverse = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0.0)
    return (
        vector * inverse[:, None, :] / size[:, :, None],
        np.swapaxes(vector * length[:, None, :] * size[:, :, None], 1, 2).copy(),
    )


def _weak(turning: Floats) -> Mask:
    """Return a mask of the rotations of elements with negligible stiffness relative to another rotation, (n, 3)."""
    return turning <= 1e-12 * turning.max(axis=1, keepdims=True)


class Matrix(Protocol):
    """Interface of a matrix that is given by its product with vectors."""

    def __matmul__(self, motion: Floats, /) -> Floats:
        """Return the product K x with a vector."""
        ...


def conjugate_gradients(
    matrix: Matrix, precondition: Callable[[Floats], Floats], residual: Floats, stop: float, *, energy: float = 0.0
) -> tuple[Floats, int]:
    """Return x, (k,), with |residual - K x| <= stop, and the number of iterations; or raise ConvergenceError.

    The iteration also ends at r·z <= `energy`, with the remaining residual r and its preconditioned form z: r·z is
    about twice the energy of the error.
    """
    x = np.zeros_like(residual)
    r = residual.copy()
    p = np.zeros_like(r)
    rho = 1.0
    for k in range(_ROUNDS):
        if np.linalg.norm(r) <= stop:
            return x, k
        z = precondition(r)
        rho, old = r @ z, rho
        if 0.0 < rho <= energy:
            return x, k
        p *= rho / old
        p += z
        Kp = matrix @ p
        curvature = p @ Kp
        if not curvature > 0.0:
            break
        x += (rho / curvature) * p
        r -= (rho / curvature) * Kp
    raise ConvergenceError(MECHANISM)
