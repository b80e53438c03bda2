"""Wall time of runs of Kalthoff and Winkler's plate with finer cells than in its study, on one and two threads.

The plate is that of `python -m validation kalthoff` until 90 µs, with f_t = 844 and 1900 MPa and seed 1. The time
includes the construction of the state, but no packing, cutting or compilation. The aim is a minute for 50 000 cells.

Run: python benchmarks/kalthoff_seconds.py [--cells 50000] [--threads 1 2] [--repeat 3] [--out FILE]
"""

import argparse
from pathlib import Path

from bondem._threads import threads
from bondem.run import solve_explicit
from kept import RESULTS, clocked, keep, origin
from validation.rows.kalthoff import DURATION, Plate

STRENGTHS = (844e6, 1900e6)


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=50_000)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--out", type=Path, default=RESULTS / "kalthoff_seconds.json")
    given = parser.parse_args(arguments)
    begun, plate, cases = origin(), Plate(), []
    size = (plate.length * plate.width * plate.thickness / given.cells) ** (1.0 / 3.0)
    body = plate.body(size, seed=1)
    for tension in STRENGTHS:
        model = plate.model(body, tension, size)
        for count in given.threads:
            with threads(count):
                solve_explicit(model, duration=0.02 * DURATION, every=50)  # compiled once
                steps = solve_explicit(model, duration=DURATION, every=50).steps
                time = clocked(lambda model=model: solve_explicit(model, duration=DURATION, every=50), given.repeat)
            cases.append({"tension": tension, "cells": len(body.particles), "threads": count, "steps": steps} | time)
            print(cases[-1], flush=True)
            keep(given.out, begun | {"cases": cases})


if __name__ == "__main__":
    main()
