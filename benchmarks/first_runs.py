"""Time of the first and second run of four kinds with an empty cache, each in a new process.

    python benchmarks/first_runs.py [--rounds 3]

The kinds are beams with breakage and contact, cells with softening and contact, the non-local law with breakage and
contact, and uniaxial compression of cells. Nothing compiles at run time, so that both runs should take the same time.
Medians of processor seconds, with packing but without the start of Python, are written to
benchmarks/results/first_runs.json.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from statistics import median

import bondem as bd
from kept import RESULTS, keep, origin

CONTACT = bd.LinearContact(E=40e9, friction=0.4)
SOFT = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.6, fracture_energy=50.0)
CELL = bd.CellBond(E=40e9, nu=0.2)
BOX = bd.Box(size=(30e-3, 15e-3, 15e-3))
LAWS = {
    "beams": (bd.Timoshenko(E=40e9, nu=0.2, radius_ratio=0.7), bd.PeripheralStress(tension=4e6, shear=4e6)),
    "cells": (CELL, SOFT),
    "non-local": (bd.NonLocal(E=40e9, nu=0.2), bd.Rankine(tension=4e6)),
}


def pull(kind: str) -> None:
    """Pull a bar of 400 elements until it breaks."""
    law, failure = LAWS[kind]
    if kind == "beams":
        bar = bd.connect(bd.pack(BOX, count=400, seed=1))
    else:
        bar = bd.connect(bd.pack(BOX, count=400, method="even", seed=1), method="laguerre")
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=2.0)]
    model = bd.Model(bar, law, 2500.0, failure=failure, contact=CONTACT, boundary=ends)
    state = bd.solve_explicit(model, duration=5e-5).state
    assert len(state.broken) + len(state.cracks) > 0


def crush() -> None:
    """Compress a cylinder of 400 cells until it fails."""
    particles = bd.pack(bd.Cylinder(radius=10e-3, length=40e-3), count=400, method="even", seed=1)
    bd.labtests.uniaxial_compression(bd.connect(particles, method="laguerre"), CELL, SOFT, density=2500.0)


KINDS = {**{kind: lambda kind=kind: pull(kind) for kind in LAWS}, "compression": crush}


def seconds(kind: str, cache: str) -> float:
    """Return the processor seconds of a run of a kind in a new process, with the cache folder `cache`."""
    environment = os.environ | {"XDG_CACHE_HOME": cache, "BONDEM_PROGRESS": "off"}
    words = [sys.executable, "-W", "ignore", __file__, "--alone", kind]
    return float(subprocess.run(words, env=environment, capture_output=True, text=True, check=True).stdout)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--alone", choices=KINDS, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.alone:
        begin = time.process_time()
        KINDS[options.alone]()
        print(time.process_time() - begin)
        return
    begun, found = origin(), {}
    for kind in KINDS:
        times: tuple[list[float], list[float]] = ([], [])
        for _ in range(options.rounds):
            with tempfile.TemporaryDirectory() as cache:
                for each in times:
                    each.append(seconds(kind, cache))
        first, second = map(median, times)
        print(f"{kind:12} first {first:5.2f} s, second {second:5.2f} s, difference {first - second:+.2f} s")
        found[kind] = {"first": first, "second": second, "difference": first - second}
    keep(RESULTS / "first_runs.json", begun | {"rounds": options.rounds, "kinds": found})


if __name__ == "__main__":
    main()
