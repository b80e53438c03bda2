"""Time of the balanced shares of facets, compared with the cut into cells of which they are a part.

A cylinder is filled with even centres and cut several times. The time of the shares is measured within the same call,
so that both times belong to one process and one moment. The remainder of the shares is the error of θ under a unit
strain.

Run: python benchmarks/shares.py [--elements 10000,100000] [--repeat 5] [--thread-count 2]
It writes benchmarks/results/shares.json.
"""

import time
from typing import Any

import numpy as np

import bondem as bd
from bondem._threads import threads
from bondem.specimen.tessellation import balance_solver, balanced_shares, facet_tables
from kept import Record, run, spread

SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)


def cut(count: int, repeat: int) -> dict[str, Any]:
    """Seconds of whole cuts and of the shares in them, iterations, and remainders."""
    particles = bd.pack(SHAPE, count=count, method="even", seed=1)
    plain, solver = facet_tables.balanced_shares, balance_solver.cg
    whole, shares, rounds = [], [], [0]

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
            whole.append(time.perf_counter() - began)
    finally:
        facet_tables.balanced_shares, balance_solver.cg = plain, solver
    assert body.cells is not None
    remainder = body.cells.remainder
    return {
        "elements": count, "facets": len(body.pairs), "iterations": rounds[0],
        "connect_seconds": spread(whole), "shares_seconds": spread(shares),
        "over_cut": spread([own / (both - own) for both, own in zip(whole, shares, strict=True)]),
        "remainder": {"rms": float(np.sqrt((remainder**2).mean())), "max": float(remainder.max())},
    }  # fmt: skip


def measure(
    record: Record, *, elements: tuple[int, ...] = (10_000, 100_000), repeat: int = 5, thread_count: int = 2
) -> None:
    with threads(thread_count):
        rows = [cut(count, repeat) for count in elements]
    record.keep(threads=thread_count, rows=rows)
    print(*rows, sep="\n")


if __name__ == "__main__":
    run()
