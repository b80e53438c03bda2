"""Normally distributed random field with similar values at near places, as a sum of random waves.

    z(x) = √(2/N) Σ cos(k_n·x + φ_n)

The components of the N wave vectors k_n are normal of standard deviation √2 / l, with the correlation length l, and
the phases φ_n are uniform. The covariance of z(x) and z(x + r) is then exp(-(r / l)²). z(x) is normal up to an excess
kurtosis of -1.5 / N. In a periodic cell wave vectors are rounded to whole periods.

Reference: Shinozuka and Deodatis (1996), with random wave vectors.
"""

import math

import numpy as np
from scipy.special import ndtri

from bondem._types import Floats, PerBond, PerBond3
from bondem.damage.counter_random import uniform_by_counter

_WAVES = 1000
# Places evaluated at once.
_PORTION = 2000


def normal_field(seed: int, length: float, place: PerBond3, period: Floats | None) -> PerBond:
    """Return the values of the field z at places [-], (m,).

    Args:
        seed: seed of the random numbers.
        length: correlation length l [m].
        place: places [m], (m, 3).
        period: edges of a periodic cell [m], (3,), or None.
    """
    drawn = uniform_by_counter(seed, 4 * _WAVES).reshape(4, _WAVES)
    wave = math.sqrt(2.0) / length * ndtri(drawn[:3])
    if period is not None:
        step = 2.0 * math.pi / np.asarray(period)[:, None]
        wave = step * np.rint(wave / step)
    phase, found = 2.0 * math.pi * drawn[3], np.empty(len(place))
    for first in range(0, len(place), _PORTION):
        x, y, z = place[first : first + _PORTION].T[:, :, None]
        angle = x * wave[0] + y * wave[1] + z * wave[2] + phase
        found[first : first + _PORTION] = np.cos(angle).sum(axis=1)
    return math.sqrt(2.0 / _WAVES) * found
