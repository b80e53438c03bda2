"""The small case of the fast part: one packing of 2000 spheres in the cylinder of fused silica, and one in a cell.

`python -m book.small [PACKINGS]` leaves means and standard deviations over as many packings in
`benchmarks/results/small.json`: what one packing of the fast part is held against.
"""

import datetime
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from book.results import Measurement

PACKINGS = Measurement("small", "python -m book.small 16", "4 min")
COUNT = 2000
SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
#: Bonds of the cell, and those of Table 2 of André et al. (2012).
CELL_LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.7)
PRINTED_LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
TESTS = {
    "tension": bd.labtests.clamped_tension,
    "bending": bd.labtests.static_bending,
    "torsion": bd.labtests.static_torsion,
}


def cylinder(seed: int) -> dict[str, float]:
    """Packing, calibration and static tests."""
    lattice = bd.connect(bd.pack(SHAPE, count=COUNT, spread=0.25, seed=seed, cache=False))
    quality = bd.fabric(lattice)
    fit = bd.calibrate(lattice, bd.materials.get("fused silica"), law=bd.EulerBernoulli)
    tension = bd.labtests.static_tension(lattice, fit.law)
    printed = bd.labtests.static_tension(lattice, PRINTED_LAW)
    found = {
        "volume_fraction": quality.volume_fraction,
        "coordination_number": quality.coordination_number,
        "core_rms_excess": quality.core_rms_excess,
        "isotropy_error": quality.isotropy_error,
        "E_mu": fit.law.E,
        "radius_ratio": fit.law.radius_ratio or 0.0,
        "E": tension.E,
        "nu": tension.nu,
        "E_printed": printed.E,
        "nu_printed": printed.nu,
    }
    for name, test in TESTS.items():
        outcome = test(lattice, fit.law, E=tension.E, nu=tension.nu, gyration=tension.gyration)
        found |= {f"{name}_error": outcome.error, f"{name}_refined": outcome.error_refined}
    return {name: float(value) for name, value in found.items() if value is not None}


def cell(seed: int) -> bd.Lattice:
    """A packing without walls."""
    return bd.connect(bd.pack(bd.Cell(size=(1.0, 1.0, 1.0)), count=COUNT, spread=0.25, seed=seed, cache=False))


def moduli(lattice: bd.Lattice) -> dict[str, float]:
    """Of the cell: E over E_μ, and ν."""
    found = bd.bulk_moduli(lattice, CELL_LAW)
    return {"cell_E_ratio": found.E / CELL_LAW.E, "cell_nu": found.nu}


def materials(lattice: bd.Lattice) -> list[dict[str, Any]]:
    """What the library has, and what the cell has when it is calibrated for it with the law that is recommended."""
    rows = []
    for name in bd.materials.names():
        material = bd.materials.get(name)
        fit = bd.calibrate(lattice, material)
        law = type(fit.law).__name__
        target = {"E": material.E, "nu": material.nu, "rho": material.rho}
        rows.append({"name": material.name, "law": law, **target, "E_error": fit.E / material.E - 1.0,
            "nu_error": fit.nu - material.nu})
    return rows


def measure(out: Path) -> None:
    """Seed 1, into a file."""
    lattice = cell(1)
    results = {"cylinder": cylinder(1), "cell": moduli(lattice), "materials": materials(lattice)}
    out.write_text(json.dumps(results, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def main(packings: int) -> None:
    """Keep what the tolerances of the fast part rest on."""
    rows = []
    for seed in range(1, packings + 1):
        rows.append(cylinder(seed) | moduli(cell(seed)))
        print(f"seed {seed}: E_μ {rows[-1]['E_mu'] / 1e9:.1f} GPa", flush=True)
    samples = {name: [row[name] for row in rows] for name in rows[0]}
    kept = {
        "packings": packings,
        "count": COUNT,
        "date": datetime.datetime.now(datetime.UTC).date().isoformat(),
        "version": bd.__version__,
        "numbers": {
            name: {"mean": float(np.mean(values)), "std": float(np.std(values, ddof=1)), "values": values}
            for name, values in samples.items()
        },
    }
    PACKINGS.path.write_text(json.dumps(kept, indent=1, allow_nan=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 16)
