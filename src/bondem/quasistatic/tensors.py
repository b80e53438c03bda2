"""Stress tensors of many cells and facets at once: what agrees with a traction, and principal stresses.

Closed forms of principal stresses lose half of the digits where two of them are equal: they tell which facets are
looked at, and `eigvalsh` looks.
"""

import numpy as np

from bondem._types import Floats

_ROOT = np.sqrt(3.0)


def full_tensor(s: Floats) -> Floats:
    """(…, 3, 3) of xx, yy, zz, xy, xz, yz."""
    return s[..., [[0, 3, 4], [3, 1, 5], [4, 5, 2]]]


def agreed(mean: Floats, n: Floats, t: Floats) -> Floats:
    """σ*: mean tensors made to agree with tractions t on facets of normals n.

    Args:
        mean: xx, yy, zz, xy, xz, yz [Pa], (6, c).
        n: (3, c).
        t: [Pa], (3, c).
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
    """Largest principal stress of (6, c), (c,)."""
    return np.asarray(np.linalg.eigvalsh(full_tensor(s.T))[:, 2], dtype=float)


def principal_range(s: Floats) -> tuple[Floats, Floats]:
    """Least and largest principal stress of (6, c), each (c,), to some 1e-8 of their size."""
    p = (s[0] + s[1] + s[2]) / 3.0
    a, b, c = s[0] - p, s[1] - p, s[2] - p
    square = 0.5 * (a * a + b * b + c * c) + s[3] ** 2 + s[4] ** 2 + s[5] ** 2
    third = a * (b * c - s[5] ** 2) - s[3] * (s[3] * c - s[5] * s[4]) + s[4] * (s[3] * s[5] - b * s[4])
    size = np.sqrt(square)
    cosine = np.divide(1.5 * _ROOT * third, size * square, out=np.ones_like(p), where=size * square > 0.0)
    angle = np.arccos(np.clip(cosine, -1.0, 1.0)) / 3.0
    size *= 2.0 / _ROOT
    return p + size * np.cos(angle + 2.0 * np.pi / 3.0), p + size * np.cos(angle)
