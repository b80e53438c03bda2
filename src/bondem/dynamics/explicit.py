"""Explicit dynamics: the loop over the time steps of a plan."""

import time
from collections.abc import Callable
from typing import cast

import numpy as np

from bondem._signals import Halt
from bondem.dynamics.contact_check import SinkingCheck
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.energy_check import EnergyCheck
from bondem.dynamics.history import GrowingHistory, History
from bondem.dynamics.plan import FINE, NOT_FINITE, RUNAWAY, Callback, ExplicitResult, Loop, Plan, Status, settled
from bondem.dynamics.pressure_check import PressureCheck
from bondem.dynamics.progress import RunProgress, has_listener, send
from bondem.dynamics.quasistatic_check import measured
from bondem.dynamics.sink import Sink
from bondem.dynamics.state_gauges import StateGauges
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.fracture_energy import fracture_energies

# Largest number of steps in one call of the core, so that interrupts and progress act soon, and steps between copies
# of a sound state: copying costs about as much as two steps.
_CHUNK = 5_000
# Steps in which an instability may grow from rounding errors: only a copy that is older is a sound state to return.
_RISE = 1_000
# Intended wall time of one call [s], and steps times elements and bonds of the first call.
_PATIENCE, _WORK = 1.0, 20_000_000


def integrate(
    model: Model, plan: Plan, *, state: State | None = None, history: History | None = None, sink: Sink | None = None,
    progress: Callable[[float], None] | None = None,
    loop_of: Callable[[Model, Plan, State, float], Loop] | None = None, callback: Callback | None = None,
    remark: str = "", halt: Halt | None = None,
) -> ExplicitResult:  # fmt: skip
    """Carry out a plan from rest, or continue from `state` and `history` of the same plan.

    A given dt is not checked, because `settled` has done so.

    Args:
        model: model to run; its geometry is the reference configuration.
        plan: parameters of the run.
        state: initial state; it is changed in place.
        history: records so far.
        sink: receiver of checkpoints, of snapshots and of the last state.
        progress: function called repeatedly with the completed share, 0 … 1.
        loop_of: function that makes the loop from model, plan, state and dt; that of the CPU by default.
        callback: function called at each record with the state and a history of this one record. It must not change
            the state, and ends the run by returning True.
        remark: addition to the message of the result.
        halt: function called repeatedly; the run stops, with a checkpoint, if it returns a signal.

    Raises:
        InputError: A callback is given without records, a value does not fit the model, or no dt can be chosen.
    """
    if callback is not None and not plan.every:
        raise InputError("callback= is called with each record, but every = 0; give every= of at least 1")
    if plan.dt is None:
        plan = settled(model, plan)
    dt = cast(float, plan.dt)
    names = tuple(plan.gauges)
    state = State(model) if state is None else state
    history = History.empty(names) if history is None else history
    began_at = state.step
    midway = plan.every > 0 and state.step % plan.every > 0 and state.step < plan.steps
    if midway and len(history) and history.time[-1] == state.time:
        history = History(history.records[:-1], names)  # a record at the end of a part, between two of the run
    written = GrowingHistory(history)
    loop = (CoreLoop if loop_of is None else loop_of)(model, plan, state, dt)
    total = plan.steps
    if progress is not None and total:
        progress(state.step / total)
    joined = f"{model.interaction.bond}s"
    status, message = Status.COMPLETED, f"{total} steps of {dt:.4g} s"
    copies = (state.copy(),)
    outside = StateGauges(model, plan)
    start = loop.record_present()  # also if it is not kept, because guards need its energy
    outside.fill(start, state)
    fresh = plan.every > 0 and len(written.so_far) == 0
    if fresh:
        written.append(start)
    stop = fresh and callback is not None and bool(callback(state, History(start, names)))
    warning = f"; {remark}" if remark else ""
    turned = ""
    if sink is not None and plan.snapshot_every and state.step == 0:
        sink.checkpoint(state, written.so_far)  # so that a run file with snapshots can always be resumed
        sink.snapshot(state)
    before = written.so_far.records
    sent, first = None, (before if len(before) else start)[:1]
    check = None
    if plan.imbalance is not None and plan.scheme.conserves:
        check = EnergyCheck(model, state, dt, plan.imbalance, first)
    pressing = PressureCheck(model)
    sinking = SinkingCheck(model) if model.fails and model.contact is None else None
    missed = "" if check is None else check.examine(before[1:])
    pace = max(_WORK // (len(state.pose) + len(state.integrity)), 1)
    while state.step < total and not stop and not missed:
        goal = min(total, copies[-1].step + _CHUNK, state.step + pace)
        watched = plan.every if plan.events or callback is not None or outside else 0
        for interval in (plan.save_every, plan.snapshot_every if sink is not None else 0, watched):
            if interval:
                goal = min(goal, (state.step // interval + 1) * interval)
        steps, began = goal - state.step, time.perf_counter()
        records, wide, lost, sick = loop.run(steps)
        taken = time.perf_counter() - began
        pace = max(round(steps * _PATIENCE / max(taken, 1e-9)), 1)
        if state.step == total and plan.every and total % plan.every and not lost and sick == FINE:
            records = np.vstack([records, loop.record_present()])  # the end of the run
        outside.fill(records, state)
        written.append(records)
        if lost or sick != FINE:
            cause = _CAUSES.get(sick, f"{lost} unbroken {joined} are turned beyond 90 degrees")
            good = copies[-1] if state.step - copies[-1].step >= _RISE else copies[0]
            status = Status.UNSTABLE
            message = (
                f"stopped at step {state.step}: {cause}; the state is that of step {good.step}."
                " Use a smaller dt, or load more gently"
            )
            state = good
            break
        if wide:
            turned = f"; {wide} {joined} were turned so far (c < 0.7 or w² < 0.75) that {model.interaction.turned}"
        pressing.examine(state)
        if sinking is not None:
            sinking.examine(state)
        if check is not None:
            missed = check.examine(records if plan.every else loop.record_present())
            if missed:
                break
        if progress is not None:
            progress(state.step / total)
        if has_listener():
            since = History(np.vstack([first, records]), names)
            sent = _progress(sent, state, total, steps / max(taken, 1e-9), since)
            send(sent)
        if plan.snapshot_every and state.step % plan.snapshot_every == 0 and sink is not None:
            # before the checkpoint, so that a resumed run does not store the same snapshot again
            sink.snapshot(state)
        if plan.save_every and state.step % plan.save_every == 0 and sink is not None:
            sink.checkpoint(state, written.so_far)
        if state.step - copies[-1].step >= _CHUNK:
            copies = (copies[-1], state.copy())
        if callback is not None and len(records) and callback(state, History(records, names)):
            stop = True
        elif any(event.happened(state, written.so_far) for event in plan.events):
            status, message = Status.STOPPED, f"stopped by an event at t = {state.time:.6g} s"
            break
        if halt is not None and halt() is not None:
            status, message = Status.STOPPED, f"interrupted at t = {state.time:.6g} s"
            break
    if stop:
        status, message = Status.STOPPED, f"stopped by the callback at t = {state.time:.6g} s"
    if missed:
        status, message = Status.IMBALANCED, f"stopped at step {state.step}: {missed}"
    elif check is not None and check.remark:
        warning = f"; {check.remark}{warning}"
    ended = status is not Status.UNSTABLE and not message.startswith("interrupted")
    if ended and plan.every and written.so_far.time[-1] < state.time:  # stopped between two records
        end = loop.record_present()
        outside.fill(end, state)
        written.append(end)
    history = written.so_far
    if sink is not None and status is not Status.UNSTABLE:
        if plan.snapshot_every and state.step % plan.snapshot_every and state.step > began_at and ended:
            sink.snapshot(state)  # the end of the run
        sink.checkpoint(state, history)
    return ExplicitResult(
        status=status, iterations=state.step, residual=history.imbalance, state=state, history=history, dt=dt,
        message=message + _fractured(state) + turned + warning,
        quasistatic=measured(model, plan, history, state), gauges=plan.gauges,
    )  # fmt: skip


def _fractured(state: State) -> str:
    """Return a text on the dissipation of broken facets over the fracture energy of their area; "" for none."""
    ratios = ", ".join(f"{one.ratio:.3g}" for one in fracture_energies(state) if one.ratio == one.ratio)
    return ratios and f"; broken area dissipated {ratios} G_f"


def _progress(before: RunProgress | None, state: State, total: int, rate: float, since: History) -> RunProgress:
    """Return the progress at the present step, with a smoothed rate and the worst error of the energy balance.

    `since` consists of the first record of the run and those of the last call of the core.
    """
    error = energy = 0.0
    if before is not None:
        error, energy = before.error, before.energy
        rate = 0.7 * before.rate + 0.3 * rate
    if len(since):
        ledger = since.energy
        error = max(error, float(np.abs(ledger.pop("balance")).max()))
        energy = max(energy, *(float(np.abs(values).max()) for values in ledger.values()))
    return RunProgress(state.step, total, state.time, rate, len(state.broken), error, energy)


_CAUSES = {
    NOT_FINITE: "a number is not finite",
    RUNAWAY: "the kinetic energy is a thousand times what was there and was put in",
}
