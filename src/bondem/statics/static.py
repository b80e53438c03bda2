"""Static equilibrium of a model under its final loads."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import cast

import numpy as np

from bondem._blas import one_blas_thread
from bondem._checks import instance
from bondem._drawing import Coloured, Plotted, columns_of
from bondem._progress import staged
from bondem._types import Floats, PerElement, PerElement3, PerElement6
from bondem.errors import InputError
from bondem.interactions.lagged_interaction import LaggedInteraction
from bondem.model.model import Model
from bondem.model.solution import Solution
from bondem.model.state import State
from bondem.observables.cell_stress import cell_stress
from bondem.observables.energy import EnergyParts, linear_energy
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.posed_state import in_equilibrium
from bondem.observables.principal_stresses import principal_stresses, von_mises_stress
from bondem.specimen.particles import freeze
from bondem.statics.lagged_statics import LaggedStatics
from bondem.statics.linear import System, solver
from bondem.statics.nonlinear import follow, strained


@dataclass(frozen=True, eq=False)
class StaticResult(Solution, Plotted):
    """Static equilibrium of a model, in the user's order; the displacements of rattlers are 0.

    `bd.failure_index` evaluates a criterion for it, and `bd.write_vtkhdf` writes it with its stresses.

    Its residual is the unbalanced force over the sum of applied and supporting force. These are roots of sums of
    squares, with torques divided by the mean radius.

    Attributes:
        displacement: displacements of the centres [m], shape (n, 3).
        rotation: rotation vectors [rad], shape (n, 3).
        reaction: force and moment of the supports on each element [N, N·m], shape (n, 6); 0 for free elements.
        energy: elastic energy of the bonds [J].
        model: model that is in equilibrium.
        nonlinear: True if rotations may be large.
    """

    displacement: PerElement3
    rotation: PerElement3
    reaction: PerElement6
    energy: EnergyParts
    model: Model
    nonlinear: bool = False

    @property
    def state(self) -> State:
        """State at rest in this equilibrium; conditions of its model are constant at the end of their schedules."""
        return in_equilibrium(self.model, self)

    @cached_property
    def stress(self) -> Floats:
        """Mean stress tensor of every element, `bd.cell_stress` [Pa], shape (n, 3, 3)."""
        if not self.nonlinear:
            return freeze(cell_stress(self.model, self))
        state = self.state
        return freeze(cell_stress(cast(Model, state.model), state))

    @property
    def principal_stresses(self) -> PerElement3:
        """Principal stresses σ1 ≥ σ2 ≥ σ3 of every element, tension positive [Pa], shape (n, 3)."""
        return principal_stresses(self.stress)

    @property
    def von_mises_stress(self) -> PerElement:
        """Stress of von Mises of every element [Pa], shape (n,)."""
        return von_mises_stress(self.stress)

    @property
    def table(self) -> dict[str, Floats]:
        """Motion, reaction and stress of every element, by name and unit, (n,) each."""
        stress = self.stress.reshape(-1, 9)[:, [0, 4, 8, 1, 5, 2]]
        return (
            columns_of("{} [m]", "xyz", self.model.lattice.centre)
            | columns_of("displacement {} [m]", "xyz", self.displacement)
            | columns_of("rotation {} [rad]", "xyz", self.rotation)
            | columns_of("reaction {} [N]", "xyz", self.reaction[:, :3])
            | columns_of("reaction moment {} [N·m]", "xyz", self.reaction[:, 3:])
            | columns_of("stress {} [Pa]", ("xx", "yy", "zz", "xy", "yz", "xz"), stress)
            | columns_of("principal stress {} [Pa]", "123", self.principal_stresses)
            | {"von Mises stress [Pa]": self.von_mises_stress}
        )

    @property
    def drawn(self) -> dict[str, Floats]:
        """Empty mapping, because figures show the elements with their motion and stress, and no curves."""
        return {}

    @property
    def _pictures(self) -> tuple[Coloured, ...]:
        turned = self.state.orientation if self.nonlinear else self.rotation
        far, stress = np.linalg.norm(self.displacement, axis=1), 1e-6 * self.von_mises_stress
        return tuple(
            Coloured(self.model.lattice, values, label, self.displacement, turned)
            for values, label in ((far, "displacement [m]"), (stress, "von Mises stress [MPa]"))
        )

    def scaled(self, factor: float) -> "StaticResult":
        """Return a copy with displacements and rotations times a factor, as a guess for bonds of another modulus."""
        return replace(self, displacement=factor * self.displacement, rotation=factor * self.rotation)


@one_blas_thread
@staged("static solution")
def solve_static(model: Model, *, nonlinear: bool = False, guess: StaticResult | None = None) -> StaticResult:
    """Compute the equilibrium under the loads and prescribed motions at the end of their schedules.

    A specimen that its supports leave free to move rigidly must carry balanced loads; its rigid motion is removed
    from the result. Absorbing boundaries have no effect. For the non-local law the result is the end of a path from
    the unloaded state, found in rounds (`bondem.statics.lagged_statics`). Its energy is that of the springs.

    Args:
        model: model to solve.
        nonlinear: True to follow large rotations; False to solve K u = f at the reference.
        guess: solution of a similar model, from which an iterative solution of K u = f starts, or None. An
            elimination ignores it.

    Raises:
        InputError: Loads drive a rigid motion that is free, a velocity is prescribed, or the model has contacts,
            walls, a criterion or no bonds. Or a guess is given for a nonlinear path, or belongs to another lattice.
        ConvergenceError: No bond resists the load, or no equilibrium is found.
    """
    instance("solve_static", "model", model, Model, "bd.Model(...)")
    instance("solve_static", "nonlinear", nonlinear, bool, "True or False")
    if nonlinear and not model.interaction.has_potential:
        raise InputError(
            f"the {model.interaction.title} has no potential to follow; leave out nonlinear=, or use solve_explicit"
        )
    if not nonlinear:
        return Statics(model).equilibrium(guess=guess)
    if guess is not None:
        raise InputError("solve_static: guess= has no effect on a nonlinear path, which begins at rest; leave it out")
    layout, constraints = model.layout, model.constraints
    n = len(layout.order)
    bent = follow(model, System.of(model))
    values = bent.motion[layout.rank]
    reaction = np.where(constraints.prescribed(n), bent.force - constraints.final_load(n, bent.state.pose), 0.0)
    end = strained(model, 1.0)
    energy = end.interaction.energy(bent.state.pose, bent.state.rest, bent.state.integrity, bent.state.eigenstrain)
    return StaticResult(
        values[:, :3].copy(), values[:, 3:].copy(), (reaction + bent.walls)[layout.rank], energy, model, True,
        iterations=bent.rounds, residual=bent.residual,
    )  # fmt: skip


class Statics:
    """Linear statics of a model: one matrix and one solver for any number of loads."""

    @one_blas_thread
    def __init__(self, model: Model) -> None:
        self.model = model
        self._system = System.of(model)
        law = model.interaction
        self._lagged = LaggedStatics(law, self._system) if isinstance(law, LaggedInteraction) else None
        self._solver = None if self._lagged is not None else solver(self._system)

    @one_blas_thread
    def equilibrium(self, *, guess: StaticResult | None = None) -> StaticResult:
        """Compute the equilibrium of the model under its own loads; see `solve_static`."""
        model, system = self.model, self._system
        layout, constraints = model.layout, model.constraints
        n = len(layout.order)
        motion, load = constraints.final_motion(n).ravel(), constraints.final_load(n).ravel()
        _check_balance(system, load, model)
        strain = constraints.final_strain()
        law = model.interaction
        load = load + law.strain_load(strain, model.pressed).ravel()
        right = load - system.matrix @ motion if motion.any() else load
        start = None
        if guess is not None:
            instance("solve_static", "guess", guess, StaticResult, "what solve_static returned for a similar model")
            if guess.displacement.shape != (n, 3):
                raise InputError(f"guess= has {len(guess.displacement)} elements; give a solution with {n}")
            start = np.hstack([guess.displacement, guess.rotation])[layout.order].ravel()
        if self._lagged is not None:
            return _of_lagged(model, system, self._lagged, load, motion)
        assert self._solver is not None
        change, iterations = self._solver.solve(right, guess=start)
        solution = motion + change
        unbalanced = (system.matrix @ solution - load).reshape(n, 6)
        reaction = np.where(constraints.prescribed(n), unbalanced, 0.0)
        displacement, rotation = (part.copy() for part in np.hsplit(solution.reshape(n, 6)[layout.rank], 2))
        reaction = reaction[layout.rank] + law.of_walls(displacement, rotation, strain, model.pressed)
        return StaticResult(
            displacement, rotation, reaction, linear_energy(model, displacement, rotation, strain), model,
            iterations=iterations, residual=_residual(system, unbalanced, load.reshape(n, 6)),
        )  # fmt: skip

    @one_blas_thread
    def response(self, load: PerElement6, *, guess: PerElement6 | None = None, rtol: float = 1e-10) -> PerElement6:
        """Compute displacements and rotations [m, rad] under other nodal forces and moments [N, N·m], (n, 6) each.

        Supports are at rest. Loads on a specimen that is free to move must be balanced.

        Args:
            load: forces and moments, user's order.
            guess: displacements and rotations with which an iteration starts [m, rad], user's order; None for zero.
            rtol: residual over load at which the iteration ends [-].

        Raises:
            InputError: The loads drive a rigid motion that the supports permit.
            ConvergenceError: No bond resists the load.
        """
        order, rank = self.model.layout.order, self.model.layout.rank
        load = load[order].ravel()
        _check_balance(self._system, load)
        if self._lagged is not None:
            return self._lagged.settle(load.reshape(-1, 6)[rank]).motion
        assert self._solver is not None
        start = None if guess is None else guess[order].ravel()
        return self._solver.solve(load, guess=start, rtol=rtol)[0].reshape(-1, 6)[rank]


def _of_lagged(model: Model, system: System, statics: LaggedStatics, load: Floats, motion: Floats) -> StaticResult:
    """Return the equilibrium of a law with lagged stresses under loads and motions, internal order, (6 n,) each."""
    order, rank = model.layout.order, model.layout.rank
    n = len(order)
    found = statics.settle(load.reshape(n, 6)[rank], motion=motion.reshape(n, 6)[rank])
    strain = found.strain
    unbalanced = -strain.nodal(strain.force)[order] - load.reshape(n, 6)
    reaction = np.where(model.constraints.prescribed(n), unbalanced, 0.0)
    return StaticResult(
        displacement=found.motion[:, :3].copy(), rotation=found.motion[:, 3:].copy(), reaction=reaction[rank],
        energy=strain.energy, model=model, iterations=found.rounds,
        residual=_residual(system, unbalanced, load.reshape(n, 6)),
    )  # fmt: skip


def _residual(system: System, unbalanced: Floats, load: Floats) -> float:
    """Return the unbalanced force of free elements over loads and supporting forces [-]."""
    metric = np.repeat([1.0, 1.0 / system.length], 3)
    rest = float(np.linalg.norm(np.where(system.free, unbalanced, 0.0) * metric))
    scale = np.linalg.norm(load * metric) + np.linalg.norm(np.where(system.free, 0.0, unbalanced) * metric)
    return rest / float(scale) if scale > 0.0 else 0.0


def _check_balance(system: System, load: Floats, model: Model | None = None) -> None:
    """Raise InputError if a load (6 n,) [N, N·m] drives a rigid motion that the supports permit.

    `model` is the model whose conditions cause this load, or None for another load.
    """
    forces = load.reshape(-1, 6) / np.repeat([1.0, system.length], 3)
    driving, scale = np.abs(system.loose.T @ load).max(initial=0.0), float(np.linalg.norm(forces))
    if model is not None:  # loads that cancel within each element leave rounding errors
        scale = math.hypot(scale, model.constraints.applied_force, np.linalg.norm(loads_on_facets(model)))
    if driving > 1e-8 * scale:
        raise InputError(
            "the loads drive a rigid motion that the supports leave free; balance them with an opposite Load,"
            " or hold the specimen with Fix"
        )
