"""What an explicit run is asked to do, and what comes back."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Protocol

import numpy as np

from bondem.errors import InputError
from bondem.laws.damping import AnyDamping, DampingTerms
from bondem.model.gauges import AnyGauge
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.events import Event
from bondem.solve.history import History
from bondem.solve.schemes import Scheme, VelocityVerlet
from bondem.solve.timestep import choose_step

# Called with the state and the record of each output; ends the run by returning True.
Callback = Callable[[State, History], bool | None]


class Status(Enum):
    """How a run ended."""

    COMPLETED = "completed"
    STOPPED = "stopped by an event"
    UNSTABLE = "unstable"


@dataclass(frozen=True, kw_only=True)
class Plan:
    """How a model is run.

    Attributes:
        duration: physical time [s]; the run takes round(duration / dt) steps.
        dt: time step [s]; None for `safety` times the critical one.
        scheme: time integration.
        damping: of elements or bonds, one kind or several in a tuple, or None.
        gauges: what to record, by name.
        every: steps between records; 0 for none.
        save_every: steps between checkpoints; 0 for none but the last.
        until: events that end the run.
        safety: share of the critical time step to use when dt is None [-].
    """

    duration: float
    dt: float | None = None
    scheme: Scheme = field(default_factory=VelocityVerlet)
    damping: AnyDamping | tuple[AnyDamping, ...] | None = None
    gauges: Mapping[str, AnyGauge] = field(default_factory=dict)
    every: int = 100
    save_every: int = 0
    until: tuple[Event, ...] = ()
    safety: float = 0.9

    def __post_init__(self) -> None:
        if not (math.isfinite(self.duration) and self.duration >= 0.0):
            raise InputError(f"duration = {self.duration} s; give a time of zero or more")
        if not 0.0 < self.safety <= 1.0:
            raise InputError(f"safety = {self.safety}; give a share of the critical step in (0, 1]")
        for name in ("every", "save_every"):
            if getattr(self, name) < 0 or int(getattr(self, name)) != getattr(self, name):
                raise InputError(f"{name} = {getattr(self, name)}; give a whole number of steps, 0 for never")
        if self.until and not self.every:
            raise InputError("events are looked at with each record: give every= at least 1 where there is until=")
        object.__setattr__(self, "until", tuple(self.until))
        DampingTerms.of(self.damping)


@dataclass(frozen=True, eq=False)
class ExplicitResult:
    """What came back.

    Attributes:
        status: how the run ended.
        state: where everything is; after an unstable run, where all was well for the last time, at most 10 000
            steps before.
        history: the records.
        dt: time step used [s].
        steps: steps done since the start of the model's time.
        message: one line for people.
    """

    status: Status
    state: State
    history: History
    dt: float
    steps: int
    message: str


class Loop(Protocol):
    """What carries out the steps of a run, on the CPU or another device."""

    state: State

    def look(self) -> np.ndarray:
        """Bring the acceleration up to date and record the present."""
        ...

    def run(self, steps: int) -> tuple[np.ndarray, int, int, int]:
        """Go on; the records written, bonds turned wide, bonds lost, and what `kernels.advance.guard` found."""
        ...


def settled(model: Model, plan: Plan) -> Plan:
    """The same plan with its time step chosen, or checked where it is given.

    Raises:
        UnstableStepError: dt above the critical step of the lattice.
    """
    step = choose_step(model, plan.scheme, plan.dt, safety=plan.safety, damping=plan.damping)
    return replace(plan, dt=step.dt)
