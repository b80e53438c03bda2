"""How much of a Rankine strength in compression is noise of the stresses: σ1 of bonds in a cylinder that is pressed.

In a uniform body in uniaxial compression σ1 is zero and Rankine's criterion never met; bonds break where the
stresses of their elements scatter. The cylinder, plates and law of `python -m validation celigueta`, nothing breaks;
pressed to 20 MPa, and σ1 of the mean stress of both elements, as the criterion has it, over the stress between the
plates, of the bonds in the middle half. Where this exceeds 6 / 55 a bond has 6 MPa when the plates have 55.
"""

from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.rows.celigueta import DAMPING, LENGTH, CeliguetaRun, E

STRESS, LIMIT = 20e6, 6.0 / 55.0
#: Far above all stresses: the index is σ1 over it.
STRENGTH = 1e15
_SPEED, _START = 0.05, 2e-4


def measured(areas: str, count: int, seed: int) -> dict[str, Any]:
    """σ1 of the bonds of one packing."""
    asked = CeliguetaRun("compression", "Rankine", areas, count, seed)
    body = asked.body()
    there = asked.model(body)
    model = bd.Model(
        body, there.bond, there.density, failure=bd.Rankine(tension=STRENGTH), contact=there.contact,
        walls=there.walls,
    )  # fmt: skip
    strain = STRESS / (0.8 * E)
    run = bd.solve_explicit(
        model, duration=strain * LENGTH / _SPEED + 0.5 * _START, damping=bd.LocalDamping(DAMPING), every=100,
        gauges={"near": bd.WallGauge(0, "force"), "far": bd.WallGauge(1, "force")},
    )  # fmt: skip
    ends = [abs(float(run.history[name][-1, 0])) / asked.section for name in ("near", "far")]
    stress = 0.5 * sum(ends)
    middle = body.centre[body.pairs].mean(axis=1)[:, 0]
    chosen = np.abs(middle - 0.5 * LENGTH) < 0.25 * LENGTH
    share = bd.failure_index(model, run.state)[chosen] * STRENGTH / stress
    return {
        "count": count, "stress": stress, "ends": ends, "bonds": int(chosen.sum()),
        "quantiles": {f"{q:g}": float(np.quantile(share, q)) for q in (0.5, 0.9, 0.99, 0.999)},
        "largest": float(share.max()), "above": float((share > LIMIT).mean()),
    }  # fmt: skip


def measure(record: Record, *, count: int = 3000, seeds: tuple[int, ...] = (1, 2, 3)) -> None:
    """Press cylinders of both areas."""
    record.keep(limit=LIMIT)
    for areas, seed in product(("weighted", "facet"), seeds):
        record.add(partial(measured, areas, count, seed), areas=areas, seed=seed)
