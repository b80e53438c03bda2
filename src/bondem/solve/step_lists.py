"""Lists of the passes of a step: what a model has on them, and nothing of what it lacks.

Each function returns a list for `bondem._core_steps.Composer`: pairs of a pass and its tables, in the order in which
the core calls them.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bondem._core_steps import StepPass
from bondem.kernels.couples import CoupleTable
from bondem.kernels.strain_tables import Strain
from bondem.kernels.tables import Added, Gauges, Rows, Schedules, StepCut
from bondem.laws.damping import DampingTerms
from bondem.model.beam_tables import AlikeBeams, Beams, beam_tables
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added, changing_strain
from bondem.solve.step_tables import (
    BodyForces,
    Dashpots,
    Drives,
    HistoryRows,
    Moving,
    Portions,
    Resistance,
    RowLoads,
    Timeline,
)

_clear_row_forces = StepPass("clear_row_forces", Rows)
_follow_loads = StepPass("follow_loads", Timeline, RowLoads, Moving, Rows)
_follow_couples = StepPass("follow_couples", Timeline, CoupleTable, Moving, Rows)
_follow_drives = StepPass("follow_drives", Timeline, Drives, Rows)
_follow_body_forces = StepPass("follow_body_forces", Timeline, BodyForces)
_follow_strains = StepPass("follow_strains", Timeline, Strain, Moving, Beams, Rows)
_open_elements = StepPass("open_elements", Moving)
_open_elements_and_rows = StepPass("open_elements_and_rows", Moving, Rows)
_open_body_work = StepPass("open_body_work", Moving, BodyForces)
_add_beam_loads = StepPass("add_beam_loads", Moving, Beams, StepCut)
_add_alike_beam_loads = StepPass("add_alike_beam_loads", Moving, Beams, AlikeBeams, StepCut)
_add_dashpot_loads = StepPass("add_dashpot_loads", Moving, Beams, Dashpots, StepCut)
_collect_sums = StepPass("collect_sums", StepCut)
_collect_dashpots = StepPass("collect_dashpots", StepCut, Dashpots)
_add_dashpots = StepPass("add_dashpots", StepCut, Dashpots)
_add_body_forces = StepPass("add_body_forces", Moving, StepCut, BodyForces)
_move_elements = StepPass("move_elements", Moving, StepCut)
_move_rows = StepPass("move_rows", Moving, StepCut, Rows)
_move_resisted = StepPass("move_resisted", Moving, StepCut, Resistance)
_move_resisted_rows = StepPass("move_resisted_rows", Moving, StepCut, Rows, Resistance)
_add_body_work = StepPass("add_body_work", Moving, BodyForces)
_check_beams = StepPass("check_beams", Moving, Beams, Portions)
_sum_beam_energies = StepPass("sum_beam_energies", Moving, Beams, Portions)
_sum_element_energies = StepPass("sum_element_energies", Moving, Portions)
_judge_energy = StepPass("judge_energy", Rows, Portions)
_write_ledger = StepPass("write_ledger", Rows, Portions, HistoryRows)
_read_gauges = StepPass("read_gauges", Moving, Rows, Gauges, HistoryRows)

Passes = list[tuple[Any, ...]]


@dataclass(frozen=True, eq=False)
class StepTables:
    """Tables of a run of beams; None for what it lacks.

    Attributes:
        moving, rows, cut, portions, gauges, schedules, timeline: tables that every run has.
        owned: whether elements own rows of the boundary.
        beams: the bonds.
        alike: constants that all of them share, or None.
        dashpots: dashpots of the bonds.
        resistance: damping and dashpots of elements.
        body: body forces.
        strain: stress-free strains that change in time.
    """

    moving: Moving
    rows: Rows
    cut: StepCut
    portions: Portions
    gauges: Gauges
    schedules: Schedules
    timeline: Timeline
    owned: bool
    beams: Beams
    alike: AlikeBeams | None
    dashpots: Dashpots | None
    resistance: Resistance | None
    body: BodyForces | None
    strain: Strain | None

    @classmethod
    def of(cls, model: Model, terms: DampingTerms, state: State, cut: StepCut, gauges: Gauges) -> "StepTables":
        """The tables of a run from a state, whose arrays they share."""
        held, strain = model.constraints, changing_strain(model, state)
        bonds = model.bonds.stretched(state.eigenstrain)
        if strain is not None:  # lengths change while it runs
            bonds = bonds.separate()
        beams, alike = beam_tables(bonds, model.layout, model.period, state.integrity, may_share=strain is None)
        more, schedules = added(model, terms, state, len(cut.sums)), held.schedules
        return cls(
            moving=Moving(state.pose, state.motion, state.acceleration, state.loss, state.rest),
            rows=held.rows(state.reaction, state.work),
            cut=cut,
            portions=Portions.of(len(state.pose), len(model.layout.i)),
            gauges=gauges,
            schedules=schedules,
            timeline=Timeline(schedules.times, schedules.values, schedules.start),
            owned=len(held.element) > 0,
            beams=beams,
            alike=alike,
            dashpots=_dashpots(more),
            resistance=_resistance(terms, more),
            body=_body_forces(more),
            strain=strain,
        )


def passes_of_the_present(t: StepTables) -> Passes:
    """Bring boundary conditions to the time of the clock."""
    passes: Passes = []
    loaded, turned = len(t.schedules.load_row) > 0, len(t.schedules.couples.schedule) > 0
    if loaded or turned:
        passes.append((_clear_row_forces, t.rows))
    if loaded:
        passes.append((_follow_loads, t.timeline, _row_loads(t.schedules), t.moving, t.rows))
    if turned:
        passes.append((_follow_couples, t.timeline, t.schedules.couples, t.moving, t.rows))
    if len(t.schedules.drive_row):
        passes.append((_follow_drives, t.timeline, _drives(t.schedules), t.rows))
    if t.body is not None:
        passes.append((_follow_body_forces, t.timeline, t.body))
    if t.strain is not None:
        passes.append((_follow_strains, t.timeline, t.strain, t.moving, t.beams, t.rows))
    return passes


def passes_of_opening(t: StepTables) -> Passes:
    """Open a step after a pause."""
    passes: Passes = [(_open_elements_and_rows, t.moving, t.rows) if t.owned else (_open_elements, t.moving)]
    if t.body is not None:
        passes.append((_open_body_work, t.moving, t.body))
    return passes


def passes_of_forces(t: StepTables) -> Passes:
    """Sum forces up, and close the step with them; open the next where it goes on without a pause."""
    passes: Passes = [(_collect_sums, t.cut)]
    if t.alike is None:
        passes.append((_add_beam_loads, t.moving, t.beams, t.cut))
    else:
        passes.append((_add_alike_beam_loads, t.moving, t.beams, t.alike, t.cut))
    if t.dashpots is not None:
        passes.append((_add_dashpot_loads, t.moving, t.beams, t.dashpots, t.cut))
        passes.append((_collect_dashpots, t.cut, t.dashpots))
        passes.append((_add_dashpots, t.cut, t.dashpots))
    if t.body is not None:
        passes.append((_add_body_forces, t.moving, t.cut, t.body))
    if t.resistance is None:
        passes.append((_move_elements, t.moving, t.cut))
        if t.owned:
            passes.append((_move_rows, t.moving, t.cut, t.rows))
    else:
        passes.append((_move_resisted, t.moving, t.cut, t.resistance))
        if t.owned:
            passes.append((_move_resisted_rows, t.moving, t.cut, t.rows, t.resistance))
    if t.body is not None:
        passes.append((_add_body_work, t.moving, t.body))
    return passes


def passes_of_the_guard(t: StepTables) -> Passes:
    """Find whether the run is sound."""
    return [
        (_check_beams, t.moving, t.beams, t.portions),
        (_sum_element_energies, t.moving, t.portions),
        (_judge_energy, t.rows, t.portions),
    ]


def passes_of_a_record(t: StepTables, history: HistoryRows) -> Passes:
    """Write a row of the history."""
    passes: Passes = [
        (_sum_element_energies, t.moving, t.portions),
        (_sum_beam_energies, t.moving, t.beams, t.portions),
        (_write_ledger, t.rows, t.portions, history),
    ]
    if len(t.gauges.quantity):
        passes.append((_read_gauges, t.moving, t.rows, t.gauges, history))
    return passes


def _row_loads(schedules: Schedules) -> RowLoads:
    turns = schedules.load_turns
    if len(turns) == 0:
        turns = np.full(len(schedules.load_row), -1, dtype=np.int64)
    return RowLoads(schedules.load_row, schedules.load_schedule, schedules.load_value, turns)


def _drives(schedules: Schedules) -> Drives:
    return Drives(schedules.drive_row, schedules.drive_dof, schedules.drive_schedule, schedules.drive_rate)


def _body_forces(more: Added | None) -> BodyForces | None:
    if more is None or len(more.group) == 0:
        return None
    member, pull = np.ascontiguousarray(more.member), np.ascontiguousarray(more.pull)
    return BodyForces(more.group, member, pull, more.schedule, more.present, more.factor, more.body)


def _dashpots(more: Added | None) -> Dashpots | None:
    if more is None or len(more.dashed) == 0:
        return None
    return Dashpots(more.dashpot, more.share, more.dashed)


def _resistance(terms: DampingTerms, more: Added | None) -> Resistance | None:
    viscous = more is not None and more.viscous
    if not viscous and terms.gamma == 0.0:
        return None
    if more is None:
        return Resistance(terms.gamma, 0.0, False, np.zeros((0, 8)), np.zeros((0, 6)))
    return Resistance(terms.gamma, more.alpha, viscous, more.dashed, more.absorbing)
