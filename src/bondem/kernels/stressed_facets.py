"""When whole facets begin to crack where everything is proportional to a load factor: by the stress of their cells.

Principal stresses are of a closed form here, which loses half of the digits where two of them are equal: it tells
which facets are near.
"""

import math
from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.damaged_facets import three
from bondem.laws.cell_energy import scalar
from bondem.laws.plasticity import principal
from bondem.laws.softening import LEAST_SLOPE, plus, pulled_along

_ROOT = math.sqrt(3.0)


class StressedFacets(NamedTuple):
    """What m facets and their n cells bear."""

    i: np.ndarray  #: (m,)
    j: np.ndarray
    normal: np.ndarray  #: (m, 3)
    traction: np.ndarray  #: [Pa], (m, 3)
    bending: np.ndarray  #: [Pa], (m,)
    tensor: np.ndarray  #: [Pa], (n, 6)


@device
def _range(s):
    """Least and largest principal stress, to some 1e-8 of their size."""
    p = (s[0] + s[1] + s[2]) / 3.0
    a, b, c = s[0] - p, s[1] - p, s[2] - p
    square = 0.5 * (a * a + b * b + c * c) + s[3] ** 2 + s[4] ** 2 + s[5] ** 2
    if square == 0.0:
        return p, p
    third = a * (b * c - s[5] ** 2) - s[3] * (s[3] * c - s[5] * s[4]) + s[4] * (s[3] * s[5] - b * s[4])
    size = math.sqrt(square)
    angle = math.acos(min(max(1.5 * _ROOT * third / (size * square), -1.0), 1.0)) / 3.0
    size *= 2.0 / _ROOT
    return p + size * math.cos(angle + 2.0 * math.pi / 3.0), p + size * math.cos(angle)


@device
def _mean(tensor, i, j):
    return (
        0.5 * (tensor[i, 0] + tensor[j, 0]), 0.5 * (tensor[i, 1] + tensor[j, 1]), 0.5 * (tensor[i, 2] + tensor[j, 2]),
        0.5 * (tensor[i, 3] + tensor[j, 3]), 0.5 * (tensor[i, 4] + tensor[j, 4]), 0.5 * (tensor[i, 5] + tensor[j, 5]),
    )  # fmt: skip


@device
def _on(s, n):
    """σ n."""
    return (
        s[0] * n[0] + s[3] * n[1] + s[4] * n[2], s[3] * n[0] + s[1] * n[1] + s[5] * n[2],
        s[4] * n[0] + s[5] * n[1] + s[2] * n[2],
    )  # fmt: skip


@device
def _agreed(s, n, a):
    """σ made to have a more as its traction on n."""
    a = plus(a, -0.5 * scalar(a, n), n)
    return (
        s[0] + 2.0 * a[0] * n[0], s[1] + 2.0 * a[1] * n[1], s[2] + 2.0 * a[2] * n[2],
        s[3] + a[0] * n[1] + a[1] * n[0], s[4] + a[0] * n[2] + a[2] * n[0], s[5] + a[1] * n[2] + a[2] * n[1],
    )  # fmt: skip


@device
def _softens(s, n, t, bent, strength, a, v):
    """Load factor at which a whole facet begins to soften along a principal direction of s, or inf."""
    principal(s, a, v)
    least, most = np.inf, 0.0
    for d in range(3):
        most = max(most, abs(scalar(n, (v[0, d], v[1, d], v[2, d]))))
    for d in range(3):
        e = v[0, d], v[1, d], v[2, d]
        slope = scalar(n, e)
        both = pulled_along(t, e, slope, a[d, d]) + bent * abs(slope) / most
        if both > 0.0:
            least = min(least, strength * max(abs(slope), LEAST_SLOPE) / both)
    return least


@kernel(parallel=False)
def stress_factors(judged, strength, whole, below, spread, factor):
    """Load factors at which whole facets of the material begin to crack and to soften, or inf.

    Facets that are far from it are passed over: σ1 of σ* is at most |σ| + √2 |t - σ n| with what bends added to t.

    Args:
        judged: what they bear at a factor of 1.
        strength: [Pa], (m,).
        whole: which facets, (c,).
        below: factors above it do not count.
        spread: how far above the least of all a factor may be, over it.
        factor: written, inf for those that are passed over, (c,).
    """
    a, v = np.empty((3, 3)), np.empty((3, 3))
    for e in range(len(whole)):
        k = whole[e]
        i, j = judged.i[k], judged.j[k]
        s, n, t, f = _mean(judged.tensor, i, j), three(judged.normal, k), three(judged.traction, k), strength[k]
        lacks, bending = plus(t, -1.0, _on(s, n)), judged.bending[k]
        size = math.sqrt(s[0] ** 2 + s[1] ** 2 + s[2] ** 2 + 2.0 * (s[3] ** 2 + s[4] ** 2 + s[5] ** 2))
        factor[e] = np.inf
        if f >= spread * below * (size + math.sqrt(2.0) * (math.sqrt(scalar(lacks, lacks)) + bending)):
            continue
        across, bent = scalar(t, n), max(bending - max(-_range(s)[0], 0.0), 0.0)
        pulled = bent + max(across, 0.0) if bent > 0.0 else across
        high = _range(_agreed(s, n, plus(lacks, pulled - across, n)))[1]
        if high <= 0.0:
            continue
        reached = f / high
        if pulled <= 0.0:
            shear = scalar(t, t) - across**2
            if shear <= 0.0:
                continue
            reached = max(reached, f * (math.sqrt(pulled**2 + 4.0 * shear) - pulled) / (2.0 * shear))
        reached = max(reached, _softens(s, n, t, bent, f, a, v))
        factor[e] = reached
        below = min(below, reached)
