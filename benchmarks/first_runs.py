"""Time of the first and second run of four kinds with an empty cache, each in a new process.

    python benchmarks/first_runs.py [--rounds 3]

The kinds are beams with breakage and contact, cells with softening and contact, the non-local law with breakage and
contact, and uniaxial compression of cells. Nothing compiles at run time, so that both runs should take the same time.
Medians of processor seconds, with packing but without the start of Python, are written to
benchmarks/results/first_runs.json.
"""

import tempfile
import time
from statistics import median

import bondem as bd
from kept import Record, alone, run

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


def timed(kind: str) -> float:
    """Seconds of the processor that a kind of run takes here and now."""
    begin = time.process_time()
    KINDS[kind]()
    return time.process_time() - begin


def measure(record: Record, *, rounds: int = 3) -> None:
    found = {}
    for kind in KINDS:
        times: tuple[list[float], list[float]] = ([], [])
        for _ in range(rounds):
            with tempfile.TemporaryDirectory() as cache:
                for each in times:
                    each.append(alone(timed, kind, XDG_CACHE_HOME=cache, BONDEM_PROGRESS="off"))
        first, second = map(median, times)
        print(f"{kind:12} first {first:5.2f} s, second {second:5.2f} s, difference {first - second:+.2f} s")
        found[kind] = {"first": first, "second": second, "difference": first - second}
    record.keep(rounds=rounds, kinds=found)


if __name__ == "__main__":
    run()
