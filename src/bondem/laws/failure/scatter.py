"""Strengths that differ from bond to bond, by a counter: the number of a bond, not a stream, decides what it gets.

So the strength of a bond depends on neither threads nor the order in which anything is computed.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtri

from bondem._checks import count, number
from bondem._types import PerBond

_GOLDEN = np.uint64(0x9E3779B97F4A7C15)


@dataclass(frozen=True, kw_only=True)
class Weibull:
    """Strengths of a weakest link: s = s₀ (V / V₀)^(-1/m) (-ln u)^(1/m), u uniform in (0, 1).

    s₀ is the parameter of the criterion: what a bond of volume V₀ survives with probability 1/e. The mean strength of
    such bonds is Γ(1 + 1/m) s₀. All strengths of a bond share one factor. Reference: Weibull (1939).

    Attributes:
        modulus: m [-]; the larger, the less scatter.
        volume: V₀ [m³].
        seed: of the random numbers.

    Raises:
        InputError: a modulus or volume that is not positive, or a seed that is no whole number.
    """

    modulus: float
    volume: float
    seed: int = 0

    def __post_init__(self) -> None:
        number("Weibull", "modulus", self.modulus, above=0.0)
        number("Weibull", "volume", self.volume, unit="m³", above=0.0)
        count("Weibull", "seed", self.seed)

    def factors(self, volume: PerBond) -> PerBond:
        """Strength of each bond over s₀ [-], user's order, (m,)."""
        u = uniform_by_counter(self.seed, len(volume))
        return np.asarray((-np.log(u) * self.volume / volume) ** (1.0 / self.modulus))


@dataclass(frozen=True, kw_only=True)
class Normal:
    """Strengths s = s₀ (1 + c z) with z normal, within ±3: c is their standard deviation over their mean.

    All strengths of a bond share one factor.

    Attributes:
        deviation: c [-], below a third.
        seed: of the random numbers.

    Raises:
        InputError: a deviation outside [0, 1/3), or a seed that is no whole number.
    """

    deviation: float
    seed: int = 0

    def __post_init__(self) -> None:
        number("Normal", "deviation", self.deviation, least=0.0, below=1.0 / 3.0, advice="a share in [0, 1/3)")
        count("Normal", "seed", self.seed)

    def factors(self, volume: PerBond) -> PerBond:
        """Strength of each bond over s₀ [-], user's order, (m,)."""
        low = 0.5 * math.erfc(3.0 / math.sqrt(2.0))
        u = low + (1.0 - 2.0 * low) * uniform_by_counter(self.seed, len(volume))
        return np.asarray(1.0 + self.deviation * ndtri(u))


def uniform_by_counter(seed: int, many: int) -> PerBond:
    """Numbers in (0, 1) of the counters 0 … many, by the hash of splitmix64 (Steele, Lea and Flood 2014), (many,)."""
    with np.errstate(over="ignore"):
        start = _mixed(np.array([seed % 2**64], dtype=np.uint64) + _GOLDEN)
        bits = _mixed(start + (np.arange(many, dtype=np.uint64) + np.uint64(1)) * _GOLDEN)
    return ((bits >> np.uint64(11)).astype(float) + 0.5) * 2.0**-53


def _mixed(z: np.ndarray) -> np.ndarray:
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))
