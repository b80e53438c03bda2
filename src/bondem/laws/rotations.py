"""Rotations as unit quaternions (w, x, y, z), for the kernels."""

import math

from bondem._compile import device


@device
def rotate(w, x, y, z, a, b, c):
    """Return the vector (a, b, c) rotated by the unit quaternion (w, x, y, z)."""
    # v + 2 u × (u × v + w v)
    tx = 2.0 * (y * c - z * b)
    ty = 2.0 * (z * a - x * c)
    tz = 2.0 * (x * b - y * a)
    return a + w * tx + (y * tz - z * ty), b + w * ty + (z * tx - x * tz), c + w * tz + (x * ty - y * tx)


# Square of a half angle below which three terms are exact to rounding: a usual step.
SMALL = 1e-5


@device
def short_series(h2):
    """Return cos(h) and sin(h)/h of a half angle from its square, below SMALL."""
    return 1.0 + h2 * (-1 / 2 + h2 * (1 / 24 - h2 / 720)), 1.0 + h2 * (-1 / 6 + h2 * (1 / 120 - h2 / 5040))


@device
def half_angle(h2):
    """Return cos(h) and sin(h)/h of the half angle from its square, by series exact to rounding below 0.2 rad."""
    if h2 < SMALL:
        return short_series(h2)
    if h2 < 0.04:
        cosine = 1.0 + h2 * (-1 / 2 + h2 * (1 / 24 + h2 * (-1 / 720 + h2 * (1 / 40320 - h2 / 3628800))))
        sinc = 1.0 + h2 * (-1 / 6 + h2 * (1 / 120 + h2 * (-1 / 5040 + h2 * (1 / 362880 - h2 / 39916800))))
        return cosine, sinc
    h = math.sqrt(h2)
    return math.cos(h), math.sin(h) / h


@device
def turned(w, x, y, z, a, b, c, cosine, sinc):
    """Return the quaternion (w, x, y, z) rotated further by the rotation vector (a, b, c) of a known half angle.

    One Newton step towards unit length is sufficient, because the exponential map itself keeps it to rounding.
    """
    p, q, r = 0.5 * sinc * a, 0.5 * sinc * b, 0.5 * sinc * c
    nw = cosine * w - p * x - q * y - r * z
    nx = cosine * x + p * w + q * z - r * y
    ny = cosine * y + q * w + r * x - p * z
    nz = cosine * z + r * w + p * y - q * x
    scale = 1.5 - 0.5 * (nw * nw + nx * nx + ny * ny + nz * nz)
    return nw * scale, nx * scale, ny * scale, nz * scale


@device
def turn(w, x, y, z, a, b, c):
    """Return the quaternion (w, x, y, z) rotated further by the rotation vector (a, b, c), and normalised."""
    cosine, sinc = half_angle(0.25 * (a * a + b * b + c * c))
    return turned(w, x, y, z, a, b, c, cosine, sinc)
