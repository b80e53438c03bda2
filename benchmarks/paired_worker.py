"""One side of a comparison: does what it is asked over a pipe, with the bondem that PYTHONPATH leads to.

A line of JSON is a task with its arguments, a line of JSON the answer. Only interfaces that old revisions have too
are used: the public ones, `State(model)` and the loop of a run.
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
    """Pack the specimen of `tiled.py` and keep it."""
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


# Loops of runs, the newest first: of the core; of Numba; of c790c8a and older revisions.
_LOOPS = (
    ("CoreLoop", "bondem.dynamics.core_loop"), ("CoreLoop", "bondem.solve.loop_core"),
    ("CpuLoop", "bondem.solve.loop_cpu"), ("_Loop", "bondem.solve.explicit"),
)  # fmt: skip


def critical(model: bd.Model) -> float:
    """Critical step of velocity Verlet, wherever a revision has it [s]."""
    places = ("bondem.dynamics.timestep", "bondem.solve.timestep")
    return importlib.import_module(next(filter(_there, places))).critical_step(model, bd.VelocityVerlet())


def _there(module: str) -> bool:
    """Whether this revision has a module."""
    try:
        return importlib.util.find_spec(module) is not None
    except ModuleNotFoundError:
        return False


class Timed:
    """What is timed: bondem's loop over the steps alone."""

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
        """A loop of this revision, ready for its first step."""
        from bondem.model.state import State

        name, module = next(
            (name, module) for name, module in _LOOPS if _there(module)
        )  # fmt: skip
        loop_of = getattr(importlib.import_module(module), name)
        plans = importlib.import_module(module if name == "_Loop" else f"{module.rpartition('.')[0]}.plan")
        if self.state is None:
            self.state = State(self.model)
            self.state.set_motion(velocity=self.velocity)
        state = self.state.copy()
        self.last = state
        loop = loop_of(self.model, plans.Plan(duration=1.0, dt=self.dt, every=0), state, self.dt)
        getattr(loop, "record_present" if hasattr(loop, "record_present") else "look")()  # formerly look
        if self.before:
            loop.run(self.before)
            self.state, self.before = state.copy(), 0
        return loop.run

    def go(self, threads: int, steps: int) -> dict:
        """Wall and processor time of so many steps [s]; a loop is made for each number of threads."""
        from bits.case import set_threads

        set_threads(threads)
        if threads not in self.runs:
            self.runs = {threads: self.make()}
            self.runs[threads](2)
        start, cpu = time.perf_counter(), time.process_time()
        self.runs[threads](steps)
        return {"seconds": time.perf_counter() - start, "cpu": time.process_time() - cpu}


_loaded: dict[str, Timed] = {}


def load(path: str, kind: str = "beams") -> dict:
    """Prepare the loop of a kind of body for its turns."""
    timed = _loaded["now"] = Timed(path, kind)
    return {"bonds": len(timed.model.lattice.pairs)}


def counts() -> dict:
    """What has failed and what touches."""
    state = _loaded["now"].last
    return {"failed": len(state.broken), "cracked": len(state.cracks) + len(state.softened),
            "touching": len(state.touching)}  # fmt: skip


def go(threads: int, steps: int) -> dict:
    return _loaded["now"].go(threads, steps)


def bits(**arguments) -> dict:
    from bits.runs import run

    return run(**arguments)


def cases() -> dict:
    """Names of the cases of `bits`."""
    from bits.cases import CASES

    return {"names": list(CASES)}


TASKS = {task.__name__: task for task in (source, specimen, load, go, counts, bits, cases)}


def main() -> None:
    # whatever anything prints must not get into the answers
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
