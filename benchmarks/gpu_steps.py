"""Bond- or facet-steps per second on a CUDA device, beside the copy bandwidth of the same run, and against the CPU.

python benchmarks/gpu_steps.py [--law beams|cells] [--elements 100000 1000000 10000000] [--compare 10000] [--repeat 5]

Specimens are a periodic packing of up to 100 000 spheres, repeated, bonded by beams or cut into cells. Bytes a
bond-step are what the passes must move at least if nothing but the poses of bonded neighbours stays in the cache
(decision 0010).
"""

import argparse
import importlib
import json
import statistics
import sys
import time
from typing import NamedTuple

import numpy as np

import bondem as bd
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step
from tiled import specimen

# Ends, integrity, levers and shares of a facet, in both of its passes; pose, motion, row and adjacency of an element.
_FACET, _MOVE = 8 + 8 + 24 + 24, 2 * 64 + 2 * 64 + 12


class Law(NamedTuple):
    """What is bonded how, and the bytes that a step moves for each bond and each element."""

    bond: bd.EulerBernoulli | bd.CellBond
    method: str
    per_bond: int
    per_element: int


LAWS = {
    # alike but for their length: ends, constants, integrity, forces written; read by both ends, adjacency. The pose
    # is read once more in the pass of the bonds
    "beams": Law(
        bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71), "distance", 8 + 32 + 8 + 72 + 2 * 48 + 4, 64 + _MOVE
    ),
    # V θ of both sides written and read, k and H, forces as above, adjacency twice. The pose is read once more in
    # each pass of the facets, its stress (a sector of 32 bytes) read and written; λ / V, row and adjacency again
    "cells": Law(
        bd.CellBond(E=72e9, nu=0.17), "laguerre", 2 * _FACET + 2 * 16 + 8 + 24 + 72 + 2 * 48 + 2 * 4,
        2 * 64 + 2 * 32 + 8 + 12 + _MOVE,
    ),
}  # fmt: skip


def copy_bandwidth(cuda, size: int = 2**30) -> float:
    """Bytes per second read and written by a copy on the device, best of ten."""
    source = cuda.device_array(size // 8, np.float64)
    target = cuda.device_array(size // 8, np.float64)
    best = np.inf
    for _ in range(10):
        cuda.synchronize()
        start = time.perf_counter()
        target.copy_to_device(source)
        cuda.synchronize()
        best = min(best, time.perf_counter() - start)
    return 2.0 * size / best


def moving(lattice: bd.Lattice, law: Law) -> tuple[bd.Model, float, State]:
    """A free periodic specimen, its time step, and elements that move at random."""
    model = bd.Model(lattice, law.bond, 2500.0)
    dt = 0.9 * critical_step(model, bd.VelocityVerlet())
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(0).standard_normal((len(lattice.particles), 3)))
    return model, dt, state


def rate(loop_of, lattice: bd.Lattice, law: Law, repeat: int, bandwidth: float, updates: float = 2e10) -> dict:
    """Bond-steps per second of a specimen, over `updates` of them but 20 000 steps at most.

    The time of a run holds neither the upload nor the copy back.
    """
    model, dt, state = moving(lattice, law)
    bonds, elements = len(lattice.pairs), len(lattice.particles)
    plan = Plan(duration=1.0, dt=dt, every=0)
    loop = loop_of(model, plan, state, dt)
    loop.run(200)  # compiles, records the graphs
    steps = 100 * round(np.clip(updates / bonds, 200, 20_000) / 100)
    rates = []
    for _ in range(repeat):
        start = time.perf_counter()
        loop.run(steps)
        whole = time.perf_counter() - start
        start = time.perf_counter()
        loop.run(0)
        rates.append(bonds * steps / (whole - (time.perf_counter() - start)))
    moved = law.per_bond + law.per_element * elements / bonds
    median = statistics.median(rates)
    return {
        "elements": elements,
        "bonds": bonds,
        "steps": steps,
        "Gbond/s": {"median": round(median / 1e9, 3), "best": round(max(rates) / 1e9, 3)},
        "bytes/bond-step": round(moved),
        "share of copy bandwidth": round(median * moved / bandwidth, 3),
    }


def difference(loop_of, lattice: bd.Lattice, law: Law, steps: int = 1000) -> float:
    """Largest difference of displacements between CPU and device after `steps`, over the largest displacement [-]."""
    model, dt, start = moving(lattice, law)
    plan = Plan(duration=steps * dt, dt=dt, every=0)
    cpu, gpu = (integrate(model, plan, state=start.copy(), loop_of=loop).state for loop in (None, loop_of))
    return float(np.abs(gpu.displacement - cpu.displacement).max() / np.abs(cpu.displacement).max())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--law", choices=sorted(LAWS), default="beams")
    parser.add_argument("--elements", type=int, nargs="+", default=[100_000, 1_000_000, 10_000_000])
    parser.add_argument("--compare", type=int, default=10_000)
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    law = LAWS[options.law]
    try:
        boundary = importlib.import_module("bondem._compile_cuda")
    except ImportError as error:
        sys.exit(f'nothing measured: numba-cuda is missing ({error}); pip install -e ".[gpu]"')
    reason = boundary.missing()
    if reason is not None or boundary.SIMULATED:
        sys.exit(f"nothing measured: {reason or 'this is the simulator, which says nothing about speed'}")
    loop_of = importlib.import_module("bondem.solve.loop_cuda").GpuLoop
    bandwidth = copy_bandwidth(boundary.cuda)
    result = {
        "device": str(boundary.cuda.get_current_device().name),
        "law": options.law,
        "copy GB/s": round(bandwidth / 1e9),
        "CPU against device, 1000 steps": difference(loop_of, specimen(options.compare, method=law.method), law),
        "runs": [],
    }
    print(json.dumps(result), flush=True)
    for elements in options.elements:
        lattice = specimen(elements, largest=100_000, method=law.method)
        result["runs"].append(rate(loop_of, lattice, law, options.repeat, bandwidth))
        print(json.dumps(result["runs"][-1]), flush=True)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
