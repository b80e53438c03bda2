"""Loop over the steps of a run on a device such as a GPU.

The parts of a step compose its lists of passes as for the CPU, and `bondem.dynamics.on_device` translates them.
The device also computes the records. They are copied to the host once per call, together with the state. Between two
records or checks, all steps have the same launches, because the number of the step is stored on the device. These
launches are recorded once, as graphs of 1, 2, 4 … 64 steps.
"""

from collections.abc import Callable, Sequence

import numpy as np

from bondem._device import Device, DeviceTables, Enqueue, HostCall, Launch, passes_of
from bondem._passes import kernels
from bondem._tables.columns import GuardNumber, HistoryColumn, LogCount
from bondem._tables.device_tables import Tick
from bondem._tables.step_tables import HistoryRows, StepScheme
from bondem.dynamics.core_loop import STORED, noticeable
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.on_device.breakage_counterparts import end, resuming
from bondem.dynamics.on_device.contact_counterparts import deepest_overlaps, lists_of_contacts, walls_listed
from bondem.dynamics.on_device.counterparts import FURTHER, launches_of
from bondem.dynamics.on_device.translation import Translation
from bondem.dynamics.parts.parts_of_model import parts_in_one_block
from bondem.dynamics.plan import FINE, NOT_FINITE, Plan
from bondem.interactions.step_part import FORCES, RESUME, composed
from bondem.model.model import Model
from bondem.model.state import State

# Steps between two guards of relative rotations, of numbers that are not finite, and of the energy.
GUARD_INTERVAL = 100
# Largest number of steps in a graph.
_RECORDED = 64
# Word of the clock that is the number of the step.
_STEP = 5


class DeviceLoop:
    """Loop over the steps of one run on a device, with the interface `Loop` that `integrate` requires."""

    def __init__(self, model: Model, plan: Plan, state: State, dt: float, device: Device) -> None:
        self.state = state
        self._every = int(plan.every)
        terms = DampingTerms.of(plan.damping)
        self._scheme = StepScheme(dt, *plan.scheme.coefficients(dt), terms.gamma, state.time - state.step * dt)
        self._shared, self._parts = parts_in_one_block(model, plan, state, dt)
        passes = dict(composed(self._parts, *FORCES))
        late = passes["postpone_elements"][1:] if "postpone_elements" in passes else None
        self._run = Translation(
            model.layout, self._shared.blocks, self._shared.ledger, len(state.reaction),
            np.zeros(0, dtype=np.uint8) if late is None else late[1].flag, further=not FURTHER.isdisjoint(passes),
        )  # fmt: skip
        self._tables = DeviceTables(device)
        self._width = HistoryColumn.COUNT + 3 * len(plan.gauges)
        self._ledger, self._still = self._shared.ledger, noticeable(model, dt)
        self._late, self._listed = late, model.contact is not None
        begins = self._launches("begin")
        self._compose()
        if begins:
            self._set_clock()
            _run(self._tables.prepared([self._tick(first=True), *self._launches("present"), *begins]))

    def _compose(self) -> None:
        """Prepare the kernel launches of a step from its parts."""
        run, late = self._run, self._late
        self._graphs: dict[int, Callable[[], None]] = {}
        present, forces = self._launches("present"), self._launches(*FORCES)
        begin, forces_now = [self._tick(first=True), *present], [self._tick(first=True, still=True), *forces]
        opening, guard, travel = self._launches("opening"), self._launches("guard"), self._launches("travel")
        guard += deepest_overlaps(run, composed(self._parts, "travel", *FORCES))
        if late is not None:
            forces += [*launches_of(composed(self._parts, *RESUME), run, resuming(late)), *end(run, late)]
        pause = [self._tick(ahead=1), *present, *forces]
        go_on = [self._tick(ahead=1, goes_on=True), *present, *forces]
        written = self._recording(HistoryRows(np.zeros((1, self._width))))
        self._tables.work_space(*run.work_spaces)
        self._tables.device.compile(passes_of((*begin, *travel, *forces, *opening, *guard, *written)))
        self._graphed = not any(isinstance(one, HostCall) for one, *_ in forces)
        others = map(self._tables.prepared, (begin, forces_now, opening, guard))
        self._begin, self._present, self._open, self._guarding = others
        halted = run.span.halted if self._listed else None
        steps = [*travel, *go_on], [*travel, *pause], go_on, pause
        self._go_on, self._pause, self._moved_on, self._moved_pause = (
            self._tables.prepared(step, halted) for step in steps
        )

    def _launches(self, *stages: str) -> list[Launch]:
        return launches_of(composed(self._parts, *stages), self._run)

    def _recording(self, rows: HistoryRows) -> list[Launch]:
        """Return the kernel launches that write the next row of the history."""
        passes = [one for part in self._parts for one in part.record(rows)]
        return [*launches_of(passes, self._run), (kernels.count_record(self._run.span), 1)]

    def _tick(self, *, ahead: int = 0, goes_on: bool = False, still: bool = False, first: bool = False) -> Launch:
        return kernels.set_clock(self._run.span, self._scheme, Tick(ahead, goes_on, still, first)), 1

    def record_present(self) -> np.ndarray:
        """Update the acceleration and return a record of the present state, (1, columns)."""
        state, budget = self.state, self._ledger.budget
        begins = state.stale or budget[0] == 0.0  # set at the start only: energy gained later must not raise it
        self._set_clock()
        _run(self._begin)
        if state.stale:
            _run(self._present)
            state.stale = False
            self._fetch()
        records = self._records(1)
        _run(records.row)
        found = records.finished([state.step])
        if begins:
            budget[0] = max(budget[0], self._still + np.abs(found[0, STORED]).sum())
            self._tables.send(budget)
        return found

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Take steps and return records, two numbers of strongly rotated bonds, and the verdict, as `Loop.run`."""
        if self.state.stale:
            self.record_present()
        state, every = self.state, self._every
        first, last = state.step, state.step + steps
        records = self._records(last // every - first // every if every else 0)
        self._set_clock()
        _run(self._begin)
        taken: list[int] = []
        now, wide, lost, sick = first, 0, 0, FINE
        while now < last and not lost and sick == FINE:
            _run(self._open)
            goal = min(last, (now // GUARD_INTERVAL + 1) * GUARD_INTERVAL)
            if every:
                goal = min(goal, (now // every + 1) * every)
            now, finite = self._advance(now, goal, records)
            if not finite:
                sick = NOT_FINITE
                break
            if now % GUARD_INTERVAL == 0 or now == last:
                turned, lost, sick = self._guard()
                wide = max(wide, turned)
            if every and now % every == 0 and not lost and sick == FINE:
                _run(records.row)
                taken.append(now)
        self._set_time(now)
        self._fetch()
        return records.finished(taken), wide, lost, sick

    def _advance(self, now: int, goal: int, records: "_Records") -> tuple[int, bool]:
        """Take steps to step `goal`; return the number of the last step, and False if a centre is not finite."""
        while now < goal:
            taken = self._enqueue(goal - now)
            stopped = self._stopped() if self._listed else None
            if stopped is None:
                now += taken
                continue
            now = stopped
            if not self._renew(now):
                return now, False
            records.prepare()
            _run(self._moved_on if goal - now > 1 else self._moved_pause)
            now += 1
        return now, True

    def _enqueue(self, steps: int) -> int:
        """Enqueue some of the next `steps` steps, as a graph where possible, and return their number."""
        if steps == 1 or not self._graphs:  # the first step loads the kernels, which recording requires
            _run(self._pause if steps == 1 else self._go_on)
            if self._graphed and not self._graphs:
                self._graphs[1] = self._tables.device.recorded(self._go_on)
            return 1
        size = min(_RECORDED, 1 << ((steps - 1).bit_length() - 1))
        if size not in self._graphs:
            self._graphs[size] = self._tables.device.recorded(self._go_on * size)
        self._graphs[size]()
        return size

    def _stopped(self) -> int | None:
        """Return the number of the last completed step if an outdated list of contacts has halted the launches.

        The result is None if the launches continue.
        """
        span = self._run.span
        self._tables.fetch(span.halted)
        if span.halted[0] == 0:
            return None
        self._tables.fetch(span.clock)
        span.halted[:] = 0
        self._tables.send(span.halted)
        return int(span.clock[_STEP])

    def _renew(self, step: int) -> bool:
        """Search for contacts again at a step and renew the launches; return False if a centre is not finite."""
        self._set_time(step)
        self._fetch()
        before = lists_of_contacts(composed(self._parts, "travel", *FORCES))
        parts = [part if part.renewed is None else part.renewed() for part in self._parts]
        self._parts = [part for part in parts if part is not None]
        self._tables.forget(*before, *self._run.dropped(before))
        if None in parts:
            return False
        self._compose()
        self._tables.send(*(log.written for log in self._run.logs), *walls_listed(composed(self._parts, "travel")))
        return True

    def _set_time(self, step: int) -> None:
        self.state.step = step
        self.state.time = self._scheme.origin + step * self._scheme.dt

    def _guard(self) -> tuple[int, int, int]:
        """Return two numbers of strongly rotated bonds, as `Loop.run`, and the verdict on the energy.

        The verdict is FINE, NOT_FINITE or RUNAWAY.
        """
        _run(self._guarding)
        found = self._ledger.found
        self._tables.fetch(found)
        return int(found[GuardNumber.WIDE]), int(found[GuardNumber.LOST]), int(found[GuardNumber.ENDING])

    def _set_clock(self) -> None:
        """Set the step number on the device to that of the state, and the counts of records and events to zero."""
        clock = self._run.span.clock
        clock[:] = 0
        clock[_STEP] = self.state.step
        self._tables.send(clock, *(log.written for log in self._run.logs))

    def _records(self, rows: int) -> "_Records":
        return _Records(self, HistoryRows(np.zeros((max(rows, 1), self._width))))

    def _fetch(self) -> None:
        """Copy from the device all arrays that passes have written, and store their values in the state."""
        self._tables.fetch_written()
        for log in self._run.logs:
            self._tables.fetch(log.event[: log.written[LogCount.EVENTS]])
        for arranged in self._run.before_keeping:
            arranged()
        for part in self._parts:
            part.keep()


class _Records:
    """Rows of the history that one call of `DeviceLoop.run` fills, with the kernel launches that write a row."""

    def __init__(self, loop: DeviceLoop, rows: HistoryRows) -> None:
        self._loop, self._rows = loop, rows
        self.prepare()

    def prepare(self) -> None:
        """Prepare the launches by which the parts of the step write a row."""
        self.row = self._loop._tables.prepared(self._loop._recording(self._rows))

    def finished(self, steps: Sequence[int]) -> np.ndarray:
        """Return the records of steps with their times, (s, columns), and free the memory of the device."""
        loop, found = self._loop, self._rows.record
        if len(steps):
            loop._tables.fetch(found)
        loop._tables.forget(self._rows)
        whole = found[: len(steps)].copy()
        whole[:, 0] = [loop._scheme.origin + step * loop._scheme.dt for step in steps]
        return whole


def _run(enqueued: Sequence[Enqueue]) -> None:
    for enqueue in enqueued:
        enqueue(None)
