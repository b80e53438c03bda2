"""Resident memory of bodies of cells, and of beams between spheres, by stage and size.

Each case runs in a new process, which imports bondem and builds a model of an irregular grid of elements and its
state. An explicit run then takes three steps. `untrimmed` is the growth of resident memory since the imports, per
element. `bytes` is the same after free memory of the heap has been returned to the system.

    python benchmarks/memory.py [--sizes 28,46] [--stages model,state,loop] [--kinds cells,beams] [--part cases]

A size is the number of elements along an edge. It writes benchmarks/results/memory.json, which keeps other cases. The
part `before` was measured with the sources before decision 0066.
"""

import ctypes
import gc
import os
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import Record, alone, run

STAGES = ("model", "state", "loop")
BEAMS = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6)
CELLS = bd.CellBond(E=1e7, nu=0.2)


def resident() -> int:
    """Return the resident memory of this process [bytes]."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def trimmed() -> int:
    """Return free memory of the heap to the system; return the resident memory of this process [bytes]."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return resident()


def model_of(kind: str, size: int) -> bd.Model:
    """Return an elastic model of size³ elements of about 1 mm, on an irregular grid."""
    rng = np.random.default_rng(size)
    grid = np.indices((size,) * 3).reshape(3, -1).T
    place, radius = grid + 0.5 + rng.uniform(-0.1, 0.1, grid.shape), rng.uniform(0.3, 0.4, len(grid))
    particles = bd.Particles(1e-3 * place, 1e-3 * radius, shape=bd.Box((1e-3 * size,) * 3))
    if kind == "cells":
        return bd.Model(bd.connect(particles, method="laguerre"), CELLS, 1000.0)
    return bd.Model(bd.connect(particles, reach=1.62), BEAMS, 1000.0)


def built(kind: str, size: int, stage: str) -> dict[str, float]:
    """Build a model up to a stage in this process; return bytes and bonds per element."""
    before, kept = trimmed(), []
    model = model_of(kind, size)
    if stage != "model":
        state = State(model)
        kept.append(state)
    if stage == "loop":
        dt = 0.8 * critical_step(model, bd.VelocityVerlet())
        loop = CoreLoop(model, Plan(duration=3.0 * dt, dt=dt, every=0), state, dt)
        loop.run(3)
        kept.append(loop)
    untrimmed = resident()
    sizes = {"bytes": trimmed() - before, "untrimmed": untrimmed - before, "bonds": len(model.lattice.pairs)}
    return {name: round(value / size**3, 2) for name, value in sizes.items()}


def measure(
    record: Record, *, sizes: tuple[int, ...] = (28, 46), stages: tuple[str, ...] = STAGES,
    kinds: tuple[str, ...] = ("cells", "beams"), part: str = "cases",
) -> None:  # fmt: skip
    for kind in kinds:
        for size in sizes:
            for stage in stages:
                case = {"kind": kind, "elements": size**3, "stage": stage}
                record.add(lambda case=(kind, size, stage): alone(built, *case), part, **case)


if __name__ == "__main__":
    run()
