"""Growth of a crack: its front along a direction, and its speed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import theilslopes

from bondem._checks import array, instance, number, possible, shown, unit_vector, vector
from bondem._types import Floats
from bondem.errors import InputError
from bondem.observables.breakage import BrokenBonds

# Largest number of advances for Theil–Sen, which computes a slope for every pair; of more, an even sample is used.
_MOST = 1500


@dataclass(frozen=True, eq=False)
class CrackGrowth:
    """The front of a crack, the farthest broken position so far, at each of its k advances.

    Attributes:
        time: time of each advance [s], shape (k,).
        length: distance of the front from the origin, along the direction [m], rising, shape (k,).
        speed: median of the slopes of all pairs of advances (Theil–Sen) [m/s].
        interval: 95 % confidence interval of the speed, for independent errors [m/s].
    """

    time: Floats
    length: Floats
    speed: float
    interval: tuple[float, float]

    def __len__(self) -> int:
        return len(self.time)


def crack_speed(
    events: BrokenBonds, origin: Sequence[float], direction: Sequence[float], *,
    between: tuple[float, float] | None = None, beyond: float = 0.0,
) -> CrackGrowth:  # fmt: skip
    """Measure the length of a crack over time, and its speed.

    The front is the largest (x - origin)·direction of all broken bonds or facets so far. The speed is the slope of
    Theil and Sen, the median slope of all pairs of advances. This median is insensitive to jumps of a crack that
    branches or restarts ahead of its front, if less than 29 % of the advances are jumps.

    Args:
        events: broken bonds, `run.events`.
        origin: point where the crack begins, such as the tip of a notch [m].
        direction: direction of growth, of any length.
        between: time interval in which advances count [s]; None for all.
        beyond: length from which advances count [m], for example beyond the damage around a notch.

    Returns:
        Times and lengths of the advances, and the speed with its confidence interval.

    Raises:
        InputError: There are fewer than three advances, or the direction has zero length.

    Reference: Theil (1950); Sen (1968) for the interval.
    """
    instance("crack_speed", "events", events, BrokenBonds, "run.events")
    start = np.array(vector("crack_speed", "origin", origin, unit="m"))
    ahead = (events.position - start) @ unit_vector("crack_speed", "direction", direction)
    least = number("crack_speed", "beyond", beyond, unit="m")
    first, last = _window(between)
    order = np.argsort(events.time, kind="stable")
    time, reach = events.time[order], np.maximum.accumulate(ahead[order], axis=0)
    # of several breakages at one time only the farthest counts as an advance
    ends = np.append(time[1:] > time[:-1], True) if len(time) else np.zeros(0, dtype=bool)
    time, reach = time[ends], reach[ends]
    rising = np.diff(reach, prepend=-np.inf) > 0.0
    retained = np.flatnonzero(rising & (time >= first) & (time <= last) & (reach >= least))
    time, reach = time[retained], reach[retained]
    if len(time) < 3:
        raise InputError(
            f"crack_speed: the front advances {len(time)} times along this direction, a speed needs 3 or more; check"
            " origin, direction, between and beyond"
        )
    some = np.unique(np.linspace(0, len(time) - 1, min(len(time), _MOST)).round().astype(int))
    slope, _, low, high = np.array(theilslopes(reach[some], time[some], 0.95), dtype=float).tolist()
    return CrackGrowth(time=time, length=reach, speed=slope, interval=(low, high))


def _window(between: tuple[float, float] | None) -> tuple[float, float]:
    if between is None:
        return -np.inf, np.inf
    found = array("crack_speed", "between", between, wanted="two times, (start, end) [s], or None")
    if found.shape != (2,) or not possible(found):
        raise InputError(f"crack_speed: between = {shown(between)}; give two times, (start, end) [s], or None")
    return float(found[0]), float(found[1])
