"""Packings of 2000 spheres of fused silica: means and scatter that a test holds one packing against."""

import numpy as np

import bondem as bd
from validation.frame.record import Record

COUNT, SHAPE = 2000, bd.Cylinder(radius=5e-3, length=40e-3)
#: Bonds of the cell, and those of Table 2 of André et al. (2012).
CELL_LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.7)
PRINTED_LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
TESTS = {
    "tension": bd.labtests.clamped_tension, "bending": bd.labtests.static_bending,
    "torsion": bd.labtests.static_torsion,
}  # fmt: skip


def cylinder(seed: int) -> dict[str, float]:
    """Return measures of a packing in the cylinder, of its calibration, and of static tests."""
    lattice = bd.connect(bd.pack(SHAPE, count=COUNT, spread=0.25, seed=seed, cache=False))
    quality = bd.fabric(lattice)
    fit = bd.calibrate(lattice, bd.materials.fused_silica, law=bd.EulerBernoulli)
    tension, printed = (bd.labtests.static_tension(lattice, law) for law in (fit.law, PRINTED_LAW))
    names = ("volume_fraction", "coordination_number", "core_rms_excess", "isotropy_error")
    found = {name: getattr(quality, name) for name in names} | {
        "E_mu": fit.law.E, "radius_ratio": fit.law.radius_ratio, "E": tension.E, "nu": tension.nu,
        "E_printed": printed.E, "nu_printed": printed.nu,
    }  # fmt: skip
    for name, test in TESTS.items():
        outcome = test(lattice, fit.law, E=tension.E, nu=tension.nu, gyration=tension.gyration)
        found |= {f"{name}_error": outcome.error, f"{name}_refined": outcome.error_refined}
    return {name: float(value) for name, value in found.items()}


def cell(seed: int) -> bd.Lattice:
    """Return a packing without walls."""
    return bd.connect(bd.pack(bd.Cell(size=(1.0, 1.0, 1.0)), count=COUNT, spread=0.25, seed=seed, cache=False))


def moduli(lattice: bd.Lattice) -> dict[str, float]:
    """Return E over E_μ, and ν, of the cell."""
    found = bd.bulk_moduli(lattice, CELL_LAW)
    return {"cell_E_ratio": found.E / CELL_LAW.E, "cell_nu": found.nu}


def measure(record: Record, *, packings: int = 16) -> None:
    rows = [cylinder(seed) | moduli(cell(seed)) for seed in range(1, packings + 1)]
    samples = {name: [row[name] for row in rows] for name in rows[0]}
    record.keep(packings=packings, count=COUNT, numbers={
        name: {"mean": float(np.mean(values)), "std": float(np.std(values, ddof=1)), "values": values}
        for name, values in samples.items()
    })  # fmt: skip
