"""The compression test of Celigueta et al. (2020) by the size of elements and by the gap over which they are bonded.

Their law, construction and plates, Rankine with 6 MPa, or Mohr and Coulomb with 14.5 MPa and 60°, friction 0.1, as in
`python -m validation celigueta`. Spheres whose centres are at most REACH (Ri + Rj) apart are bonded: 1.3 there, which
the paper does not print.

Run: python benchmarks/non_local_reach.py [--counts 300 1000 3000] [--reaches 1.1 1.3 1.5] [--seeds 1 2] [--out DIR]
     python benchmarks/non_local_reach.py --failure Mohr-Coulomb --counts 3000
     python benchmarks/non_local_reach.py --summary
Every run is kept in --out as soon as it is done.
"""

import argparse
import json
import time
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from kept import RESULTS, commit, keep, origin
from validation.rows.celigueta import DAMPING, LENGTH, RADIUS, CeliguetaRun, Fallen

#: How far the plates come together at the most [m], and their speed [m/s].
WAY, SPEED = 0.8e-3, 0.05
# Stresses, over the peak, between which E is read.
_ELASTIC = (0.2, 0.5)


def pressed(count: int, reach: float, seed: int, failure: str) -> dict[str, Any]:
    """One test: peak, E between the plates [Pa], force on the other plate over that at the peak, and what it took."""
    test = CeliguetaRun("compression", failure, "weighted", count, seed)
    particles = bd.pack(bd.Cylinder(radius=RADIUS, length=LENGTH), count=count, spread=0.25, seed=seed)
    body = bd.connect(particles, reach=reach)
    gauges = {"still": bd.WallGauge(0, "force"), "moving": bd.WallGauge(1, "force"),
              "way": bd.WallGauge(1, "displacement")}  # fmt: skip
    begun = time.perf_counter()
    run = bd.solve_explicit(
        test.model(body), duration=WAY / SPEED, damping=bd.LocalDamping(DAMPING), every=200, gauges=gauges,
        until=Fallen(test.axis, 0.3e6 * test.section),
    )  # fmt: skip
    stress, other = (np.abs(run.history[name][:, 0]) / test.section for name in ("moving", "still"))
    strain = np.abs(run.history["way"][:, 0]) / LENGTH
    peak = int(np.argmax(stress))
    first, last = (int(np.flatnonzero(stress >= share * stress[peak])[0]) for share in _ELASTIC)
    return {
        "count": count, "reach": reach, "seed": seed, "failure": failure,
        "z": 2.0 * len(body.pairs) / count, "peak": float(stress[peak]),
        "E_plates": float(np.polyfit(strain[first : last + 1], stress[first : last + 1], 1)[0]),
        "other": float(other[peak] / stress[peak]), "peak_strain": float(strain[peak]), "broken": len(run.events),
        "broken_at_peak": int((run.events.time <= run.history.time[peak]).sum()), "dt": run.dt,
        "steps": run.iterations, "status": run.status.value, "seconds": round(time.perf_counter() - begun, 1),
    }  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[300, 1000, 3000])
    parser.add_argument("--reaches", type=float, nargs="+", default=[1.1, 1.3, 1.5])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--failure", default="Rankine", choices=["Rankine", "Mohr-Coulomb"])
    parser.add_argument("--out", type=Path, default=Path("out/non_local_reach"))
    parser.add_argument("--summary", action="store_true", help="bring what is in --out into the results")
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    if given.summary:
        rows = [json.loads(file.read_text()) for file in given.out.glob("*.json")]
        rows.sort(key=lambda one: (one["failure"], one["count"], one["reach"], one["seed"]))
        begun = origin() | {"command": "python benchmarks/non_local_reach.py"}
        keep(RESULTS / "non_local_reach.json", begun | {"cases": rows})
        return
    for count in sorted(given.counts):
        for reach in given.reaches:
            for seed in given.seeds:
                file = given.out / f"{given.failure}-{count}-{reach:g}-seed{seed}.json"
                if file.exists():
                    continue
                row = pressed(count, reach, seed, given.failure)
                file.write_text(json.dumps(row | {"commit": commit()}))
                print(f"{given.failure}, {count} elements, reach {reach:g}, packing {seed}: {row}", flush=True)


if __name__ == "__main__":
    main()
