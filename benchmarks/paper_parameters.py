"""Fused silica with the bonds that André et al. (2012) print in Table 2, on packings of ours.

    python benchmarks/paper_parameters.py [--count 10000] [--packings 5] [--out FILE]          about a minute

E_μ = 265 GPa, ν_μ = 0.3, r̃ = 0.71 in the paper's cylinder, packed to 6.2 contacts a sphere (its limit) and to the
onset of jamming: what E and ν come to depends on the packing. Leaves benchmarks/results/paper_parameters.json, SI.
"""

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd

RESULTS = Path(__file__).parent / "results" / "paper_parameters.json"
SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
TARGETS: dict[str, dict[str, Any]] = {"contacts": {}, "jamming": {"jamming": True}}


def packings(count: int, seeds: int, target: dict[str, Any]) -> dict[str, Any]:
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


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--packings", type=int, default=5)
    parser.add_argument("--out", type=Path, default=RESULTS)
    options = parser.parse_args(arguments)
    results = {name: packings(options.count, options.packings, target) for name, target in TARGETS.items()}
    results |= {"elements": options.count, "version": bd.__version__}
    options.out.write_text(json.dumps(results, indent=1, allow_nan=False) + "\n")


if __name__ == "__main__":
    main()
