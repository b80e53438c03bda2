"""What facets of any integrity bear in small motions about the reference (`bondem.laws.softening`), without friction.

Of each half that presses, what is along the normal stays whole.
"""

import math
from typing import NamedTuple

import numpy as np

from bondem._compile import device, kernel
from bondem.laws.cell_energy import cross, scalar
from bondem.laws.softening import plus

# A half facet is closed or opens where its force along the normal is beyond this share of its size.
_TURNS = 1e-9


class DamagedFacets(NamedTuple):
    """Constants and states of m facets, a row each; see `bondem.model.cell_constants`."""

    i: np.ndarray  #: (m,)
    j: np.ndarray
    k: np.ndarray
    area: np.ndarray
    part: np.ndarray  #: part of cell i in the compliance, (m,)
    lever_i: np.ndarray  #: (m, 3)
    lever_j: np.ndarray
    share_i: np.ndarray
    share_j: np.ndarray
    normal: np.ndarray
    H: np.ndarray  #: (m, 3, 3)
    integrity: np.ndarray  #: (m,)
    closed: np.ndarray  #: halves that press, (m, 2)


class Borne(NamedTuple):
    """What facets bear."""

    traction: np.ndarray  #: (m, 3)
    bending: np.ndarray  #: (m,)
    opening: np.ndarray  #: F / A of facets that have lost integrity, as if they were whole, (m, 3)
    opened: np.ndarray  #: |F⁺| / A of these, (m,)
    turned: np.ndarray  #: halves of these that close or open, (m, 2)
    moment: np.ndarray  #: V σ of cells, to which facets add, xx, yy, zz, xy, xz, yz, (n, 6)


@device
def three(rows, k):
    """Row k of (m, 3)."""
    return rows[k, 0], rows[k, 1], rows[k, 2]


@device
def _set(rows, k, a):
    rows[k, 0], rows[k, 1], rows[k, 2] = a


@device
def _end(u, phi, p, lever):
    return plus(three(u, p), 1.0, cross(three(phi, p), lever))


@device
def _swollen(s, shut, share, gap, normal):
    """V θ of a half, s δ and, pressed, (1 - s) of what is along the normal."""
    grown = s * scalar(share, gap)
    if shut:
        grown += (1.0 - s) * scalar(share, normal) * scalar(gap, normal)
    return grown


@kernel(parallel=False)
def part_facets(facets, u, phi, gap, swelling):
    """Write gaps of facets [m], (m, 3), and add V θ [m³] to those of their cells, (n,)."""
    s, closed = facets.integrity, facets.closed
    for k in range(len(facets.k)):
        i, j = facets.i[k], facets.j[k]
        d = plus(_end(u, phi, j, three(facets.lever_j, k)), -1.0, _end(u, phi, i, three(facets.lever_i, k)))
        _set(gap, k, d)
        n = three(facets.normal, k)
        swelling[i] += _swollen(s[k], closed[k, 0], three(facets.share_i, k), d, n)
        swelling[j] += _swollen(s[k], closed[k, 1], three(facets.share_j, k), d, n)


@device
def _add_moment(moment, p, arm, f, sign):
    """Add sym b⊗f to V σ of a cell."""
    moment[p, 0] += sign * arm[0] * f[0]
    moment[p, 1] += sign * arm[1] * f[1]
    moment[p, 2] += sign * arm[2] * f[2]
    moment[p, 3] += 0.5 * sign * (arm[0] * f[1] + arm[1] * f[0])
    moment[p, 4] += 0.5 * sign * (arm[0] * f[2] + arm[2] * f[0])
    moment[p, 5] += 0.5 * sign * (arm[1] * f[2] + arm[2] * f[1])


@device
def _half(F, s, shut, n):
    """What a half bears, its F⁺, and whether it closes or opens now."""
    along, size = scalar(F, n), _TURNS * math.sqrt(scalar(F, F))
    if shut:
        opens = plus(F, -along, n)
        return plus((s * F[0], s * F[1], s * F[2]), (1.0 - s) * along, n), opens, along > size
    return (s * F[0], s * F[1], s * F[2]), F, along < -size


@kernel(parallel=False)
def load_facets(facets, phi, gap, stress, borne):
    """Write what facets bear, and add their moments to those of their cells.

    Args:
        facets: m of them.
        phi: rotations of the cells, (n, 3).
        gap: of the facets [m], (m, 3).
        stress: λ θ of the cells [Pa], (n,).
        borne: what is written.
    """
    for k in range(len(facets.k)):
        i, j, stiff, s = facets.i[k], facets.j[k], facets.k[k], facets.integrity[k]
        d, n, w = three(gap, k), three(facets.normal, k), facets.part[k]
        whole = stiff * d[0], stiff * d[1], stiff * d[2]
        share_i, share_j = three(facets.share_i, k), three(facets.share_j, k)
        if s < 1.0:
            one, open_i, borne.turned[k, 0] = _half(plus(whole, stress[i] / w, share_i), s, facets.closed[k, 0], n)
            v = 1.0 - w
            two, open_j, borne.turned[k, 1] = _half(plus(whole, stress[j] / v, share_j), s, facets.closed[k, 1], n)
            force = plus((w * one[0], w * one[1], w * one[2]), v, two)
            opens = plus((w * open_i[0], w * open_i[1], w * open_i[2]), v, open_j)
            borne.opened[k] = math.sqrt(scalar(opens, opens)) / facets.area[k]
            whole = plus(plus(whole, stress[i], share_i), stress[j], share_j)
            one_area = 1.0 / facets.area[k]
            _set(borne.opening, k, (one_area * whole[0], one_area * whole[1], one_area * whole[2]))
        else:
            force = plus(plus(whole, stress[i], share_i), stress[j], share_j)
            borne.opened[k] = 0.0
            borne.turned[k, 0] = borne.turned[k, 1] = False
        a = 1.0 / facets.area[k]
        _set(borne.traction, k, (a * force[0], a * force[1], a * force[2]))
        _add_moment(borne.moment, i, three(facets.lever_i, k), force, 1.0)
        _add_moment(borne.moment, j, three(facets.lever_j, k), force, -1.0)
        turn, square = plus(three(phi, j), -1.0, three(phi, i)), 0.0
        for r in range(3):
            square += turn[r] * scalar(three(facets.H[k], r), turn)
        # of slivers below 0 by rounding
        borne.bending[k] = math.sqrt(stiff * max(square, 0.0)) * a
