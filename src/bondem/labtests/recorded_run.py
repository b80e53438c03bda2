"""Explicit runs of laboratory tests: in memory, or in a run file from which an interrupted test continues."""

import math
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol, TypeVar

import numpy as np

from bondem._drawing import PlottedState
from bondem.dynamics.damping import AnyDamping
from bondem.dynamics.plan import ExplicitResult
from bondem.dynamics.schemes import VelocityVerlet
from bondem.dynamics.timestep import choose_step
from bondem.errors import BondemError, RunInterrupted, UnstableRunError, UnstableRunWarning
from bondem.model.model import Model
from bondem.model.state import State
from bondem.run import solve_explicit

Result = TypeVar("Result")

# Number of checkpoints and snapshots in the longest duration of a test, and least number of steps between two.
_SAVES, _STEPS = 40, 20
# Least number of records of a curve.
_LEAST = 3


class _WithRun(Protocol):
    @property
    def run(self) -> ExplicitResult: ...


class OfOneRun(PlottedState):
    """Base class of results of a test with the explicit run `run`."""

    @property
    def state(self: _WithRun) -> State:
        """State of the body at the end of the run."""
        return self.run.state


def step_of(model: Model, *, damping: AnyDamping | None = None, softening: float = 0.45) -> float:
    """Return the time step of a test [s]: 0.9 of the critical step, or `softening` of it if cells can crack or yield.

    Cracks that open fast and slip have an energy error of second order, so that half the step gives a quarter of it.
    """
    safety = 0.9 if model.softening is None else softening
    return choose_step(model, VelocityVerlet(), None, safety=safety, damping=damping).dt


def run_test(
    test: str, model: Model, read: Callable[[ExplicitResult], Result], *, duration: float, every: int,
    out: str | Path | None, dt: float | None = None, **options: Any,
) -> Result:  # fmt: skip
    """Carry out the run of a test and evaluate it by the function `read`.

    Args:
        test: name of the calling function.
        model: specimen and loading.
        read: function of the run that returns the result of the test.
        duration: longest duration of the run [s].
        every: number of steps between records.
        out: run file with checkpoints and snapshots. A file of this very test is continued, or evaluated if the test
            is complete. None for no file.
        dt: time step [s]; None for that of `step_of`.
        **options: further options of `solve_explicit`.

    Raises:
        UnstableRunError: the run became unstable or lost its energy balance.
        InputError: the file contains another run, or cannot be written.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error is that of `read` so far, None for a short run.
    """
    if dt is None:
        dt = step_of(model)
    if out is not None:
        between = every * math.ceil(max(duration / dt / _SAVES, _STEPS) / every)
        options |= {"out": out, "resume": True, "save_every": between, "snapshot_every": between}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UnstableRunWarning)  # an error below
            run = solve_explicit(model, duration=duration, dt=dt, every=every, **options)
    except RunInterrupted as stop:
        raise RunInterrupted(str(stop), _so_far(read, stop.result)) from None
    if run.status.failed:
        raise UnstableRunError(f"labtests.{test}: {run.message}")
    return read(run)


def _so_far(read: Callable[[ExplicitResult], Result], run: ExplicitResult) -> Result | None:
    """Evaluate an interrupted run; None if it was too short."""
    if len(run.history) < _LEAST:
        return None
    try:
        with np.errstate(all="ignore"):
            return read(run)
    except (BondemError, ArithmeticError):
        return None
