"""Time of a calibration: from nothing, warm, and compared with the procedure of André et al. (2012).

    python -m benchmarks.calibration [--repeats 3] [--count 10000]          about 4 minutes on 2 cores

"From nothing" is `bondem calibrate` in a new process, with an empty cache and without stored packings. The paper
draws curves from explicit quasi-static runs of 100 000 steps each (figure 10). One such run is timed, on all threads,
on the calibrated specimen; the time of all `RUNS` is extrapolated. Five points per curve are assumed, because the
paper does not state their number. Writes benchmarks/results/calibration.json.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import bondem as bd
from bondem._threads import most_threads
from validation.measures.explicit_tension import explicit_tension

RESULT = Path(__file__).resolve().parent / "results" / "calibration.json"
TARGET = ("--E", "72.5e9", "--nu", "0.17", "--rho", "2201", "--law", "euler-bernoulli")

#: Numbers of runs in the paper: five values of ν_μ for fig. 11; five of E_μ at five of r̃ for figs 13 and 14, which
#: give fig. 15; five of E_μ at the r̃ found for fig. 16. With known trends, figs 15 and 16 alone would suffice.
RUNS = {"whole study": 5 + 25 + 5, "figs 15 and 16": 5 + 5}


def from_nothing(count: int, *more: str) -> float:
    """Return the wall time of `bondem calibrate` in a new process without stored packings [s]."""
    with tempfile.TemporaryDirectory() as empty:
        bare = os.environ | {"BONDEM_CACHE_DIR": empty, "BONDEM_PACKING_CACHE": "off"}
        begun = time.perf_counter()
        words = [sys.executable, "-m", "bondem", "calibrate", *TARGET, "--count", str(count), *more]
        done = subprocess.run(words, env=bare, capture_output=True, text=True, check=True)
        taken = time.perf_counter() - begun
    said = done.stdout.strip().splitlines()[-1].strip()
    print(f"from nothing{' '.join(['', *more])}: {taken:.1f} s; {said}", flush=True)
    return taken


def timed(work, repeats: int) -> dict[str, float]:
    """Return the smallest and median wall time of a function [s]."""
    taken = []
    for _ in range(repeats):
        begun = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begun)
    return {"min": min(taken), "median": statistics.median(taken)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--count", type=int, default=10_000, help="elements")
    parser.add_argument("--steps", type=int, default=100_000, help="steps of the explicit run")
    options = parser.parse_args()

    cold = {
        "3 cells": [from_nothing(options.count) for _ in range(options.repeats)],
        "1 cylinder": [from_nothing(options.count, "--shape", "cylinder", "--packings", "1")],
    }
    particles = bd.pack(bd.Cylinder(5e-3, 40e-3), count=options.count, spread=0.25, seed=1, cache=False)
    bar = bd.connect(particles)
    cell = bd.connect(bd.pack(bd.Cell((10e-3,) * 3), count=options.count, spread=0.25, seed=1, cache=False))
    silica = bd.materials.fused_silica
    fit = bd.calibrate(bar, silica, law=bd.EulerBernoulli)
    warm = {
        name: timed(lambda lattice=lattice: bd.calibrate(lattice, silica, law=bd.EulerBernoulli), options.repeats)
        for name, lattice in (("1 cylinder", bar), ("1 cell", cell))
    }
    run = explicit_tension(bar, fit.law, density=fit.density, steps=options.steps, ramp=0.5, phi=1.3, stress=1e6)
    ours = warm["1 cylinder"]["median"]
    paper = {
        name: {"runs": runs, "seconds": runs * run.seconds, "ratio": runs * run.seconds / ours}
        for name, runs in RUNS.items()
    }
    result = {
        "count": options.count,
        "threads": most_threads(),
        "from_nothing": {name: {"min": min(t), "median": statistics.median(t)} for name, t in cold.items()},
        "warm": warm,
        "explicit_run": {"steps": run.steps, "seconds": run.seconds, "busy_seconds": run.busy,
                         "E_ppm": 1e6 * (run.E / fit.E - 1.0)},
        "paper_way_extrapolated": paper,
        "version": bd.__version__,
    }  # fmt: skip
    RESULT.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(f"warm, cylinder {ours:.2f} s, cell {warm['1 cell']['median']:.2f} s (medians)")
    print(f"one explicit run of {run.steps} steps: {run.seconds:.1f} s")
    for name, one in paper.items():
        print(f"{name}: {one['runs']} runs, {one['seconds']:.0f} s (extrapolated), {one['ratio']:.0f} times ours")


if __name__ == "__main__":
    main()
