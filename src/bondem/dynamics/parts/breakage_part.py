"""Breakage of beams that fail at once."""

import numpy as np

from bondem._passes import steps
from bondem._tables.damage_tables import BeamIntegrity
from bondem._tables.step_tables import AlikeBeams, Beams, Dashpots
from bondem.damage.failure_passes import strengths_of
from bondem.dynamics.parts.damage_part import DamageTables
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.state import State


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
    strengths = strengths_of(damage.table)
    judge = [steps.JUDGE_BEAMS_BY[damage.table.kind](moving, beams, strengths, candidates, postponed)]
    remove: Passes = []
    if dashpots is not None:
        remove.append(steps.withdraw_dashpots(moving, beams, dashpots, candidates, postponed))
    remove.append(steps.break_beams(moving, beams, integrity, candidates, postponed, damage.log))
    part = damage.part(shared, judge, remove, dashpots)
    return Part(part.stages, part.record, lambda: damage.keep(beams.integrity, state))
