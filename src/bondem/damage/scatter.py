"""Scatter of strengths from bond to bond, by a counter: the number of a bond determines its random number.

The strength of a bond therefore depends on neither threads nor the order of computation. Correlated strengths depend
on the place of a bond, not on its number (`bondem.damage.correlated`).
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr, ndtri

from bondem._checks import count, number
from bondem._types import Floats, PerBond, PerBond3
from bondem.damage.correlated import normal_field
from bondem.damage.counter import uniform_by_counter
from bondem.errors import InputError

# Numbers in (0, 1) stay that far from its ends, as those of the counter do.
_EDGE = 2.0**-54


@dataclass(frozen=True, kw_only=True)
class Weibull:
    """Strengths of a weakest link: s = s₀ (V / V₀)^(-1/m) (-ln u)^(1/m), u uniform in (0, 1).

    s₀ is the parameter of the criterion, the strength that a bond of volume V₀ exceeds with probability 1/e. The mean
    strength of such bonds is Γ(1 + 1/m) s₀. All strengths of a bond share one factor. Reference: Weibull (1939).

    With a correlation length l, u = Φ(z) for a normal field z of covariance exp(-(r/l)²) between bonds r apart. V is
    then the larger of the volume of the bond and that of the field's correlation, ∫ exp(-(r/l)²) dV = π^(3/2) l³. A
    patch of that volume has one strength however finely it is divided; many patches are a weakest link again.

    Attributes:
        modulus: m [-]; a larger value gives less scatter.
        volume: V₀ [m³].
        seed: seed of the random numbers.
        correlation: l [m]; None for independent strengths.

    Raises:
        InputError: A modulus, volume or correlation is not positive, or the seed is not a whole number.
    """

    modulus: float
    volume: float
    seed: int = 0
    correlation: float | None = None

    def __post_init__(self) -> None:
        number("Weibull", "modulus", self.modulus, above=0.0)
        number("Weibull", "volume", self.volume, unit="m³", above=0.0)
        count("Weibull", "seed", self.seed)
        _check_length("Weibull", self.correlation)

    def factors(
        self, volume: PerBond, place: PerBond3 | None = None, period: Floats | None = None
    ) -> PerBond:
        """Return the strength of each bond over s₀ [-], user's order, (m,); see `Criterion.factors`."""
        u = _uniform(self.seed, len(volume), self.correlation, place, period)
        if self.correlation is not None:
            volume = np.maximum(volume, math.pi**1.5 * self.correlation**3)
        return np.asarray((-np.log(u) * self.volume / volume) ** (1.0 / self.modulus))


@dataclass(frozen=True, kw_only=True)
class Normal:
    """Normally distributed strengths s = s₀ (1 + c z), with z normal within ±3 and c their relative deviation.

    c is the standard deviation over the mean. All strengths of a bond share one factor.

    Attributes:
        deviation: c [-], below a third.
        seed: seed of the random numbers.
        correlation: l [m] of the normal field of strengths, whose covariance is exp(-(r/l)²) between bonds
            r apart; None for independent strengths.

    Raises:
        InputError: The deviation is outside [0, 1/3), the seed is not a whole number, or the correlation is not
            positive.
    """

    deviation: float
    seed: int = 0
    correlation: float | None = None

    def __post_init__(self) -> None:
        number("Normal", "deviation", self.deviation, least=0.0, below=1.0 / 3.0, advice="a share in [0, 1/3)")
        count("Normal", "seed", self.seed)
        _check_length("Normal", self.correlation)

    def factors(
        self, volume: PerBond, place: PerBond3 | None = None, period: Floats | None = None
    ) -> PerBond:
        """Return the strength of each bond over s₀ [-], user's order, (m,); see `Criterion.factors`."""
        low = 0.5 * math.erfc(3.0 / math.sqrt(2.0))
        u = low + (1.0 - 2.0 * low) * _uniform(self.seed, len(volume), self.correlation, place, period)
        return np.asarray(1.0 + self.deviation * ndtri(u))


def _check_length(owner: str, correlation: float | None) -> None:
    if correlation is not None:
        number(owner, "correlation", correlation, unit="m", above=0.0, advice="a length in m, or None")


def _uniform(
    seed: int, many: int, correlation: float | None, place: PerBond3 | None, period: Floats | None
) -> PerBond:
    """Return uniform numbers in (0, 1) for bonds, by their number or by their place."""
    if correlation is None:
        return uniform_by_counter(seed, many)
    if place is None:
        raise InputError("strengths that are correlated need the places of the bonds; give place= too")
    return np.clip(ndtr(normal_field(seed, correlation, place, period)), _EDGE, 1.0 - _EDGE)
