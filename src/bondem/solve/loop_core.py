"""The loop of the CPU by the core: a step is a list of passes, which the core walks on its own threads."""

from typing import Any

import numpy as np

from bondem._compile import current_threads
from bondem._core import Pass
from bondem._core_steps import Composer, StepPass
from bondem.kernels.advance import FINE, NOT_FINITE, RUNAWAY, SERIAL_BONDS
from bondem.kernels.couples import CoupleTable
from bondem.kernels.strain_tables import Strain
from bondem.kernels.tables import (
    CONTACT,
    FIXED_COLUMNS,
    TRANSLATION,
    Added,
    Gauges,
    Rows,
    StepCut,
    StepScheme,
)
from bondem.laws.damping import DampingTerms
from bondem.model.blocks import Blocks
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added, changing_strain
from bondem.solve.loop_cpu import BLOCK, gauge_tables, noticeable
from bondem.solve.plan import Plan
from bondem.solve.step_tables import (
    AlikeBeams,
    Beams,
    BodyForces,
    Dashpots,
    Drives,
    History,
    Moving,
    Portions,
    Resistance,
    RowLoads,
    Span,
    StepPasses,
    Timeline,
)

# Bonds of a thread at least.
_DOMAIN = SERIAL_BONDS // 4

_take_steps = Pass("take_steps", StepPasses, StepCut, StepScheme, Span, Portions)
_ENDINGS = {"sound": FINE, "not_finite": NOT_FINITE, "runaway": RUNAWAY}

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
_write_ledger = StepPass("write_ledger", Rows, Portions, History)
_read_gauges = StepPass("read_gauges", Moving, Rows, Gauges, History)


def core_has(model: Model) -> bool:
    """Whether the core has all passes of a model: beams of the total formulation that neither break nor touch."""
    return (
        model.cells is None
        and model.non_local is None
        and model.formulation == "total"
        and model.breaking is None
        and model.contacts is None
    )


class CoreLoop:
    """The lists of passes of one run, and the calls that go on with it."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        self.state = state
        self._every = int(plan.every)
        self._width = FIXED_COLUMNS + 3 * len(plan.gauges)
        self._origin = state.time - state.step * dt
        layout, held = model.layout, model.constraints
        terms = DampingTerms.of(plan.damping)
        self._scheme = StepScheme(dt, *plan.scheme.coefficients(dt), terms.gamma, self._origin)
        self._threads, domains = current_threads(), 1
        if len(layout.i) >= SERIAL_BONDS:
            domains = min(self._threads, len(layout.i) // _DOMAIN)
        else:
            self._threads = 1
        blocks = Blocks.of(layout, BLOCK, domains, held.row_of >= 0)
        self._cut = blocks.table()
        self._n, self._m = len(state.pose), len(layout.i)
        self._portions = Portions.of(self._n, self._m)
        self._still = noticeable(model, dt)
        self._moving = Moving(state.pose, state.motion, state.acceleration, state.loss, state.rest)
        self._rows = held.rows(state.reaction, state.work)
        self._gauges = gauge_tables(model, plan)
        self._compose(model, terms, blocks)

    def _compose(self, model: Model, terms: DampingTerms, blocks: Blocks) -> None:
        """Lists of the passes that this model has."""
        state, held, cut = self.state, model.constraints, self._cut
        moving, rows, portions = self._moving, self._rows, self._portions
        schedules = held.schedules
        timeline = Timeline(schedules.times, schedules.values, schedules.start)
        strain = changing_strain(model, state)
        beams, alike = beam_tables(model, state, changing=strain is not None)
        more = added(model, terms, state, blocks.rows)
        body = None if more is None else _body_forces(more)
        dashpots = None if more is None else _dashpots(more)
        owned = len(held.element) > 0
        present = [(_clear_row_forces, rows)] if len(schedules.load_row) or len(schedules.couples.schedule) else []
        if len(schedules.load_row):
            present.append((_follow_loads, timeline, _row_loads(schedules), moving, rows))
        if len(schedules.couples.schedule):
            present.append((_follow_couples, timeline, schedules.couples, moving, rows))
        if len(schedules.drive_row):
            present.append((_follow_drives, timeline, _drives(schedules), rows))
        if body is not None:
            present.append((_follow_body_forces, timeline, body))
        if strain is not None:
            present.append((_follow_strains, timeline, strain, moving, beams, rows))
        opening: list[Any] = [(_open_elements_and_rows, moving, rows) if owned else (_open_elements, moving)]
        forces: list[Any] = [(_collect_sums, cut)]
        forces.append((_add_beam_loads, moving, beams, cut))
        if alike is not None:
            forces[-1] = _add_alike_beam_loads, moving, beams, alike, cut
        if dashpots is not None:
            forces += [
                (_add_dashpot_loads, moving, beams, dashpots, cut), (_collect_dashpots, cut, dashpots),
                (_add_dashpots, cut, dashpots),
            ]  # fmt: skip
        if body is not None:
            forces.append((_add_body_forces, moving, cut, body))
        resistance = _resistance(terms, more)
        if resistance is None:
            forces += [(_move_elements, moving, cut)] + ([(_move_rows, moving, cut, rows)] if owned else [])
        else:
            forces.append((_move_resisted, moving, cut, resistance))
            if owned:
                forces.append((_move_resisted_rows, moving, cut, rows, resistance))
        if body is not None:
            forces.append((_add_body_work, moving, body))
            opening.append((_open_body_work, moving, body))
        guard = [
            (_check_beams, moving, beams, portions), (_sum_element_energies, moving, portions),
            (_judge_energy, rows, portions),
        ]  # fmt: skip
        self._composer = Composer()
        lists = (self._composer(passes) for passes in (present, opening, forces, guard))
        self._lists = StepPasses(*lists, record=self._composer(()))
        self._record = [
            (_sum_element_energies, moving, portions), (_sum_beam_energies, moving, beams, portions)
        ]  # fmt: skip

    def _take(self, span: Span, records: np.ndarray) -> str:
        """Carry out a span, with rows of the history to write to."""
        history = History(records)
        writing = [*self._record, (_write_ledger, self._rows, self._portions, history)]
        if len(self._gauges.quantity):
            writing.append((_read_gauges, self._moving, self._rows, self._gauges, history))
        composer = Composer()
        lists = self._lists._replace(record=composer(writing))
        return _take_steps(lists, self._cut, self._scheme, span, self._portions, threads=self._threads)

    def _span(self, steps: int, *, looks: bool = False) -> Span:
        state = self.state
        return Span(
            state.step, steps, self._every, looks, looks and state.stale, self._n, self._m, np.zeros(4, dtype=np.int64)
        )

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        state, budget = self.state, self._portions.budget
        begins = state.stale or budget[0] == 0.0  # what a run gains as it goes on is no budget of its own
        records = np.empty((1, self._width))
        self._take(self._span(0, looks=True), records)
        state.stale = False
        if begins:
            budget[0] = max(budget[0], self._still + records[0, TRANSLATION : CONTACT + 1].sum())
        return records

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and whether the run is sound."""
        if self.state.stale:
            self.look()
        state, span = self.state, self._span(steps)
        records = np.empty((steps // self._every + 1 if self._every else 0, self._width))
        ending = self._take(span, records)
        done, written, wide, lost = span.done.tolist()
        state.step += done
        state.time = self._origin + state.step * self._scheme.dt
        return records[:written], wide, lost, _ENDINGS[ending]


def beam_tables(model: Model, state: State, *, changing: bool) -> tuple[Beams, AlikeBeams | None]:
    """Beams of a state as the core takes them, and what they share unless their lengths change."""
    bonds = model.bonds.stretched(state.eigenstrain)
    bonds, same = (bonds.separate(), None) if changing else (bonds, bonds.alike)
    b = bonds.rows(model.layout, model.period, state.integrity, alike=same is not None)
    columns = (
        b.i, b.j, b.X0, b.Y0, b.Z0, b.length, b.kn, b.A, b.B, b.C, b.kt, b.ks, b.lever, b.integrity, b.period
    )  # fmt: skip
    beams = Beams(*map(np.ascontiguousarray, columns))
    return beams, None if same is None else AlikeBeams(b.hold, *same)


def _row_loads(schedules: Any) -> RowLoads:
    turns = schedules.load_turns
    if len(turns) == 0:
        turns = np.full(len(schedules.load_row), -1, dtype=np.int64)
    return RowLoads(schedules.load_row, schedules.load_schedule, schedules.load_value, turns)


def _drives(schedules: Any) -> Drives:
    return Drives(schedules.drive_row, schedules.drive_dof, schedules.drive_schedule, schedules.drive_rate)


def _body_forces(more: Added) -> BodyForces | None:
    if len(more.group) == 0:
        return None
    member, pull = np.ascontiguousarray(more.member), np.ascontiguousarray(more.pull)
    return BodyForces(more.group, member, pull, more.schedule, more.present, more.factor, more.body)


def _dashpots(more: Added) -> Dashpots | None:
    return Dashpots(more.dashpot, more.share, more.dashed) if len(more.dashed) else None


def _resistance(terms: DampingTerms, more: Added | None) -> Resistance | None:
    viscous = more is not None and more.viscous
    if not viscous and terms.gamma == 0.0:
        return None
    if more is None:
        return Resistance(terms.gamma, 0.0, False, np.zeros((0, 8)), np.zeros((0, 6)))
    return Resistance(terms.gamma, more.alpha, viscous, more.dashed, more.absorbing)
