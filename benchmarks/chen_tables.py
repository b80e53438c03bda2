"""Chen et al. (2022), Tables 3, 4 and 5: what the cases of `chen_cases.py` are, static tips, and a bond's stiffness.

    python benchmarks/chen_tables.py [--out FILE]          a few seconds

Leaves benchmarks/results/chen_tables.json, SI.
"""

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from chen_cases import CASES, bond, static_cases

RESULTS = Path(__file__).parent / "results" / "chen_tables.json"


def cases() -> dict[str, dict[str, Any]]:
    """Table 3, read off the specimens: from the least to the largest of each quantity."""
    found = {}
    for case, variants in CASES.items():
        measures: dict[str, list[float]] = {"length": [], "slenderness": [], "element_radius": [], "bond_radius": []}
        gap = 0.0
        for lattice, radius, _ in variants.values():
            x, R = lattice.particles.position[:, 0], lattice.particles.radius
            measures["length"].append(x[-1] - x[0])
            measures["slenderness"] += (np.diff(x) / (2.0 * radius)).tolist()
            measures["element_radius"] += R.tolist()
            measures["bond_radius"].append(radius)
            gap = max(gap, float(np.abs(np.diff(x) - R[:-1] - R[1:]).max()))
        found[case] = {name: [min(values), max(values)] for name, values in measures.items()} | {"gap": gap > 1e-9}
    return found


def stiffnesses() -> list[dict[str, float]]:
    """Table 5: axial and shear stiffness of a bond in case 3 [N/m]."""
    rows = []
    for n, (lattice, radius, _) in CASES["3"].items():
        laws = {law: bd.Model(lattice, bond(law, radius), 1000.0).stiffness for law in ("PBM", "EBBM", "TBBM")}
        shear = {law: float(k.ks[0]) for law, k in laws.items()}
        rows.append({"bonds": n, "axial": float(laws["PBM"].kn[0])} | shear)
    return rows


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=RESULTS)
    out = parser.parse_args(arguments).out
    tips = [entry for entry in static_cases() if entry["case"] == "1"]
    results = {"table3": cases(), "table4": tips, "table5": stiffnesses(), "version": bd.__version__}
    out.write_text(json.dumps(results, indent=1, allow_nan=False) + "\n")


if __name__ == "__main__":
    main()
