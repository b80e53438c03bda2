"""The compression test of Celigueta et al. (2020) by the size of elements and by the gap over which they are bonded.

Their law, construction and plates, Rankine with 6 MPa, or Mohr and Coulomb with 14.5 MPa and 60°, friction 0.1, as in
`python -m validation celigueta`. Spheres whose centres are at most REACH (Ri + Rj) apart are bonded: 1.3 there, which
the paper does not print.
"""

import time
from functools import partial
from itertools import product
from typing import Any, Literal

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.rows.celigueta import LENGTH, RADIUS, CeliguetaRun

# Stresses, over the peak, between which E is read.
_ELASTIC = (0.2, 0.5)


def pressed(count: int, reach: float, seed: int, failure: str) -> dict[str, Any]:
    """One test: peak, E between the plates [Pa], force on the other plate over that at the peak, and what it took."""
    test = CeliguetaRun("compression", failure, "weighted", count, seed)
    particles = bd.pack(bd.Cylinder(radius=RADIUS, length=LENGTH), count=count, spread=0.25, seed=seed)
    body = bd.connect(particles, reach=reach)
    begun = time.perf_counter()
    run = test.run(test.model(body))
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
