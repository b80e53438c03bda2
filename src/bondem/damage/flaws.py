"""Strengths set by random flaws: equal near each flaw, with the strength of a body set by its weakest flaw.

Flaws of a strength below s are a Poisson process of density (s/s₀)^m / V₀, with Weibull's modulus m and the strength
s₀ of the volume V₀. A body of volume V has none with probability exp(-(V/V₀) (s/s₀)^m). This is Weibull's
distribution for every shape. A bond has the strength of the weakest flaw within a distance l of it.

Space is divided into cubes of edge l/2. The weakest flaw of a cube that contains the volume w of the body has the
strength s₀ (E V₀/w)^(1/m), with E from an exponential distribution. E and the place of the flaw in its cube depend
on the seed and on the number of the cube only. Elements of another size or order therefore change the strengths only
by the volume of the body in each cube. Every cube with bonds has its flaw within l of these, so that the smallest
strength of a body is Weibull's exactly. In a periodic cell cubes divide its edges.

References: Weibull (1939); Smith (1990), Max-stable processes and spatial extremes.
"""

import numpy as np
from scipy.spatial import KDTree

from bondem._types import Floats, PerBond, PerBond3
from bondem.damage.counter_random import uniform_by_cube

# Edges of cubes per length l, and flaws evaluated at once.
_PER_LENGTH, _PORTION = 2.0, 2000


def weakest_flaw(seed: int, length: float, share: PerBond, place: PerBond3, period: Floats | None) -> PerBond:
    """Return (s/s₀)^m / V₀ of the weakest flaw that reaches each bond [1/m³], (m,).

    Args:
        seed: seed of the random numbers.
        length: distance l within which a flaw sets strengths [m].
        share: volume of the body that belongs to each bond [m³], (m,).
        place: places of the bonds [m], (m, 3).
        period: edges of a periodic cell [m], (3,), or None.
    """
    if not len(place):
        return np.zeros(0)
    edge = np.full(3, length / _PER_LENGTH)
    if period is not None:
        edge = np.asarray(period) / np.ceil(np.asarray(period) / edge)
        place = np.mod(place, period)
    cube = np.floor(place / edge).astype(np.int64)
    own, of_bond = np.unique(cube, axis=0, return_inverse=True)
    drawn = uniform_by_cube(seed, own, 4)
    rate = -np.log(drawn[:, 0]) / np.bincount(of_bond.ravel(), weights=share, minlength=len(own))
    flaw, tree = (own + drawn[:, 1:]) * edge, KDTree(place, boxsize=period)
    found, falling = np.empty(len(place)), np.argsort(-rate, kind="stable")
    for first in range(0, len(falling), _PORTION):
        some = falling[first : first + _PORTION]
        for one, reached in zip(some, tree.query_ball_point(flaw[some], length), strict=True):
            found[reached] = rate[one]  # weaker flaws come later
    return found
