"""Natural modes of a model: K φ = ω² M φ."""

from dataclasses import dataclass
from typing import Any, Literal, cast

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import bsr_array, csc_array, csr_array, diags_array
from scipy.sparse.linalg import LinearOperator

from bondem._blas import one_blas_thread
from bondem._checks import count as whole_number
from bondem._checks import instance
from bondem._drawing import Coloured, Plotted
from bondem._names import warn_user
from bondem._progress import staged
from bondem._types import Floats, Ints
from bondem.boundary.conditions import Load
from bondem.boundary.loads import BodyForce, Eigenstrain, Pressure
from bondem.errors import ConvergenceError, InputError, PrestressWarning
from bondem.interactions.cells.corrected_mass import corrected_mass
from bondem.model.model import Model
from bondem.model.solution import Solution
from bondem.model.state import State
from bondem.model.stiffness_matrices import mass_diagonal
from bondem.statics.lanczos import lowest_modes
from bondem.statics.linear import (
    Elimination,
    Iteration,
    System,
    normalising,
    orthonormal,
    prefers_elimination,
    solver,
)
from bondem.statics.prestress import about_equilibrium
from bondem.statics.static import StaticResult

# Number of additional vectors in a block, so that it does not end between two equal frequencies.
_GUARD = 4
# Error of ω² at which the iteration stops, as a share of ω².
_TOLERANCE = 1e-8
_ROUNDS = 300
# Rounds after which a block is widened, and least number of further vectors.
_PATIENCE, _WIDER = 60, 8
# -ω² of the lowest mode over the largest ω² from which on an equilibrium counts as unstable.
_UNSTABLE = 1e-6


@dataclass(frozen=True, eq=False)
class ModesResult(Solution, Plotted):
    """Lowest natural modes of a model, without rigid motions that the supports leave free.

    The residual is the largest error of ω² that K φ - ω² M φ allows, over the largest requested ω².

    Attributes:
        frequency: ω / 2π, ascending [Hz], shape (count,).
        shape: φ of each mode, translations and rotations (u, θ) in the user's order, normalised to
            φᵀ M φ = 1 kg·m², largest component positive, shape (count, n, 6).
        model: model that vibrates.
    """

    frequency: Floats
    shape: Floats
    model: Model

    @property
    def table(self) -> dict[str, Floats]:
        """Number and frequency of every mode, by name and unit, (count,) each."""
        return {"mode [-]": np.arange(1.0, len(self.frequency) + 0.5), "frequency [Hz]": self.frequency}

    @property
    def _pictures(self) -> tuple[Coloured, ...]:
        # relative motion, because the size of a mode depends on the mass only
        size = np.linalg.norm(self.shape[0, :, :3], axis=1).max() or 1.0
        moved = self.model.lattice.particles.mean_radius / size * self.shape[0]
        far, title = np.linalg.norm(moved[:, :3], axis=1), f"lowest mode, {self.frequency[0]:.4g} Hz"
        values, label = far / far.max(), "motion over its largest value [-]"
        return (Coloured(self.model.lattice, values, label, moved[:, :3], moved[:, 3:], title),)


@one_blas_thread
@staged("modes")
def solve_modes(
    model: Model, *, count: int = 8, prestress: StaticResult | State | Literal[False] | None = None
) -> ModesResult:
    """Compute the lowest natural frequencies and modes, without damping.

    Fixed and driven elements are at rest. Rigid motions that the supports permit are left out, and so are rattlers.
    Absorbing boundaries have no effect. Loads and strains act only through the stresses of `prestress`: tension makes
    a string stiffer across, and pressure makes a column softer.

    Args:
        model: the vibrating model.
        count: number of modes.
        prestress: equilibrium about which the specimen vibrates, without free rigid motions. Give
            `bd.solve_static(model)`, with nonlinear=True for large motions, or a state at rest. None means the
            reference configuration; False means the same without a warning about loads that have no effect.

    Warns:
        PrestressWarning: The model has loads or strains, and no `prestress` is given.

    Raises:
        InputError: The model has fewer modes than `count`, no bonds or potential, or contacts, walls or a criterion.
            Or `prestress` is not an equilibrium of the model, or an unstable one.
        ConvergenceError: The iteration did not reach an estimated relative error of 1e-8 in ω².
    """
    instance("solve_modes", "model", model, Model, "bd.Model(...)")
    count = whole_number("solve_modes", "count", count, least=1)
    if not model.interaction.has_potential:
        raise InputError(
            f"the {model.interaction.title} has no potential, and so no modes; use bd.CellBond, or solve_explicit"
        )
    system, mass = System.of(model), mass_diagonal(model)
    if prestress is None:
        _warn_of_loads(model)
    elif prestress is not False:
        system = about_equilibrium(model, system, prestress)
    available = int(system.free.sum()) - system.loose.shape[1]
    if not 1 <= count <= available:
        raise InputError(f"count = {count}, but the model has {available} modes; give a number from 1 to {available}")
    corrected = mass_matrix(model, system)
    if corrected is not None:
        square, shape, rounds = _of_corrected_mass(system, corrected, mass, count)
    elif available <= max(200, 4 * count):
        square, shape, rounds = _dense(system, mass, count)
    elif prefers_elimination(system):
        square, shape, rounds = _inverse_lanczos(system, mass, count)
    else:
        square, shape, rounds = _block_gradients(system, mass, count)
    if square[0] < -_UNSTABLE * np.abs(square).max() and prestress is not None and prestress is not False:
        raise InputError("prestress= is an unstable equilibrium that buckles and has no frequencies; lower the loads")
    M = diags_array(mass) if corrected is None else corrected
    shape /= np.sqrt((shape * (M @ shape)).sum(axis=0))
    shape *= np.sign(shape[np.abs(shape).argmax(axis=0), np.arange(count)])
    frequency = np.sqrt(np.maximum(square, 0.0)) / (2.0 * np.pi)
    return ModesResult(
        frequency, shape.T.reshape(count, -1, 6)[:, model.layout.rank].copy(), model,
        iterations=rounds, residual=_residual(system, M, mass, square, shape),
    )  # fmt: skip


def _warn_of_loads(model: Model) -> None:
    loaded = [one for one in model.boundary if isinstance(one, Load | Pressure | BodyForce | Eigenstrain)]
    if loaded:
        warn_user(
            f"solve_modes: {type(loaded[0]).__name__} does not affect the modes of the reference; give"
            " prestress=bd.solve_static(model) for those of the loaded specimen, or prestress=False",
            PrestressWarning,
        )


def _residual(system: System, M: Any, mass: Floats, square: Floats, shape: Floats) -> float:
    rest = (system.matrix @ shape - (M @ shape) * square) * system.free.ravel()[:, None]
    error = np.sqrt((rest**2 / mass[:, None]).sum(axis=0).max())
    return float(error / square[-1]) if square[-1] > 0.0 else 0.0


def mass_matrix(model: Model, system: System) -> csr_array | None:
    """Return the dispersion-corrected mass matrix, (6 n, 6 n), or None for lumped masses."""
    factor, forms = model.correction, system.matrix.forms
    if factor is None or forms is None:
        return None
    return corrected_mass(mass_diagonal(model), csr_array(forms.tocsr()), factor[model.layout.order])


def _of_corrected_mass(system: System, M: csr_array, mass: Floats, count: int) -> tuple[Floats, Floats, int]:
    """Return ω² (count,), modes (6 n, count) and rounds of iteration for a mass matrix that is not diagonal."""
    live = np.flatnonzero(system.free)
    rigid = system.loose @ normalising(system.loose.T @ (mass[:, None] * system.loose))
    solve, rounds = solver(system).solve, [0]

    def inverse(load: Floats) -> Floats:
        whole = _spread(load, live, len(mass))
        whole -= mass[:, None] * rigid @ (rigid.T @ whole)
        rounds[0] += 1
        motion = solve(whole, rtol=1e-12)[0]
        return (motion - rigid @ (rigid.T @ (mass * motion)))[live]

    def product(motion: Floats) -> Floats:
        return (system.matrix @ _spread(motion, live, len(mass)))[live]

    K = LinearOperator((len(live), len(live)), matvec=product, dtype=float)
    start = inverse(np.random.default_rng(0).standard_normal(len(live)))
    square, shape = lowest_modes(K, inverse, start, mass=csr_array(M[live][:, live]), count=count, tolerance=0.0)
    return square, _spread(shape, live, len(mass)), rounds[0]


def _spread(values: Floats, live: Ints, size: int) -> Floats:
    """Return values of the free degrees of freedom `live`, (k, …), at all degrees of freedom, (size, …); others 0."""
    whole = np.zeros((size, *values.shape[1:]))
    whole[live] = values
    return whole


def _dense(system: System, mass: Floats, count: int) -> tuple[Floats, Floats, int]:
    live = np.flatnonzero(system.free)
    matrix = csc_array(system.matrix.tocsc()[:, live])[live].toarray()
    scale = 1.0 / np.sqrt(mass[live])
    none = system.loose.shape[1]
    found: Any = eigh(matrix * scale[:, None] * scale, subset_by_index=[none, none + count - 1])
    square, vector = found
    return square, _spread(scale[:, None] * vector, live, len(mass)), 1


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
    """Return ω² (count,), modes (6 n, count) and rounds of block conjugate gradients (LOBPCG, Knyazev 2001).

    The iteration starts from modes of the clusters. Equal frequencies, of which a ball has many, converge
    slowly if the block ends among them. A block that has not converged in 60 rounds is therefore widened.
    """
    iteration = Iteration(system)
    n, none = len(iteration.root), system.loose.shape[1]
    root = iteration.root
    blocks = np.swapaxes(root, 1, 2) @ (mass.reshape(n, 6, 1) * root)
    M = bsr_array((blocks, np.arange(n), np.arange(n + 1)), shape=iteration.scaled.shape)
    most = int(system.free.sum()) - none
    rigid = iteration.unscaled(system.loose)
    rigid = rigid @ normalising(rigid.T @ (M @ rigid))
    found, rounds, guard = np.zeros((6 * n, 0)), 0, _GUARD
    while rounds < _ROUNDS:
        width = min(count + guard, most)
        S = np.hstack([found, iteration.coarse.modes(M, width + none)])
        S -= rigid @ ((M @ rigid).T @ S)
        square, found, new, done = _iterated(iteration, M, rigid, S, count=count, width=width)
        rounds += new
        if done:
            return square[:count], iteration.displacement(found[:, :count]), rounds
        guard += max(_WIDER, count // 2)
    raise ConvergenceError(
        f"the first {count} modes did not converge; ask for fewer with count=, and for bonds with moments where"
        " elements can roll freely"
    )


def _iterated(
    iteration: Iteration, M: Any, rigid: Floats, S: Floats, *, count: int, width: int
) -> tuple[Floats, Floats, int, bool]:
    """Return ω², (width,), and vectors of a block, its rounds, and True if the first `count` have converged."""
    K = cast(Any, iteration.scaled)  # types of sparse products take a type checker a minute in this loop
    M_rigid, KS, MS = M @ rigid, K @ S, M @ S
    last, square, X = 0, np.zeros(0), S
    for k in range(_PATIENCE):
        square, turn = _ritz(S.T @ KS, S.T @ MS, width)
        X, KX, MX = S @ turn, KS @ turn, MS @ turn
        R = KX - MX * square
        W = iteration.approximate(R)
        if square[0] < -_UNSTABLE * np.abs(square[:count]).max():  # Ritz values are above the least: it buckles
            return square, X, k + 1, True
        # bounds the error of each ω², but for the quality of the preconditioner
        error = np.einsum("nk,nk->k", R, W)
        if len(square) >= count and (error[:count] <= _TOLERANCE * square[:count]).all():
            return square, X, k + 1, True
        W -= rigid @ (M_rigid.T @ W)
        turn[:last] = 0.0
        last = turn.shape[1]
        S, KS, MS = (
            np.hstack([new, fresh, old @ turn]) for new, fresh, old in ((X, W, S), (KX, K @ W, KS), (MX, M @ W, MS))
        )
    return square, X, _PATIENCE, False


def _ritz(K: Floats, M: Floats, count: int) -> tuple[Floats, Floats]:
    """Return the lowest eigenvalues, (count,), and vectors of a pencil (K, M) of nearly dependent vectors."""
    scale = 1.0 / np.sqrt(M.diagonal())
    size, vector = np.linalg.eigh(M * scale[:, None] * scale)
    keep = size > 1e-12 * size[-1]
    basis = scale[:, None] * vector[:, keep] / np.sqrt(size[keep])
    square, turn = np.linalg.eigh(basis.T @ K @ basis)
    return square[:count], basis @ turn[:, :count]
