"""Bond-steps per second of the explicit solver: bonds, gather and integration, with peak memory an element.

python benchmarks/bond_steps.py [--elements 100000] [--threads 1 2] [--repeat 7] [--largest 100000] [--out FILE]

The packing is made here, not read from the cache of packings, so that the memory of the process is that of both.
"""

import argparse
import json
import os
import resource
import time
import tracemalloc
from pathlib import Path

import numpy as np

# Before bondem: the packing counts.
os.environ["BONDEM_PACKING_CACHE"] = "off"

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import RESULTS, keep, origin, spread
from tiled import specimen


def peak_bytes() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--elements", type=int, default=100_000)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--repeat", type=int, default=7)
    parser.add_argument("--largest", type=int, default=100_000, help="spheres that are packed and repeated [100000]")
    parser.add_argument("--out", type=Path, default=RESULTS / "bond_steps.json")
    options = parser.parse_args()
    here = origin()
    lattice = specimen(options.elements, largest=options.largest)
    bonds = len(lattice.pairs)
    model = bd.Model(lattice, bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71), 2500.0)
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    tracemalloc.start()
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(0).standard_normal((len(lattice.particles), 3)))
    state = integrate(model, Plan(duration=2 * dt, dt=dt, every=0), state=state).state
    solver = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    steps = max(60, 40_000_000 // bonds)
    result = {**here, "elements": len(lattice.particles), "bonds": bonds, "steps": steps}
    for count in options.threads:
        with threads(count):
            plan = Plan(duration=(state.step + 2) * dt, dt=dt, every=0)
            state = integrate(model, plan, state=state).state
            times = []
            for _ in range(options.repeat):
                plan = Plan(duration=(state.step + steps) * dt, dt=dt, every=0)
                start = time.perf_counter()
                state = integrate(model, plan, state=state).state
                times.append(time.perf_counter() - start)
        result[f"Mbond/s, {count} thread(s)"] = spread([bonds * steps / t / 1e6 for t in times], 3)
    result["peak bytes/element, state and solver"] = round(solver / len(lattice.particles))
    result["peak bytes/element, process"] = round(peak_bytes() / len(lattice.particles))
    keep(options.out, result)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
