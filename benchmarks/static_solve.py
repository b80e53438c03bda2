"""Time of the static, modal and non-linear solvers on a jittered cylinder of length 8 radii, z = 6.2.

python benchmarks/static_solve.py [elements ...] [--repeat 3] [--out benchmarks/results/static_solve.json]

The bar is pulled, and bent for relaxation. The deviation of the relaxed bar from the static solution is also
recorded.
"""

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.statics.linear import Iteration, System
from kept import RESULTS, clocked, keep, origin
from validation.measures.jittered_cylinder import cylinder

LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.5)
DEPTH = 1.0


def far(found: np.ndarray, expected: np.ndarray) -> float:
    """Return the largest difference over the largest expected value [-]."""
    return float(np.abs(found - expected).max() / np.abs(expected).max())


def tasks(lattice: bd.Lattice, report: dict) -> dict[str, Callable[[], object]]:
    """Return the functions to time, by name; write the deviation of the relaxed bar into `report`."""
    clamp = bd.Fix(bd.Face("x_min", depth=DEPTH))
    pull = bd.Load(bd.Face("x_max", depth=DEPTH), force=(1e3, 0.0, 0.0))
    model = bd.Model(lattice, LAW, density=2700.0, boundary=[clamp, pull])
    free = model.with_boundary([pull, bd.Load(bd.Face("x_min", depth=DEPTH), force=(-1e3, 0.0, 0.0))])
    bent = model.with_boundary([clamp, bd.Load(bd.Face("x_max", depth=DEPTH), force=(0.0, 0.0, 1.0))])
    near = bd.solve_static(model)
    wider = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.52)
    similar = bd.Model(lattice, wider, 1000.0, boundary=[clamp, pull])
    system = System.of(model)
    found: dict[str, Callable[[], object]] = {
        "static, clamped": lambda: bd.solve_static(model),
        "static, free": lambda: bd.solve_static(free),
        "static, warm start": lambda: bd.solve_static(similar, guess=near),
        "of it matrix": lambda: System.of(model),
        "of it preconditioner": lambda: Iteration(system),
    }
    if len(lattice.particles) > 50_000:
        return found
    static, relaxed = bd.solve_static(bent), bd.solve_relaxed(bent)
    report["relaxed from static, bent"] = {
        name: far(getattr(relaxed, name), getattr(static, name)) for name in ("displacement", "rotation", "reaction")
    }
    return found | {
        "eight modes": lambda: bd.solve_modes(model, prestress=False),
        "static, bent": lambda: bd.solve_static(bent),
        "relaxed to 1e-6, bent": lambda: bd.solve_relaxed(bent),
        "static, non-linear": lambda: bd.solve_static(model, nonlinear=True),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("elements", type=int, nargs="*", default=[11_000, 110_000], help="about so many")
    parser.add_argument("--repeat", type=int, default=3, help="of each; 0: no times, the error alone [3]")
    parser.add_argument("--out", type=Path, default=RESULTS / "static_solve.json")
    options = parser.parse_args()
    report: dict = {**origin(), "repeat": options.repeat, "sizes": []}
    for count in options.elements:
        lattice = cylinder(count)
        size: dict = {"asked": count, "elements": len(lattice.particles), "bonds": len(lattice.pairs), "seconds": {}}
        print(f"{size['elements']} elements, {size['bonds']} bonds")
        for name, task in tasks(lattice, size).items():
            if not options.repeat:
                continue
            took = size["seconds"][name] = clocked(task, options.repeat)
            wall, cpu = took["wall"], took["cpu"]
            print(f"  {name:24s} {wall['median']:8.2f} s wall {cpu['median']:8.2f} s cpu (medians)", flush=True)
        report["sizes"].append(size)
    keep(options.out, report)


if __name__ == "__main__":
    main()
