"""What a GPU does: all its passes against the CPU, and bond-steps per second in double precision.

python benchmarks/gpu_device.py [--seconds 225] [--out FILE]

As long as there is time: small runs with all that acts on bodies, on the device and on the CPU; beams and cells of
1e4 to 1e6 elements; beams and cells that break; a batch of 100 specimens of 10 000 elements, several at once; a body
in contact, where the device has contacts; beams and cells of 1e7 elements. Bodies are periodic packings of 10 000
spheres, repeated. The file is written after each of them. `--host` rehearses the script in small, with the CPU as
the device.
"""

import argparse
import importlib
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem._device import Device, Host
from bondem.dynamics.device_loop import DeviceLoop, device_has
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import RESULTS, keep, origin
from paired import ROOT
from tiled import specimen

LAWS: dict[str, tuple[Any, str]] = {
    "beams": (bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71), "distance"),
    "cells": (bd.CellBond(E=72e9, nu=0.17), "laguerre"),
}
SIZES, LARGEST = (10_000, 100_000, 1_000_000), 10_000_000
#: Deviation of small runs from those of the CPU below which they agree, of the largest value of each array.
CLOSE = 1e-10
# Bond-steps of a measurement, about, and its steps at least and at most.
_UPDATES, _LEAST, _MOST = 4e9, 100, 10_000
# Seconds that a larger body takes per element beside its steps: packing, tables, memory.
_PER_ELEMENT = 1.2e-5
# Specimens of a batch, their elements, and how many are on the device at once.
_BATCH, _OF_EACH, _AT_ONCE = 100, 10_000, 16


class Clock:
    """Time that is left."""

    def __init__(self, seconds: float) -> None:
        self.start, self.seconds = time.perf_counter(), seconds

    @property
    def left(self) -> float:
        """Seconds."""
        return self.seconds - (time.perf_counter() - self.start)


def checked(device: Callable[[], Device]) -> dict[str, float]:
    """Return the deviation of each small run from that of the CPU."""
    sys.path.append(str(ROOT))
    cases = importlib.import_module("tests.device_runs")
    found = {}
    for name, make in cases.CASES.items():
        model, start, steps, dt, options = make()
        plan = Plan(duration=steps * dt, dt=dt, **options)
        cpu = integrate(model, plan, state=start(model))

        def loop_of(model: bd.Model, plan: Plan, state: State, dt: float) -> DeviceLoop:
            return DeviceLoop(model, plan, state, dt, device())

        gpu = integrate(model, plan, state=start(model), loop_of=loop_of)
        found[name] = cases.deviation(cpu, gpu)
    return found


def moving(lattice: bd.Lattice, law: Any, **options: Any) -> tuple[bd.Model, float, State]:
    """Return a free periodic body, its time step, and elements that move at random."""
    model = bd.Model(lattice, law, 2500.0, **options)
    dt = 0.5 * critical_step(model, bd.VelocityVerlet())
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(0).standard_normal((len(lattice.particles), 3)))
    return model, dt, state


def loop_on(device: Device, model: bd.Model, dt: float, state: State) -> DeviceLoop:
    """Return a loop whose graphs are recorded."""
    loop = DeviceLoop(model, Plan(duration=1.0, dt=dt, every=0), state, dt, device)
    loop.run(200)
    return loop


def timed(loop: DeviceLoop, bonds: int, *, repeat: int = 3) -> dict[str, float]:
    """Return bond-steps per second; the time holds no copies of the state."""
    steps = 100 * round(min(max(_UPDATES / max(bonds, 1), _LEAST), _MOST) / 100)
    rates = []
    for _ in range(repeat):
        start = time.perf_counter()
        loop.run(steps)
        whole = time.perf_counter() - start
        start = time.perf_counter()
        loop.run(0)
        rates.append(bonds * steps / (whole - (time.perf_counter() - start)))
    return {"steps": steps, "median": statistics.median(rates), "best": max(rates)}


def measured(device: Callable[[], Device], elements: int, name: str, **options: Any) -> dict[str, Any]:
    """Return how fast a body steps."""
    law, method = LAWS[name]
    began = time.perf_counter()
    lattice = specimen(elements, largest=10_000, method=method)
    model, dt, state = moving(lattice, law, **options)
    loop = loop_on(device(), model, dt, state)
    ready = time.perf_counter() - began
    bonds = len(lattice.pairs)
    result = timed(loop, bonds, repeat=3 if elements <= 1_000_000 else 1)
    broken = len(state.broken)
    return {
        "bodies": name, "elements": len(lattice.particles), "bonds": bonds, "steps": int(result["steps"]),
        "bond-steps/s": {"median": float(f"{result['median']:.4g}"), "best": float(f"{result['best']:.4g}")},
        "prepared in s": round(ready, 1), "finite": bool(np.isfinite(state.pose).all()), "broken": broken,
    }  # fmt: skip


def batch(device: Callable[[], Device], count: int, elements: int, at_once: int) -> dict[str, Any]:
    """Return how fast many specimens step, several at once, each on a stream of its own."""
    law, method = LAWS["beams"]
    lattice = specimen(elements, largest=10_000, method=method)
    model, dt, start = moving(lattice, law)
    bonds, steps = len(lattice.pairs), 1000

    def carry_out(states: list[State]) -> float:
        own = device()
        loops = [loop_on(own, model, dt, state) for state in states]
        began = time.perf_counter()
        for loop in loops:
            loop.run(steps)
        return time.perf_counter() - began

    shares = [[start.copy() for _ in range(k, count, at_once)] for k in range(min(at_once, count))]
    with ThreadPoolExecutor(at_once) as pool:
        longest = max(pool.map(carry_out, shares))
    return {
        "specimens": count, "elements": elements, "bonds of each": bonds, "at once": at_once, "steps": steps,
        "bond-steps/s": float(f"{count * bonds * steps / longest:.4g}"),
    }  # fmt: skip


def report(device: Callable[[], Device], clock: Clock, *, rehearsal: bool) -> Iterator[tuple[str, Any]]:
    """Carry out what there is time for; yield each result under its name."""
    deviations = checked(device)
    yield "deviation from the CPU", deviations
    yield "all agree", bool(max(deviations.values()) < CLOSE)
    yield "checked in s", round(clock.seconds - clock.left, 1)
    steps: list[dict[str, Any]] = []

    def bodies(*sizes: int) -> Iterator[tuple[str, Any]]:
        for elements in sizes:
            for name in LAWS:
                if clock.left > 10.0 + 2.0 * elements * _PER_ELEMENT:
                    steps.append(measured(device, elements, name))
                    yield "steps", steps

    yield from bodies(*((500, 2_000) if rehearsal else SIZES))
    brittle = bd.PeripheralStress(tension=1e8, shear=1e8)
    if clock.left > 20.0:
        yield "beams that break", measured(device, 2_000 if rehearsal else 1_000_000, "beams", failure=brittle)
    weak = bd.MohrCoulomb(tension=2e7, cohesion=4e7, friction_angle=0.6)
    if clock.left > 20.0:
        yield "cells that break", measured(device, 500 if rehearsal else 100_000, "cells", failure=weak)
    if clock.left > 20.0:
        yield "batch", batch(device, *((4, 500, 2) if rehearsal else (_BATCH, _OF_EACH, _AT_ONCE)))
    touching: dict[str, Any] = {"contact": bd.LinearContact(E=265e9)}
    probe = bd.Model(specimen(500, largest=500), LAWS["beams"][0], 2500.0, **touching)
    if not device_has(probe):
        yield "contacts", "not on the device yet"
    elif clock.left > 20.0:
        yield "contacts", measured(device, 2_000 if rehearsal else 100_000, "beams", **touching)
    if not rehearsal:
        yield from bodies(LARGEST)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=225.0)
    parser.add_argument("--host", action="store_true")
    parser.add_argument("--out", type=Path, default=RESULTS / "gpu_device.json")
    options = parser.parse_args()
    clock, found = Clock(options.seconds), origin()
    if options.host:
        device: Callable[[], Device] = Host
    else:
        cuda = importlib.import_module("bondem._cuda")
        reason = cuda.lacks_gpu()
        if reason is not None:
            sys.exit(f"nothing measured: {reason}")
        device = cuda.CudaDevice
        found["device"] = cuda.CudaDevice().name
    for name, result in report(device, clock, rehearsal=options.host):
        found[name] = result
        found["seconds"] = round(clock.seconds - clock.left, 1)
        keep(options.out, found)
        print(name, result[-1] if isinstance(result, list) else result, flush=True)
    return 0 if found["all agree"] else 1


if __name__ == "__main__":
    sys.exit(main())
