"""Runs on a GPU: bond-steps per second in double precision.

python benchmarks/gpu_device.py [--out FILE]

Beams and cells of 1e4 to 1e6 elements, a body in contact, beams and cells that break or crack, a batch of 100
specimens of 10 000 elements, several at once, and the time of each pass of a step. Last are beams of 1e7 and cells of
3e6 elements. Bodies are repeated periodic packings of 10 000 spheres. The CPU runs bodies of up to 1e6 elements too,
on all its cores. Each section is a process of its own: one that fails is recorded as such, and the others continue.
First the runs of `pytest --gpu` are compared with those of the CPU.
`--host` rehearses the script with small bodies and the CPU as the device.
"""

import importlib
import statistics
import subprocess
import sys
import time
import warnings
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import numpy as np

import bondem as bd
from bondem._core import pass_tables
from bondem._device import Device, Enqueue, Host
from bondem._passes import Kernel
from bondem._threads import current_threads
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Loop, Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from kept import Record, alone, run
from tiled import specimen

LAWS: dict[str, tuple[Any, str]] = {
    "beams": (bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71), "distance"),
    "cells": (bd.CellBond(E=72e9, nu=0.17), "laguerre"),
}
BRITTLE: dict[str, Any] = {"failure": bd.PeripheralStress(tension=1e8, shear=1e8)}
WEAK: dict[str, Any] = {"failure": bd.MohrCoulomb(tension=2e7, cohesion=4e7, friction_angle=0.6)}
COHESIVE: dict[str, Any] = {"failure": bd.Rankine(tension=2e7, fracture_energy=50.0)}
TOUCHING: dict[str, Any] = {"contact": bd.LinearContact(E=265e9)}
# Least and largest number of steps of a measurement.
_LEAST, _MOST = 100, 10_000
# The CPU carries out this part of the bond-steps of a device, and bodies of up to so many elements.
_PART_OF_CPU, _LARGEST_OF_CPU = 0.1, 1_000_000


class Sizes(NamedTuple):
    """Numbers of elements of all bodies, for the device or for a rehearsal."""

    plain: tuple[int, ...] = (10_000, 100_000, 1_000_000)
    largest: tuple[tuple[str, int], ...] = (("beams", 10_000_000), ("cells", 3_000_000))
    touching: int = 100_000
    beams_that_break: int = 1_000_000
    cells_that_break: int = 100_000
    cells_that_crack: int = 100_000
    batch: tuple[int, int, int] = (100, 10_000, 16)  #: specimens, elements of each, specimens at once
    compared: int | None = None  #: runs of the tests that are compared with the CPU; None for all
    packing: int = 10_000  #: largest number of spheres of the repeated packing
    updates: float = 2e9  #: intended bond-steps of a measurement


REHEARSAL = Sizes(
    (400, 1_200), (("beams", 2_400), ("cells", 800)), 800, 1_200, 400, 400, (4, 400, 2),
    compared=4, packing=400, updates=1e5,
)  # fmt: skip


class Body(NamedTuple):
    """Periodic body without constraints in random motion."""

    model: bd.Model
    state: State
    dt: float


def prepared(name: str, elements: int, packing: int, options: dict[str, Any]) -> Body:
    """Return a body of beams or cells, with half the critical time step of the packing that it repeats."""
    law, method = LAWS[name]
    part = specimen(min(elements, packing), largest=packing, method=method)
    dt = 0.5 * critical_step(bd.Model(part, law, 2500.0, **options), bd.VelocityVerlet())
    model = bd.Model(specimen(elements, largest=packing, method=method), law, 2500.0, **options)
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(0).standard_normal((len(model.mass), 3)))
    return Body(model, state, dt)


def loop_on(device: Device, body: Body, state: State) -> DeviceLoop:
    """Return a loop on a device after 200 steps, so that its graphs are recorded."""
    loop = DeviceLoop(body.model, Plan(duration=1.0, dt=body.dt, every=0), state, body.dt, device)
    loop.run(200)
    return loop


def rates(loop: Loop, bonds: int, updates: float, repeat: int) -> dict[str, float]:
    """Return bond-steps per second of a loop without the time by which it copies its state, as median and best."""
    steps, found = 100 * round(min(max(updates / max(bonds, 1), _LEAST), _MOST) / 100), []
    for _ in range(repeat):
        start = time.perf_counter()
        loop.run(steps)
        whole = time.perf_counter() - start
        start = time.perf_counter()
        loop.run(0)
        found.append(bonds * steps / (whole - (time.perf_counter() - start)))
    return {
        "median": float(f"{statistics.median(found):.4g}"), "best": float(f"{max(found):.4g}"),
        "steps": repeat * steps,
    }  # fmt: skip


def measured(own: Device, sizes: Sizes, name: str, elements: int, options: dict[str, Any]) -> dict[str, Any]:
    """Return the speed of a body on a device and on the CPU, with its sizes and counts of failures."""
    body = prepared(name, elements, sizes.packing, options)
    state, bonds = body.state, len(body.state.integrity)
    on_cpu, repeat = state.copy() if elements <= _LARGEST_OF_CPU else None, 3 if elements <= 1_000_000 else 1
    found = rates(loop_on(own, body, state), bonds, sizes.updates, repeat)
    result = {
        "bodies": name, "elements": len(state.pose), "bonds": bonds, "bond-steps/s": found,
        "µs per step": float(f"{1e6 * bonds / found['median']:.4g}"), "finite": bool(np.isfinite(state.pose).all()),
        "broken": int((state.integrity == 0.0).sum()), "cracks": len(state.cracks),
    }  # fmt: skip
    if on_cpu is not None:
        loop = CoreLoop(body.model, Plan(duration=1.0, dt=body.dt, every=0), on_cpu, body.dt)
        loop.run(200)
        cpu = rates(loop, bonds, _PART_OF_CPU * sizes.updates, repeat)
        ratio = float(f"{found['median'] / cpu['median']:.4g}")
        result |= {"cpu": {"threads": current_threads(), **cpu}, "ratio": ratio}
    return result


def passes(own: Device, sizes: Sizes, name: str, elements: int, options: dict[str, Any]) -> dict[str, float]:
    """Return the microseconds of each pass of a step, launched 100 times in succession, by its place and name."""
    body, names, plain = prepared(name, elements, sizes.packing, options), {}, own.prepared

    def named(one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        made = plain(one, count, tables, halted)
        names[id(made)] = f"{one.name}, {count}"
        return made

    own.prepared = named  # type: ignore[method-assign]
    loop, found, flag = loop_on(own, body, body.state), {}, np.zeros(1)
    place, _memory = own.allocate(8)
    for k, enqueue in enumerate(loop._go_on):
        repeated, times = own.recorded([enqueue] * 100), []
        for _ in range(4):
            own.fetch(place, flag)  # after all launches so far
            start = time.perf_counter()
            repeated()
            own.fetch(place, flag)
            times.append(time.perf_counter() - start)
        found[f"{k + 1}. {names[id(enqueue)]}"] = float(f"{1e4 * min(times[1:]):.4g}")
    return found


def compiled(own: Device) -> dict[str, float]:
    """Compile all passes, unless they are in the cache, and return their number and the seconds."""
    names, start = tuple(pass_tables("kernels")), time.perf_counter()
    own.compile(names)
    return {"passes": len(names), "seconds": float(f"{time.perf_counter() - start:.3g}")}


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


def deviation_of(case: str, host: bool) -> float:
    """Return the largest deviation of a run of `tests/` on a device from that on the CPU, over the largest values."""
    warnings.simplefilter("ignore")
    of_device = Host if host else importlib.import_module("bondem._cuda").CudaDevice
    model, start, steps, dt, options = cases()[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    on_cpu = integrate(model, plan, state=start(model))
    found = integrate(model, plan, state=start(model), loop_of=lambda *of: DeviceLoop(*of, of_device()))
    return float(f"{importlib.import_module('tests.device_runs').deviation(on_cpu, found):.3g}")


def cases() -> dict[str, Any]:
    """Return the runs that `pytest --gpu` compares."""
    modules = map(importlib.import_module, ("tests.device_runs", "tests.device_cracks", "tests.device_yielding"))
    return {name: case for module in modules for name, case in module.CASES.items()}


def agreement(host: bool, sizes: Sizes) -> dict[str, Any]:
    """Compare all runs of `pytest --gpu` with the CPU, where neither fuses products and sums."""
    names = list(cases())[: sizes.compared]
    plain = {"BONDEM_ISA": "v2", "BONDEM_CUDA_FMA": "off", "BONDEM_NUM_THREADS": "1"}
    with ThreadPoolExecutor() as pool:
        found = dict(zip(names, pool.map(lambda name: alone(deviation_of, name, host, **plain), names), strict=True))
    above = {name: deviation for name, deviation in found.items() if deviation > 1e-15}
    return {"runs": len(names), "largest": max(found.values()), "above 1e-15": above}


def sections(device: Callable[[], Device], sizes: Sizes) -> dict[str, Callable[[], Any]]:
    """Return the function of each section by name, in order."""
    one = partial(measured, device(), sizes)
    plain = [(name, elements) for elements in sizes.plain for name in LAWS]
    return {
        "compiled": lambda: compiled(device()),
        **{f"{name}, {elements}": partial(one, name, elements, {}) for name, elements in plain},
        "batch": partial(batch, device, sizes),
        "contact": partial(one, "beams", sizes.touching, TOUCHING),
        "cells that break": partial(one, "cells", sizes.cells_that_break, WEAK),
        "cells that crack": partial(one, "cells", sizes.cells_that_crack, COHESIVE),
        "beams that break": partial(one, "beams", sizes.beams_that_break, BRITTLE),
        **{f"passes, {name}, {elements}": partial(passes, device(), sizes, name, elements, {})
           for name, elements in plain[2:]},
        "passes, contact": partial(passes, device(), sizes, "beams", sizes.touching, TOUCHING),
        **{f"{name}, {elements}": partial(one, name, elements, {}) for name, elements in sizes.largest},
    }


def section(name: str, host: bool) -> Any:
    """Return the result of a section."""
    warnings.simplefilter("ignore")
    device = Host if host else importlib.import_module("bondem._cuda").CudaDevice
    sizes = REHEARSAL if host else Sizes()
    return agreement(host, sizes) if name == "agreement" else sections(device, sizes)[name]()


def measure(record: Record, *, host: bool = False, only: str = "") -> None:
    """Measure sections.

    Args:
        host: rehearse in small, with the CPU as the device.
        only: name of the section to measure; all unless given.
    """
    device: Callable[[], Device] = Host
    if not host:
        cuda = importlib.import_module("bondem._cuda")
        reason = cuda.lacks_gpu()
        if reason is not None:
            sys.exit(f"nothing measured: {reason}")
        device = cuda.CudaDevice
        record.keep(device=cuda.CudaDevice().name)
    for name in ("agreement", *sections(device, REHEARSAL if host else Sizes())):
        if only not in ("", name):
            continue
        began = time.perf_counter()
        try:
            result = alone(section, name, host)
        except subprocess.CalledProcessError as error:  # the other sections still need their time on the device
            result = {"failed": f"exit status {error.returncode}"}
        record.keep(**{name: result})
        print(f"{time.perf_counter() - began:6.1f} s  {name}: {result}", flush=True)


if __name__ == "__main__":
    run()
