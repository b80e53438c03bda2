"""What a handful of packings says about all others: intervals of Student's distribution."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.stats import t as student

from bondem._types import Floats
from bondem.errors import InputError

KINDS = ("confidence", "prediction")
# More packings than this nobody makes; then the answer is "more".
_MOST = 100_000


def half_width(n: int, *, kind: str, level: float) -> float:
    """Half an interval over the standard deviation of n packings; see `Sample.interval`."""
    if kind not in KINDS:
        raise InputError(f"kind = '{kind}'; choose from {', '.join(KINDS)}")
    if not 0.0 < level < 1.0:
        raise InputError(f"level = {level}; give a probability between 0 and 1, such as 0.95")
    if n < 2:
        raise InputError("one packing says nothing about the scatter of others; calibrate on two or more")
    share = 1.0 / n + (1.0 if kind == "prediction" else 0.0)
    return float(student.ppf(0.5 + 0.5 * level, n - 1)) * math.sqrt(share)


@dataclass(frozen=True, eq=False)
class Sample:
    """One quantity of several packings made alike.

    Attributes:
        values: of each packing, (n,).
    """

    values: Floats

    @property
    def mean(self) -> float:
        """Arithmetic mean."""
        return float(np.mean(self.values))

    @property
    def std(self) -> float:
        """Standard deviation over the packings, n - 1 in the denominator; 0 for one packing."""
        return float(np.std(self.values, ddof=1)) if len(self.values) > 1 else 0.0

    def interval(self, *, kind: str = "confidence", level: float = 0.95) -> tuple[float, float]:
        """Where the mean of all packings ("confidence") or one new packing ("prediction") lies.

        mean ± t s √(1/n) or ± t s √(1 + 1/n), with t of n - 1 degrees of freedom: right, on average over
        calibrations, in `level` of all cases where packings scatter normally.

        Raises:
            InputError: fewer than two packings, which have no scatter to learn from, or an unknown kind.
        """
        half = half_width(len(self.values), kind=kind, level=level) * self.std
        return self.mean - half, self.mean + half

    def packings_for(self, precision: float, *, level: float = 0.95) -> int:
        """How many packings make the confidence interval of the mean no wider than ± precision × mean.

        Takes the scatter of these packings for that of all.

        Raises:
            InputError: fewer than two packings, or a precision that is not positive.
        """
        if not precision > 0.0:
            raise InputError(f"precision = {precision}; give a positive share, such as 0.01")
        if len(self.values) < 2:
            raise InputError("one packing says nothing about the scatter of others; calibrate on two or more")
        ratio = self.std / abs(precision * self.mean)

        def too_wide(n: int) -> bool:
            return float(student.ppf(0.5 + 0.5 * level, n - 1)) * ratio > math.sqrt(n)

        low, high = 1, 2
        while too_wide(high):
            low, high = high, 2 * high
            if high > _MOST:
                raise InputError(f"precision = {precision:g} takes more than {_MOST} packings; use larger ones")
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if too_wide(middle) else (low, middle)
        return high
