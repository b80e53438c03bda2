"""Runs of a case, interrupted in several ways, on several numbers of threads, whose arrays are stored."""

import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bits.case import ROUND, Case, set_threads
from bits.cases import CASES
from bondem.errors import StepWarning

GAUGES = {
    "moved": bd.Gauge(bd.Everything(), "displacement", "max_abs"),
    "drift": bd.Gauge(bd.Everything(), "velocity"),
    "turned": bd.Gauge(bd.Everything(), "rotation"),
    "spin": bd.Gauge(bd.Everything(), "angular_velocity", "max_abs"),
}
GRIP = {"grip": bd.Gauge(bd.Everything(), "force", "sum")}  # where anything is held or loaded
# Share of the first of two consecutive runs.
_FIRST = 0.43


def run(name: str, size: int, threads: list[int], pauses: list[str], steps: int, folder: str,
        dt: float | None = None) -> dict:  # fmt: skip
    """Run a case, and write PAUSE-THREADS.npz for each pause and number of threads.

    Args:
        name: of the case.
        size: elements, about.
        threads: on how many, one after the other.
        pauses: how a run is interrupted: "every 7" records, "saved every 37" checkpoints, or "two runs".
        steps: of each run.
        folder: where the files go.
        dt: time step [s]; the share of the critical one that the case names when None.

    Returns:
        "dt", numbers of "elements" and "bonds", "faults" (messages of runs that were not completed), the largest
        displacement "moved" over the mean radius, and the largest number of contacts, "touching".
    """
    case = CASES[name](size)
    chosen = explicit(case.model, case, duration=0.0, safety=case.share, every=0).dt
    dt = chosen if dt is None else dt
    faults: dict[str, str] = {}
    moved, touching = 0.0, 0
    for count in threads:
        set_threads(count)
        for pause in pauses:
            if case.rounds and pause.startswith("saved"):
                continue
            values = {"chosen dt": np.array(chosen)}
            for k, result in enumerate(_paused(case, pause, steps, dt)):
                values |= {f"{key} {k + 1}" if k else key: value for key, value in arrays(result).items()}
                if result.status.name != "COMPLETED":
                    faults[f"{pause}, {count} threads"] = result.message
                last = result.state
            np.savez(Path(folder) / f"{pause}-{count}.npz", **values)
            moved = max(moved, float(np.abs(last.displacement).max()))
            touching = max(touching, len(last.touching) + len(last.wall_touching))
    lattice = case.model.lattice
    return {
        "dt": dt, "elements": len(lattice.particles), "bonds": len(lattice.pairs), "faults": faults,
        "moved": moved / lattice.particles.mean_radius, "touching": touching,
    }  # fmt: skip


def arrays(result) -> dict[str, np.ndarray]:
    """Return copies of all arrays of a result by name; copies, because old revisions change an initial state."""
    state = result.state
    values = {name: getattr(state, name).copy() for name in state.ARRAYS}
    values |= {"step": np.array(state.step), "time": np.array(state.time), "records": result.history.records}
    return values | {"status": np.array(result.status.name)}


def _paused(case: Case, pause: str, steps: int, dt: float) -> Iterator[Any]:
    """Yield the result of the run, or of the two runs, of a case."""
    start = case.start(dt)
    if pause == "two runs":
        part = ROUND if case.rounds else round(_FIRST * steps)
        first = explicit(case.model, case, duration=part * dt, dt=dt, every=30, state=start)
        yield first
        again = case.model if case.then is None else case.then
        yield explicit(again, case, duration=(steps - part) * dt, dt=dt, every=30, state=first.state)
    elif pause.startswith("saved"):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "run.h5"
            options = {"every": 30, "save_every": int(pause.split()[-1]), "out": out}
            yield explicit(case.model, case, duration=steps * dt, dt=dt, state=start, **options)
    else:
        every = int(pause.split()[-1])
        yield explicit(case.model, case, duration=steps * dt, dt=dt, every=every, state=start)


def explicit(model: bd.Model, case: Case, **options) -> Any:
    """Run `solve_explicit` with the options of a case, and with gauges of all quantities."""
    held = GRIP if len(model.constraints.element) else {}
    gauges = GAUGES | held | case.options.get("gauges", {})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StepWarning)
        return bd.solve_explicit(model, **(case.options | options | {"gauges": gauges}))
