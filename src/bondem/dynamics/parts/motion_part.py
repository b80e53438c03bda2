"""Motion of elements under the sum of their forces, with damping."""

import numpy as np

from bondem._core_steps import StepPass
from bondem._tables.step_tables import Dashpots, Moving, Resistance, Rows, StepCut
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.dashpots import bond_dashpots
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.beams.bond_table import with_zeros
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model

_open_elements = StepPass("open_elements", Moving)
_open_elements_and_rows = StepPass("open_elements_and_rows", Moving, Rows)
_reopen_elements = StepPass("reopen_elements", Moving)
_reopen_rows = StepPass("reopen_rows", Moving, Rows)
_collect_sums = StepPass("collect_sums", StepCut)
_collect_dashpots = StepPass("collect_dashpots", StepCut, Dashpots)
_add_dashpots = StepPass("add_dashpots", StepCut, Dashpots)
_move_elements = StepPass("move_elements", Moving, StepCut)
_move_rows = StepPass("move_rows", Moving, StepCut, Rows)
_move_resisted = StepPass("move_resisted", Moving, StepCut, Resistance)
_move_resisted_rows = StepPass("move_resisted_rows", Moving, StepCut, Rows, Resistance)


def motion(shared: SharedTables, dashpots: Dashpots | None, resistance: Resistance | None) -> Part:
    """Return the part that gathers forces and moves elements."""
    moving, cut, rows = shared.moving, shared.cut, shared.rows
    opening: Passes = [(_open_elements_and_rows, moving, rows) if shared.owned else (_open_elements, moving)]
    gather: Passes = [(_collect_sums, cut)]
    if dashpots is not None:
        gather += [(_collect_dashpots, cut, dashpots), (_add_dashpots, cut, dashpots)]
    move: Passes
    if resistance is None:
        move = [(_move_elements, moving, cut)]
        held = (_move_rows, moving, cut, rows)
    else:
        move = [(_move_resisted, moving, cut, resistance)]
        held = (_move_resisted_rows, moving, cut, rows, resistance)
    reopening: Passes = [(_reopen_elements, moving)]
    if shared.owned:
        move.append(held)
        reopening.append((_reopen_rows, moving, rows))
    return Part({"opening": opening, "gather": gather, "move": move, "resume": move, "reopening": reopening})


def dashpots_of(model: Model, terms: DampingTerms, cut: StepCut) -> Dashpots | None:
    """Return the dashpots of bonds, or None."""
    if terms.eta == 0.0 and terms.beta == 0.0:
        return None
    share = model.bonds.lever / model.bonds.length
    return Dashpots(with_zeros(bond_dashpots(model, terms)), with_zeros(share), np.zeros((len(cut.sums), 8)))


def resistance_of(model: Model, terms: DampingTerms, dashpots: Dashpots | None) -> Resistance | None:
    """Return damping and dashpots that resist the motion of elements, or None."""
    absorbing = model.constraints.absorbing
    viscous = dashpots is not None or len(absorbing) > 0 or terms.alpha > 0.0
    if not viscous and terms.gamma == 0.0:
        return None
    dashed = np.zeros((0, 8)) if dashpots is None else dashpots.sums
    return Resistance(terms.gamma, terms.alpha, viscous, dashed, absorbing)
