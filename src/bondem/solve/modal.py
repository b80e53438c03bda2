"""Natural modes of a model: K φ = ω² M φ."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import bsr_array, csc_array, diags_array

from bondem._checks import count as whole_number
from bondem._checks import instance
from bondem._types import Floats
from bondem.errors import ConvergenceError, InputError
from bondem.model.matrices import mass_diagonal
from bondem.model.model import Model
from bondem.solve.lanczos import lowest_modes
from bondem.solve.linear import Elimination, Iteration, System, normalising, orthonormal, prefers_elimination
from bondem.solve.solution import Solution
from bondem.solve.threads import one_blas_thread

# Vectors iterated beside the wanted ones, so that a wanted pair is not cut in two.
_GUARD = 4
# Error of ω² at which the iteration stops, as a share of ω².
_TOLERANCE = 1e-8
_ROUNDS = 300


@dataclass(frozen=True, eq=False)
class ModesResult(Solution):
    """The lowest natural modes; a motion the supports leave free is no mode.

    The residual is the largest error of ω² that K φ - ω² M φ allows, over the largest ω² asked for.

    Attributes:
        frequency: ω / 2π, ascending [Hz], shape (count,).
        shape: φ of each mode, translations and rotations (u, θ) in the user's order, normalised to
            φᵀ M φ = 1 kg·m², largest component positive, shape (count, n, 6).
    """

    frequency: Floats
    shape: Floats


@one_blas_thread
def solve_modes(model: Model, *, count: int = 8) -> ModesResult:
    """Lowest natural frequencies and modes about the reference configuration, without damping.

    What is fixed or driven is held; rigid motions that the supports permit are left out, as are rattlers. Loads,
    strains and absorbing boundaries take no part.

    Raises:
        InputError: more modes than the model has, contacts or walls.
        ConvergenceError: the iteration stopped before the tolerance of 1e-6 on frequencies.
    """
    instance("solve_modes", "model", model, Model, "bd.Model(...)")
    count = whole_number("solve_modes", "count", count, least=1)
    if model.non_local is not None:
        raise InputError("the non-local law has no potential, and so no modes: use bd.CellBond, or solve_explicit")
    system, mass = System.of(model), mass_diagonal(model)
    available = int(system.free.sum()) - system.loose.shape[1]
    if not 1 <= count <= available:
        raise InputError(f"count = {count}, but the model has {available} modes; ask for at least one, and no more")
    if available <= max(200, 4 * count):
        square, shape, rounds = _dense(system, mass, count)
    elif prefers_elimination(system):
        square, shape, rounds = _inverse_lanczos(system, mass, count)
    else:
        square, shape, rounds = _block_gradients(system, mass, count)
    shape /= np.sqrt((mass[:, None] * shape**2).sum(axis=0))
    shape *= np.sign(shape[np.abs(shape).argmax(axis=0), np.arange(count)])
    frequency = np.sqrt(np.maximum(square, 0.0)) / (2.0 * np.pi)
    return ModesResult(
        frequency, shape.T.reshape(count, -1, 6)[:, model.layout.rank].copy(),
        iterations=rounds, residual=_residual(system, mass, square, shape),
    )  # fmt: skip


def _residual(system: System, mass: Floats, square: Floats, shape: Floats) -> float:
    rest = (system.matrix @ shape - mass[:, None] * shape * square) * system.free.ravel()[:, None]
    error = np.sqrt((rest**2 / mass[:, None]).sum(axis=0).max())
    return float(error / square[-1]) if square[-1] > 0.0 else 0.0


def _dense(system: System, mass: Floats, count: int) -> tuple[Floats, Floats, int]:
    live = np.flatnonzero(system.free)
    matrix = system.matrix.tocsc()[:, live][live].toarray()
    scale = 1.0 / np.sqrt(mass[live])
    none = system.loose.shape[1]
    square, vector = eigh(matrix * scale[:, None] * scale, subset_by_index=[none, none + count - 1])
    shape = np.zeros((len(mass), count))
    shape[live] = scale[:, None] * vector
    return square, shape, 1


def _inverse_lanczos(system: System, mass: Floats, count: int) -> tuple[Floats, Floats, int]:
    root = np.sqrt(mass)
    rigid = orthonormal(root[:, None] * system.loose)
    elimination = Elimination(system)

    def free(v: Floats) -> Floats:
        return v - rigid @ (rigid.T @ v)

    rounds = 0

    def inverse(v: Floats) -> Floats:
        nonlocal rounds
        rounds += 1
        return free(root * elimination.solve(root * free(v * alive))[0])

    alive = system.free.ravel().astype(float)
    scale = diags_array(1.0 / root)
    start = free(alive * np.random.default_rng(0).standard_normal(len(mass)))
    matrix = csc_array(scale @ system.matrix.tocsc() @ scale)
    square, vector = lowest_modes(matrix, inverse, start, count=count, tolerance=1e-12)
    return square, vector / root[:, None], rounds


def _block_gradients(system: System, mass: Floats, count: int) -> tuple[Floats, Floats, int]:
    """Locally optimal block preconditioned conjugate gradients (Knyazev 2001), begun with the clumps' modes."""
    iteration = Iteration(system)
    n, none = len(iteration.root), system.loose.shape[1]
    root = iteration.root
    blocks = np.swapaxes(root, 1, 2) @ (mass.reshape(n, 6, 1) * root)
    K, M = iteration.scaled, bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=iteration.scaled.shape)
    width = min(count + _GUARD, int(system.free.sum()) - none)
    rigid = iteration.unscaled(system.loose)
    rigid = rigid @ normalising(rigid.T @ (M @ rigid))
    M_rigid = M @ rigid
    S = iteration.coarse.modes(M, width + none)
    S -= rigid @ (M_rigid.T @ S)
    KS, MS = K @ S, M @ S
    last = 0
    for k in range(_ROUNDS):
        square, turn = _ritz(S.T @ KS, S.T @ MS, width)
        X, KX, MX = S @ turn, KS @ turn, MS @ turn
        R = KX - MX * square
        W = iteration.approximate(R)
        # bounds the error of each ω², but for the quality of the preconditioner
        error = np.einsum("nk,nk->k", R, W)
        if (error[:count] <= _TOLERANCE * square[:count]).all():
            return square[:count], iteration.displacement(X[:, :count]), k + 1
        W -= rigid @ (M_rigid.T @ W)
        turn[:last] = 0.0
        last = width
        S, KS, MS = (
            np.hstack([new, fresh, old @ turn])
            for new, fresh, old in ((X, W, S), (KX, K @ W, KS), (MX, M @ W, MS))
        )
    raise ConvergenceError(
        f"the first {count} modes did not converge; ask for fewer with count=, and for bonds with moments where"
        " elements can roll freely"
    )


def _ritz(K: Floats, M: Floats, count: int) -> tuple[Floats, Floats]:
    """Lowest eigenvalues and vectors of a small pencil whose vectors may nearly depend on each other."""
    scale = 1.0 / np.sqrt(M.diagonal())
    size, vector = np.linalg.eigh(M * scale[:, None] * scale)
    keep = size > 1e-12 * size[-1]
    basis = scale[:, None] * vector[:, keep] / np.sqrt(size[keep])
    square, turn = np.linalg.eigh(basis.T @ K @ basis)
    return square[:count], basis @ turn[:, :count]
