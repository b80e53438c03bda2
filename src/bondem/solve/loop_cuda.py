"""Explicit dynamics on a CUDA device, where the whole step stays.

An element takes 212 bytes on the device, in double precision: pose 64, motion 64, acceleration 48, loss 24, row and
adjacency 12; and 12 more where body forces act. The bytes of bonds, facets and cells are given in
`bondem.solve.forces_cuda`, and those of breaking, softening and cracks in `breakage_cuda`, `beam_softening_cuda` and
`cracks_cuda`. 1e8 bonds of 3.2e7 elements take 19 or 23 GB, and 1e7 cells with 7e7 facets 16 GB.

Records are gathered on the device and transferred once per call. The state is transferred at the end of a call: at
checkpoints, at evaluations of events, and every 10 000 steps.
"""

from typing import Any

import numpy as np

from bondem._compile_cuda import Array, download, launch, missing, recorded, upload, zeros
from bondem.errors import InputError
from bondem.kernels.advance import BEYOND, FINE, GUARD_INTERVAL, NOT_FINITE, RUNAWAY
from bondem.kernels.couples import CoupleTable
from bondem.kernels.cuda import sample
from bondem.kernels.cuda.elements import move, open_step, pull_groups, schedule_rows, turn_moments
from bondem.kernels.cuda.tables import DeviceBodies, DeviceElements, DeviceGauges, RowSchedules
from bondem.kernels.tables import (
    CONTACT,
    FIXED_COLUMNS,
    FRACTURE,
    PLASTIC,
    TRANSLATION,
    Adjacency,
    Gauges,
    Rows,
    StepScheme,
)
from bondem.laws.damping import DampingTerms, LocalDamping
from bondem.model.constraints import Constraints
from bondem.model.gauges import Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.beam_softening_cuda import SoftBeamForces
from bondem.solve.breakage_cuda import BeamBreakage, DeviceBreakage, FacetBreakage
from bondem.solve.cracks_cuda import CrackForces
from bondem.solve.forces_cuda import BeamForces, DeviceFacetForces, DeviceForces, DeviceRun, starts
from bondem.solve.gauge_tables import gauge_tables
from bondem.solve.loop_core import noticeable
from bondem.solve.plan import Plan

# Columns of a record that the device fills, in its order; there are no contacts.
_COLUMNS = np.array([1, 2, 3, 4, 5, 6, 8, 9, 10, FRACTURE, PLASTIC])
# Entries of a sum that a thread adds up at least, and parts of a sum at most.
_PART, _PARTS = 8, 16384
# Steps in one CUDA graph at most.
_RECORDED = 64


class GpuLoop:
    """The steps of one run on a device; `integrate` uses it like the loop of the CPU.

    Raises:
        InputError: There is no device, or the model or plan has features that run on the CPU only.
    """

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        require_runnable(model, plan)
        self.state = state
        self._every = int(plan.every)
        gamma = DampingTerms.of(plan.damping).gamma
        self._scheme = StepScheme(dt, *plan.scheme.coefficients(dt), gamma, state.time - state.step * dt)
        self._still_scheme = self._scheme._replace(dt=0.0, finish=0.0)
        self._clock = upload(np.zeros(1, dtype=np.int64))
        self._count = len(model.layout.order)
        self._elements = DeviceElements._make(map(upload, (state.pose, state.motion, state.acceleration, state.loss)))
        layout = model.layout
        ends = layout.in_start.astype(np.int32), layout.out_start.astype(np.int32)
        self._adjacency = Adjacency._make(map(upload, (*ends, layout.out_bond)))
        self._rows, self._schedules = _rows(model.constraints, state), _schedules(model.constraints)
        self._bodies = _bodies(model.constraints)
        self._couples = _couples(model.constraints)
        run = DeviceRun(
            self._clock, self._scheme, self._elements, self._adjacency, self._rows, self._schedules
        )  # fmt: skip
        self._forces, self._breakage = self._law(model, state, run, dt)
        self._gauges = _gauges(gauge_tables(model, plan), state)
        parts = _parts(max(self._count, self._forces.m))
        self._parts, self._fewer = zeros(sample.SUMS, parts), zeros(sample.SUMS, -(-parts // 128))
        self._graphs: dict[int, Any] = {}
        self._budget, self._still = np.zeros(2), noticeable(model, dt)

    def _law(
        self, model: Model, state: State, run: DeviceRun, dt: float
    ) -> tuple[DeviceForces, DeviceBreakage | None]:
        """Return the forces of the law, and the breakage of its bonds or facets if they break at once."""
        table = model.breaking
        if model.beam_softening is not None and table is not None:
            return SoftBeamForces(table, model, state, run), None
        if model.cells is None:
            beams = BeamForces(model, state, run)
            return beams, None if table is None else BeamBreakage(table, model, state, run, self._bodies, beams)
        if model.softening is not None:
            return CrackForces(model, state, run, dt), None
        facets = DeviceFacetForces(model, state, run)
        return facets, None if table is None else FacetBreakage(table, model, state, run, self._bodies, facets)

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present state."""
        self._clock.copy_to_device(np.array([self.state.step]))
        begins = self.state.stale or self._budget[0] == 0.0  # what a run gains as it goes on is no budget of its own
        if self.state.stale:
            self._schedule(0)
            self._step(0, still=True)
            self.state.stale = False
            self._fetch()
        else:
            self._forces.take_up()
        records = zeros(1, sample.SUMS + 3 * self._gauges.g)
        self._schedule(0)
        self._sample(0, records)
        record = self._finished(records, [self.state.step])
        if begins:
            self._budget[0] = max(self._budget[0], self._still + record[0, TRANSLATION : CONTACT + 1].sum())
        return record

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Carry out steps; see `Loop`."""
        if self.state.stale:
            self.look()
        first, every = self.state.step, self._every
        last = first + steps
        self._clock.copy_to_device(np.array([first]))
        room = last // every - first // every if every else 0
        records = zeros(room, sample.SUMS + 3 * self._gauges.g)
        sampled: list[int] = []
        now, wide, lost, sick = first, 0, 0, FINE
        while now < last and not lost and sick == FINE:
            self._open()
            goal = min(last, (now // GUARD_INTERVAL + 1) * GUARD_INTERVAL)
            if every:
                goal = min(goal, (now // every + 1) * every)
            self._go_on(goal - now - 1)
            self._schedule(1)
            self._step(1)
            now = goal
            if now % GUARD_INTERVAL == 0 or now == last:
                turned, lost, sick = self._guard()
                wide = max(wide, turned)
            if every and now % every == 0 and not lost and sick == FINE:
                self._sample(len(sampled), records)
                sampled.append(now)
        self.state.step = now
        self.state.time = self._scheme.origin + now * self._scheme.dt
        self._fetch()
        return self._finished(records, sampled), wide, lost, sick

    def _schedule(self, ahead: int, stream: Any = 0) -> None:
        clock, scheme, schedules, bodies = self._clock, self._scheme, self._schedules, self._bodies
        launch(schedule_rows, schedules.r, clock, ahead, scheme, schedules, self._rows, stream=stream)
        if self._couples is not None:
            launch(
                turn_moments, 1, clock, ahead, scheme, schedules, self._couples, self._elements.pose, self._rows,
                stream=stream,
            )  # fmt: skip
        if bodies.b:
            launch(pull_groups, bodies.present.shape[0], clock, ahead, scheme, schedules, bodies, stream=stream)

    def _open(self) -> None:
        self._schedule(0)
        launch(open_step, self._count, self._elements, self._rows, self._bodies, self._scheme)

    def _step(self, tick: int, *, go_on: bool = False, still: bool = False, stream: Any = 0) -> None:
        """Compute forces of all bonds, and move all elements; `still` computes the acceleration only."""
        scheme = self._still_scheme if still else self._scheme
        breakage = None if still else self._breakage
        if breakage is not None:
            breakage.mark(stream)
        self._forces.act(tick, stream)
        if breakage is not None:
            breakage.move(tick, go_on=go_on, stream=stream)
            return
        launch(
            move, self._count, self._clock, tick, self._elements, self._adjacency, self._forces.forces, self._rows,
            self._bodies, scheme, go_on, stream=stream,
        )  # fmt: skip

    def _go_on(self, steps: int) -> None:
        """Carry out the steps between pauses, in graphs of powers of two."""
        if steps > 0 and not self._graphs:  # what a run that goes on has not launched yet is compiled now
            self._inner(1, 0)
            steps -= 1
        while steps > 0:
            size = min(_RECORDED, 1 << (steps.bit_length() - 1))
            if size not in self._graphs:
                self._graphs[size] = recorded(lambda stream, size=size: self._inner(size, stream))
            self._graphs[size]()
            steps -= size

    def _inner(self, steps: int, stream: Any) -> None:
        for _ in range(steps):
            self._schedule(1, stream)
            self._step(1, go_on=True, stream=stream)

    def _guard(self) -> tuple[int, int, int]:
        flags = upload(np.zeros(3, dtype=np.int32))
        self._forces.guard(flags)
        wide, lost, broken = flags.copy_to_host().tolist()
        return wide, lost, NOT_FINITE if broken else self._energy_guard()

    def _energy_guard(self) -> int:
        """Return whether the kinetic energy is at most the energy supplied, as `kernels.advance.guard` does."""
        launch(sample.element_sums, self._parts.shape[1], self._elements, self._rows, self._parts)
        kinetic = float(self._parts.copy_to_host()[: sample.NORMAL].sum())
        work = np.zeros_like(self.state.work)
        download(self._rows.work, work)
        supplied = float(np.abs(work).sum())
        if not (kinetic < np.inf and supplied < np.inf):
            return NOT_FINITE
        self._budget[1] = max(self._budget[1], supplied)
        return RUNAWAY if kinetic > BEYOND * self._budget.sum() else FINE

    def _sample(self, row: int, records: Array) -> None:
        parts, fewer, gauges = self._parts, self._fewer, self._gauges
        launch(sample.element_sums, parts.shape[1], self._elements, self._rows, parts)
        self._forces.sums(parts)
        if self._breakage is not None:
            self._breakage.sums(parts)
        launch(sample.gauge_sums, gauges.g * gauges.parts.shape[1], self._elements, gauges, self._rows)
        launch(sample.fold, fewer.size, parts, fewer)
        launch(sample.write_record, records.shape[1], fewer, gauges, row, records)

    def _finished(self, records: Array, steps: list[int]) -> np.ndarray:
        """Convert records of the device to those of a history."""
        raw = records.copy_to_host()[: len(steps)]
        whole = np.zeros((len(steps), FIXED_COLUMNS + 3 * self._gauges.g))
        whole[:, 0] = [self._scheme.origin + step * self._scheme.dt for step in steps]
        whole[:, _COLUMNS] = raw[:, : sample.SUMS]
        whole[:, FIXED_COLUMNS:] = raw[:, sample.SUMS :]
        return whole

    def _fetch(self) -> None:
        """Copy the state from the device."""
        state, elements = self.state, self._elements
        for array, target in (
            (elements.pose, state.pose), (elements.motion, state.motion),
            (elements.acceleration, state.acceleration), (elements.loss, state.loss),
            (self._rows.work, state.work), (self._rows.reaction, state.reaction),
        ):  # fmt: skip
            download(array, target)
        self._forces.keep(state)
        if self._breakage is not None:
            self._breakage.keep(state)


def require_runnable(model: Model, plan: Plan) -> None:
    """Check that a model can run on a device, and that there is one.

    Raises:
        InputError: A feature runs on the CPU only, or there is no device.
    """
    held = model.constraints
    lacking = {
        "contacts and walls": model.contact is not None,
        "the non-local law": model.non_local is not None,
        "the incremental formulation": model.formulation != "total",
        "absorbing faces": len(held.absorbing) > 0,
        "pressures that follow": len(held.load_turns) > 0,
        "strains that change (state.set_eigenstrain gives constant ones)": len(held.strain_part) > 0,
        "damping other than LocalDamping": plan.damping is not None and not isinstance(plan.damping, LocalDamping),
        "gauges of walls": any(not isinstance(gauge, Gauge) for gauge in plan.gauges.values()),
        "more than 2³¹ bonds": len(model.layout.i) >= 2**31,
    }
    for what, asked in lacking.items():
        if asked:
            raise InputError(f"device='gpu' cannot run {what} yet; use device='cpu'")
    reason = missing()
    if reason is not None:
        raise InputError(f"device='gpu': {reason}")


def _rows(held: Constraints, state: State) -> Rows:
    of, fixed, reaction, work = map(upload, (held.row_of.astype(np.int32), held.fixed, state.reaction, state.work))
    force, half, full, grip = (zeros(len(held.element), 6) for _ in range(4))
    return Rows(of, fixed, force, half, full, reaction, grip, work)


def _bodies(held: Constraints) -> DeviceBodies:
    count = len(held.body_on)
    member, group = np.unique(held.body_on.T, axis=0, return_inverse=True)
    arrays = (
        (group.ravel() if count else np.zeros(0)).astype(np.uint32), member.astype(float), held.body_value,
        held.body_schedule,
    )  # fmt: skip
    return DeviceBodies._make([count, *map(upload, arrays), held.works[0], zeros(len(member), 3)])


def _couples(held: Constraints) -> CoupleTable | None:
    return CoupleTable._make(map(upload, held.schedules.couples)) if held.couples else None


def _schedules(held: Constraints) -> RowSchedules:
    rows = len(held.element)
    loads, drives = np.argsort(held.load_row, kind="stable"), np.argsort(held.drive_row, kind="stable")
    arrays = (
        held.times, held.values, held.start,
        starts(held.load_row, rows), held.load_schedule[loads], held.load_value[loads],
        starts(held.drive_row, rows), held.drive_dof[drives], held.drive_schedule[drives], held.drive_rate[drives],
    )  # fmt: skip
    return RowSchedules._make([rows, *map(upload, arrays)])


def _gauges(gauges: Gauges, state: State) -> DeviceGauges:
    count, element = len(gauges.quantity), gauges.element
    arrays = state.rest[element], gauges.start, element.astype(np.int32), gauges.quantity, gauges.reduction
    parts = zeros(count, _parts(int(np.diff(gauges.start).max(initial=1))), 3)
    return DeviceGauges._make([count, *map(upload, arrays), parts])


def _parts(entries: int) -> int:
    """Return the number of threads that share a sum, which depends on nothing but its entries."""
    return max(1, min(_PARTS, -(-entries // _PART)))
