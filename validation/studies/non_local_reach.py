"""The compression test of Celigueta et al. (2020) by the size of elements and by the gap over which they are bonded.

Their law, construction and plates, Rankine with 6 MPa, or Mohr and Coulomb with 14.5 MPa and 60°, friction 0.1, as in
`python -m validation celigueta`. Spheres whose centres are at most REACH (Ri + Rj) apart are bonded: 1.3 there, which
the paper does not print.
"""

from functools import partial
from itertools import product
from typing import Any, Literal

import bondem as bd
from validation.frame.files import plain
from validation.frame.record import Record
from validation.rows.celigueta import LENGTH, RADIUS, CeliguetaRun


def pressed(count: int, reach: float, seed: int, failure: str) -> dict[str, Any]:
    """One test, as those of `python -m validation celigueta` are read."""
    test = CeliguetaRun("compression", failure, "weighted", count, seed)
    particles = bd.pack(bd.Cylinder(radius=RADIUS, length=LENGTH), count=count, spread=0.25, seed=seed)
    body = bd.connect(particles, reach=reach)
    found = plain(test.read(body, test.run(test.model(body))))
    return {name: value for name, value in found.items() if name != "curve"}


def measure(
    record: Record, *, counts: tuple[int, ...] = (300, 1000, 3000), reaches: tuple[float, ...] = (1.1, 1.3, 1.5),
    seeds: tuple[int, ...] = (1, 2), failure: Literal["Rankine", "Mohr-Coulomb"] = "Rankine",
) -> None:  # fmt: skip
    """Press cylinders of several numbers of elements."""
    for count, reach, seed in product(sorted(counts), reaches, seeds):
        case = {"count": count, "reach": reach, "seed": seed, "failure": failure}
        record.add(partial(pressed, **case), **case)
    record.rows().sort(key=lambda one: (one["failure"], one["count"], one["reach"], one["seed"]))
    record.keep()
