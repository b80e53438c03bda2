"""The public solvers: they turn a path into a sink and choose the device."""

import importlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from bondem._checks import instance, shown
from bondem._progress import staged
from bondem.errors import InputError
from bondem.fracture.growing_cracks import GrowingCracks
from bondem.io.runfile import RunFile, read_run
from bondem.laws.damping import AnyDamping
from bondem.laws.failure.criterion import Criterion
from bondem.model.gauges import AnyGauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.events import Event
from bondem.solve.explicit import integrate
from bondem.solve.halting import noticing, stop_by
from bondem.solve.modal import solve_modes
from bondem.solve.plan import Callback, ExplicitResult, Loop, Plan, Status
from bondem.solve.relaxation import solve_relaxed
from bondem.solve.schemes import Scheme, VelocityVerlet
from bondem.solve.stage import begin, check_gauges
from bondem.solve.static import solve_static
from bondem.solve.timestep import choose_step

__all__ = ["resume", "solve_explicit", "solve_modes", "solve_relaxed", "solve_static"]


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
    device: str = "cpu",
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
    callback: Callback | None = None,
) -> ExplicitResult:
    """Explicit dynamics of a bonded specimen, from rest or from `state`.

    Args:
        model: what to run.
        duration: physical time [s]; round(duration / dt) steps are taken.
        dt: time step [s]; None for `safety` times the critical one of the assembled lattice.
        scheme: time integration; velocity Verlet unless given.
        damping: of elements or bonds, one kind or several in a tuple; none unless asked.
        gauges: what to record, by name: `bd.Gauge`, `bd.WallGauge`.
        every: steps between records; 0 for none.
        save_every: steps between checkpoints into `out`; 0 for the last state only.
        snapshot_every: steps between snapshots into `out`, which ParaView 6 shows as it grows; 0 for none.
        until: an event that ends the run early, or several.
        safety: share of the critical step to use when dt is None [-].
        imbalance: shares of the largest energy so far (work, losses, stored energies), beyond which the balance of
            the energy ledger gives a warning and stops the run with the status IMBALANCED [-]; None for no check,
            and `math.inf` in place of one share for never. It is checked with each record, or now and then where
            `every` is 0; not with `bd.TchamwaWielgosz`, which dissipates what no line of the ledger holds.
        state: where to start, such as the end of another run of the same elements and bonds; it stays as it is. Its
            time goes on, and with it that of all schedules: those of a second stage begin at `state.time`.
        device: "cpu", or "gpu" for a CUDA device (`pip install "bondem[gpu]"`): beams of the total formulation
            and cells, that may break, soften and yield by every criterion; without contacts and walls that bodies
            touch. A function of `bd.StressCriterion` must compile for CUDA: numbers and `math`, not NumPy.
        out: run file (HDF5) to write; nothing is written when None. With it SIGINT (Ctrl-C) and SIGTERM stop the run
            after a checkpoint, for `resume`; a second one stops it at once.
        progress: called now and then with the share done, 0 … 1.
        callback: called as callback(state, record) with each record, a `History` of one; it must not change the
            state, and ends the run by returning True.

    Returns:
        status, state, history, dt, steps and a message; a run that became unstable says so in its status and
        returns the last good state, one that lost its energy balance returns the present state and all records.

    Warns:
        StepWarning: the given dt is above 0.9 of the critical step; the message says so too.
        ImbalanceWarning: the balance of the energy ledger is beyond the first share of `imbalance`.
        StageWarning: a schedule that is new in this stage began before it.

    Raises:
        UnstableStepError: dt above the critical step.
        InputError: a bad value, the state of another model, a prescribed displacement that does not begin where the
            elements are, or an output path that cannot be written.
    """
    instance("solve_explicit", "model", model, Model, "bd.Model(...)")
    if state is not None:
        instance("solve_explicit", "state", state, State, "the state of a run, or model.state()")
    for name, given in (("progress", progress), ("callback", callback)):
        if given is not None and not callable(given):
            raise InputError(f"solve_explicit: {name} = {shown(given)}; give a function, or None")
    plan = Plan(
        duration=duration,
        dt=dt,
        scheme=scheme if scheme is not None else VelocityVerlet(),
        damping=damping,
        gauges={} if gauges is None else gauges,
        every=every,
        save_every=save_every,
        snapshot_every=snapshot_every,
        until=until,
        safety=safety,
        imbalance=imbalance,
    )
    loop_of = _loop_on(device, model, plan)
    check_gauges(model, plan)
    own = begin(model, state)
    step = choose_step(model, plan.scheme, plan.dt, safety=plan.safety, damping=plan.damping)
    plan = replace(plan, dt=step.dt)
    plan.steps  # noqa: B018  refuses more than anyone waits for
    if out is None:
        return integrate(
            model, plan, state=own, progress=progress, callback=callback, loop_of=loop_of, remark=step.remark
        )
    with RunFile(out, model, plan, cracks=GrowingCracks(model.lattice)) as sink, noticing() as halt:
        result = integrate(
            model, plan, state=own, sink=sink, progress=progress, callback=callback, loop_of=loop_of,
            remark=step.remark, halt=halt,
        )  # fmt: skip
        stopped = halt()
    return _unless(stopped, result, sink)


def _unless(stopped: int | None, result: ExplicitResult, sink: RunFile) -> ExplicitResult:
    """The result, unless a signal stopped the run before its end."""
    if stopped is not None and result.message.startswith("interrupted"):
        stop_by(stopped, f"{result.message}, step {result.steps}; bd.resume('{sink.path}') goes on from there")
    return result


@staged("resumed run")
def resume(
    path: str | Path,
    *,
    device: str = "cpu",
    failure: Criterion | None = None,
    progress: Callable[[float], None] | None = None,
) -> ExplicitResult:
    """Go on with a run from the last checkpoint in its run file, to the bit as if it had never stopped.

    Checkpoints go on into the same file. A run that had ended comes back as it is.

    Args:
        path: run file, from `solve_explicit(..., out=path, save_every=...)`.
        device: "cpu" or "gpu"; to the bit on the one it was begun on.
        failure: the criterion of the run, where that is a `bd.StressCriterion`: no file holds its function.
        progress: called now and then with the share done, 0 … 1.

    Raises:
        RunFileError: no such file, not a run file, damaged, of a newer bondem, or of another criterion.
        InputError: the file cannot be written.
    """
    kept = read_run(path, failure=failure)
    if kept.state.step and any(event.happened(kept.state) for event in kept.plan.events):
        return ExplicitResult(
            status=Status.STOPPED,
            iterations=kept.state.step,
            residual=kept.history.imbalance,
            state=kept.state,
            history=kept.history,
            dt=kept.plan.dt or 0.0,
            message=f"had been stopped by an event at t = {kept.state.time:.6g} s",
        )
    loop_of = _loop_on(device, kept.model, kept.plan)
    cracks = GrowingCracks(kept.model.lattice)
    with RunFile(path, kept.model, kept.plan, cracks=cracks, goes_on=kept) as sink, noticing() as halt:
        result = integrate(
            kept.model, kept.plan, state=kept.state, history=kept.history, sink=sink, progress=progress,
            loop_of=loop_of, halt=halt,
        )  # fmt: skip
        stopped = halt()
    return _unless(stopped, result, sink)


def _loop_on(device: str, model: Model, plan: Plan) -> Callable[[Model, Plan, State, float], Loop] | None:
    """What makes the loop of a run on a device; None for that of the CPU.

    Raises:
        InputError: an unknown device, one that is not here, or one that cannot run this.
    """
    if isinstance(device, str) and device == "cpu":
        return None
    if not isinstance(device, str) or device != "gpu":
        raise InputError(f"device = {shown(device)} is unknown; choose 'cpu' or 'gpu'")
    try:
        gpu = importlib.import_module("bondem.solve.loop_cuda")
    except ImportError as error:
        raise InputError(
            f"device='gpu' needs the package numba-cuda ({error}): pip install \"bondem[gpu]\", or use device='cpu'"
        ) from error
    gpu.require_runnable(model, plan)
    return gpu.GpuLoop
