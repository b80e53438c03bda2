"""Random variation of strength from bond to bond, in which the number of a bond determines its random number.

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
from bondem.damage.counter_random import uniform_by_counter
from bondem.damage.flaws import weakest_flaw
from bondem.errors import InputError

# Least distance of random numbers from 0 and 1, the same as for those of the counter.
_EDGE = 2.0**-54


@dataclass(frozen=True, kw_only=True)
class Weibull:
    """Strengths with Weibull's distribution: s = s₀ (V / V₀)^(-1/m) (-ln u)^(1/m), u uniform in (0, 1).

    s₀ is the parameter of the criterion, the strength that a bond of volume V₀ exceeds with probability 1/e. The mean
    strength of such bonds is Γ(1 + 1/m) s₀. All strengths of a bond share one factor. Reference: Weibull (1939).

    With a correlation length l, the body contains flaws at random places, of which (s/s₀)^m / V₀ per volume have a
    strength below s. Each sets the strength of all bonds within l (`bondem.damage.flaws`). The smallest strength of a
    body of volume V then has the mean Γ(1 + 1/m) s₀ (V₀/V)^(1/m), for every shape, size of elements and l. A brittle
    body of cells has this strength if l is at least two cells; with m = 5 it is up to 8 % stronger. Without a
    correlation length strengths are independent and V is the volume of the bond, its area times its length; a bar of
    such bonds is stronger than its weakest link.

    Attributes:
        modulus: Weibull modulus m [-]; a larger value gives less scatter.
        volume: reference volume V₀ [m³].
        seed: seed of the random numbers.
        correlation: l [m], the radius about a flaw within which strengths are equal; None for independent strengths.

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
        self, volume: PerBond, place: PerBond3 | None = None, period: Floats | None = None, body: float | None = None
    ) -> PerBond:
        """Return the strength of each bond over s₀ [-], user's order, (m,).

        Volumes are in m³, (m,) for bonds, places, (m, 3), and periodic edges, (3,), in m, as in `Criterion.factors`.

        Raises:
            InputError: Strengths are correlated, and no places are given.
        """
        if self.correlation is None:
            rate = -np.log(uniform_by_counter(self.seed, len(volume))) / volume
        else:
            # area times length of a tessellation is three times its volume, except at the surface
            share = volume / 3.0 if body is None else volume * (body / volume.sum())
            rate = weakest_flaw(self.seed, self.correlation, share, _needed(place), period)
        return np.asarray((self.volume * rate) ** (1.0 / self.modulus))


@dataclass(frozen=True, kw_only=True)
class Normal:
    """Normally distributed strengths s = s₀ (1 + c z), with z standard normal, truncated to ±3.

    All strengths of a bond share one factor.

    Attributes:
        deviation: c, the standard deviation over the mean before truncation [-], below a third.
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
        self, volume: PerBond, place: PerBond3 | None = None, period: Floats | None = None, body: float | None = None
    ) -> PerBond:
        """Return the strength of each bond over s₀ [-], user's order, (m,).

        Volumes are in m³, (m,) for bonds, places, (m, 3), and periodic edges, (3,), in m, as in `Criterion.factors`.

        Raises:
            InputError: Strengths are correlated, and no places are given.
        """
        low = 0.5 * math.erfc(3.0 / math.sqrt(2.0))
        if self.correlation is None:
            u = uniform_by_counter(self.seed, len(volume))
        else:
            u = np.clip(ndtr(normal_field(self.seed, self.correlation, _needed(place), period)), _EDGE, 1.0 - _EDGE)
        return np.asarray(1.0 + self.deviation * ndtri(low + (1.0 - 2.0 * low) * u))


def _check_length(owner: str, correlation: float | None) -> None:
    if correlation is not None:
        number(owner, "correlation", correlation, unit="m", above=0.0, advice="a length in m, or None")


def _needed(place: PerBond3 | None) -> PerBond3:
    if place is None:
        raise InputError("strengths that are correlated need the places of the bonds; give place= too")
    return place
