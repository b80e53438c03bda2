"""Wall time of runs of Kalthoff and Winkler's plate with finer cells than in its study, on one and two threads.

The plate is that of `python -m validation kalthoff` until 90 µs, with f_t = 844 and 1900 MPa and seed 1. The time
includes the construction of the state, but no packing, cutting or compilation. The aim is a minute for 50 000 cells.

Run: python benchmarks/kalthoff_seconds.py [--cells 50000] [--threads 1,2] [--repeat 3] [--out FILE]
"""

from bondem._threads import threads as of_threads
from bondem.run import solve_explicit
from kept import Record, clocked, run
from validation.rows.kalthoff import DURATION, Plate

STRENGTHS = (844e6, 1900e6)


def measure(
    record: Record, *, cells: int = 50_000, threads: tuple[int, ...] = (1, 2), repeat: int = 3
) -> None:
    plate, cases = Plate(), []
    size = (plate.length * plate.width * plate.thickness / cells) ** (1.0 / 3.0)
    body = plate.body(size, seed=1)
    for tension in STRENGTHS:
        model = plate.model(body, tension, size)
        for count in threads:
            with of_threads(count):
                solve_explicit(model, duration=0.02 * DURATION, every=50)  # compiled once
                steps = solve_explicit(model, duration=DURATION, every=50).steps
                time = clocked(lambda model=model: solve_explicit(model, duration=DURATION, every=50), repeat)
            cases.append({"tension": tension, "cells": len(body.particles), "threads": count, "steps": steps} | time)
            print(cases[-1], flush=True)
            record.keep(cases=cases)


if __name__ == "__main__":
    run()
