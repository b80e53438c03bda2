"""Fused silica with the bonds that André et al. (2012) print in Table 2, on packings of ours."""

from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record

SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
TARGETS: dict[str, dict[str, Any]] = {"contacts": {}, "jamming": {"jamming": True}}


def pulled(count: int, seeds: int, target: dict[str, Any]) -> dict[str, Any]:
    """Means, standard deviations and a row a packing."""
    rows = []
    for seed in range(1, seeds + 1):
        lattice = bd.connect(bd.pack(SHAPE, count=count, spread=0.25, seed=seed, **target))
        quality, tension = bd.fabric(lattice), bd.labtests.static_tension(lattice, LAW)
        rows.append(
            {"seed": seed, "E": tension.E, "nu": tension.nu, "coordination_number": quality.coordination_number,
             "volume_fraction": quality.volume_fraction}
        )  # fmt: skip
    values = {name: [row[name] for row in rows] for name in rows[0] if name != "seed"}
    return {
        "mean": {name: float(np.mean(found)) for name, found in values.items()},
        "std": {name: float(np.std(found, ddof=1)) if seeds > 1 else None for name, found in values.items()},
        "packings": rows,
    }


def measure(record: Record, *, count: int = 10_000, packings: int = 5) -> None:
    """Pull several packings to both targets."""
    record.keep(elements=count, **{name: pulled(count, packings, target) for name, target in TARGETS.items()})
