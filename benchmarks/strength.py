"""Strengths and fracture energies of bodies of cells: what is put in, and what tests to failure give back.

A concrete: E = 40 GPa, ν = 0.2, f_t = 4 MPa, c = 14.3 MPa, φ = 35°. Direct tension of a bar, plain and notched on one
side to a third of its depth: peak over f_t, and work over the ligament and G_f. Compression between smooth platens,
with a pressure on the sides or without: peak over what a Mohr–Coulomb continuum bears. Nothing is calibrated.
Without fracture energy a notched bar has the toughness of its elements: σ √(π a) over f_t √d is the same for all
sizes d, with σ the largest stress of the whole section, a the depth of the notch, and no factor for the shape; "slit"
is a notch half a cell wide, where the root of the notch has no size of its own.

Run: python benchmarks/strength.py [--kinds tension notched slit brittle compression triaxial]
         [--counts 1000 3000 10000] [--seeds 1 2 3 4 5] [--out DIR] [--anew]
     python benchmarks/strength.py --summary
Every case is kept in --out as soon as it is done, so that a run goes on where it was stopped; the last command sums
them up in benchmarks/results/strength.json, with those that are there already and were not done anew.
Without --anew these are not done again.
"""

import argparse
import json
import math
import time
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from kept import RESULTS, commit, keep, origin

LAW = bd.CellBond(E=40e9, nu=0.2)
TENSION, COHESION, ANGLE = 4e6, 14.3e6, math.radians(35.0)
SIZE = (60e-3, 30e-3, 30e-3)
NOTCH = (3e-3, 10e-3)  # width along x, depth along y
#: Allowed distance from what was put in [-].
LIMIT = 0.05


@dataclass(frozen=True)
class Case:
    """One test.

    Attributes:
        kind: of test.
        energy: G_f [J/m²] in tension, G_II in compression; 0 is brittle.
        pressure: on the sides [Pa].
    """

    kind: str
    energy: float
    pressure: float = 0.0


CASES = (
    Case("tension", 20.0), Case("tension", 80.0), Case("notched", 20.0), Case("notched", 80.0), Case("brittle", 0.0),
    Case("notched", 0.0), Case("slit", 0.0),
    Case("compression", 50.0), Case("compression", 500.0), Case("compression", 5000.0),
    Case("triaxial", 500.0, 5e6), Case("triaxial", 500.0, 10e6), Case("triaxial", 5000.0, 5e6),
    Case("triaxial", 5000.0, 10e6),
)  # fmt: skip


def specimen(kind: str, count: int, seed: int) -> bd.Lattice:
    shape: bd.Shape = bd.Box(SIZE)
    if kind in ("notched", "slit"):
        width = NOTCH[0] if kind == "notched" else 0.5 * (math.prod(SIZE) / count) ** (1.0 / 3.0)
        slot = bd.Box((width, NOTCH[1], 2.0 * SIZE[2]))
        shape = shape - slot.moved((0.5 * (SIZE[0] - width), 0.0, -0.5 * SIZE[2]))
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed), method="laguerre")


def measured(case: Case, count: int, seed: int) -> dict[str, Any]:
    """One test of one specimen: ratios to what was put in, and how far from statics it was."""
    body = specimen(case.kind, count, seed)
    begun = time.perf_counter()
    rows: dict[str, float] = {}
    if case.kind in ("compression", "triaxial"):
        failure = bd.MohrCoulomb(
            tension=TENSION, cohesion=COHESION, friction_angle=ANGLE, fracture_energy=50.0,
            fracture_energy_shear=case.energy,
        )  # fmt: skip
        test = bd.labtests.uniaxial_compression(body, LAW, failure, pressure=case.pressure)
        assert failure.softening is not None
        assert failure.softening.slip is not None
        rows["strength"] = test.peak / failure.softening.slip.compressive(case.pressure)
    else:
        failure = bd.Rankine(tension=TENSION, fracture_energy=case.energy or None)
        test = bd.labtests.direct_tension(body, LAW, failure)
        if case.kind not in ("notched", "slit"):
            rows["strength"] = test.peak / TENSION
        if case.energy:
            rows["energy"] = test.work / case.energy  # over the section at mid-length, the ligament
    assert body.facets is not None
    length = float(np.median(body.facets.span))
    toughness = {}
    if case.kind in ("notched", "slit") and not case.energy:
        gross = test.peak * (1.0 - NOTCH[1] / SIZE[1])
        toughness = {"toughness": gross * math.sqrt(math.pi * NOTCH[1]) / (TENSION * math.sqrt(length))}
    return toughness | {
        "kind": case.kind, "energy": case.energy, "pressure": case.pressure, "count": count, "seed": seed,
        "length": length, "ratios": rows, "peak": test.peak, "E": test.E / LAW.E,
        "asymmetry": test.asymmetry, "kinetic": test.kinetic, "residual": test.residual,
        "steps": test.run.iterations, "seconds": time.perf_counter() - begun, "cracks": len(test.state.cracks),
        "broken": len(test.run.events), "status": test.run.status.value,
    }  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = sorted({case.kind for case in CASES})
    parser.add_argument("--kinds", nargs="+", default=kinds, choices=kinds)
    parser.add_argument("--counts", type=int, nargs="+", default=[1000, 3000, 10_000])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4, 5])
    parser.add_argument("--out", type=Path, default=Path("out/strength"))
    parser.add_argument("--summary", action="store_true", help="sum up what is in --out and in the results")
    parser.add_argument("--anew", action="store_true", help="cases that are in the results too")
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    if given.summary:
        sum_up(given.out)
        return
    done = {} if given.anew else kept()
    for count, seed, case in product(given.counts, given.seeds, CASES):
        file = given.out / f"{case.kind}-{case.energy:g}-{case.pressure / 1e6:g}-{count}-seed{seed}.json"
        known = (case.kind, case.energy, case.pressure, count, seed) in done
        if case.kind in given.kinds and not known and not file.exists():
            found = measured(case, count, seed)
            file.write_text(json.dumps(found | {"commit": commit()}))
            print(f"{file.stem}: {found['ratios']}, {found['seconds']:.0f} s", flush=True)


def kept() -> dict[tuple[object, ...], dict[str, Any]]:
    """Cases of the results, by kind, energy, pressure, count and seed."""
    file = RESULTS / "strength.json"
    cases = json.loads(file.read_text())["cases"] if file.exists() else []
    return {tuple(one[name] for name in ("kind", "energy", "pressure", "count", "seed")): one for one in cases}


def sum_up(out: Path) -> None:
    """All cases in a folder and in the results in one record."""
    begun, found = origin(), kept()
    for file in out.glob("*.json"):
        one = json.loads(file.read_text())
        found[tuple(one[name] for name in ("kind", "energy", "pressure", "count", "seed"))] = one
    cases = sorted(found.values(), key=lambda one: one["seed"])
    judged = [one for one in cases if one["ratios"]]
    within = sum(all(abs(ratio - 1.0) <= LIMIT for ratio in one["ratios"].values()) for one in judged)
    told = f"{within} of {len(judged)} specimens within {100 * LIMIT:g} % in all that was measured"
    keep(RESULTS / "strength.json", begun | {"within": within, "cases": cases})
    print(told)


if __name__ == "__main__":
    main()
