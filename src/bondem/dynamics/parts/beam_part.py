"""Part of a step for beams of the total formulation: forces, energies, check of rotations, changing strains."""

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._passes import StepEntry, steps
from bondem._tables.step_tables import Beams, Dashpots, Moving, StepBlocks, Strain, UniformBeams
from bondem.damage.breakage_part import breakage
from bondem.damage.damage_part import BondParts, DamageTables, Joints
from bondem.damage.softening_part import SofteningTables, softening
from bondem.dynamics.parts.shared_tables import SharedTables, apart
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.interaction import Interaction
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.state import State


def beams(
    _: Interaction, model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None, __: float
) -> BondParts:
    """Return the parts of a step for beams, and the beams as joints, whose elements do not touch before failure.

    The parts are the forces, with dashpots if given, and breakage or softening if beams can fail.
    """
    moving, blocks, ledger = shared.moving, shared.blocks, shared.ledger
    strain = _changing_strain(model, state)
    bonds = model.bonds.stretched(state.eigenstrain)
    if strain is not None:  # lengths change during the run
        bonds = bonds.separate()
    table, uniform = beam_tables(bonds, model.layout, model.period, state.integrity, may_share=strain is None)
    damage = DamageTables.of(model.breaking, state, blocks, len(table.i))
    soft, failure = None, []
    if damage is not None and model.beam_softening is not None:
        soft = SofteningTables.of(model.beam_softening, damage, state, table, uniform, handed=model.hands_over)
        failure = [softening(soft, damage, state, shared, table)]
    elif damage is not None:
        failure = [breakage(damage, state, shared, table, uniform, dashpots)]
    present = [] if strain is None else [steps.follow_strains(shared.timeline, strain, moving, table, shared.rows)]
    loads: Passes = [_loads(moving, table, uniform, blocks, damage, soft)]
    if dashpots is not None:
        loads.append(steps.add_dashpot_loads(moving, table, dashpots, blocks))
    forces = Part(
        {"present": present, "loads": loads, "guard": [steps.check_beams(moving, table, ledger)]},
        record=lambda _: [steps.sum_beam_energies(moving, table, ledger)],
    )
    pressed = None if soft is None else soft.bounds
    return BondParts([forces, *failure], Joints(table.integrity, apart(model, state), damage, pressed))


def _changing_strain(model: Model, state: State) -> Strain | None:
    """Return the table of stress-free strains that conditions add to those of the state, or None without any."""
    constraints, plain = model.constraints, model.bonds
    if not len(constraints.strain_part):
        return None
    bond = np.flatnonzero((constraints.strain_part != 0.0).any(axis=0))
    return Strain(
        schedule=constraints.strain_schedule, bond=bond.astype(np.uint32),
        part=np.ascontiguousarray(constraints.strain_part[:, bond]),
        still=1.0 + (state.eigenstrain[bond] if state.eigenstrain.size else np.zeros(len(bond))),
        length=plain.length[bond], shear=plain.ks[bond], lever=plain.lever[bond],
        factor=np.zeros((4, len(constraints.strain_part))), power=exact_sums(len(constraints.strain_part)),
        due=np.zeros(2, dtype=np.uint8), place=constraints.works[1],
    )  # fmt: skip


def _loads(
    moving: Moving, table: Beams, uniform: UniformBeams | None, blocks: StepBlocks, damage: DamageTables | None,
    soft: SofteningTables | None,
) -> StepEntry:  # fmt: skip
    """Return the pass of forces of beams with shared or separate constants, which break, soften or do neither."""
    if damage is None:
        if uniform is None:
            return steps.add_beam_loads(moving, table, blocks)
        return steps.add_uniform_beam_loads(moving, table, uniform, blocks)
    kind, candidates = damage.table.kind, damage.candidates
    if soft is None:
        if uniform is None:
            return steps.add_marked_beam_loads(moving, table, blocks, damage.bounds, candidates)
        return steps.add_marked_uniform_beam_loads(moving, table, uniform, blocks, damage.bounds, candidates)
    if uniform is None:
        return steps.ADD_BEAM_LOADS_SOFTENING_BY[kind](moving, table, blocks, soft.bounds, candidates)
    return steps.ADD_UNIFORM_BEAM_LOADS_SOFTENING_BY[kind](moving, table, uniform, blocks, soft.bounds, candidates)
