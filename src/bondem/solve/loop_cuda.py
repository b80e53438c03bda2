"""Explicit dynamics on a CUDA device: the whole step stays there.

Bytes on the device, in double precision (m bonds, n elements):

    a bond      124 where all are alike but for their length, else 164: ends 8, adjacency 4, constants 32 or 72,
                integrity 8, force and torques 72
    an element  212: pose 64, motion 64, acceleration 48, loss 24, row and adjacency 12

so that 1e8 bonds of 3.2e7 elements take 19 or 23 GB. Records gather on the device and come over once a call; the
state comes over when a call ends, which is at checkpoints, at looks of events, and every 10 000 steps.
"""

from typing import Any

import numpy as np

from bondem._compile_cuda import Array, download, launch, missing, recorded, upload, zeros
from bondem.errors import InputError
from bondem.kernels.advance import BEYOND, FINE, GUARD_INTERVAL, NOT_FINITE, RUNAWAY
from bondem.kernels.cuda import sample
from bondem.kernels.cuda.bonds import bond_forces, rotation_guard
from bondem.kernels.cuda.elements import move, open_step, schedule_rows
from bondem.kernels.tables import CONTACT, FIXED_COLUMNS, TRANSLATION
from bondem.laws.damping import DampingTerms, LocalDamping
from bondem.model.boundary import Drive, Fix, Load
from bondem.model.gauges import Gauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.loop_cpu import gauge_tables, noticeable
from bondem.solve.plan import Plan

# Columns of a record that the device fills, in its order; there are no contacts.
_COLUMNS = np.array([1, 2, 3, 4, 5, 6, 8, 9, 10])
# Entries of a sum that a thread adds up at least, and parts of a sum at most.
_PART, _PARTS = 8, 16384
# Steps in one CUDA graph at most.
_RECORDED = 64


class GpuLoop:
    """The steps of one run on a device; to `integrate` what the loop of the CPU is.

    Raises:
        InputError: there is no device, or the model or plan has what runs on the CPU only.
    """

    def __init__(self, model: Model, plan: Plan, state: State, dt: float) -> None:
        require_runnable(model, plan)
        self.state = state
        self._every = int(plan.every)
        self._dt = dt
        self._origin = state.time - state.step * dt
        self._finish, self._begin, self._extra = plan.scheme.coefficients(dt)
        self._gamma = DampingTerms.of(plan.damping).gamma
        layout, held = model.layout, model.constraints
        n, self._bonds, self._rows = len(layout.order), len(layout.i), len(held.element)
        self._elements = n
        bonds = model.bonds.stretched(state.eigenstrain)
        same = bonds.alike
        constants = np.vstack([bonds.direction, bonds.length])
        if same is None:
            constants = np.vstack([constants, bonds.kn, bonds.A, bonds.B, bonds.C, bonds.kt])
        self._clock = upload(np.zeros(1, dtype=np.int64))
        self._pose, self._motion = upload(state.pose), upload(state.motion)
        self._acceleration = upload(state.acceleration)
        self._loss, self._work, self._reaction = upload(state.loss), upload(state.work), upload(state.reaction)
        self._bond_arrays = (
            upload(layout.i), upload(layout.j), upload(constants),
            upload(np.zeros(4) if same is None else np.array(same)), upload(state.integrity), upload(model.period),
        )  # fmt: skip
        self._forces = zeros(9, self._bonds)
        self._adjacency = (
            upload(layout.in_start.astype(np.int32)), upload(layout.out_start.astype(np.int32)),
            upload(layout.out_bond),
        )  # fmt: skip
        self._row_of, self._fixed = upload(held.row_of.astype(np.int32)), upload(held.fixed)
        self._force, self._half, self._full = (zeros(self._rows, 6) for _ in range(3))
        loads, drives = np.argsort(held.load_row, kind="stable"), np.argsort(held.drive_row, kind="stable")
        self._schedules = tuple(upload(array) for array in (
            held.times, held.values, held.start,
            _starts(held.load_row, self._rows), held.load_schedule[loads], held.load_value[loads],
            _starts(held.drive_row, self._rows), held.drive_dof[drives], held.drive_schedule[drives],
            held.drive_rate[drives],
        ))  # fmt: skip
        gauges = gauge_tables(model, plan)
        start, element = gauges.start, gauges.element
        self._gauges = len(gauges.quantity)
        self._gauge_start, self._reduction = upload(start), upload(gauges.reduction)
        self._gauge_arrays = (
            upload(state.rest[element]), self._gauge_start, upload(element.astype(np.int32)), upload(gauges.quantity),
            self._reduction,
        )  # fmt: skip
        parts = _parts(max(n, self._bonds))
        self._parts, self._fewer = zeros(sample.SUMS, parts), zeros(sample.SUMS, -(-parts // 128))
        self._gauge_parts = zeros(self._gauges, _parts(int(np.diff(start).max(initial=1))), 3)
        self._graphs: dict[int, Any] = {}
        self._budget, self._still = np.zeros(2), noticeable(model, dt)

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        self._clock.copy_to_device(np.array([self.state.step]))
        if self.state.stale:
            self._schedule(0)
            self._step(0, still=True)
            self.state.stale = False
            self._fetch()
        records = zeros(1, sample.SUMS + 3 * self._gauges)
        self._schedule(0)
        self._sample(0, records)
        record = self._finished(records, [self.state.step])
        self._budget[0] = max(self._budget[0], self._still + record[0, TRANSLATION : CONTACT + 1].sum())
        return record

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and what `kernels.advance.guard` would find."""
        if self.state.stale:
            self.look()
        first, every = self.state.step, self._every
        last = first + steps
        self._clock.copy_to_device(np.array([first]))
        room = last // every - first // every if every else 0
        records = zeros(room, sample.SUMS + 3 * self._gauges)
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
        self.state.time = self._origin + now * self._dt
        self._fetch()
        return self._finished(records, sampled), wide, lost, sick

    def _schedule(self, ahead: int, stream: Any = 0) -> None:
        launch(
            schedule_rows, self._rows, self._clock, ahead, self._origin, self._dt, self._rows, *self._schedules,
            self._force, self._half, self._full, stream=stream,
        )  # fmt: skip

    def _open(self) -> None:
        self._schedule(0)
        launch(
            open_step, self._elements, self._pose, self._motion, self._acceleration, self._row_of, self._fixed,
            self._force, self._half, self._reaction, self._work, self._dt, self._begin, self._extra,
        )  # fmt: skip

    def _step(self, tick: int, *, go_on: bool = False, still: bool = False, stream: Any = 0) -> None:
        """Forces of all bonds, and the motion of all elements; `still` finds the acceleration only."""
        launch(bond_forces, self._bonds, self._pose, *self._bond_arrays, self._bonds, self._forces, stream=stream)
        dt, finish = (0.0, 0.0) if still else (self._dt, self._finish)
        launch(
            move, self._elements, self._clock, tick, self._pose, self._motion, self._acceleration, self._forces,
            *self._adjacency, self._row_of, self._fixed, self._force, self._half, self._full, self._reaction,
            self._work, dt, finish, self._begin, self._extra, self._gamma, self._loss, go_on, stream=stream,
        )  # fmt: skip

    def _go_on(self, steps: int) -> None:
        """Steps between pauses, in graphs of powers of two."""
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
        i, j, constants, _, integrity, period = self._bond_arrays
        flags = upload(np.zeros(3, dtype=np.int32))
        launch(rotation_guard, self._bonds, self._pose, i, j, constants, integrity, period, self._bonds, flags)
        wide, lost, broken = flags.copy_to_host().tolist()
        return wide, lost, NOT_FINITE if broken else self._energy_guard()

    def _energy_guard(self) -> int:
        """As `kernels.advance.guard`: whether the kinetic energy is no more than what can have come in."""
        launch(sample.element_sums, self._parts.shape[1], self._motion, self._loss, self._work, self._parts)
        kinetic = float(self._parts.copy_to_host()[: sample.NORMAL].sum())
        supplied = float(np.abs(self._work.copy_to_host()).sum())
        if not (kinetic < np.inf and supplied < np.inf):
            return NOT_FINITE
        self._budget[1] = max(self._budget[1], supplied)
        return RUNAWAY if kinetic > BEYOND * self._budget.sum() else FINE

    def _sample(self, row: int, records: Array) -> None:
        parts, fewer = self._parts, self._fewer
        launch(sample.element_sums, parts.shape[1], self._motion, self._loss, self._work, parts)
        launch(sample.bond_sums, parts.shape[1], self._pose, *self._bond_arrays, self._bonds, parts)
        launch(
            sample.gauge_sums, self._gauges * self._gauge_parts.shape[1], self._pose, self._motion,
            *self._gauge_arrays, self._row_of, self._fixed, self._reaction, self._force, self._gauges,
            self._gauge_parts,
        )  # fmt: skip
        launch(sample.fold, fewer.size, parts, fewer)
        launch(
            sample.write_record, records.shape[1], fewer, self._gauge_parts, self._gauge_start, self._reduction, row,
            records,
        )  # fmt: skip

    def _finished(self, records: Array, steps: list[int]) -> np.ndarray:
        """Records of the device as those of a history."""
        raw = records.copy_to_host()[: len(steps)]
        whole = np.zeros((len(steps), FIXED_COLUMNS + 3 * self._gauges))
        whole[:, 0] = [self._origin + step * self._dt for step in steps]
        whole[:, _COLUMNS] = raw[:, : sample.SUMS]
        whole[:, FIXED_COLUMNS:] = raw[:, sample.SUMS :]
        return whole

    def _fetch(self) -> None:
        """Bring the state to what it is on the device."""
        state = self.state
        for array, target in (
            (self._pose, state.pose), (self._motion, state.motion), (self._acceleration, state.acceleration),
            (self._loss, state.loss), (self._work, state.work), (self._reaction, state.reaction),
        ):  # fmt: skip
            download(array, target)


def require_runnable(model: Model, plan: Plan) -> None:
    """Whether this can run on a device, and one is there.

    Raises:
        InputError: something that runs on the CPU only, or no device.
    """
    lacking = {
        "contacts and walls": model.contact is not None,
        "the incremental formulation": model.formulation != "total",
        "a boundary condition other than Fix, Drive and Load": any(
            not isinstance(condition, Fix | Drive | Load) for condition in model.boundary
        ),
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


def _starts(rows: np.ndarray, count: int) -> np.ndarray:
    """Where the entries of each row begin in `rows`, once sorted."""
    return np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))]).astype(np.int64)


def _parts(entries: int) -> int:
    """How many threads share a sum: it depends on nothing but its entries."""
    return max(1, min(_PARTS, -(-entries // _PART)))
