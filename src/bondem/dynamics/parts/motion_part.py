"""Part of a step that sums the forces on elements and moves them, with damping."""

import numpy as np

from bondem._passes import steps
from bondem._tables.step_tables import Dashpots, Resistance, StepBlocks
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.dashpot_rate import bond_dashpots
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model


def motion(shared: SharedTables, dashpots: Dashpots | None, resistance: Resistance | None) -> Part:
    """Return the part that sums forces and moves elements, with dashpots of bonds and other damping if given."""
    moving, blocks, rows = shared.moving, shared.blocks, shared.rows
    opening: Passes = [steps.open_elements_and_rows(moving, rows) if shared.owned else steps.open_elements(moving)]
    gather: Passes = [steps.collect_sums(blocks)]
    if dashpots is not None:
        gather += [steps.collect_dashpots(blocks, dashpots), steps.add_dashpots(blocks, dashpots)]
    move: Passes
    if resistance is None:
        move = [steps.move_elements(moving, blocks)]
        owners = steps.move_rows(moving, blocks, rows)
    else:
        move = [steps.move_resisted(moving, blocks, resistance)]
        owners = steps.move_resisted_rows(moving, blocks, rows, resistance)
    reopening: Passes = [steps.reopen_elements(moving)]
    if shared.owned:
        move.append(owners)
        reopening.append(steps.reopen_rows(moving, rows))
    return Part({"opening": opening, "gather": gather, "move": move, "resume": move, "reopening": reopening})


def dashpots_of(model: Model, terms: DampingTerms, blocks: StepBlocks) -> Dashpots | None:
    """Return the dashpots of bonds for the damping `terms`, or None without bond damping."""
    if terms.eta == 0.0 and terms.beta == 0.0:
        return None
    share = model.bonds.lever / model.bonds.length
    return Dashpots(with_zeros(bond_dashpots(model, terms)), with_zeros(share), np.zeros((len(blocks.sums), 8)))


def resistance_of(model: Model, terms: DampingTerms, dashpots: Dashpots | None) -> Resistance | None:
    """Return the table of damping, dashpots and absorbing boundaries that resist motion, or None without any."""
    absorbing = model.constraints.absorbing
    viscous = dashpots is not None or len(absorbing) > 0 or terms.alpha > 0.0
    if not viscous and terms.gamma == 0.0:
        return None
    dashed = np.zeros((0, 8)) if dashpots is None else dashpots.sums
    return Resistance(terms.gamma, terms.alpha, viscous, dashed, absorbing)
