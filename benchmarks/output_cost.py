"""Cost of output: snapshots of 100 000 elements at every hundredth of a run, over the run without any.

Three runs in one process take turns, all with a checkpoint at the end. One has no snapshots; two have one at the
start, and two or ten more. The difference of the last two, over eight, is the cost of a snapshot. The rest of the
cost of two snapshots belongs to constant data, which is computed and written once. This and a hundred snapshots, over
the time of a run of 50 000 steps, is the cost of output every 1 %. The compression test of 12 000 elements in `python
-m validation celigueta` takes 55 000 steps, and more with smaller elements.

Times are processor seconds of one thread, which do not depend on other work of the machine. The share of wall time is
also given, because a disk may be slower than the processor.

Run: python benchmarks/output_cost.py [--elements 100000] [--steps 200] [--repeat 3] [--threads 1]
It writes benchmarks/results/output_cost.json.
"""

import tempfile
import time
from pathlib import Path

import numpy as np

import bondem as bd
from kept import Record, run, spread

FEW, MANY, LONG = 2, 10, 50_000


def model_of(kind: str, count: int) -> bd.Model:
    """Return a bar of brittle beams or cells that is pulled along x and does not break."""
    shape = bd.Box((4e-2, 2e-2, 2e-2))
    particles = bd.pack(shape, count=count, method="even", seed=1)
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=0.01)]
    if kind == "cells":
        body = bd.connect(particles, method="laguerre")
        failure = bd.MohrCoulomb(tension=1e9, cohesion=3e9, friction_angle=0.6)
        return bd.Model(body, bd.CellBond(E=30e9, nu=0.2), 2500.0, failure=failure, boundary=ends)
    lattice = bd.connect(particles, reach=1.3)
    law = bd.EulerBernoulli(E=100e9, nu=0.2, radius_ratio=0.5)
    failure = bd.PeripheralStress(tension=1e9, shear=3e9)
    return bd.Model(lattice, law, 2500.0, failure=failure, boundary=ends)


def seconds(model: bd.Model, steps: int, dt: float, every: int, folder: Path) -> tuple[np.ndarray, int]:
    """Return processor and wall seconds of a run, (2,), and the size of its file [bytes]."""
    began = np.array((time.process_time(), time.perf_counter()))
    bd.solve_explicit(model, duration=steps * dt, dt=dt, every=0, snapshot_every=every, out=folder / "run.h5")
    taken = np.array((time.process_time(), time.perf_counter())) - began
    return taken, (folder / "run.h5").stat().st_size


def measured(kind: str, count: int, steps: int, repeat: int) -> dict:
    model = model_of(kind, count)
    dt = bd.solve_explicit(model, duration=0.0).dt
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        seconds(model, 20, dt, 10, folder)
        plain, few, many = [], [], []
        for _ in range(repeat):
            plain.append(seconds(model, steps, dt, 0, folder))
            few.append(seconds(model, steps, dt, steps // FEW, folder))
            many.append(seconds(model, steps, dt, steps // MANY, folder))
    # the first snapshot also computes and writes constant data, such as the polyhedra
    each = np.array([(b[0] - a[0]) / (MANY - FEW) for a, b in zip(few, many, strict=True)])
    once = np.array([b[0] - a[0] - (FEW + 1) * one for a, b, one in zip(plain, few, each, strict=True)])
    step = np.array([a[0] / steps for a in plain])
    cost = (np.median(once, axis=0) + 100.0 * np.median(each, axis=0)) / (LONG * np.median(step, axis=0))
    return {
        "kind": kind, "elements": count, "bonds": len(model.lattice.pairs), "steps": steps,
        "step": spread(step[:, 0]), "snapshot": spread(each[:, 0]), "once": spread(once[:, 0]),
        "bytes a snapshot": (many[-1][1] - few[-1][1]) / (MANY - FEW),
        "bytes without": plain[-1][1], "cost": float(cost[0]), "cost by the wall": float(cost[1]),
    }  # fmt: skip


def measure(
    record: Record, *, elements: int = 100_000, steps: int = 200, repeat: int = 3, threads: int = 1,
    kinds: tuple[str, ...] = ("beams", "cells"),
) -> None:  # fmt: skip
    cases = []
    bd.set_threads(threads)
    for kind in kinds:
        cases.append(measured(kind, elements, steps, repeat))
        print({key: round(value, 6) if isinstance(value, float) else value for key, value in cases[-1].items()})
    record.keep(threads=threads, cases=cases, long=LONG)


if __name__ == "__main__":
    run()
