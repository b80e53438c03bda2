"""Runs on a GPU: deviation of all passes from the CPU, and bond-steps per second in double precision.

python benchmarks/gpu_device.py [--seconds 225] [--out FILE]

Within the given time the script compiles all passes, and compares small runs of all kinds with the CPU. It then times
beams and cells of 1e4 to 1e6 elements, a body in contact, and beams and cells that break or crack. A batch of 100
specimens of 10 000 elements runs several at once. Last are beams of 1e7 and cells of 3e6 elements, which other
processes prepare meanwhile. Bodies are repeated periodic packings of 10 000 spheres.

A section that fails is recorded with its error, and the others continue. The file is written after each result.
`--host` rehearses the script with small bodies and the CPU as the device.
"""

import importlib
import itertools
import math
import multiprocessing
import statistics
import sys
import time
import traceback
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import numpy as np

import bondem as bd
from bondem._core import pass_tables
from bondem._device import Device, Host
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import Record, run
from tiled import specimen

LAWS: dict[str, tuple[Any, str]] = {
    "beams": (bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71), "distance"),
    "cells": (bd.CellBond(E=72e9, nu=0.17), "laguerre"),
}
BRITTLE: dict[str, Any] = {"failure": bd.PeripheralStress(tension=1e8, shear=1e8)}
WEAK: dict[str, Any] = {"failure": bd.MohrCoulomb(tension=2e7, cohesion=4e7, friction_angle=0.6)}
COHESIVE: dict[str, Any] = {"failure": bd.Rankine(tension=2e7, fracture_energy=50.0)}
TOUCHING: dict[str, Any] = {"contact": bd.LinearContact(E=265e9)}
#: Largest deviation of small runs from those of the CPU that counts as agreement, over the largest value of each
#: array.
CLOSE = 1e-10
# Share of the time after which no further small run begins.
_CHECKING = 0.4
# Intended bond-steps of a measurement, and its least and largest number of steps.
_UPDATES, _LEAST, _MOST = 4e9, 100, 10_000
# Least remaining time with which a measurement begins [s].
_NEEDED = 12.0


class Sizes(NamedTuple):
    """Numbers of elements of all bodies, for the device or for a rehearsal."""

    plain: tuple[int, ...] = (10_000, 100_000, 1_000_000)
    largest: tuple[tuple[str, int], ...] = (("beams", 10_000_000), ("cells", 3_000_000))
    touching: int = 100_000
    beams_that_break: int = 1_000_000
    cells_that_break: int = 100_000
    cells_that_crack: int = 100_000
    batch: tuple[int, int, int] = (100, 10_000, 16)  #: specimens, elements of each, specimens at once
    packing: int = 10_000  #: largest number of spheres of the repeated packing
    steps: float = _UPDATES


REHEARSAL = Sizes(
    (400, 1_200), (("beams", 2_400), ("cells", 800)), 800, 1_200, 400, 400, (4, 400, 2), packing=400, steps=1e5
)


class Clock:
    """Clock of the time that remains for the script."""

    def __init__(self, seconds: float) -> None:
        self.start, self.seconds = time.perf_counter(), seconds

    @property
    def spent(self) -> float:
        """Time since the start [s]."""
        return time.perf_counter() - self.start

    @property
    def left(self) -> float:
        """Time until the end [s]."""
        return self.seconds - self.spent


# ---- small runs against those of the CPU


def cases() -> dict[str, Any]:
    """Return functions that make small runs of all kinds, by name, with the kinds in turn."""
    kinds = [
        [(name, make) for name, make in importlib.import_module(f"tests.{module}").CASES.items()]
        for module in ("device_runs", "device_cracks", "device_yielding")
    ]
    turns = itertools.zip_longest(*kinds)
    return dict(one for turn in turns for one in turn if one is not None)


def checked(device: Callable[[], Device], clock: Clock) -> dict[str, Any]:
    """Return the deviation of small runs from those of the CPU, or the error with which one has ended."""
    deviation, found, own = importlib.import_module("tests.device_runs").deviation, {}, device()

    def loop_of(model: bd.Model, plan: Plan, state: State, dt: float) -> DeviceLoop:
        return DeviceLoop(model, plan, state, dt, own)

    for name, make in cases().items():
        if clock.spent > _CHECKING * clock.seconds:
            found[name] = "no time"
            continue
        try:
            model, start, steps, dt, options = make()
            plan = Plan(duration=steps * dt, dt=dt, **options)
            cpu, gpu = (integrate(model, plan, state=start(model), loop_of=loop) for loop in (None, loop_of))
            found[name] = float(f"{deviation(cpu, gpu):.3g}")
        except Exception as error:
            found[name] = f"{type(error).__name__}: {error}"
    return found


def agrees(found: dict[str, Any]) -> bool:
    """Return True if all runs for which there was time agree with those of the CPU."""
    return all(one == "no time" or (isinstance(one, float) and one < CLOSE) for one in found.values())


# ---- bodies


class Body(NamedTuple):
    """Periodic body without constraints in random motion."""

    model: bd.Model
    state: State
    dt: float
    seconds: float  #: time of its preparation [s]


def prepared(name: str, elements: int, packing: int, options: dict[str, Any]) -> Body:
    """Return a body of beams or cells, with half the critical time step of the packing that it repeats."""
    began = time.perf_counter()
    law, method = LAWS[name]
    warnings.simplefilter("ignore")
    part = specimen(min(elements, packing), largest=packing, method=method)
    dt = 0.5 * critical_step(bd.Model(part, law, 2500.0, **options), bd.VelocityVerlet())
    lattice = specimen(elements, largest=packing, method=method)
    model = bd.Model(lattice, law, 2500.0, **options)
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(0).standard_normal((len(lattice.particles), 3)))
    return Body(model, state, dt, time.perf_counter() - began)


def loop_on(device: Device, body: Body, state: State) -> DeviceLoop:
    """Return a loop on a device after 200 steps, so that its graphs are recorded."""
    loop = DeviceLoop(body.model, Plan(duration=1.0, dt=body.dt, every=0), state, body.dt, device)
    loop.run(200)
    return loop


def timed(loop: DeviceLoop, bonds: int, updates: float, repeat: int) -> dict[str, float]:
    """Return the number of steps, and median and best bond-steps per second, without copies of the state."""
    steps = 100 * round(min(max(updates / max(bonds, 1), _LEAST), _MOST) / 100)
    rates = []
    for _ in range(repeat):
        start = time.perf_counter()
        loop.run(steps)
        whole = time.perf_counter() - start
        start = time.perf_counter()
        loop.run(0)
        rates.append(bonds * steps / (whole - (time.perf_counter() - start)))
    return {"steps": steps, "median": statistics.median(rates), "best": max(rates)}


def measured(device: Device, body: Body, name: str, sizes: Sizes) -> dict[str, Any]:
    """Return the speed of a body on a device, with its sizes, and counts of failures."""
    state, began = body.state, time.perf_counter()
    loop = loop_on(device, body, state)
    first = time.perf_counter() - began
    bonds, elements = len(state.integrity), len(state.pose)
    result = timed(loop, bonds, sizes.steps, repeat=3 if elements <= 1_000_000 else 1)
    return {
        "bodies": name, "elements": elements, "bonds": bonds, "steps": int(result["steps"]),
        "bond-steps/s": {"median": float(f"{result['median']:.4g}"), "best": float(f"{result['best']:.4g}")},
        "µs per step": float(f"{1e6 * bonds / result['median']:.4g}"), "made in s": round(body.seconds, 1),
        "first 200 steps in s": round(first, 1), "finite": bool(np.isfinite(state.pose).all()),
        "broken": int((state.integrity == 0.0).sum()), "cracks": len(state.cracks),
    }  # fmt: skip


def batch(device: Callable[[], Device], sizes: Sizes) -> dict[str, Any]:
    """Return the speed of many specimens, of which several run at once on separate streams."""
    count, elements, at_once = sizes.batch
    body = prepared("beams", elements, sizes.packing, {})
    bonds, steps = len(body.state.integrity), 1000

    def ready(states: list[State]) -> list[DeviceLoop]:
        own = device()
        return [loop_on(own, body, state) for state in states]

    def carry_out(loops: list[DeviceLoop]) -> None:
        for loop in loops:
            loop.run(steps)

    shares = [[body.state.copy() for _ in range(k, count, at_once)] for k in range(min(at_once, count))]
    with ThreadPoolExecutor(at_once, initializer=device) as pool:  # the device becomes that of each thread
        groups = list(pool.map(ready, shares))
        began = time.perf_counter()
        list(pool.map(carry_out, groups))
        whole = time.perf_counter() - began
    return {
        "specimens": count, "elements": elements, "bonds of each": bonds, "at once": at_once, "steps": steps,
        "bond-steps/s": float(f"{count * bonds * steps / whole:.4g}"),
    }  # fmt: skip


# ---- the report

Section = tuple[str, Callable[[], Any]]


def sections(
    device: Callable[[], Device], clock: Clock, sizes: Sizes, pool: ProcessPoolExecutor
) -> Iterator[Section]:
    """Yield the name and function of each section, in order; other processes prepare large bodies from the start."""
    large = {one: pool.submit(prepared, *one, sizes.packing, {}) for one in sizes.largest}
    last = sizes.plain[-1]
    ahead = {name: pool.submit(prepared, name, last, sizes.packing, {}) for name in LAWS}
    own = device()

    def plain(name: str, elements: int, options: dict[str, Any]) -> dict[str, Any]:
        return measured(own, prepared(name, elements, sizes.packing, options), name, sizes)

    def awaited(name: str, future: Future) -> dict[str, Any]:
        return measured(own, future.result(timeout=max(clock.left - _NEEDED, 1.0)), name, sizes)

    for elements in sizes.plain[:-1]:
        for name in LAWS:
            yield f"{name}, {elements}", partial(plain, name, elements, {})
    yield "batch", partial(batch, device, sizes)
    yield "contact", partial(plain, "beams", sizes.touching, TOUCHING)
    yield "cells that break", partial(plain, "cells", sizes.cells_that_break, WEAK)
    yield "cells that crack", partial(plain, "cells", sizes.cells_that_crack, COHESIVE)
    for name, future in ahead.items():
        yield f"{name}, {last}", partial(awaited, name, future)
    yield "beams that break", partial(plain, "beams", sizes.beams_that_break, BRITTLE)
    for (name, elements), future in large.items():
        yield f"{name}, {elements}", partial(awaited, name, future)


def carried_out(work: Callable[[], Any]) -> Any:
    """Return the result of a section, or a text about the error that it raised."""
    try:
        return work()
    except Exception as error:  # because the other sections still need their time on the device
        traceback.print_exc()
        return {"failed": f"{type(error).__name__}: {error}"}


def report(device: Callable[[], Device], clock: Clock, sizes: Sizes) -> Iterator[tuple[str, Any]]:
    """Run the sections for which there is time; yield each result with its name."""
    pool = ProcessPoolExecutor(4, mp_context=multiprocessing.get_context("spawn"))
    try:
        large = sections(device, clock, sizes, pool)
        first = next(large)  # starts the preparation of bodies
        began = clock.spent
        yield "compiled", carried_out(lambda: device().compile(tuple(pass_tables("kernels"))) or "all passes")
        yield "compiled in s", round(clock.spent - began, 1)
        deviations = carried_out(lambda: checked(device, clock))
        yield "deviation from the CPU", deviations
        yield "all agree", agrees(deviations)
        for name, work in itertools.chain([first], large):
            yield name, carried_out(work) if clock.left > _NEEDED else "no time"
    finally:
        for process in list((getattr(pool, "_processes", None) or {}).values()):
            process.terminate()  # bodies in preparation come too late
        pool.shutdown(wait=False, cancel_futures=True)


def finite(value: Any) -> Any:
    """Return a result with texts in place of numbers that JSON lacks, such as infinity."""
    if isinstance(value, dict):
        return {key: finite(one) for key, one in value.items()}
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def measure(record: Record, *, seconds: float = 225.0, host: bool = False) -> None:
    """Measure as long as there is time.

    Args:
        seconds: that there are.
        host: rehearse in small, with the CPU as the device.
    """
    warnings.simplefilter("ignore")
    clock, device = Clock(seconds), Host
    if not host:
        cuda = importlib.import_module("bondem._cuda")
        reason = cuda.lacks_gpu()
        if reason is not None:
            sys.exit(f"nothing measured: {reason}")
        device = cuda.CudaDevice
        record.keep(device=cuda.CudaDevice().name)
    for name, result in report(device, clock, REHEARSAL if host else Sizes()):
        record.keep(**{name: finite(result), "seconds": round(clock.spent, 1)})
        print(f"{clock.spent:6.1f} s  {name}: {result}", flush=True)
    sys.exit(0 if record.data["all agree"] else 1)


if __name__ == "__main__":
    run()
