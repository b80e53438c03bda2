"""Elastic energy of a state, computed from its poses apart from the passes of a run."""

from dataclasses import replace

import numpy as np

from bondem._tables.columns import SoftColumn
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.interaction import SurfaceState
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import wall_places
from bondem.observables.facet_loads import loads_on_facets


def elastic_energy(model: Model, state: State) -> EnergyParts:
    """Compute the energy of a state under the total formulation, at any rotation.

    Holding walls, tractions on them and stress-free strains are those of the time of the state.

    Raises:
        ValueError: The state has cracks that soften, or cells that have yielded.
    """
    if len(state.cracks) or state.plastic.any():
        raise ValueError("the state has cracks or plastic strains; use run.history.energy")
    law, strain, surface = model.interaction, state.rest_strain, None
    if law.on_facets:
        force = loads_on_facets(model, state.time)
        pressed = law.pressed(np.arange(len(force)), force)[model.layout.order]
        surface = SurfaceState(state.grips, wall_places(model, state), pressed)
    found = law.energy(state.pose, state.rest, state.integrity, strain, surface)
    return replace(found, normal=found.normal + _pressed_energy(model, state))


def _pressed_energy(model: Model, state: State) -> float:
    """Return the energy of the pressure on beams that soften, ½ (1 - s) kn <L - ℓ>², beside that of the beams [J].

    Contacts store that of broken beams where the model has them.
    """
    bond = state.softened[:, SoftColumn.BOND].astype(np.int64)
    if model.hands_over:
        bond = bond[state.integrity[bond] > 0.0]
    layout, beams = model.layout, model.bonds.stretched(state.rest_strain)
    branch = state.pose[layout.j[bond], :3] - state.pose[layout.i[bond], :3]
    branch -= model.period[:3] * np.rint(branch * model.period[3:])
    short = np.maximum(beams.length[bond] - np.linalg.norm(branch, axis=1), 0.0)
    return 0.5 * float(((1.0 - state.integrity[bond]) * beams.kn[bond] * short**2).sum())
