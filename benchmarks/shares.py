"""Time of the balanced shares of facets, compared with the cut into cells of which they are a part.

A cylinder is filled with even centres and cut several times. The time of the shares is measured within the same call,
so that both times belong to one process and one moment. The remainder of the shares is the error of θ under a unit
strain.

Run: python benchmarks/shares.py [--elements 10000 100000] [--repeat 5] [--threads 2]
It writes benchmarks/results/shares.json.
"""

import argparse
import time
from typing import Any

import numpy as np

import bondem as bd
from bondem._threads import threads
from bondem.specimen.tessellation import balance_solver, balanced_shares, facet_tables
from kept import RESULTS, keep, origin, spread

SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)


def measure(count: int, repeat: int) -> dict[str, Any]:
    """Return seconds of whole cuts and of the shares in them, and iterations and remainders of the shares."""
    particles = bd.pack(SHAPE, count=count, method="even", seed=1)
    plain, solver = facet_tables.balanced_shares, balance_solver.cg
    cut, shares, rounds = [], [], [0]

    def timed(*arguments: Any) -> balanced_shares.Shares:
        began = time.perf_counter()
        found = plain(*arguments)
        shares.append(time.perf_counter() - began)
        return found

    def counted(*arguments: Any, **options: Any) -> Any:
        rounds[0] = 0
        return solver(*arguments, callback=lambda _: rounds.__setitem__(0, rounds[0] + 1), **options)

    facet_tables.balanced_shares, balance_solver.cg = timed, counted
    try:
        for _ in range(repeat):
            began = time.perf_counter()
            body = bd.connect(particles, method="laguerre")
            cut.append(time.perf_counter() - began)
    finally:
        facet_tables.balanced_shares, balance_solver.cg = plain, solver
    assert body.cells is not None
    remainder = body.cells.remainder
    return {
        "elements": count, "facets": len(body.pairs), "iterations": rounds[0],
        "connect_seconds": spread(cut), "shares_seconds": spread(shares),
        "over_cut": spread([own / (whole - own) for whole, own in zip(cut, shares, strict=True)]),
        "remainder": {"rms": float(np.sqrt((remainder**2).mean())), "max": float(remainder.max())},
    }  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="+", default=[10_000, 100_000])
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--threads", type=int, default=2)
    given = parser.parse_args(arguments)
    begun, rows = origin(), []
    with threads(given.threads):
        for count in given.elements:
            rows.append(measure(count, given.repeat))
            print(rows[-1], flush=True)
    keep(RESULTS / "shares.json", begun | {"threads": given.threads, "rows": rows})


if __name__ == "__main__":
    main()
