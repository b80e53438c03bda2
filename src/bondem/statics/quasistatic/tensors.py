"""Stress tensors of many cells and facets at once: agreement with a traction, and principal stresses.

Closed forms of principal stresses lose half of the digits where two of them are equal. They only select facets, which
`eigvalsh` then evaluates.
"""

import numpy as np

from bondem._types import Floats

_ROOT = np.sqrt(3.0)


def full_tensor(s: Floats) -> Floats:
    """Return (…, 3, 3) of xx, yy, zz, xy, xz, yz."""
    return s[..., [[0, 3, 4], [3, 1, 5], [4, 5, 2]]]


def agreed(mean: Floats, n: Floats, t: Floats) -> Floats:
    """Return σ*: mean tensors modified to agree with tractions t on facets of normals n.

    Args:
        mean: components xx, yy, zz, xy, xz, yz [Pa], (6, c).
        n: normals, (3, c).
        t: tractions [Pa], (3, c).
    """
    x, y, z = n
    a = t[0] - (mean[0] * x + mean[3] * y + mean[4] * z)
    b = t[1] - (mean[3] * x + mean[1] * y + mean[5] * z)
    c = t[2] - (mean[4] * x + mean[5] * y + mean[2] * z)
    half = 0.5 * (a * x + b * y + c * z)
    a, b, c = a - half * x, b - half * y, c - half * z
    more = 2.0 * a * x, 2.0 * b * y, 2.0 * c * z, a * y + b * x, a * z + c * x, b * z + c * y
    return mean + np.stack(more)


def largest(s: Floats) -> Floats:
    """Return the largest principal stress of tensors (6, c), (c,)."""
    return np.asarray(np.linalg.eigvalsh(full_tensor(s.T))[:, 2], dtype=float)
