"""The compression test of Celigueta et al. (2020) by the size of elements and by the gap over which they are bonded.

Their law, construction and plates, Rankine with 6 MPa, friction 0.1, as in `python -m validation celigueta`. Spheres
whose centres are at most REACH (Ri + Rj) apart are bonded: 1.3 there, which the paper does not print.

Run: python benchmarks/non_local_reach.py [--counts 300 1000 3000] [--reaches 1.1 1.3 1.5] [--seeds 1 2] [--out DIR]
     python benchmarks/non_local_reach.py --summary
Every run is kept in --out as soon as it is done.
"""

import argparse
import json
from dataclasses import dataclass
from pathlib import Path

from bondem.packing import pack
from bondem.specimen.bonding import connect
from bondem.specimen.geometry import Cylinder
from bondem.specimen.lattice import Lattice
from kept import RESULTS, commit, keep, origin
from validation.rows.celigueta import LENGTH, RADIUS, CeliguetaRun

#: Of what a run measures.
_KEPT = ("bonds", "z", "dt", "steps", "status", "peak", "peak_still", "peak_strain", "broken", "broken_at_peak",
         "E_plates", "E_inside", "ledger", "run_seconds")  # fmt: skip


@dataclass(frozen=True)
class Reached(CeliguetaRun):
    """A test of the paper with another reach of bonds.

    Attributes:
        reach: largest distance of bonded centres over the sum of their radii [-].
    """

    reach: float = 1.3

    @property
    def readable(self) -> str:
        """See `Request`."""
        return f"reach{self.reach:g}_{super().readable}"

    def body(self) -> Lattice:
        """See `CeliguetaRun`."""
        cylinder = Cylinder(radius=RADIUS, length=LENGTH)
        return connect(pack(cylinder, count=self.count, spread=0.25, seed=self.seed), reach=self.reach)


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[300, 1000, 3000])
    parser.add_argument("--reaches", type=float, nargs="+", default=[1.1, 1.3, 1.5])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--out", type=Path, default=Path("out/non_local_reach"))
    parser.add_argument("--summary", action="store_true", help="bring what is in --out into the results")
    given = parser.parse_args(arguments)
    given.out.mkdir(parents=True, exist_ok=True)
    if given.summary:
        rows = [json.loads(file.read_text()) for file in given.out.glob("*.json")]
        rows.sort(key=lambda one: (one["count"], one["reach"], one["seed"]))
        begun = origin() | {"command": "python benchmarks/non_local_reach.py"}
        keep(RESULTS / "non_local_reach.json", begun | {"cases": rows})
        return
    for count in sorted(given.counts):
        for reach in given.reaches:
            for seed in given.seeds:
                file = given.out / f"{count}-{reach:g}-seed{seed}.json"
                if file.exists():
                    continue
                run = Reached("compression", "Rankine", "weighted", count, seed, reach=reach)
                found = run.measured(given.out)
                row = {"count": count, "reach": reach, "seed": seed} | {name: found[name] for name in _KEPT}
                file.write_text(json.dumps(row | {"commit": commit()}))
                print(f"{count} elements, reach {reach:g}, packing {seed}: {row}", flush=True)


if __name__ == "__main__":
    main()
