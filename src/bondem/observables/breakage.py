"""Broken bonds of a run, and the failure index of unbroken ones, which is 1 at failure."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance
from bondem._tables.columns import EventColumn, SoftColumn
from bondem._types import Floats, Ints, PerBond
from bondem.damage.criteria.criterion import MODES
from bondem.errors import InputError
from bondem.interactions.cells.cell_tables import STRESS
from bondem.model.model import Model
from bondem.model.state import State
from bondem.model.state_compatibility import difference
from bondem.observables.cell_forces import SmallMotion
from bondem.observables.cell_stress import lambda_theta
from bondem.observables.crack_index import crack_index
from bondem.observables.posed_state import posed


@dataclass(frozen=True, eq=False)
class BrokenBonds:
    """Broken bonds or facets in the order of breakage; those of one step are in the internal order of bonds.

    A run that continues from a state keeps the breakages of this state, and numbers its own steps anew.

    Attributes:
        time: time of breakage [s], shape (e,).
        step: number of the time step of breakage within its run [-], shape (e,).
        bond: user's number of the bond or facet [-], shape (e,).
        mode: "tension", "shear", "bending" or "twisting", shape (e,).
        gap: elongation of a bond from its rest length, or opening of a facet along its normal [m], shape (e,).
        energy: energy released [J], shape (e,).
        position: contact point of the bond, or middle of the facet [m], shape (e, 3).
        opening_steps: number of time steps from the onset of softening to complete loss [-], shape (e,): 0 for the
            same step, nan for bonds and facets that failed at once or whose onset is unknown.
    """

    time: Floats
    step: Ints
    bond: Ints
    mode: np.ndarray
    gap: Floats
    energy: Floats
    position: Floats
    opening_steps: Floats

    @classmethod
    def of(cls, state: State) -> "BrokenBonds":
        """List the bonds or facets that have broken up to a state."""
        rows = state.broken
        return cls(
            time=rows[:, EventColumn.TIME].copy(),
            step=rows[:, EventColumn.STEP].astype(np.int64),
            bond=state.layout.bond_order[rows[:, EventColumn.BOND].astype(np.int64)],
            mode=np.array(MODES)[rows[:, EventColumn.MODE].astype(np.int64)],
            gap=rows[:, EventColumn.GAP].copy(),
            energy=rows[:, EventColumn.ENERGY].copy(),
            position=rows[:, EventColumn.PLACE : EventColumn.PLACE + 3] + state.origin,
            opening_steps=rows[:, EventColumn.OPENING_STEPS].copy(),
        )

    def __len__(self) -> int:
        return len(self.time)


def failure_index(model: Model, state: State | SmallMotion) -> PerBond:
    """Compute the index of the failure criterion for each bond or facet: 1 at failure, 0 if broken.

    Static solutions are those of the model without its criterion, `dataclasses.replace(model, failure=None)`.

    Softening beams and facets have index 1. Functions of the stress of cells, such as `bd.DruckerPrager`, are
    evaluated at σ* of `bd.Rankine`, and are 0 for facets in compression. `bd.Rankine`, and `bd.MohrCoulomb` with a
    fracture energy, give such a facet at most the index of its traction alone.

    Args:
        model: model with a failure criterion.
        state: state of this model, at any rotation, or a solution of `bd.solve_static`.

    Returns:
        Index [-], user's order, shape (m,).

    Raises:
        InputError: The model has no criterion, the state or solution belongs to another model, or a state with cracks
            was changed after its last step.
    """
    instance("failure_index", "model", model, Model, "bd.Model(...)")
    motion = state
    if not isinstance(state, State):
        state = _at_rest(model, state)
    other = difference(state.model, model)
    if other:
        raise InputError(f"failure_index: the state belongs to another {other}; give one of this model")
    if model.softening is not None:
        return crack_index(model, model.softening, state, motion)
    table = model.breaking
    if table is None:
        raise InputError("failure_index: the model has no criterion; give it failure=bd.PeripheralStress(...)")
    layout = model.layout
    law, pose, strengths = model.interaction, state.pose.copy(), table.strengths
    pose[:, STRESS] = lambda_theta(model, motion)[layout.order]
    found = law.indices(pose, state.of_law, table.kind, strengths)
    softened = state.softened[:, SoftColumn.BOND].astype(np.int64)
    found[softened] = state.integrity[softened] > 0.0
    own = np.empty_like(found)
    own[layout.bond_order] = found
    return own


def _at_rest(model: Model, solution: SmallMotion) -> State:
    """Return the state at rest in the pose of a static solution.

    Raises:
        InputError: The object is no solution, or belongs to another lattice.
    """
    moved = getattr(solution, "displacement", None)
    if moved is None or not hasattr(solution, "rotation"):
        instance("failure_index", "state", solution, State, "the state of a run, model.state(), or a static solution")
    assert moved is not None
    of = getattr(solution, "model", model)
    if of.lattice is not model.lattice or len(moved) != len(model.lattice.particles):
        raise InputError("failure_index: the solution belongs to another lattice; give one of this model")
    return posed(model, solution)
