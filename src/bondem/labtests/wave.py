"""Longitudinal wave along a specimen after a strike at x_max: velocities of faces and sections."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._types import Floats, PerElement3
from bondem.boundary.conditions import Drive
from bondem.boundary.gauges import Gauge
from bondem.dynamics.history import History
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.recorded_run import run_test
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


@dataclass(frozen=True, eq=False)
class Wave:
    """Velocities after a strike; `near`, `far` and `sections` are along x, positive towards the far face, x_min.

    Attributes:
        time: time of each step [s], (s,).
        near: mean velocity of the struck elements at x_max [m/s], (s,).
        far: mean velocity of the elements at x_min [m/s], (s,).
        place: middle of each slice of the specimen along x [m], (b,).
        sections: mean velocity of the connected elements of each slice [m/s], (s, b); NaN for empty slices.
        snapshots: pairs of a time [s] and the velocity of every element along x, y and z [m/s], (n, 3).
    """

    time: Floats
    near: Floats
    far: Floats
    place: Floats
    sections: Floats
    snapshots: tuple[tuple[float, PerElement3], ...]


def strike(
    lattice: Lattice, law: AnyLaw, *, density: float, duration: float, velocity: float = 0.1, held: bool = True,
    slices: int = 0, moments: tuple[float, ...] = (), depth: float = 0.02, out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> Wave:  # fmt: skip
    """Strike the elements at x_max with a velocity towards x_min and record the wave.

    Args:
        lattice: the specimen, free except for the struck elements.
        law: bond law, cell law or non-local law of the specimen.
        density: density of the elements, ρ_μ [kg/m³].
        duration: duration of the run [s].
        velocity: velocity of the struck elements [m/s].
        held: True to prescribe the velocity during the run, False for an initial velocity.
        slices: number of slices along x for `Wave.sections`.
        moments: times of the snapshots [s]; each is taken at the nearest step.
        depth: depth of the two face regions, in mean radii [-].
        out: run file (HDF5) from which the same call resumes, without slices and moments; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error is the `Wave` so far, None for a short run.
    """
    near, far = Face("x_max", depth), Face("x_min", depth)
    model = Model(lattice, law, density=density, boundary=[Drive(near, vx=-velocity)] if held else [])
    state = State(model)
    if not held:
        start = np.zeros((len(lattice.particles), 3))
        start[near.select(lattice), 0] = -velocity
        state.set_motion(velocity=start)
    lower, upper = lattice.particles.envelope.bounds
    edges = np.linspace(lower[0], upper[0], slices + 1)
    inside = np.flatnonzero(lattice.connected)
    number = np.searchsorted(edges[1:-1], lattice.centre[inside, 0], side="right")
    members = np.bincount(number, minlength=slices).astype(float)
    sections: list[Floats] = []
    snapshots: list[tuple[float, PerElement3]] = []
    waiting = sorted(moments)
    last = 0.0

    def sample(state: State, _record: History) -> None:
        nonlocal last
        if not slices and not waiting:
            return
        now = state.velocity
        if slices:
            total = np.bincount(number, weights=-now[inside, 0], minlength=slices)
            sections.append(np.divide(total, members, out=np.full(slices, np.nan), where=members > 0.0))
        # the nearest step: this one, once the next one would be further away
        step, last = state.time - last, state.time
        while waiting and state.time + 0.5 * step >= waiting[0]:
            waiting.pop(0)
            snapshots.append((state.time, now))

    def read(run: ExplicitResult) -> Wave:
        return Wave(
            time=run.history.time, near=-run.history["near"][:, 0], far=-run.history["far"][:, 0],
            place=0.5 * (edges[1:] + edges[:-1]), snapshots=tuple(snapshots),
            sections=np.array(sections) if slices else np.zeros((len(run.history), 0)),
        )  # fmt: skip

    return run_test(
        "impact", model, read, duration=duration, every=1, out=out, state=state, progress=progress,
        gauges={"near": Gauge(near, "velocity"), "far": Gauge(far, "velocity")},
        callback=sample if slices or waiting else None,
    )  # fmt: skip


def first_passage(time: Floats, signal: Floats, level: float) -> float:
    """Compute the time at which a signal first reaches a level, interpolated between samples [s].

    Args:
        time: sample times [s], (s,).
        signal: samples, (s,).
        level: value to reach, in the unit of the signal; larger than the first sample.

    Raises:
        InputError: the signal never reaches the level.
    """
    if not (signal >= level).any():
        raise InputError(
            f"signal: its largest value {signal.max():.3g} is below the level {level:.3g}; record longer"
        )
    first = int(np.argmax(signal >= level))
    before = max(first - 1, 0)
    return float(np.interp(level, signal[[before, first]], time[[before, first]]))
