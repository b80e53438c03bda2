"""Breakage of beams that fail at once."""

import numpy as np

from bondem._core_steps import StepPass
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.step_tables import AlikeBeams, Beams, Dashpots, Moving
from bondem.damage.failure_passes import BEAM_CRITERIA, strengths_of
from bondem.dynamics.parts.damage_part import DamageTables
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.state import State

_judge_beams = {
    name: StepPass(f"judge_beams_by_{name}", Moving, Beams, Strengths, Candidates, Postponed)
    for name in BEAM_CRITERIA
}
_withdraw_dashpots = StepPass("withdraw_dashpots", Moving, Beams, Dashpots, Candidates, Postponed)
_break_beams = StepPass("break_beams", Moving, Beams, BeamIntegrity, Candidates, Postponed, EventLog)


def breakage(
    damage: DamageTables,
    state: State,
    shared: SharedTables,
    beams: Beams,
    alike: AlikeBeams | None,
    dashpots: Dashpots | None,
) -> Part:
    """Return the part of beams that break."""
    moving, candidates, postponed = shared.moving, damage.candidates, damage.postponed
    hold = np.zeros(0) if alike is None else alike.hold
    integrity = BeamIntegrity(beams.integrity, hold)
    judge = [(_judge_beams[damage.table.kind], moving, beams, strengths_of(damage.table), candidates, postponed)]
    remove: Passes = []
    if dashpots is not None:
        remove.append((_withdraw_dashpots, moving, beams, dashpots, candidates, postponed))
    remove.append((_break_beams, moving, beams, integrity, candidates, postponed, damage.log))
    part = damage.part(shared, judge, remove, dashpots)
    return Part(part.stages, part.record, lambda: damage.keep(beams.integrity, state))
