"""A large body through failure: does a step grow slower, memory grow, or energy drift as it breaks?

The plate of examples/cracks.py, torn by 1 MPa until its crack has branched: time a step, memory, broken facets and
what the ledger misses, tenth by tenth of the run.

Run: python benchmarks/large_fracture.py [--elements 100000] [--threads 2] [--out FILE]
"""

import argparse
import resource
import time
from pathlib import Path

import numpy as np

import bondem as bd
from bondem._threads import threads
from kept import RESULTS, keep, origin

DURATION, PARTS = 90e-6, 10
# Where the work has gone.
PLACES = (
    "translation", "rotation", "normal", "shear", "bending", "twisting", "contact", "loss", "friction", "fracture",
    "crushing", "plastic",
)  # fmt: skip


def plate(count: int) -> bd.Model:
    slot = bd.Box((100e-3, 1e-3, 6e-3)).moved((-50e-3, 19.5e-3, -2e-3))
    shape = bd.Box((100e-3, 40e-3, 2e-3)).cut(slot, name="notch")
    body = bd.connect(bd.pack(shape, count=count, method="even", seed=1), method="laguerre")
    pull = [bd.Pressure(bd.Face(name), -1e6) for name in ("y_min", "y_max")]
    failure = bd.Rankine(tension=3.08e6, fracture_energy=3.0)
    return bd.Model(body, bd.CellBond(E=32e9, nu=0.2), density=2450.0, failure=failure, boundary=pull)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, default=100_000)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--out", type=Path, default=RESULTS / "large_fracture.json")
    options = parser.parse_args()
    begun = origin()
    model = plate(options.elements)
    parts: list[dict[str, float]] = []
    last = [time.perf_counter(), 0]

    def look(state: bd.State, history: bd.History) -> bool:
        now, energy = time.perf_counter(), history.energy
        if state.step > last[1]:
            row = {
                "time": state.time, "ms_a_step": 1e3 * (now - last[0]) / (state.step - last[1]),
                "memory_GiB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20,
                "cracked": len(state.cracks), "broken": len(state.broken),
                "missing": abs(sum(float(energy[name][-1]) for name in PLACES) / float(energy["work"][-1]) - 1.0),
            }  # fmt: skip
            parts.append(row)
            print({name: f"{value:.4g}" for name, value in row.items()}, flush=True)
        last[:] = now, state.step
        return False

    with threads(options.threads):
        dt = bd.solve_explicit(model, duration=1e-9).dt  # and compile
        steps = int(np.ceil(DURATION / dt))
        last[0] = time.perf_counter()
        run = bd.solve_explicit(model, duration=DURATION, dt=dt, every=max(1, steps // PARTS), callback=look)
    pieces = bd.fragments(model.lattice, run.state)
    print(run.message, len(pieces), "pieces")
    keep(options.out, begun | {
        "elements": options.elements, "facets": len(model.lattice.pairs), "threads": options.threads,
        "steps": run.state.step, "pieces": len(pieces), "parts": parts,
    })  # fmt: skip


if __name__ == "__main__":
    main()
