"""Process of one revision in a comparison: carries out tasks from a pipe with the bondem on PYTHONPATH.

A task with its arguments is a line of JSON, and so is the answer. Only interfaces that old revisions also have are
used: public ones, `State(model)` and the loop of a run.
"""

import importlib
import importlib.util
import json
import os
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd


def source() -> dict:
    return {"file": str(Path(bd.__file__).resolve())}


def specimen(elements: int, largest: int, path: str) -> dict:
    """Pack the specimen of `tiled.py`, write it to a file, and return the number of elements."""
    from tiled import specimen

    lattice = specimen(elements, largest=largest)
    particles = lattice.particles
    aside = Path(path).with_suffix(f".{os.getpid()}.npz")
    np.savez(
        aside, position=particles.position, radius=particles.radius, period=particles.period, pairs=lattice.pairs
    )
    aside.replace(path)
    return {"elements": len(particles)}


def read_lattice(path: str) -> bd.Lattice:
    with np.load(path) as file:
        period = file["period"]
        shape = bd.Cell(size=tuple(period.tolist()))
        particles = bd.Particles(file["position"], file["radius"], period, shape)
        return bd.Lattice(particles, file["pairs"])


# Names and modules of the loop of a run, the newest first: of the core; of Numba; of c790c8a and older revisions.
_LOOPS = (
    ("CoreLoop", "bondem.dynamics.core_loop"), ("CoreLoop", "bondem.solve.loop_core"),
    ("CpuLoop", "bondem.solve.loop_cpu"), ("_Loop", "bondem.solve.explicit"),
)  # fmt: skip


def critical(model: bd.Model) -> float:
    """Return the critical step of velocity Verlet [s], from the module in which this revision has it."""
    places = ("bondem.dynamics.timestep", "bondem.solve.timestep")
    return importlib.import_module(next(filter(_there, places))).critical_step(model, bd.VelocityVerlet())


def _there(module: str) -> bool:
    """Return True if this revision has a module."""
    try:
        return importlib.util.find_spec(module) is not None
    except ModuleNotFoundError:
        return False


def set_threads(count: int) -> None:
    """Set the number of threads, in old revisions that of Numba."""
    if hasattr(bd, "set_threads"):
        bd.set_threads(count)
    else:
        importlib.import_module("numba").set_num_threads(count)


class Timed:
    """Body whose steps are timed, by the loop of a run alone."""

    def __init__(self, path: str, kind: str) -> None:
        from paired_kinds import KINDS

        kind_of = KINDS[kind]
        self.model = kind_of.model(read_lattice(path))
        n = len(self.model.lattice.particles)
        self.dt = kind_of.share * critical(self.model)
        self.velocity = kind_of.speed * np.random.default_rng(0).standard_normal((n, 3))
        self.before = kind_of.before
        self.state: Any = None
        self.runs: dict[int, Callable[[int], object]] = {}

    def make(self) -> Callable[[int], object]:
        """Return the function that takes steps with a new loop of this revision."""
        from bondem.model.state import State

        name, module = next((name, module) for name, module in _LOOPS if _there(module))
        loop_of = getattr(importlib.import_module(module), name)
        plans = importlib.import_module(module if name == "_Loop" else f"{module.rpartition('.')[0]}.plan")
        if self.state is None:
            self.state = State(self.model)
            self.state.set_motion(velocity=self.velocity)
        state = self.state.copy()
        self.last = state
        loop = loop_of(self.model, plans.Plan(duration=1.0, dt=self.dt, every=0), state, self.dt)
        getattr(loop, "record_present" if hasattr(loop, "record_present") else "look")()  # once "look"
        if self.before:
            loop.run(self.before)
            self.state, self.before = state.copy(), 0
        return loop.run

    def go(self, threads: int, steps: int) -> dict:
        """Return wall and processor time of `steps` steps [s]; each number of threads has its own loop."""
        set_threads(threads)
        if threads not in self.runs:
            self.runs = {threads: self.make()}
            self.runs[threads](2)
        start, cpu = time.perf_counter(), time.process_time()
        self.runs[threads](steps)
        return {"seconds": time.perf_counter() - start, "cpu": time.process_time() - cpu}


_loaded: dict[str, Timed] = {}


def load(path: str, kind: str = "beams") -> dict:
    """Load the specimen of a file as a kind of body, and return its number of bonds."""
    timed = _loaded["now"] = Timed(path, kind)
    return {"bonds": len(timed.model.lattice.pairs)}


def counts() -> dict:
    """Return the numbers of failed bonds, of cracked facets or softened beams, and of contacts."""
    state = _loaded["now"].last
    return {"failed": len(state.broken), "cracked": len(state.cracks) + len(state.softened),
            "touching": len(state.touching)}  # fmt: skip


def go(threads: int, steps: int) -> dict:
    return _loaded["now"].go(threads, steps)


TASKS = {task.__name__: task for task in (source, specimen, load, go, counts)}


def main() -> None:
    # printed text must not get into the answers
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    for line in sys.stdin:
        arguments = json.loads(line)
        try:
            answer = TASKS[arguments.pop("task")](**arguments)
        except Exception:
            answer = {"error": traceback.format_exc()}
        answers.write(json.dumps(answer) + "\n")
        answers.flush()


if __name__ == "__main__":
    main()
