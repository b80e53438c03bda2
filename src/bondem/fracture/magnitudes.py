"""Magnitudes of acoustic emissions, and the slope (b-value) of their distribution."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._checks import number
from bondem._types import Floats
from bondem.errors import InputError

# Fewest emissions for a slope, whose standard error is about b / √n.
_FEWEST = 10
# Normal quantile of an interval of 95 %.
_CONFIDENCE = 1.96
# Largest number of bins over the range of magnitudes; more indicate a width in another unit.
_BINS = 1_000_000


@dataclass(frozen=True)
class BValue:
    """Slope of the distribution of magnitudes, log10 N(≥ M) = a - b M.

    Attributes:
        b: maximum-likelihood estimate [-].
        error: standard error of b, ln(10) b² s / √n with s² = Σ (M - mean)² / (n - 1) [-].
        interval: 95 % confidence interval of b, b ± 1.96 standard errors [-].
        completeness: magnitude M_c from which emissions were counted [-].
        count: number n of these emissions.
    """

    b: float
    error: float
    interval: tuple[float, float]
    completeness: float
    count: int


def magnitude_of(energy: Floats) -> Floats:
    """Return the magnitudes 2/3 log10(E / J) - 3.2 [-] of energies [J]; -inf for zero energy."""
    with np.errstate(divide="ignore"):
        return 2.0 / 3.0 * np.log10(energy) - 3.2


def b_value_of(magnitude: Floats, completeness: float | None, width: float) -> BValue:
    """Estimate the slope b from magnitudes, as `AcousticEmission.b_value` documents."""
    bin_width = number("b_value", "width", width, above=0.0)
    known = magnitude[np.isfinite(magnitude)]
    if completeness is None:
        _enough(len(known), "of any energy")
        least = _fullest(known, bin_width)
    else:
        least = number("b_value", "completeness", completeness)
    counted = known[known >= least]
    n = len(counted)
    _enough(n, f"of magnitude {least:.2f} or more")
    above = float(counted.mean()) - least
    if above <= 0.0 or float(np.ptp(counted)) == 0.0:
        raise InputError("b_value: all emissions are of one magnitude; gather them over more time= and distance=")
    b = math.log10(math.e) / above
    error = math.log(10.0) * b**2 * float(counted.std(ddof=1)) / math.sqrt(n)
    reach = _CONFIDENCE * error
    return BValue(b=b, error=error, interval=(b - reach, b + reach), completeness=least, count=n)


def _enough(count: int, which: str) -> None:
    if count < _FEWEST:
        raise InputError(
            f"b_value: {count} emissions {which} are too few for a slope, which needs {_FEWEST}, better 100; use more"
            " elements, or gather over less time= and distance="
        )


def _fullest(magnitude: Floats, width: float) -> float:
    """Return the middle of the bin of magnitudes with most entries; the lowest of equally full bins."""
    if float(np.ptp(magnitude)) / width > _BINS:
        raise InputError(f"b_value: width = {width:g} gives too many bins; use a width of about 0.1")
    number_of = np.floor(magnitude / width).astype(np.int64)
    bins, many = np.unique(number_of, return_counts=True)
    return float((bins[int(many.argmax())] + 0.5) * width)
