"""Speed of explicit steps of cells and of beams on the same elements, per step and per simulated microsecond.

The same packing (periodic, κ = 25 %) is bonded where spheres touch, with beams, and cut into cells. Runs of both
alternate, and ratios are those of successive runs. A cell has about 7 facets, in two passes, and a sphere 3.1 bonds,
but the time step of cells is longer. The relevant ratio is that of the times for a microsecond of the same specimen.

Run: python benchmarks/cell_steps.py [--elements 10000,100000] [--threads 1,2] [--repeat 5]
It writes benchmarks/results/cell_steps.json.
"""

import time
import tracemalloc
from typing import Any

import numpy as np

import bondem as bd
from bondem._threads import threads as of_threads
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import Record, run, spread

SILICA = bd.materials.fused_silica
#: Bonds with which such packings are about as stiff as the glass; the speed does not depend on their values.
BEAMS = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
EDGE = 10e-3


class Runner:
    """Model in random motion, whose steps are timed without the preparation of a run."""

    def __init__(self, model: bd.Model) -> None:
        self.model = model
        self.dt = 0.9 * critical_step(model, bd.VelocityVerlet())
        tracemalloc.start()
        self.state = State(model)
        self.state.set_motion(velocity=1e-3 * np.random.default_rng(0).standard_normal((len(model.mass), 3)))
        self.loop().run(2)
        self.memory = tracemalloc.get_traced_memory()[1] / len(model.mass)
        tracemalloc.stop()

    def loop(self) -> CoreLoop:
        """Return a loop on the present number of threads."""
        return CoreLoop(self.model, Plan(duration=1.0, dt=self.dt, every=0), self.state, self.dt)


def seconds(loop: CoreLoop, steps: int) -> float:
    """Return the wall time of a step [s]."""
    began = time.perf_counter()
    loop.run(steps)
    return (time.perf_counter() - began) / steps


def stepped(count: int, counts: tuple[int, ...], repeat: int) -> dict[str, Any]:
    particles = bd.pack(bd.Cell((EDGE,) * 3), count=count, spread=0.25, seed=1)
    body, lattice = bd.connect(particles, method="laguerre"), bd.connect(particles)
    cells = Runner(bd.Model(body, bd.CellBond(E=SILICA.E, nu=SILICA.nu), SILICA.rho))
    beams = Runner(bd.Model(lattice, BEAMS, SILICA.rho * EDGE**3 / particles.volume.sum()))
    steps = max(20, 2_000_000 // count)
    found: dict[str, Any] = {
        "elements": count, "facets": len(body.pairs) / count, "bonds": len(lattice.pairs) / count,
        "dt": {"cells": cells.dt, "beams": beams.dt}, "bytes": {"cells": cells.memory, "beams": beams.memory},
    }  # fmt: skip
    for number in counts:
        with of_threads(number):
            loops = cells.loop(), beams.loop()
            for loop in loops:
                loop.run(5)
            pairs = [tuple(seconds(loop, steps) for loop in loops) for _ in range(repeat)]
        one, other = zip(*pairs, strict=True)
        ratio = [b / c for c, b in pairs]
        found[f"threads_{number}"] = {
            "cells": _rates(one, count, found["facets"], cells.dt),
            "beams": _rates(other, count, found["bonds"], beams.dt),
            "element_rate": spread(ratio),
            "microsecond": spread([r * cells.dt / beams.dt for r in ratio]),
        }
        print(count, number, found[f"threads_{number}"], flush=True)
    return found


def _rates(seconds: tuple[float, ...], count: int, each: float, dt: float) -> dict[str, Any]:
    """Return bonds or facets, and elements, stepped per second, and seconds per simulated microsecond."""
    return {
        "bond_steps": spread([count * each / s for s in seconds]),
        "element_steps": spread([count / s for s in seconds]),
        "microsecond_s": spread([1e-6 / dt * s for s in seconds]),
    }


def measure(
    record: Record, *, elements: tuple[int, ...] = (10_000, 100_000), threads: tuple[int, ...] = (1, 2),
    repeat: int = 5,
) -> None:  # fmt: skip
    record.keep(cases=[stepped(count, threads, repeat) for count in elements])


if __name__ == "__main__":
    run()
