"""Elastic energy of the bonds and its parts."""

import numpy as np

from bondem._tables.cell_tables import CellPoses
from bondem._tables.columns import SoftColumn
from bondem._tables.step_tables import Beams
from bondem._types import Floats, PerBond, PerElement3
from bondem.errors import InputError
from bondem.interactions.beams.beam_tables import beam_energies, beam_tables
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_strain import CellStrain
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
    if model.cells is not None:
        return _cell_energy(model, displacement, rotation, strain)
    lattice, k = model.lattice, model.stiffness
    bonds = BondStrain.of(lattice, k.lever, displacement, rotation)
    elongation = bonds.normal.copy()
    if strain is not None:
        elongation[model.layout.bond_order] -= lattice.length[model.layout.bond_order] * strain
    return EnergyParts(
        normal=0.5 * float((k.kn * elongation**2).sum()),
        shear=0.5 * float((k.ks * (bonds.shear**2).sum(axis=1)).sum()),
        bending=0.5 * float((k.kb * (bonds.bend**2).sum(axis=1)).sum()),
        twisting=0.5 * float((k.kt * bonds.twist**2).sum()),
    )


def _cell_energy(
    model: Model, displacement: PerElement3, rotation: PerElement3, strain: PerBond | None
) -> EnergyParts:
    body, constants = model.lattice, model.cell_constants
    grips = constants.grips
    slip, wall = stress_free_gap(model, strain), wall_motion(model, strain)
    pressed = model.pressed
    found = CellStrain.of(body, constants, displacement, rotation, slip=slip, wall=wall, pressed=pressed)
    facets, cells = body_of(body)
    # ½ V λ θ² is the potential of cells and loads; less the work of the loads on the openings of their facets
    force = loads_on_facets(model)
    opened = constants.softness / cells.free.area @ (force**2).sum(axis=1)
    opened -= 2.0 * found.stress(constants) @ pressed
    normal = (found.gap * facets.normal).sum(axis=1)
    turned = (found.turn * facets.normal).sum(axis=1)
    along = np.einsum("ma,mab,mb->m", facets.normal, constants.H, facets.normal) * turned**2
    whole = np.einsum("ma,mab,mb->m", found.turn, constants.H, found.turn)
    moments, held = constants.gradients.moments(found.turn, rotation)
    whole += (moments * found.turn).sum(axis=1)
    own = rotation[grips.cell]
    gripped = (grips.k[:, None] * found.held**2).sum() + np.einsum("ga,gab,gb->", own, grips.H, own)
    gripped -= (held * rotation).sum()
    stretched = (constants.k * normal**2).sum() + found.stress(constants) @ found.swelling
    return EnergyParts(
        normal=0.5 * float(stretched + gripped + opened),
        shear=0.5 * float((constants.k * ((found.gap**2).sum(axis=1) - normal**2)).sum()),
        bending=0.5 * float((whole - along).sum()),
        twisting=0.5 * float(along.sum()),
    )


def stress_free_gap(model: Model, strain: PerBond | None) -> Floats | None:
    """Return the gaps that stress-free strains subtract from the gaps of facets [m], (m, 3), with a negative sign.

    `strain` is ε* [-], in internal order, (m,).
    """
    if strain is None or model.cells is None:
        return None
    own = np.empty(len(strain))
    own[model.layout.bond_order] = strain
    return -own[:, None] * model.lattice.branch


def wall_motion(model: Model, strain: PerBond | None) -> Floats:
    """Return the motion of walls towards facets of cells, less the growth of cells by the strains [m], (g, 3)."""
    grips = model.cell_constants.grips
    if strain is None:
        return grips.motion
    return grips.motion + grips.lever - grips.grown(model.layout.of_elements(strain)).arm


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
