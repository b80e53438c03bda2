"""Time and memory of large bodies of cells: packing, cutting, a static solution, and an explicit run.

A cylinder is filled with `count` even centres (`bd.pack(method="even")`) and cut; then it is clamped and pulled
statically, and an explicit run takes some steps. Each size runs in a new process, so that peak memory belongs to one
size; a small body is computed first, so that compilation is not timed.

Run: python benchmarks/cell_scale.py [--elements 10000,100000] [--thread-count 2]
     python benchmarks/cell_scale.py --elements 1000000 --no-static
It writes benchmarks/results/cell_scale.json, with an entry per size, and keeps entries of other sizes.
"""

import resource
import time
from typing import Any

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.timestep import critical_step
from kept import Record, alone, run

SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
SILICA = bd.materials.fused_silica
#: Steps of the explicit run.
STEPS = 20


def stages_of(count: int, static: bool) -> dict[str, Any]:
    """Seconds of each stage, and the peak of memory after it, by stage."""
    found: dict[str, Any] = {"elements": count}
    began = time.perf_counter()

    def done(stage: str) -> None:
        nonlocal began
        peak = 1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        found[stage] = {"seconds": time.perf_counter() - began, "peak_bytes": peak}
        began = time.perf_counter()

    particles = bd.pack(SHAPE, count=count, method="even", seed=1)
    done("pack")
    body = bd.connect(particles, method="laguerre")
    done("cut")
    found["facets"] = len(body.pairs) / count
    pull = [bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(1e3, 0.0, 0.0))]
    model = bd.Model(body, bd.CellBond(E=SILICA.E, nu=SILICA.nu), SILICA.rho, boundary=pull)
    if static:
        bd.solve_static(model)
        done("static")
    dt = critical_step(model, bd.VelocityVerlet())
    done("critical_step")
    bd.solve_explicit(model, duration=STEPS * 0.9 * dt, dt=0.9 * dt)
    done(f"explicit_{STEPS}_steps")
    return found


def timed(count: int, thread_count: int, static: bool) -> dict[str, Any]:
    """Seconds and memory of a body, after a small one."""
    with threads(thread_count):
        stages_of(2000, static)
        return stages_of(count, static)


def measure(
    record: Record, *, elements: tuple[int, ...] = (10_000, 100_000), thread_count: int = 2, no_static: bool = False
) -> None:
    for count in elements:
        one = alone(timed, count, thread_count, not no_static) | {"threads": thread_count, **record.origin}
        stages = {name: value for name, value in one.items() if isinstance(value, dict) and "seconds" in value}
        print(count, *(f"{k} {v['seconds']:.1f} s, {v['peak_bytes'] / 2**30:.2f} GiB;" for k, v in stages.items()))
        cases = [other for other in record.rows() if other["elements"] != count] + [one]
        record.keep(cases=sorted(cases, key=lambda one: one["elements"]))


if __name__ == "__main__":
    run()
