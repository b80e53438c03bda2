"""Composition of the parts of a step from a model."""

from dataclasses import replace
from functools import singledispatch

from bondem._tables.step_tables import Dashpots, Gauges, StepBlocks
from bondem._types import PerBond
from bondem.damage.damage_part import BondParts, DamageTables, Joints
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.gauge_tables import gauge_tables
from bondem.dynamics.parts.beam_part import beams
from bondem.dynamics.parts.body_force_part import body_forces
from bondem.dynamics.parts.boundary_part import boundary
from bondem.dynamics.parts.cell_body_part import body_of_cells
from bondem.dynamics.parts.contact_part import ContactTables
from bondem.dynamics.parts.history_part import history
from bondem.dynamics.parts.motion_part import dashpots_of, motion, resistance_of
from bondem.dynamics.parts.shared_tables import SharedTables, apart
from bondem.dynamics.plan import Plan
from bondem.interactions.beams.bond_table import with_twins
from bondem.interactions.cells.cell_interaction import CellInteraction
from bondem.interactions.interaction import Run, SteppingInteraction
from bondem.interactions.step_part import Part, Passes
from bondem.model.domain_blocks import Blocks
from bondem.model.model import Model
from bondem.model.state import State


def parts_of(
    model: Model, terms: DampingTerms, state: State, blocks: StepBlocks, gauges: Gauges, dt: float
) -> tuple[SharedTables, list[Part]]:
    """Return the tables and the parts of a run from a state, whose arrays they share."""
    shared = SharedTables.of(model, state, blocks)
    dashpots = dashpots_of(model, terms, blocks)
    bonds = _bonds(model.interaction, model, state, shared, dashpots, dt)
    contacts, moments = [], []
    if model.contact is not None:
        touching = ContactTables(model, model.contacts, state, shared, gauges, bonds.joints, dt)
        contacts = [touching.part()]
        moments = [] if bonds.stresses is None else [touching.moments(bonds.stresses)]
    parts = [
        boundary(model.constraints, shared),
        *contacts,
        *bonds.parts,
        *moments,
        motion(shared, dashpots, resistance_of(model, terms, dashpots)),
    ]
    pulled = body_forces(model, state, shared)
    if pulled is not None:
        parts.append(pulled)  # last, because its work is computed with the velocities after the kick
    kinetic = [one for part in parts for one in part.kinetic]
    return shared, [*parts, history(shared, gauges, kinetic)]


def parts_in_one_block(model: Model, plan: Plan, state: State, dt: float) -> tuple[SharedTables, list[Part]]:
    """Return the tables and the parts of a step that treats all elements as one block."""
    block = max(len(state.pose), 1)
    postponed = 0 if model.breaking is None else len(state.pose)
    blocks = Blocks.of(model.layout, block, 1, model.constraints.row_of >= 0).table(postponed)
    return parts_of(model, DampingTerms.of(plan.damping), state, blocks, gauge_tables(model, plan), dt)


def _of_law(
    law: SteppingInteraction, model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None, _: float
) -> BondParts:
    """Return the parts of bonds whose law provides its own passes, and of their breakage."""
    damage = DamageTables.of(model.breaking, state, shared.blocks, len(with_twins(model.layout.i)))

    def failing(judge: Passes, remove: Passes, integrity: PerBond) -> Part:
        assert damage is not None
        part = damage.part(shared, judge, remove, dashpots)
        return replace(part, keep=lambda: damage.keep(integrity, state))

    touches = model.contact is not None
    run = Run(shared.moving, shared.blocks, shared.ledger, state.of_law, dashpots, damage, failing, touches)
    found = law.parts(run)
    return BondParts(found.parts, Joints(found.integrity, apart(model, state), damage), found.stresses)


# Function that returns the parts of bonds, by the class of their interaction; `beams` is the default.
_bonds = singledispatch(beams)
_bonds.register(CellInteraction, body_of_cells)
_bonds.register(SteppingInteraction, _of_law)
