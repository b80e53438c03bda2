"""Chen et al. (2022), Tables 3, 4 and 5: what the cases of `chen.py` are, static tips, and a bond's stiffness."""

from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.studies.chen import CASES, bond, static_cases


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


def measure(record: Record) -> None:
    """Evaluate the tables."""
    record.keep(table3=cases(), table4=[one for one in static_cases() if one["case"] == "1"], table5=stiffnesses())
