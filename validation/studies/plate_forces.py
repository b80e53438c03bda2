"""Why the plate that stands still bears less than the one that moves: inertia, or the damping of elements.

The difference of both forces is what the momentum of the elements grows by, and what local damping takes: it opposes
velocities, so that a body that follows one plate is held back, and one between two plates that come nearer by as much
is not. The tests of `python -m validation celigueta`, Rankine, the authors' areas, with less damping and with both
plates driven at half the speed. Impulses are those from a fifth of the peak of the moving plate up to it.
"""

from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record
from validation.rows.celigueta import COUNT, SPEED, CeliguetaRun

#: Local damping, and whether both plates move.
CASES = ((0.3, False), (0.1, False), (0.03, False), (0.3, True), (0.03, True))
_START = 2e-4


def _driven(along: str, schedule: bd.Ramp) -> bd.Driven:
    given: dict[str, Any] = {along: schedule}
    return bd.Driven(**given)


def measured(test: str, count: int, seed: int, damping: float, both: bool) -> dict[str, Any]:
    """Forces of both plates of one run."""
    asked = CeliguetaRun(test, "Rankine", "weighted", count or COUNT[test], seed)
    body, axis, speed = asked.body(), asked.axis, SPEED[test]
    there = asked.model(body)
    walls = there.walls
    if both:
        name = "v" + "xyz"[axis]
        walls = [
            replace(wall, motion=_driven(name, bd.Ramp(0.0, 0.5 * sign * speed, _START)))
            for wall, sign in zip(walls, (1.0, -1.0), strict=True)
        ]
    model = bd.Model(
        body, there.bond, there.density, failure=there.failure, contact=there.contact, walls=walls
    )  # fmt: skip
    momentum: list[float] = []

    def tell(state: bd.State, record: bd.History) -> bool:
        momentum.append(float(model.mass @ state.velocity[:, axis]))
        return False

    run = asked.run(model, damping=damping, callback=tell)
    moving, still = (np.abs(run.history[one][:, axis]) for one in ("moving", "still"))
    time, peak = run.history.time, int(np.argmax(moving))
    first = int(np.flatnonzero(moving[: peak + 1] > 0.2 * moving[peak])[0])
    span = slice(first, peak + 1)
    given, passed = (float(np.trapezoid(force[span], time[span])) for force in (moving, still))
    gained = abs(momentum[min(peak, len(momentum) - 1)] - momentum[min(first, len(momentum) - 1)])
    return {
        "count": len(body.particles), "at_peak": float(still[peak] / moving[peak]), "impulses": passed / given,
        "momentum": gained / given, "damped": 1.0 - passed / given - gained / given,
    }  # fmt: skip


def measure(
    record: Record, *, tests: tuple[str, ...] = ("splitting",), count: int = 0, seeds: tuple[int, ...] = (1, 2, 3),
) -> None:  # fmt: skip
    """Measure forces of both plates with several dampings; `count` 0 is that of the paper."""
    for test, (damping, both), seed in product(tests, CASES, seeds):
        record.add(partial(measured, test, count, seed, damping, both), test=test, seed=seed, damping=damping,
                   both=both)  # fmt: skip
