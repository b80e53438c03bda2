"""Process of one revision in a comparison: carries out tasks from a pipe with the bondem on PYTHONPATH.

A task with its arguments is a line of JSON, and so is the answer. Only interfaces are used that old revisions with a
compiled core also have: public ones, `State(model)` and the loop of a run.
"""

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
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from paired_kinds import KINDS


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


class Timed:
    """Body whose steps are timed, by the loop of a run alone."""

    def __init__(self, path: str, kind: str) -> None:
        kind_of = KINDS[kind]
        self.model = kind_of.model(read_lattice(path))
        n = len(self.model.lattice.particles)
        self.dt = kind_of.share * critical_step(self.model, bd.VelocityVerlet())
        self.velocity = kind_of.speed * np.random.default_rng(0).standard_normal((n, 3))
        self.before = kind_of.before
        self.state: Any = None
        self.runs: dict[int, Callable[[int], object]] = {}

    def make(self) -> Callable[[int], object]:
        """Return the function that takes steps with a new loop of this revision."""
        if self.state is None:
            self.state = State(self.model)
            self.state.set_motion(velocity=self.velocity)
        state = self.state.copy()
        self.last = state
        loop = CoreLoop(self.model, Plan(duration=1.0, dt=self.dt, every=0), state, self.dt)
        getattr(loop, "record_present", getattr(loop, "look", None))()  # formerly "look"
        if self.before:
            loop.run(self.before)
            self.state, self.before = state.copy(), 0
        return loop.run

    def go(self, threads: int, steps: int) -> dict:
        """Return wall and processor time of `steps` steps [s]; each number of threads has its own loop."""
        bd.set_threads(threads)
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
