"""A flat joint that slips by three edges of its facets under a pressure: its friction with and without contact.

python benchmarks/joint_slip.py [--label after] [--quick] [--out FILE]

A box is cut in halves by a joint with cohesion c and tan φ, on which cells end; the halves are strong. Its ends press
with p, by a thickness that is held or by a dead pressure, and shear the joint. Once c is spent, the shear traction T
is p tan φ: T/(p tan φ) is a mean over each half edge of slip. A held thickness presses where halves still overlap, a
share 1 - slip/L of the joint. Labels name the code that was measured; cases in the file are not run again.
"""

import argparse
import json
import warnings
from pathlib import Path

import numpy as np

import bondem as bd
from bondem._threads import threads
from kept import RESULTS, keep, origin

LENGTH, HEIGHT, E, RHO = 20e-3, 8e-3, 20e9, 2400.0
COHESION, PHI, PRESSURE, G_SHEAR = 2e6, 0.5, 4e6, 100.0
EDGES = 3.0
CONTACTS = {
    "none": None,
    "LinearContact": bd.LinearContact(E=E, friction=np.tan(PHI)),
    "HertzMindlin": bd.HertzMindlin(E=E, nu=0.2, friction=np.tan(PHI)),
}
CASES = [
    *((way, "LinearContact", seed, n) for n in (240, 320) for way in ("held", "dead") for seed in (1, 2, 3, 4, 5)),
    *((way, "HertzMindlin", seed, 240) for way in ("held", "dead") for seed in (1, 2)),
    *((way, "none", 1, 240) for way in ("held", "dead")),
]  # fmt: skip


def slipped(way: str, contact: str, seed: int, count: int) -> dict:
    """What the joint of one packing carries."""
    plane = bd.Plane(point=(0, 0, HEIGHT / 2), normal=(0, 0, 1))
    packing = bd.pack(bd.Box((LENGTH, LENGTH, HEIGHT)), count=count, method="even", seed=seed, around=plane)
    body = bd.connect(packing, method="laguerre")
    far = bd.Box((3 * LENGTH,) * 3)
    low, up = (bd.Within(far.moved((-LENGTH, -LENGTH, HEIGHT / 2 - z))) for z in (3 * LENGTH, 0.0))
    i, j = body.pairs.T
    upper = np.zeros(len(body.centre), dtype=bool)
    upper[up.select(body)] = True
    edge = float(np.sqrt(np.median(body.facets.area[upper[i] != upper[j]])))
    strong = bd.MohrCoulomb(tension=80e6, cohesion=300e6, friction_angle=PHI, fracture_energy=5e4)
    joint = bd.MohrCoulomb(
        tension=1e6, cohesion=COHESION, friction_angle=PHI, fracture_energy=10.0, fracture_energy_shear=G_SHEAR
    )
    sound = np.sqrt(E / RHO)
    rise = 100 * LENGTH / sound
    duration, distance = 22 * rise, (EDGES + 0.15) * edge
    slide = bd.Ramp(0, distance / (duration - 1.5 * rise), 0.5 * rise, begin=1.2 * rise)
    top, closing = bd.Face("z_max"), bd.Ramp(0, -PRESSURE / E * HEIGHT, rise)
    press = [bd.Drive(top, z=closing, vx=slide, vy=0.0)]
    if way == "dead":
        press = [bd.Drive(top, vx=slide, vy=0.0), bd.Pressure(top, PRESSURE, schedule=bd.Ramp(0, 1, rise))]
    model = bd.Model(
        body, bd.CellBond(E=E, nu=0.0), density=RHO, contact=CONTACTS[contact],
        failure={bd.Everything(): strong, (low, up): joint}, boundary=[bd.Fix(bd.Face("z_min")), *press],
    )  # fmt: skip
    with warnings.catch_warnings(record=True) as said, threads(1):
        warnings.simplefilter("always")
        run = bd.solve_explicit(
            model, duration=duration, every=50, damping=bd.MassDamping(0.4 * np.pi * sound / LENGTH),
            gauges={"force": bd.Gauge(bd.Face("z_min"), "force"), "moved": bd.Gauge(top, "displacement")},
        )  # fmt: skip
    slip = run.history["moved"][:, 0]
    stress = run.history["force"] / LENGTH**2 / PRESSURE
    friction, energy = -stress[:, 0] / np.tan(PHI), run.history.energy
    rows = [(slip >= a * edge) & (slip < (a + 0.5) * edge) & (slip > 0.2 * edge) for a in np.arange(0, EDGES, 0.5)]
    overlap = np.array([1.0 - slip[row].mean() / LENGTH if way == "held" and row.any() else 1.0 for row in rows])
    mean = np.array([friction[row].mean() if row.any() else 0.0 for row in rows])
    return {
        "press": way, "contact": contact, "seed": seed, "cells": count, "edges": float(slip[-1] / edge),
        "friction": np.round(mean, 3).tolist(), "of_overlap": np.round(mean / overlap, 3).tolist(),
        "normal": np.round([stress[row, 2].mean() if row.any() else 0.0 for row in rows], 3).tolist(),
        "least_integrity": float(run.state.bond_integrity[upper[i] == upper[j]].min()),
        "ledger": float(np.abs(energy["balance"]).max() / energy["work"].max()),
        "warnings": sorted({str(one.message).split(",")[0] for one in said if "overlap" in str(one.message)}),
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--label", default="after")
    parser.add_argument("--quick", action="store_true", help="one packing of each kind")
    parser.add_argument("--out", type=Path, default=RESULTS / "joint_slip.json")
    options = parser.parse_args()
    kept = json.loads(options.out.read_text(encoding="utf-8")) if options.out.exists() else {}
    rows = kept.get(options.label, {}).get("rows", [])
    report = kept | {options.label: {**origin(), "rows": rows}}
    known = {(row["press"], row["contact"], row["seed"], row["cells"]) for row in rows}
    for case in CASES:
        if case in known or (options.quick and case[2:] != (1, 240)):
            continue
        rows.append(slipped(*case))
        print(rows[-1], flush=True)
        keep(options.out, report)


if __name__ == "__main__":
    main()
