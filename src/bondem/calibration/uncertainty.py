"""Intervals of Student's distribution for quantities of a few packings."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.special import stdtrit

from bondem._checks import choice, number
from bondem._types import Floats
from bondem.errors import InputError

Kind = Literal["confidence", "prediction"]
# Upper limit of the numbers of packings that `packings_for` tries by doubling.
_MOST = 2**16


def half_width(n: int, *, kind: Kind, level: float) -> float:
    """Half-width of an interval over the standard deviation of n packings [-]; for errors see `Sample.interval`."""
    choice("interval", "kind", kind, Kind)
    number("", "level", level, above=0.0, below=1.0, advice="a probability between 0 and 1, such as 0.95")
    if n < 2:
        raise InputError("a single packing has no scatter; calibrate on two or more")
    share = 1.0 / n + (1.0 if kind == "prediction" else 0.0)
    return float(stdtrit(n - 1, 0.5 + 0.5 * level)) * math.sqrt(share)


@dataclass(frozen=True, eq=False)
class Sample:
    """Values of one quantity for several packings of the same kind.

    Attributes:
        values: value of each packing, (n,).
    """

    values: Floats

    @property
    def mean(self) -> float:
        """Arithmetic mean of the values."""
        return float(np.mean(self.values))

    @property
    def std(self) -> float:
        """Standard deviation of the values, with n - 1 in the denominator; 0 for a single packing."""
        return float(np.std(self.values, ddof=1)) if len(self.values) > 1 else 0.0

    def interval(self, *, kind: Kind = "confidence", level: float = 0.95) -> tuple[float, float]:
        """Compute the interval of the mean of all packings ("confidence") or of one new packing ("prediction").

        The interval is mean ± t s √(1/n) or ± t s √(1 + 1/n), with t of n - 1 degrees of freedom. For normally
        distributed packings the interval contains the value with probability `level`, on average over calibrations.

        Raises:
            InputError: fewer than two packings, which have no scatter, an unknown kind, or `level` outside (0, 1).
        """
        half = half_width(len(self.values), kind=kind, level=level) * self.std
        return self.mean - half, self.mean + half

    def packings_for(self, precision: float, *, level: float = 0.95) -> int:
        """Return the number of packings for a confidence interval of the mean within ± precision × mean.

        The standard deviation of these packings is taken for that of all packings.

        Args:
            precision: half-width of the interval over the mean [-].
            level: probability that the interval contains the mean [-].

        Raises:
            InputError: fewer than two packings, or a precision that is not positive or needs more than 65 536.
        """
        number("", "precision", precision, above=0.0, advice="a positive share, such as 0.01")
        if len(self.values) < 2:
            raise InputError("a single packing has no scatter; calibrate on two or more")
        ratio = self.std / abs(precision * self.mean)

        def too_wide(n: int) -> bool:
            return float(stdtrit(n - 1, 0.5 + 0.5 * level)) * ratio > math.sqrt(n)

        low, high = 1, 2
        while too_wide(high):
            low, high = high, 2 * high
            if high > _MOST:
                raise InputError(f"precision = {precision:g}: needs more than {_MOST} packings; use larger packings")
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if too_wide(middle) else (low, middle)
        return high
