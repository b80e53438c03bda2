"""Equilibrium at large rotations: the minimum of the energy of bonds and loads, found by Newton's method.

The tangent is the second derivative of the bond energy by displacements and spins, exact to rounding for each bond.
Loads keep their direction; the forces of a moment rotate with its region. Load and prescribed motion grow together in
steps that rotate no element by more than a fraction of a radian. This follows the path from rest.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import bsr_array

from bondem._types import Floats
from bondem.boundary.couples import Couple
from bondem.boundary.wall_constraints import reference_base
from bondem.errors import ConvergenceError, InputError
from bondem.geometry.rotations import rotation_vector, turned_further
from bondem.interactions.beams.beam_tables import beam_tables, count_turned
from bondem.interactions.stiffness import Stiffness
from bondem.model.model import Model
from bondem.model.state import State
from bondem.statics.linear import Elimination, System, solver

# Largest rotation of an element in one step of the load [rad].
_TURN = 0.3
_ROUNDS = 20
_TOLERANCE = 1e-9
_SHORTEST = 1e-4
# Largest number of elements for which the tangent is eliminated if moments act: without their part it may be
# indefinite, so that conjugate gradients fail.
_ELIMINATED = 5000


@dataclass(frozen=True, eq=False)
class Bent:
    """Equilibrium at large rotations, internal order.

    Attributes:
        state: state with the poses.
        motion: displacements and rotation vectors [m, rad], shape (n, 6).
        force: resistance of the bonds to displacements and spins, K u for small ones [N, N·m], (n, 6).
        walls: loads on cells by walls that fix their facets [N, N·m], (n, 6).
        rounds: number of iterations of Newton's method, over all steps of the load.
        residual: unbalanced force at the end, over that of loads and supports [-].
    """

    state: State
    motion: Floats
    force: Floats
    walls: Floats
    rounds: int
    residual: float


def follow(model: Model, system: System) -> Bent:
    """Return the equilibrium at the end of all schedules, reached in steps from rest.

    Raises:
        InputError: The supports leave a rigid motion free.
        ConvergenceError: The load cannot be reached, because the body buckles or bonds turn beyond their range.
    """
    if system.loose.shape[1]:
        raise InputError("nonlinear=True needs a specimen that is held; fix all six rigid motions with Fix")
    n = len(system.free)
    motion = model.constraints.final_motion(n)
    state = State(model)
    done, step, residual = 0.0, 1.0, 0.0
    rounds = 0
    while done < 1.0:
        step = min(step, 1.0 - done)
        trial = _advance(strained(model, done + step), system, state, done + step, motion * step)
        rounds += trial.rounds
        if trial.state is not None:
            state, done, step, residual = trial.state, done + step, 2.0 * step, trial.residual
        else:
            step *= trial.shorter
            if step < _SHORTEST:
                raise ConvergenceError(
                    f"no equilibrium was found beyond {done:.4g} of the load: it buckles, or turns bonds too far;"
                    " lower it, bond with more and shorter bonds, or use solve_explicit with damping"
                )
    force, walls = strained(model, 1.0).interaction.gradient(state.pose)
    return Bent(state, moved_from_rest(state), force, walls, rounds, residual)


def moved_from_rest(state: State) -> Floats:
    """Return displacements and rotation vectors of a state [m, rad], internal order, (n, 6)."""
    return np.concatenate([state.pose[:, :3] - state.rest, rotation_vector(state.pose[:, 4:])], axis=1)


def strained(model: Model, share: float) -> Model:
    """Return the model with a share of its final stress-free strains, tractions, and motions of walls."""
    law, constraints = model.interaction, model.constraints
    motion = share * law.supports.motion
    strain, pressed = share * constraints.final_strain(), share * constraints.final_press()
    return model.by(law.strained(strain, reference_base(len(motion)), motion, pressed))


@dataclass(frozen=True, eq=False)
class _Trial:
    """Result of a load step: its equilibrium and residual, or the factor by which to shorten the step."""

    rounds: int
    state: State | None = None
    residual: float = np.nan
    shorter: float = 0.5


def _advance(model: Model, system: System, start: State, share: float, motion: Floats) -> _Trial:
    """Return the equilibrium under a `share` of the loads after a prescribed `motion` [m, rad], (n, 6)."""
    state = start.copy()
    noise = 1e-14 * float((model.bonds.kn * model.bonds.length).max()) * np.sqrt(len(motion))
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity, may_share=False)
    for k in range(_ROUNDS):
        force, walls = model.interaction.gradient(state.pose)
        load = share * model.constraints.final_load(len(motion), state.pose)
        rest, scale = _sizes(system, load, force, walls)
        if k and rest <= _TOLERANCE * scale + noise:
            wide, _, sick = count_turned(state.pose, beams)
            left = rest / scale if scale > 0.0 else 0.0
            return _Trial(k) if wide or sick else _Trial(k, state, left)
        tangent = replace(system, matrix=tangent_matrix(model, system.matrix.bonds, state.pose))
        right = (load - force).ravel()
        if k == 0 and motion.any():
            right = right - tangent.matrix @ motion.ravel()
        try:
            change = _solved(tangent, right, model.constraints.final_couples(), share, state.pose).reshape(-1, 6)
        except ConvergenceError:
            return _Trial(k)
        if k == 0:
            change += motion
        turn = np.sqrt((change[:, 3:] ** 2).sum(axis=1).max())
        if not turn <= 3.0 * _TURN:
            return _Trial(k, shorter=min(0.5, _TURN / turn) if np.isfinite(turn) else 0.5)
        if k == 0 and turn > 1.2 * _TURN:
            return _Trial(k, shorter=_TURN / turn)
        state.pose[:, :3] += change[:, :3]
        state.pose[:, 4:] = turned_further(state.pose[:, 4:], change[:, 3:])
    return _Trial(_ROUNDS)


def _solved(
    tangent: System, right: Floats, couples: list[tuple[Couple, float]], share: float, pose: Floats
) -> Floats:
    """Return the change by Newton's method, (6 n,), with forces of moments that rotate with their regions.

    The forces add an unsymmetric matrix of rank three per moment to the tangent, so that Woodbury's identity applies.
    """
    if not couples:
        return solver(tangent).solve(right, rtol=1e-8)[0]
    by = Elimination(tangent) if len(tangent.free) <= _ELIMINATED else solver(tangent)
    n, count = len(tangent.free), 3 * len(couples)
    G, seen_by = np.zeros((2, n, 6, count))
    for c, (couple, factor) in enumerate(couples):
        given, seen = couple.turning(pose)
        np.add.at(G[:, :, 3 * c : 3 * c + 3], couple.element, share * factor * given)
        np.add.at(seen_by[:, :, 3 * c : 3 * c + 3], couple.element, seen.transpose(1, 2, 0))
    B = seen_by.reshape(-1, count).T * tangent.free.ravel()
    moved = np.stack([by.solve(column, rtol=1e-8)[0] for column in G.reshape(-1, count).T], axis=1)
    change = by.solve(right, rtol=1e-8)[0]
    return change + moved @ np.linalg.solve(np.eye(count) - B @ moved, B @ change)


def tangent_matrix(model: Model, pattern: bsr_array, pose: Floats) -> Stiffness:
    """Return the symmetric part of the second derivative of the bond energy at a pose, (6 n, 6 n).

    The antisymmetric part is the torque on each element, because spins are applied one after the other. It vanishes
    in equilibrium. `pose` is the pose of all elements, internal order, (n, 8). `pattern` is a matrix with the blocks
    of the result, such as the matrix at rest.
    """
    layout = model.layout
    whole = model.interaction.bond_tangents(pose)
    H = np.moveaxis(0.5 * (whole + np.swapaxes(whole, 0, 1)), 2, 0)
    diagonal, above, below = layout.blocks
    data = np.zeros_like(pattern.data)
    np.add.at(data, diagonal[layout.i], H[:, :6, :6])
    np.add.at(data, diagonal[layout.j], H[:, 6:, 6:])
    data[above], data[below] = H[:, :6, 6:], H[:, 6:, :6]
    return model.interaction.tangent(pose, data, pattern)


def at_pose(model: Model, system: System, pose: Floats) -> Stiffness:
    """Return the tangent of a strained model at a pose, (n, 8), into which the stresses of its cells are written."""
    model.interaction.gradient(pose)
    return tangent_matrix(model, system.matrix.bonds, pose)


def unbalanced(model: Model, system: System, pose: Floats) -> float:
    """Return the unbalanced force at a pose over that of the final loads and supports, with torques over R̄ [-]."""
    rest, scale = _sizes(system, model.constraints.final_load(len(pose), pose), *model.interaction.gradient(pose))
    return rest / scale if scale > 0.0 else 0.0


def _sizes(system: System, load: Floats, force: Floats, walls: Floats) -> tuple[float, float]:
    """Return the norm of the unbalanced force, and that of loads and supports, with torques over R̄ [N].

    Loads, resistance of the bonds and loads by walls have the shape (n, 6) [N, N·m].
    """
    metric = np.repeat([1.0, 1.0 / system.length], 3)
    rest = np.where(system.free, load - force, 0.0) * metric
    supports = np.where(system.free, walls, force) * metric
    return float(np.linalg.norm(rest)), float(np.linalg.norm(load * metric) + np.linalg.norm(supports))
