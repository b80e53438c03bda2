"""Public solvers, which open the run file and choose the device."""

import importlib
import math
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Literal

from bondem._checks import instance, place, shown
from bondem._extras import install
from bondem._names import users_line
from bondem._progress import staged
from bondem._signals import noticing, stop_by
from bondem.boundary.gauges import AnyGauge
from bondem.damage.criteria.criterion import Criterion
from bondem.damage.criteria.stress_criterion import StressCriterion
from bondem.dynamics.damping import AnyDamping
from bondem.dynamics.events import Event
from bondem.dynamics.explicit import integrate
from bondem.dynamics.opening_check import warn_of_openings
from bondem.dynamics.plan import Callback, ExplicitResult, Loop, Plan, Status
from bondem.dynamics.quasistatic_check import measured
from bondem.dynamics.restart import begin, check_gauges
from bondem.dynamics.schemes import Scheme, VelocityVerlet
from bondem.dynamics.timestep import choose_step
from bondem.errors import InputError, UnstableRunWarning
from bondem.fracture.growing_cracks import GrowingCracks
from bondem.io.run_contents import identity_in, read_contents
from bondem.io.run_identity import identity_of
from bondem.io.runfile import Checkpoint, RunFile, ends_at, read_run
from bondem.model.model import Model
from bondem.model.state import State
from bondem.statics.modes import solve_modes
from bondem.statics.relaxation import solve_relaxed
from bondem.statics.static import solve_static

__all__ = ["resume", "solve_explicit", "solve_modes", "solve_relaxed", "solve_static"]

Device = Literal["cpu", "gpu"]
_OTHER = "give another name"


@staged("explicit run")
def solve_explicit(
    model: Model,
    *,
    duration: float,
    dt: float | None = None,
    scheme: Scheme | None = None,
    damping: AnyDamping | tuple[AnyDamping, ...] | None = None,
    gauges: Mapping[str, AnyGauge] | None = None,
    every: int = 100,
    save_every: int = 0,
    snapshot_every: int = 0,
    until: Event | Sequence[Event] = (),
    safety: float = 0.9,
    imbalance: tuple[float, float] | None = (0.01, 0.10),
    state: State | None = None,
    device: Device = "cpu",
    out: str | Path | None = None,
    resume: bool = False,
    progress: Callable[[float], None] | None = None,
    callback: Callback | None = None,
) -> ExplicitResult:
    """Solve the explicit dynamics of a bonded specimen, from rest or from `state`.

    Args:
        model: model to run.
        duration: physical time [s], 0 or more than half a step; round(duration / dt) steps are taken.
        dt: time step [s]; None for `safety` times the critical step, or less to resolve short collisions.
        scheme: time integration scheme; velocity Verlet by default.
        damping: damping of elements or bonds, one kind or several in a tuple; none by default.
        gauges: quantities to record, by name: `bd.Gauge`, `bd.StrainGauge` or `bd.WallGauge`.
        every: steps between records, besides one at the end of the run; 0 for no records.
        save_every: steps between checkpoints into `out`; 0 for the last state only. Without `out` it has no effect.
        snapshot_every: steps between snapshots into `out`, which ParaView 6 shows during the run; 0 for none. Without
            `out` it has no effect.
        until: one event or several that end the run early.
        safety: share of the critical step to use if dt is None [-], in (0, 1].
        imbalance: limits of the error of the energy balance [-], as shares of the largest energy so far (work,
            losses, stored energies). Beyond the first limit the run gives a warning. Beyond the second it stops with
            status IMBALANCED. None disables the check, and `math.inf` disables one limit. The balance is checked with
            each record, or at intervals if `every` is 0. There is no check with `bd.TchamwaWielgosz`, whose
            dissipation is not in the balance.
        state: initial state, such as the end of another run of the same elements and bonds, or an equilibrium of
            `solve_static` or `solve_quasistatic`; it is not changed. The time of the state continues, also for all
            schedules: those of a second stage begin at `state.time`.
        device: "cpu", or "gpu" for a CUDA device (extra `gpu`). The GPU runs every model that the CPU runs, of fewer
            than 2³¹ bonds, or 2³⁰ facets that may crack.
        out: run file (HDF5) to write; None for no file. SIGINT (Ctrl-C) and SIGTERM stop the run, with a file after
            a checkpoint, from which `resume` continues; a second signal stops it at once.
        resume: True to continue the run in the file `out`, if the file has the same model, options and initial state.
            A repeated call then completes a killed run, or returns the result of a complete one. A file of another
            run or a `callback` raises an error. False to replace a run file; files of other kinds, and of the run
            that led to `state`, raise an error.
        progress: function called repeatedly with the completed share, 0 … 1.
        callback: function called as callback(state, record) at each record, with a `History` of this record. The
            function must not change the state, and ends the run by returning True.

    Returns:
        Status, state, history, dt, steps and a message. A run that became unstable has the status UNSTABLE and its
        last valid state. A run that lost its energy balance returns the present state and all records.

    Warns:
        StepWarning: The given dt is above 0.9 of the critical step, dashpots make the default one far smaller, or a
            free body with the non-local law has no damping.
        ContactWarning: Contacts are outside the range of their law or have none, or a wall is on the wrong side.
        ImbalanceWarning: The error of the energy balance exceeds the first limit of `imbalance`.
        UnstableRunWarning: The run ended as UNSTABLE or IMBALANCED.
        TurnedPressureWarning: Elements under a pressure without `follows` have turned by more than 0.1 rad.
        StageWarning: A schedule that is new in this stage began before it, or a load is not that of the equilibrium
            from which the run begins.
        NotQuasistaticWarning: The run looks quasi-static (a servo wall; two ends, one of them driven, with damping or
            slowly), but its kinetic energy, the difference of the forces at both ends or the force of a servo wall
            shows that it is not; `result.quasistatic` has the numbers.
        UnresolvedOpeningWarning: Cracks of cells open in so few steps that the fracture energy may be off by more
            than 15 %; `result.events.opening_steps` has the numbers.

    Raises:
        UnstableStepError: dt exceeds the critical step or is not positive, or the lattice has no stiffness.
        RunFileError: The file cannot be resumed, or the disk is full.
        InputError: A value is invalid, the state belongs to another model or is too late for the steps, the output
            file cannot be written, or a prescribed displacement jumps or does not begin where the elements are.
        RunInterrupted: Ctrl-C was pressed; the exception, a `KeyboardInterrupt`, contains the `.result` so far.
    """
    instance("solve_explicit", "model", model, Model, "bd.Model(...)")
    if state is not None:
        instance("solve_explicit", "state", state, State, "the state of a run, or model.state()")
    for name, given in (("progress", progress), ("callback", callback)):
        if given is not None and not callable(given):
            raise InputError(f"solve_explicit: {name} = {shown(given)}; give a function, or None")
    plan = Plan(
        duration=duration, dt=dt, scheme=scheme if scheme is not None else VelocityVerlet(), damping=damping,
        gauges={} if gauges is None else gauges, every=every, save_every=save_every, snapshot_every=snapshot_every,
        until=until, safety=safety, imbalance=imbalance,
    )  # fmt: skip
    loop_of = _loop_on(device, model)
    check_gauges(model, plan)
    own = begin(model, state)
    step = choose_step(model, plan.scheme, plan.dt, safety=plan.safety, damping=plan.damping)
    plan = replace(plan, dt=step.dt)
    plan.steps  # noqa: B018  rejects excessive numbers of steps
    if math.ulp(own.time) > 0.1 * step.dt:  # a tenth of a step, by which times of records would be off
        raise InputError(
            f"state: time = {own.time:.6g} s: steps of {step.dt:.3g} s are lost against it; set an earlier time"
        )
    if resume:
        found = _file_of_run(out, model, plan, own, callback)
        if found is not None:
            known = model.failure if isinstance(model.failure, StressCriterion) else None
            return _going_on(found, read_run(found, failure=known), device, progress)
    elif out is not None and state is not None and ends_at(place("out", out), state):
        raise InputError(f"out = '{out}': the file holds the run that led to state=, and would be lost; {_OTHER}")
    file = nullcontext()
    if out is not None:
        identity = identity_of(model, plan, own)
        file = RunFile(out, model, plan, cracks=GrowingCracks(model.lattice), identity=identity)
    with file as sink, noticing() as halt:
        result = integrate(
            model, plan, state=own, sink=sink, progress=progress, callback=callback, loop_of=loop_of,
            remark=step.remark, halt=halt,
        )  # fmt: skip
        stopped = halt()
    return _unless(stopped, result, sink)


def _unless(stopped: int | None, result: ExplicitResult, sink: RunFile | None) -> ExplicitResult:
    """Return the result after its warnings; raise the exception of a signal that stopped the run before its end."""
    if stopped is not None and result.message.startswith("interrupted"):
        on = "" if sink is None else f"; bd.resume('{sink.path}') continues from there"
        stop_by(stopped, f"{result.message}, step {result.steps}{on}", result)
    if result.status.failed:
        text = f"the run ended before its duration and gives no result ({result.status.name}): {result.message}"
        warnings.warn(text, UnstableRunWarning, stacklevel=users_line())
    else:
        result.quasistatic.warn()
        warn_of_openings(result.state, result.dt)
    return result


def _file_of_run(
    out: str | Path | None, model: Model, plan: Plan, initial: State, callback: Callback | None
) -> str | Path | None:
    """Return the path of a run file that contains this run, or None if there is no file.

    Raises:
        InputError: There is no path, the run has a callback, or the file contains anything else.
    """
    if out is None:
        raise InputError("solve_explicit: resume = True, but out = None; give the path of a run file")
    if callback is not None:
        raise InputError(
            "solve_explicit: resume = True, but a file does not hold what callback= remembers; end the run by until="
        )
    path = place("out", out)
    if not os.path.exists(path):
        return None
    known = identity_in(path)
    if known == identity_of(model, plan, initial):
        return path
    duration = read_contents(path).duration if known else plan.duration
    if known == identity_of(model, replace(plan, duration=duration), initial):
        raise InputError(
            f"out = '{path}': the file holds this run with duration = {duration:g} s; for a longer run continue from"
            f" its end, state=bd.read_run(path).state, and {_OTHER}"
        )
    raise InputError(
        f"out = '{path}': the file does not hold this run (model, options and initial state); delete it, or {_OTHER}"
    )


@staged("resumed run")
def resume(
    path: str | Path,
    *,
    device: Device = "cpu",
    failure: Criterion | None = None,
    progress: Callable[[float], None] | None = None,
) -> ExplicitResult:
    """Resume a run from the last checkpoint in its run file; the result is bit-identical to an uninterrupted run.

    Checkpoints continue in this file. A finished run only returns its result. Warnings are those of `solve_explicit`.

    Args:
        path: run file, from `solve_explicit(..., out=path, save_every=...)`.
        device: "cpu" or "gpu"; the result is bit-identical only on the device of the first part.
        failure: criterion of the run, required for a `bd.StressCriterion`, because a file cannot store its function.
        progress: function called repeatedly with the completed share, 0 … 1.

    Raises:
        RunFileError: The file is missing, no run file, damaged, of a newer bondem, or of another criterion.
        InputError: The file cannot be written, or the device is unknown or missing.
        RunInterrupted: Ctrl-C was pressed; its `.result` is that of the run so far.
    """
    return _going_on(path, read_run(path, failure=failure), device, progress)


def _going_on(
    path: str | Path, saved: Checkpoint, device: str, progress: Callable[[float], None] | None
) -> ExplicitResult:
    """Continue a run from its checkpoint, or return the result of a finished run."""
    over = _over(saved)
    if over is not None:
        return _unless(None, over, None)
    loop_of = _loop_on(device, saved.model)
    cracks = GrowingCracks(saved.model.lattice)
    with RunFile(path, saved.model, saved.plan, cracks=cracks, goes_on=saved) as sink, noticing() as halt:
        result = integrate(
            saved.model, saved.plan, state=saved.state, history=saved.history, sink=sink, progress=progress,
            loop_of=loop_of, halt=halt,
        )  # fmt: skip
        stopped = halt()
    return _unless(stopped, result, sink)


def _over(saved: Checkpoint) -> ExplicitResult | None:
    """Return the result of a run that is finished at its checkpoint, or None."""
    state, plan = saved.state, saved.plan
    if state.step and any(event.happened(state, saved.history) for event in plan.events):
        status, message = Status.STOPPED, f"had been stopped by an event at t = {state.time:.6g} s"
    elif 0 < plan.steps <= state.step:
        status, message = Status.COMPLETED, f"{plan.steps} steps of {plan.dt:.4g} s"
    else:
        return None
    return ExplicitResult(
        status=status, iterations=state.step, residual=saved.history.imbalance, state=state, history=saved.history,
        dt=plan.dt or 0.0, message=message, quasistatic=measured(saved.model, plan, saved.history, state),
        gauges=plan.gauges,
    )  # fmt: skip


def _loop_on(device: str, model: Model) -> Callable[[Model, Plan, State, float], Loop] | None:
    """Return the factory of the loop of a run on a device, None for the CPU.

    Raises:
        InputError: The device is unknown or missing, or cannot run this model.
    """
    if not isinstance(device, str) or device not in ("cpu", "gpu"):
        raise InputError(f"device = {shown(device)} is unknown; choose 'cpu' or 'gpu'")
    if device == "cpu":
        return None
    try:
        gpu = importlib.import_module("bondem.dynamics.gpu_loop")
        gpu.require_gpu(model)
    except ImportError as error:
        raise InputError(
            f"device='gpu' needs NVIDIA's packages for Python ({error}); {install('gpu')}, or use device='cpu'"
        ) from error
    return gpu.loop_on_gpu
