"""Fracture by load factors beside slow explicit runs: notched bars of concrete, and what finer steps change.

E = 40 GPa, ν = 0.2, f_t = 4 MPa, G_f = 20 J/m². A prism 60 × 30 × 30 mm with a notch 3 mm wide and 10 mm deep is
pulled between smooth platens: by `bd.solve_quasistatic` with bands of several widths about the softening line; by
`bd.labtests.direct_tension`, damped, at its usual speed and at a quarter of it; and by displacements that grow by one
and by half a per cent of that of the peak (`displacement_steps.py`), where nothing snaps back. Peaks over that of the
slower explicit run, work over the ligament and G_f, events, facets, and time.

Run: python benchmarks/load_factors.py [--counts 300 1000 3000] [--seeds 1] [--ripples 0.2 0.1 0.05 0.02]
         [--together 0.005] [--steps 0.01 0.005]
It writes benchmarks/results/load_factors.json; cases that are there already are kept.
"""

import argparse
import json
import time
from itertools import product
from pathlib import Path

import numpy as np

import bondem as bd
from displacement_steps import pulled_in_steps
from kept import RESULTS, keep, origin

LAW = bd.CellBond(E=40e9, nu=0.2)
ENERGY = 20.0
FAILURE = bd.Rankine(tension=4e6, fracture_energy=ENERGY)
SIZE, NOTCH = (60e-3, 30e-3, 30e-3), (3e-3, 10e-3)
LIGAMENT = SIZE[2] * (SIZE[1] - NOTCH[1])
#: Traverses of sound until the expected peak of the explicit runs.
TRAVERSES = (60.0, 240.0)
FILE = RESULTS / "load_factors.json"


def body(count: int, seed: int) -> bd.Lattice:
    """The notched prism."""
    slot = bd.Box((NOTCH[0], NOTCH[1], 2.0 * SIZE[2])).moved((0.5 * (SIZE[0] - NOTCH[0]), -1e-6, -0.5 * SIZE[2]))
    shape = bd.Box(SIZE).cut(slot, name="notch")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def explicit(bar: bd.Lattice, traverses: float) -> dict:
    began = time.perf_counter()
    test = bd.labtests.direct_tension(bar, LAW, FAILURE, traverses=traverses)
    return {
        "traverses": traverses, "peak": test.peak, "work": test.work / ENERGY,
        "steps": test.run.state.step, "seconds": time.perf_counter() - began,
    }  # fmt: skip


def by_steps(bar: bd.Lattice, way: float, part: float) -> dict:
    """By displacements from 0.7 of that of the peak on, `part` of it each, until a tenth of the peak is lost."""
    began = time.perf_counter()
    found = pulled_in_steps(model_of(bar), bd.Face("x_max"), 0.7 * way, part * way, 0.9)
    return {
        "part": part, "peak": float(found.load.max()) / LIGAMENT, "steps": len(found.load),
        "rounds": int(found.rounds.sum()), "most rounds": int(found.rounds[: found.load.argmax() + 1].max()),
        "seconds": time.perf_counter() - began,
    }  # fmt: skip


def model_of(bar: bd.Lattice) -> bd.Model:
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
    return bd.Model(bar, LAW, density=2400.0, failure=FAILURE, boundary=ends)


def by_factors(bar: bd.Lattice, ripple: float, together: float) -> dict:
    began, busy = time.perf_counter(), time.process_time()
    path = bd.solve_quasistatic(model_of(bar), bd.Face("x_max"), ripple=ripple, together=together)
    return {
        "ripple": ripple, "together": together, "peak": path.peak / LIGAMENT,
        "way": float(path.displacement[path.load.argmax()]),
        "work": float(path.work[-1]) / LIGAMENT / ENERGY, "events": len(path.load), "solutions": path.solutions,
        "failures": len(path.bond), "facets": len(set(path.bond.tolist())),
        "events of a facet": float(np.median(np.unique(path.bond, return_counts=True)[1])),
        "closure": float(path.work[-1] - path.stored[-1] - path.energy.sum()) / path.work[-1],
        "iterations": path.iterations, "end": path.end, "seconds": time.perf_counter() - began,
        "processor seconds": time.process_time() - busy,
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[300, 1000, 3000])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--ripples", type=float, nargs="+", default=[0.2, 0.1, 0.05, 0.02])
    parser.add_argument("--together", type=float, default=0.005)
    parser.add_argument("--steps", type=float, nargs="*", default=[0.01, 0.005], help="over the way of the peak")
    parser.add_argument("--traverses", type=float, nargs="*", default=TRAVERSES, help="of explicit runs")
    parser.add_argument("--out", type=Path, default=FILE)
    options = parser.parse_args()
    begun = origin()
    cases = json.loads(options.out.read_text(encoding="utf-8"))["cases"] if options.out.exists() else []
    for count, seed in product(options.counts, options.seeds):
        bar = body(count, seed)
        case = next((one for one in cases if (one["count"], one["seed"]) == (count, seed)), None)
        if case is None:
            case = {"count": count, "seed": seed, "facets": len(bar.pairs), "explicit": [], "load factors": []}
            cases.append(case)
        for traverses in options.traverses:
            if traverses not in [one["traverses"] for one in case["explicit"]]:
                case["explicit"].append(explicit(bar, traverses))
        slow = case["explicit"][-1]["peak"] if case["explicit"] else None
        for ripple in options.ripples:
            known = [(one["ripple"], one["together"]) for one in case["load factors"]]
            if (ripple, options.together) not in known:
                case["load factors"].append(by_factors(bar, ripple, options.together))
        ways = case.setdefault("displacements", [])
        for part in options.steps:
            if part not in [one["part"] for one in ways]:
                ways.append(by_steps(bar, case["load factors"][-1]["way"], part))
        for one in ways:
            one["over explicit"] = one["peak"] / slow if slow else None
            print(count, seed, one, flush=True)
        for one in case["load factors"]:
            one["over explicit"] = one["peak"] / slow if slow else None
            shown = ("ripple", "over explicit", "work", "events", "solutions", "iterations", "seconds")
            print(count, seed, {key: one[key] for key in shown}, flush=True)
        keep(options.out, begun | {"cases": cases})


if __name__ == "__main__":
    main()
