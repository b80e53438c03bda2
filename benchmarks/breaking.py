"""Cost of a failure criterion while no bond breaks: steps with and without it, in turns.

python benchmarks/breaking.py [--elements 10000] [--repeat 15] [--thread-count 1] [--cells] [--contact] [--out FILE]

With --contact, bodies also have contact, and are timed intact and in pieces. A body moves inward until thousands of
its bonds are broken; one of cells also until most of its facets are broken ("in dust").

Without --contact the strength is far above all loads, and the motion is random. Times are processor time on one
thread, which other processes disturb less, and wall time on several.
"""

import time

import numpy as np

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from kept import Record, run, variant
from tiled import specimen


def block(elements: int, cells: bool) -> tuple[bd.Lattice, bd.CellBond | bd.EulerBernoulli]:
    if cells:
        box = bd.pack(bd.Box(size=(2e-2, 1e-2, 1e-2)), count=elements, method="even", seed=1)
        return bd.connect(box, method="laguerre"), bd.CellBond(E=72.5e9, nu=0.17)
    return specimen(elements, largest=elements), bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)


def loops(elements: int, cells: bool) -> tuple[dict[str, CoreLoop], int, dict[str, dict[str, int]]]:
    lattice, law = block(elements, cells)
    criteria: dict[str, bd.Criterion | None] = {
        "elastic": None, "MohrCoulomb": bd.MohrCoulomb(tension=1e15, cohesion=1e15, friction_angle=0.6)
    }  # fmt: skip
    if cells:  # criteria on the stresses of cells, which every step computes and evaluates
        soft = bd.MohrCoulomb(tension=1e15, cohesion=1e15, friction_angle=0.6, fracture_energy=1e18)
        criteria |= {"Rankine": bd.Rankine(tension=1e15), "MohrCoulomb, softening": soft}
    else:
        criteria["PeripheralStress"] = bd.PeripheralStress(tension=1e15, shear=1e15)
    found = {}
    for name, failure in criteria.items():
        model = bd.Model(lattice, law, 2500.0, failure=failure)
        dt = 0.5 * critical_step(model, bd.VelocityVerlet())
        state = model.state()
        state.set_motion(velocity=1e-3 * np.random.default_rng(0).standard_normal((len(lattice.particles), 3)))
        found[name] = CoreLoop(model, Plan(duration=dt, dt=dt, every=0), state, dt)
        found[name].run(3)
    return found, len(lattice.pairs), {}


def touching(elements: int, cells: bool) -> tuple[dict[str, CoreLoop], int, dict[str, dict[str, int]]]:
    lattice, law = block(elements, cells)
    failure = bd.PeripheralStress(tension=265e6, shear=265e6)
    if cells:
        failure = bd.MohrCoulomb(tension=50e6, cohesion=150e6, friction_angle=0.6, fracture_energy=50.0)
    contact = bd.LinearContact(E=70e9, friction=0.4)
    inward = -(lattice.centre - lattice.centre.mean(axis=0)) / (0.5 * np.ptp(lattice.centre[:, 0]))
    found, counts = {}, {}
    crushed = [("in pieces", 5.0, 1000), ("in dust", 20.0, 1200)] if cells else [("in pieces", 4.0, 600)]
    for name, speed, steps in (("elastic", 0.5, 3), ("whole", 0.5, 3), *crushed):
        fails = name != "elastic"
        model = bd.Model(
            lattice, law, 2500.0, failure=failure if fails else None, contact=contact if fails else None
        )  # fmt: skip
        dt = 0.5 * critical_step(model, bd.VelocityVerlet())
        state = model.state()
        state.set_motion(velocity=speed * inward)
        found[name] = CoreLoop(model, Plan(duration=dt, dt=dt, every=0), state, dt)
        found[name].run(steps)
        counts[name] = {"broken": len(state.broken), "cracked": len(state.cracks), "contacts": len(state.touching)}
        print(name, counts[name])
    return found, len(lattice.pairs), counts


def measure(
    record: Record, *, elements: int = 10_000, repeat: int = 15, thread_count: int = 1, cells: bool = False,
    contact: bool = False,
) -> None:  # fmt: skip
    clock = time.process_time if thread_count == 1 else time.perf_counter
    with threads(thread_count):
        found, bonds, counts = (touching if contact else loops)(elements, cells)
        steps = max(20, (1_000_000 if contact else 4_000_000) // bonds)
        times: dict[str, list[float]] = {name: [] for name in found}
        for _ in range(repeat):
            for name, loop in found.items():
                begin = clock()
                loop.run(steps)
                times[name].append((clock() - begin) / steps / bonds * 1e9)
    elastic = np.array(times["elastic"])
    result = {"elements": elements, "bonds": bonds, "threads": thread_count}
    for name, each in times.items():
        row = {
            "least_ns": min(each), "median_ns": float(np.median(each)),
            "ratio_of_least": float(min(each) / elastic.min()),
            "median_ratio": float(np.median(np.array(each) / elastic)),
        }  # fmt: skip
        result[name] = row | counts.get(name, {})
        print(name, {key: round(value, 3) for key, value in row.items()})
    variant(record, "_cells" * cells + "_contact" * contact).keep(**result)


if __name__ == "__main__":
    run()
