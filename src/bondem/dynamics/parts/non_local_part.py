"""Bonds of the non-local law: stresses of elements that lag a step behind, and forces that follow from them."""

import numpy as np

from bondem._passes import steps
from bondem._tables.damage_tables import BeamIntegrity
from bondem._tables.non_local_tables import LaggedStresses, NonLocalBonds, NonLocalWork
from bondem._tables.step_tables import Beams, Dashpots, HistoryRows, StepCut
from bondem.damage.failure_passes import strengths_of
from bondem.dynamics.parts.damage_part import BondParts, DamageTables, Joints, damage_of
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.model import Model
from bondem.model.non_local_tables import lagged_stresses, non_local_tables
from bondem.model.state import State


def non_local(model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None) -> BondParts:
    """Return the parts of bonds of the non-local law, with dashpots beside them or without."""
    moving, cut, portions = shared.moving, shared.cut, shared.portions
    beams, bonds = non_local_tables(model, state)
    stresses = lagged_stresses(model, state, _rows_of_moments(model, cut), int(cut.part[-1]))
    work = NonLocalWork(np.zeros(len(portions.bonds)))
    damage = damage_of(model, state, cut, len(beams.i))
    dashes: Passes = [] if dashpots is None else [steps.add_dashpot_loads(moving, beams, dashpots, cut)]
    stages: dict[str, Passes] = {"prepare": [steps.turn_stresses(moving, stresses)]}
    if damage is None and model.contacts is None:  # nothing needs the stresses of now before the elements move
        stages["loads"] = [steps.add_lasting_loads(moving, beams, bonds, stresses, cut), *dashes]
        stages["gather"] = [steps.collect_moments(cut, stresses)]
        stages["add"] = [steps.find_stresses_of_block(moving, stresses)]
    else:
        stages["prepare"].append(steps.find_non_local_forces(moving, beams, bonds, stresses))
        stages["prepare"].append(steps.collect_moments(cut, stresses))
        stages["stress"] = [steps.find_stresses(moving, stresses)]
        stages["loads"] = [steps.add_non_local_loads(bonds, cut), *dashes]
    stages["guard"] = [steps.check_beams(moving, beams, portions)]

    def keep() -> None:
        if bonds.history is not state.history:
            state.history[:] = bonds.history[:, : state.history.shape[1]]

    def record(history: HistoryRows) -> Passes:
        return [
            steps.sum_non_local_energies(moving, beams, bonds, portions, work),
            steps.write_non_local_work(work, history),
        ]

    parts = [Part(stages, record, keep)]
    if damage is not None:
        parts.append(_breakage(damage, state, shared, beams, bonds, stresses, dashpots))
    return BondParts(parts, Joints.of(model, state, beams.integrity, damage), stresses)


def _breakage(
    damage: DamageTables,
    state: State,
    shared: SharedTables,
    beams: Beams,
    bonds: NonLocalBonds,
    stresses: LaggedStresses,
    dashpots: Dashpots | None,
) -> Part:
    """Return the part of bonds that break."""
    moving, candidates, postponed = shared.moving, damage.candidates, damage.postponed
    strengths, integrity = strengths_of(damage.table), BeamIntegrity(beams.integrity, np.zeros(0))
    judge: Passes = [steps.judge_pairs(beams, stresses, strengths, candidates, postponed)]
    remove: Passes = []
    if dashpots is not None:
        remove.append(steps.withdraw_dashpots(moving, beams, dashpots, candidates, postponed))
    remove += [
        steps.break_pairs(moving, beams, bonds, candidates, postponed, damage.log),
        steps.relieve_pairs(moving, beams, bonds, stresses, integrity, candidates),
    ]
    part = damage.part(shared, judge, remove, dashpots)
    stages = {**part.stages, "loads": [steps.mark_pairs(beams, stresses, strengths, candidates)]}
    return Part(stages, part.record, lambda: damage.keep(beams.integrity, state))


def _rows_of_moments(model: Model, cut: StepCut) -> np.ndarray:
    """Return the row of the moment that each bond adds to for its element i, uint32, (m,).

    Rows behind those of the n elements are contributions of bonds between domains, in the order of `cut.part`.
    """
    i = model.layout.i
    row = cut.row_i[: len(i)].astype(np.int64)
    return np.where(row < cut.parts, i, len(model.layout.order) + row - cut.parts).astype(np.uint32)
