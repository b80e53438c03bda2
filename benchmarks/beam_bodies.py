"""Bodies of calibrated beam bonds against three-dimensional elasticity, in the shapes that cells are held against.

Euler–Bernoulli bonds are calibrated once for each of five materials, in periodic cells without any wall, and fill the
seven shapes of benchmarks/cell_bodies.py: as calibrated, and with E_μ and r̃ changed for the whole body by bondem's
surface correction (`fit.law_for`). The continua are those of the cells, and so are the quantities: E and ν of bars,
six free frequencies, and what loads on the clamped body do. Spheres are held and loaded at their centres, which lie R̄
inside of the faces: what a load does is compared with the continuum between these planes, in the beams' favour (with
faces held, several per cent of the length would be missing).

Run: python benchmarks/beam_bodies.py [--shapes …] [--materials …] [--count 10000] [--seed 1] [--out DIR]
     python benchmarks/beam_bodies.py --summary
Every case is kept in --out as soon as it is done, so that a run goes on where it was stopped. A run of all shapes and
materials sums them up in benchmarks/results/beam_bodies.json; the last command does so with what there is.
"""

import argparse
import json
import time
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from any_specimen import DEPTH, MATERIALS, MODES, SPREAD, cells, deflections
from cell_bodies import bodies, free_modes, mesh
from kept import RESULTS, commit, keep, origin
from matching import matched

#: Spheres of each calibrating cell, and how many cells.
CELL, CELLS = 10_000, 2
WAYS = ("calibrated", "corrected")


@cache
def fit(material: str) -> Any:
    """The bonds of a material."""
    return bd.calibrate(cells(CELL, CELLS), bd.materials.get(material), law=bd.EulerBernoulli)


@cache
def body(name: str, count: int, seed: int) -> bd.Lattice:
    return bd.connect(bd.pack(bodies()[name].shape, count=count, spread=SPREAD, seed=seed))


@cache
def clamped(name: str, nu: float, inside: float) -> dict[str, float]:
    """What each unit load does where it acts, for E = 1, between planes `inside` [m] of the faces."""
    one = bodies()[name]
    lever = inside * np.eye(3)["xyz".index(one.loaded[0])]
    motion = _between(name, inside).response(
        1.0, nu, held="x_min", loaded=one.loaded, loads=list(one.loads.values()), lever=lever.tolist()
    )
    pairs = zip(one.loads.items(), motion, strict=True)
    return {load: float(np.concatenate(values) @ moved) for (load, values), moved in pairs}


@cache
def _between(name: str, inside: float) -> Any:
    return mesh(name).between(inside, "x_min", bodies()[name].loaded)


def case(material: str, name: str, count: int, seed: int) -> dict[str, Any]:
    """One body: every quantity over that of the continuum, less one; of ν the difference."""
    lattice, found = body(name, count, seed), fit(material)
    target = found.material
    laws = (found.law, found.law_for(lattice))
    size = (bodies()[name].shape.volume / count) ** (1.0 / 3.0)
    return {
        "material": material, "shape": name, "nu": target.nu, "count": count, "seed": seed,
        "thickness": bodies()[name].thickness / size,
    } | {way: errors(lattice, law, found, name) for way, law in zip(WAYS, laws, strict=True)}  # fmt: skip


def errors(lattice: bd.Lattice, law: Any, found: Any, name: str) -> dict[str, float]:
    """Of one law in one body."""
    target, moving = found.material, lattice.connected
    rows: dict[str, float] = {}
    if bodies()[name].bar:
        bar = bd.labtests.static_tension(lattice, law, depth=DEPTH)
        rows |= {"E": bar.E / target.E - 1.0, "nu": bar.nu - target.nu}
    theory = free_modes(name, target.nu)
    modes = bd.solve_modes(bd.Model(lattice, law, found.density_for(lattice)), count=MODES + 3)
    expected = mesh(name).sampler(lattice.particles.position[moving])(theory.shape)
    groups = matched(modes, lattice.particles.volume[moving], theory, expected, moving)
    speed = np.sqrt(target.E / target.rho)
    each = [one.measured / (speed * one.reference) - 1.0 for one in groups for _ in one.modes]
    rows |= {f"f{k}": error for k, error in enumerate(each[:6], start=1)}
    exact = clamped(name, target.nu, lattice.particles.mean_radius)
    pushed = deflections(lattice, law, bodies()[name].loaded, bodies()[name].loads)
    return rows | {load: moved * target.E / exact[load] - 1.0 for load, moved in pushed.items()}


def worst(one: dict[str, Any], way: str) -> float:
    return max(map(abs, one[way].values()))


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shapes", nargs="+", default=list(bodies()), choices=list(bodies()))
    parser.add_argument("--materials", nargs="+", default=list(MATERIALS), choices=list(MATERIALS))
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, default=Path("out/beam_bodies"))
    parser.add_argument("--summary", action="store_true", help="sum up what is in --out")
    given = parser.parse_args(arguments)
    if given.summary:
        sum_up(given.out)
        return
    given.out.mkdir(parents=True, exist_ok=True)
    for name, material in product(given.shapes, given.materials):
        file = given.out / f"{name}-{material}-{given.count}-seed{given.seed}.json"
        if not file.exists():
            started = time.perf_counter()
            one = case(material, name, given.count, given.seed) | {"commit": commit()}
            file.write_text(json.dumps(one))
            said = ", ".join(f"{100 * worst(one, way):.1f} % {way}" for way in WAYS)
            print(f"{file.stem}: worst {said}; {time.perf_counter() - started:.0f} s", flush=True)
    if set(given.shapes) == set(bodies()) and set(given.materials) == set(MATERIALS):
        sum_up(given.out)


def sum_up(out: Path) -> None:
    """All cases in a folder."""
    begun = origin()
    cases = [json.loads(file.read_text()) for file in out.glob("*-seed*.json")]
    order, materials = list(bodies()), list(MATERIALS)
    cases.sort(key=lambda one: (order.index(one["shape"]), materials.index(one["material"]), one["seed"]))
    keep(RESULTS / "beam_bodies.json", begun | {"cell": CELL, "cells": CELLS, "cases": cases})
    for name in dict.fromkeys(one["shape"] for one in cases):
        mine = [one for one in cases if one["shape"] == name]
        said = ", ".join(f"{100 * max(worst(one, way) for one in mine):.1f} % {way}" for way in WAYS)
        print(f"{name}, {len(mine)} bodies: worst {said}")


if __name__ == "__main__":
    main()
