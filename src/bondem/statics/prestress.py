"""Stiffness of a model about an equilibrium under load, which includes the effect of its stresses."""

from dataclasses import replace
from typing import cast

import numpy as np

from bondem._checks import instance
from bondem.boundary.wall_constraints import reference_base
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import wall_places
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.posed_state import posed
from bondem.statics.linear import System
from bondem.statics.nonlinear import at_pose, strained, unbalanced
from bondem.statics.static import StaticResult

# Unbalanced force over that of loads and supports, above which a pose is no equilibrium.
_REST = 1e-2


def about_equilibrium(model: Model, system: System, prestress: StaticResult | State) -> System:
    """Return the linear system of a model with its matrix replaced by the tangent at an equilibrium.

    Args:
        model: model to solve.
        system: linear system at rest.
        prestress: a static solution of the model, or a state of it at rest.

    Raises:
        InputError: The value is another object, of another model, an unbalanced solution or a state with broken
            bonds. Or the supports leave the specimen free, or the bonds are incremental.
    """
    instance("solve_modes", "prestress", prestress, (StaticResult, State), "a solution of solve_static, or a state")
    if len(prestress.displacement) != len(model.lattice.particles):
        raise InputError(f"prestress= has {len(prestress.displacement)} elements; give a solution of this model")
    if system.loose.shape[1]:
        raise InputError("prestress= needs a specimen that is held; fix all six rigid motions with Fix")
    if model.formulation == "incremental":
        cure = "formulation='total'" if model.interaction.evaluated == "force" else "bd.CellBond"
        raise InputError(f"prestress= needs a potential; use {cure}")
    if isinstance(prestress, State):
        loaded, pose = _of_state(model, prestress), prestress.pose.copy()
    else:
        loaded, pose = strained(model, 1.0), posed(model, prestress).pose
    left = unbalanced(loaded, system, pose) if isinstance(prestress, StaticResult) else 0.0
    if left > _REST:
        raise InputError(
            f"prestress= is not an equilibrium of this model: {left:.2g} of the forces are unbalanced; give what"
            " solve_static returned for it, with nonlinear=True where motions are large"
        )
    return replace(system, matrix=at_pose(loaded, system, pose))


def _of_state(model: Model, state: State) -> Model:
    """Return the model with the strains, walls and tractions that act at the time of a state."""
    if not np.all(state.integrity == 1.0) or len(state.cracks) or state.plastic.any():
        raise InputError("prestress= is a state with broken bonds or cracks; leave these bonds out of a new lattice")
    law, count = model.interaction, len(model.interaction.supports.cell)
    base, motion = reference_base(count), law.supports.motion
    if len(state.grips) == count > 0:
        base, motion = state.grips, wall_places(model, state)
    force = loads_on_facets(cast(Model, state.model), state.time)
    pressed = law.pressed(np.arange(len(force)), force)[model.layout.order]
    return model.by(law.strained(state.rest_strain, base, motion, pressed))
