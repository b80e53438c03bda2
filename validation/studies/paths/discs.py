"""Splitting discs beside finite elements with one cohesive crack, with friction on their cracks and without."""

import json
from functools import cache

import bondem as bd
from validation.frame.record import RESULTS
from validation.studies import brazilian
from validation.studies.paths.rows import Row

#: E G_f / f_t^2 over the diameter; where finite elements have no maximum of the load, the strength is stated only.
SHARES = (0.25, 1.0, 4.0)
#: Friction on the cracks of the second disc of each kind.
FRICTION = 0.3
#: How far the strength may be from finite elements, and how much friction may change it [-].
LIMIT, CHANGE = 0.04, 0.03


@cache
def expected(share: float) -> float | None:
    """Strength over f_t by the first mesh of `disc_finite_elements.py`; None where the load has no maximum."""
    kept = json.loads((RESULTS / "disc_finite_elements.json").read_text())["discs"]
    return next(one["strength"] for one in kept if one["share"] == share)


def energy_of(share: float) -> float:
    """Return the fracture energy of which E G_f / f_t² is a share of the diameter [J/m²]."""
    return share * brazilian.DIAMETER * brazilian.TENSION**2 / brazilian.LAW.E


@cache
def disc(count: int, seed: int) -> bd.Lattice:
    """The cells of a disc."""
    return brazilian.DISC.body(count, seed)


def _split(body: bd.Lattice, share: float, friction: float) -> tuple[float, str]:
    """Return the stress at the centre over f_t when the disc splits, or the largest where its load has no maximum."""
    failure = bd.Rankine(tension=brazilian.TENSION, fracture_energy=energy_of(share), friction=friction)
    run = brazilian.pressed(body, failure)
    force = 0.5 * (run.history["bottom"][:, 1] - run.history["top"][:, 1]) / brazilian.EXPECTED
    note = f"{run.status.value}, imbalance {run.history.imbalance:.1e}"
    return float(force.max()), note if run.status is bd.Status.STOPPED else f"{note}, no maximum"


def discs(seed: int, count: int) -> list[Row]:
    """Strength without friction over that of finite elements, and with friction over that without."""
    body, rows = disc(count, seed), []
    for share in SHARES:
        theory = expected(share)
        (smooth, note), (rough, also) = (_split(body, share, friction) for friction in (0.0, FRICTION))
        told, limit = f"E G_f / f_t² = {share:g} D", LIMIT if theory else None
        rows += [
            Row("discs", f"{told}: strength over f_t", smooth, theory or 1.0, limit, note=note),
            Row("discs", f"{told}: strength with friction {FRICTION:g} over that without", rough / smooth, 1.0,
                CHANGE if theory else None, note=also),
        ]  # fmt: skip
    return rows
