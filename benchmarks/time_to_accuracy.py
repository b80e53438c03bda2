"""Time to a given accuracy: cells, calibrated beam bonds and quadratic finite elements on the same body.

The body is a beam of fused silica, 40 × 5 × 5 mm, free. Each method is refined; for each size it is made from
nothing (packed, cut or bonded, calibrated where it has to be; or meshed) and solved for its first six frequencies.
The error is the largest of the six against a finer mesh of triquadratic hexahedra. Beams are calibrated on the same
packing, for E, ν and ρ (`bd.calibrate`). All is compiled beforehand. Two packings of each size.

Run: python benchmarks/time_to_accuracy.py
It writes benchmarks/results/time_to_accuracy.json.
"""

import argparse
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import bondem as bd
from continuum import Continuum
from kept import RESULTS, keep, origin

SIZE = (40e-3, 5e-3, 5e-3)
SILICA = bd.materials.fused_silica
SEEDS = (1, 2)
CELLS, BEAMS = (150, 300, 600, 1200, 2500, 5000, 10_000), (1200, 2500, 5000, 10_000)
MESHES = (5e-3, 2.5e-3, 1.67e-3)
FINEST = 1.25e-3


def of_cells(count: int, seed: int) -> np.ndarray:
    body = bd.connect(bd.pack(bd.Box(SIZE), count=count, method="even", seed=seed), method="laguerre")
    return bd.solve_modes(bd.Model(body, bd.CellBond(E=SILICA.E, nu=SILICA.nu), SILICA.rho), count=6).frequency


def of_beams(count: int, seed: int) -> np.ndarray:
    lattice = bd.connect(bd.pack(bd.Box(SIZE), count=count, spread=0.25, seed=seed))
    fit = bd.calibrate(lattice, SILICA)
    return bd.solve_modes(bd.Model(lattice, fit.law, fit.density), count=6).frequency


def of_mesh(cell: float) -> np.ndarray:
    return Continuum.box(SIZE, cell=cell).vibration(SILICA.E, SILICA.nu, SILICA.rho, count=6).frequency


def row(name: str, size: float, seed: int | None, exact: np.ndarray, make: Callable[[], Any]) -> dict[str, Any]:
    began = time.perf_counter()
    found = make()
    taken = time.perf_counter() - began
    error = float(np.abs(np.sort(found)[:6] / exact - 1.0).max())
    print(f"{name:>6} {size:<8g} seed {seed}: {taken:.2f} s, worst of six {100 * error:.2f} %", flush=True)
    return {"method": name, "size": size, "seed": seed, "seconds": taken, "error": error}


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args(arguments)
    begun = origin()
    exact = np.sort(of_mesh(FINEST))[:6]
    of_cells(150, 3), of_beams(1200, 3)  # compiles
    rows = [row("cells", n, s, exact, lambda n=n, s=s: of_cells(n, s)) for n in CELLS for s in SEEDS]
    rows += [row("beams", n, s, exact, lambda n=n, s=s: of_beams(n, s)) for n in BEAMS for s in SEEDS]
    rows += [row("mesh", c, None, exact, lambda c=c: of_mesh(c)) for c in MESHES]
    first = {}
    for name in ("cells", "beams", "mesh"):
        sizes = dict.fromkeys(one["size"] for one in rows if one["method"] == name)
        groups = [[one for one in rows if one["method"] == name and one["size"] == size] for size in sizes]
        good = [group for group in groups if max(one["error"] for one in group) <= 0.01]
        quick = min(good, key=lambda group: max(one["seconds"] for one in group), default=None)
        if quick is not None:
            first[name] = {"size": quick[0]["size"], "seconds": max(one["seconds"] for one in quick)}
    print("within 1 % on all packings:", first)
    found = {"exact_Hz": exact.tolist(), "within_1_percent": first, "rows": rows}
    keep(RESULTS / "time_to_accuracy.json", begun | found)


if __name__ == "__main__":
    main()
