"""How a crack grows: the front of what has broken along a direction, and its speed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import theilslopes

from bondem._checks import array, instance, number, possible, shown, vector
from bondem._types import Floats
from bondem.errors import InputError
from bondem.fracture.directions import unit_vector
from bondem.observe.breakage import BrokenBonds

# Theil–Sen takes a slope of every pair: of more advances than this it takes as many, evenly chosen.
_MOST = 1500


@dataclass(frozen=True, eq=False)
class CrackGrowth:
    """The front of a crack: the farthest that has broken so far, at each of its k advances.

    Attributes:
        time: of each advance [s], shape (k,).
        length: distance of the front from the origin, along the direction [m], rising, shape (k,).
        speed: median of the slopes of all pairs of advances (Theil–Sen) [m/s].
        interval: in which the speed lies with 95 % confidence, of errors that do not depend on each other [m/s].
    """

    time: Floats
    length: Floats
    speed: float
    interval: tuple[float, float]

    def __len__(self) -> int:
        return len(self.time)


def crack_speed(
    events: BrokenBonds,
    origin: Sequence[float],
    direction: Sequence[float],
    *,
    between: tuple[float, float] | None = None,
    beyond: float = 0.0,
) -> CrackGrowth:
    """Length of a crack over time, and how fast it grows.

    The front is the largest (x - origin)·direction of all that has broken. The slope of Theil and Sen is that of most
    of its course, and is not led astray by the jumps of a crack that branches or starts anew ahead of itself, as long
    as these are less than 29 % of its advances.

    Args:
        events: what broke, `run.events`.
        origin: where the crack begins, such as the tip of a notch [m].
        direction: along which it grows, of any length.
        between: count advances from a time to another only [s].
        beyond: count advances from this length on only [m], as where the front is past the damage about a notch.

    Raises:
        InputError: fewer than three advances, or a direction of no length.

    Reference: Theil (1950); Sen (1968), whose interval it is.
    """
    instance("crack_speed", "events", events, BrokenBonds, "run.events")
    start = np.array(vector("crack_speed", "origin", origin, unit="m"))
    ahead = (events.position - start) @ unit_vector("crack_speed", "direction", direction)
    least = number("crack_speed", "beyond", beyond, unit="m")
    first, last = _window(between)
    order = np.argsort(events.time, kind="stable")
    time, reach = events.time[order], np.maximum.accumulate(ahead[order], axis=0)
    # of what breaks in one instant only the farthest is an advance
    ends = np.append(time[1:] > time[:-1], True) if len(time) else np.zeros(0, dtype=bool)
    time, reach = time[ends], reach[ends]
    rising = np.diff(reach, prepend=-np.inf) > 0.0
    kept = np.flatnonzero(rising & (time >= first) & (time <= last) & (reach >= least))
    time, reach = time[kept], reach[kept]
    if len(time) < 3:
        raise InputError(
            f"crack_speed: the front advances {len(time)} times along this direction; a speed needs 3 or more: check"
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
