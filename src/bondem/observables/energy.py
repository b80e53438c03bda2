"""Elastic energy of the bonds and its parts."""

import numpy as np

from bondem._tables.cell_tables import CellPoses
from bondem._tables.columns import SoftColumn
from bondem._tables.step_tables import Beams
from bondem._types import Floats, PerBond, PerElement3
from bondem.errors import InputError
from bondem.interactions.beams.beam_tables import beam_energies, beam_tables
from bondem.interactions.cells.cell_tables import body_energies, cell_tables, gradient_tables, place_held_walls
from bondem.interactions.energy_parts import EnergyParts
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.facet_loads import loads_on_facets


def linear_energy(
    model: Model, displacement: PerElement3, rotation: PerElement3, strain: PerBond | None = None
) -> EnergyParts:
    """Compute the energy of small displacements [m] and rotations [rad], user's order, (n, 3) each.

    The parts are ½ kn (δ·X - L ε*)², ½ ks |δ - (δ·X) X|², ½ kb |ρ - (ρ·X) X|², ½ kt (ρ·X)² of `BondStrain`.
    `strain` is ε* of each bond [-], in internal order.
    """
    law = model.interaction
    traction = loads_on_facets(model) if law.on_facets else np.zeros((0, 3))
    strain = np.zeros(len(model.lattice.pairs)) if strain is None else strain
    return law.small_energy(displacement, rotation, strain, model.pressed, traction)


def elastic_energy(model: Model, state: State) -> EnergyParts:
    """Compute the energy of a state under the total formulation, at any rotation.

    Holding walls, tractions on them and stress-free strains are those of the time of the state.

    Raises:
        InputError: The state has cracks that soften, or cells that have yielded.
    """
    return energy_of(model, state, state.rest_strain)


def energy_of(model: Model, state: State, strain: PerBond, *, wall: Floats | None = None) -> EnergyParts:
    """Compute the energy of a state with stress-free strains ε* [-], internal order, (m,), or (0,) for none.

    With `wall` [m], (g, 3), walls are at these places and tractions are those of the model's own cells. Without, both
    are as for `elastic_energy`.
    """
    if len(state.cracks) or state.plastic.any():
        raise InputError(
            "elastic_energy: the state has cracks or plastic strains; use run.history.energy"
        )
    if model.cells is None:
        beams, _ = beam_tables(
            model.bonds.stretched(strain), model.layout, model.period, state.integrity, may_share=False
        )
        normal, *others = beam_energies(state.pose, beams)
        return EnergyParts(normal + _pressed_energy(model, state, beams), *others)
    layout, constants = model.layout, model.cells.stretched(strain, model.layout)
    walls = constants.grips.table(layout, model.constraints.row_of, 0, None if wall is not None else state.grips)
    whole = constants.damaged(state.integrity, layout.i, layout.j)
    facets, cells = cell_tables(whole, layout, model.period, state.integrity, layout.i)
    if wall is None:
        place_held_walls(walls, state.time)
        cells.given[:] = model.cell_constants.pressed_by(loads_on_facets(model, state.time))[layout.order]
    else:
        walls.wall[:] = wall
    gradients = gradient_tables(whole.gradients, len(state.pose), walls)
    return EnergyParts(*body_energies(CellPoses(state.pose, state.rest), facets, cells, gradients, walls))


def _pressed_energy(model: Model, state: State, beams: Beams) -> float:
    """Return the energy of the pressure on beams that soften, ½ (1 - s) kn <L - ℓ>², beside that of the beams [J].

    Contacts store that of broken beams where the model has them.
    """
    bond = state.softened[:, SoftColumn.BOND].astype(np.int64)
    if model.hands_over:
        bond = bond[state.integrity[bond] > 0.0]
    branch = state.pose[beams.j[bond], :3] - state.pose[beams.i[bond], :3]
    branch -= beams.period[:3] * np.rint(branch * beams.period[3:])
    short = np.maximum(beams.length[bond] - np.linalg.norm(branch, axis=1), 0.0)
    return 0.5 * float(((1.0 - state.integrity[bond]) * beams.kn[bond] * short**2).sum())
