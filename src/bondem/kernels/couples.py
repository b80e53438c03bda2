"""Moments of loads, as forces on regions that turn: the smallest forces about the present centroid of their points.

With shares w of the points and s their places from the centroid, f = w ω × s and J ω = M, J = Σ w (s² 1 - s⊗s). The
forces have no resultant, and torques bear what is left of M where the points cannot, as in a row: the total is M.
"""

from typing import NamedTuple

import numpy as np

from bondem._compile import device
from bondem.laws.cell_energy import cross
from bondem.laws.rotations import rotate


class CoupleTable(NamedTuple):
    """Moments of loads on points of elements, c of them."""

    start: np.ndarray  #: where the points of each begin, (c + 1,)
    schedule: np.ndarray  #: (c,)
    moment: np.ndarray  #: [N·m], (c, 3)
    element: np.ndarray  #: of each point
    row: np.ndarray  #: of the boundary, that the element owns
    arm: np.ndarray  #: from its centre [m], (…, 3)
    share: np.ndarray  #: of the moment's forces [-]


# Square of the share of the largest moments of inertia below which points have none about an axis.
_NONE = 1e-8


@device
def _point(couples, pose, k):
    """From the centre of its element to a point, and its place."""
    x, arm = pose[couples.element[k]], couples.arm[k]
    a = rotate(x[4], x[5], x[6], x[7], arm[0], arm[1], arm[2])
    return a, (x[0] + a[0], x[1] + a[1], x[2] + a[2])


@device
def _centroid(couples, pose, first, last):
    x = y = z = 0.0
    for k in range(first, last):
        w = couples.share[k]
        _, place = _point(couples, pose, k)
        x += w * place[0]
        y += w * place[1]
        z += w * place[2]
    return x, y, z


@device
def _from(place, centre):
    return place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]


@device
def _turn(couples, pose, first, last, centre, m):
    """ω of J ω = m, zero about axes along which the points lie: (J² + ε² 1) ω = J m."""
    xx = yy = zz = xy = xz = yz = 0.0
    for k in range(first, last):
        w = couples.share[k]
        _, place = _point(couples, pose, k)
        s = _from(place, centre)
        xx += w * (s[1] * s[1] + s[2] * s[2])
        yy += w * (s[0] * s[0] + s[2] * s[2])
        zz += w * (s[0] * s[0] + s[1] * s[1])
        xy -= w * s[0] * s[1]
        xz -= w * s[0] * s[2]
        yz -= w * s[1] * s[2]
    size = xx + yy + zz
    if size <= 0.0:
        return 0.0, 0.0, 0.0
    xx, yy, zz, xy, xz, yz = xx / size, yy / size, zz / size, xy / size, xz / size, yz / size
    b = (
        xx * m[0] + xy * m[1] + xz * m[2],
        xy * m[0] + yy * m[1] + yz * m[2],
        xz * m[0] + yz * m[1] + zz * m[2],
    )
    a = xx * xx + xy * xy + xz * xz + _NONE
    d = xy * xy + yy * yy + yz * yz + _NONE
    f = xz * xz + yz * yz + zz * zz + _NONE
    p = xx * xy + xy * yy + xz * yz
    q = xx * xz + xy * yz + xz * zz
    r = xy * xz + yy * yz + yz * zz
    # L D Lᵀ, whose errors turn the points about the line they lie on alone; those of cofactors change all of ω
    u, v = p / a, q / a
    e, w = d - u * p, r - u * q
    t = w / e
    g = f - v * q - t * w
    y = b[1] - u * b[0]
    z = (b[2] - v * b[0] - t * y) / g
    y = y / e - t * z
    return (b[0] / a - u * y - v * z) / size, y / size, z / size


@device
def add_couple(couples, c, amplitude, pose, force):
    """Add the forces and torques of a moment to those of the rows of its elements."""
    first, last = couples.start[c], couples.start[c + 1]
    moment = couples.moment[c]
    m = amplitude * moment[0], amplitude * moment[1], amplitude * moment[2]
    centre = _centroid(couples, pose, first, last)
    w = _turn(couples, pose, first, last, centre, m)
    rest = m
    for k in range(first, last):
        arm, place = _point(couples, pose, k)
        s = _from(place, centre)
        v, share = cross(w, s), couples.share[k]
        f = share * v[0], share * v[1], share * v[2]
        borne, about = cross(s, f), cross(arm, f)
        rest = rest[0] - borne[0], rest[1] - borne[1], rest[2] - borne[2]
        r = couples.row[k]
        for d in range(3):
            force[r, d] += f[d]
            force[r, 3 + d] += about[d]
    for k in range(first, last):
        for d in range(3):
            force[couples.row[k], 3 + d] += couples.share[k] * rest[d]
