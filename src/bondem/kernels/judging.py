"""What single bonds bear, and whether they break: the exact judgement of those that a loop has marked.

A loop over bonds marks those whose forces reach a bound; they are judged here one by one, at the end of their block,
before any of their ends has moved. Bonds that break hold both their ends back: these close the step with the whole
force, and do not open the next (`bondem.kernels.breaking`).

What is called from several places is compiled once for all of them (`kernel`), as it runs for few bonds.
"""

import math

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.bond_pass import branch
from bondem.kernels.soft_beam import whole_beam
from bondem.laws.beam_energy import bond_force
from bondem.laws.cell_energy import cross, scalar
from bondem.laws.failure.elliptic import elliptic_index
from bondem.laws.failure.linear_sum import linear_index
from bondem.laws.failure.mohr_coulomb import mohr_coulomb_index
from bondem.laws.failure.peripheral_stress import peripheral_index
from bondem.laws.rotations import rotate


@device
def judged(kind, load, s):
    """Index of a criterion, which breaks at 1, and what breaks it; its number is that of its class."""
    if kind == 0:
        return peripheral_index(load, s)
    if kind == 1:
        return mohr_coulomb_index(load, s)
    if kind == 2:
        return linear_index(load, s)
    return elliptic_index(load, s)


@device
def _across(a, e):
    """Length of what of a vector is not along a unit vector."""
    c = cross(a, e)
    return math.sqrt(scalar(c, c))


@loop(parallel=False)
def single_bond(pose, bonds, k):
    """Branch [m], force on j and torques on i and j [N, N·m] of one bond of the total formulation."""
    a, b = bonds.i[k], bonds.j[k]
    d = branch(pose, a, b, bonds.period)
    s = bonds.integrity[k]
    fx, fy, fz, ax, ay, az, bx, by, bz = bond_force(
        d[0], d[1], d[2],
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7], pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        bonds.X0[k], bonds.Y0[k], bonds.Z0[k], bonds.length[k],
        s * bonds.kn[k], s * bonds.A[k], s * bonds.B[k], s * bonds.C[k], s * bonds.kt[k],
    )  # fmt: skip
    return d, (fx, fy, fz), (ax, ay, az), (bx, by, bz)


@device
def _angle(pose, p, e, bonds, k):
    """Between a unit vector and the reference direction of a bond turned with an element [rad]."""
    q = rotate(pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], bonds.X0[k], bonds.Y0[k], bonds.Z0[k])
    return math.atan2(_across(q, e), scalar(q, e))


@loop(parallel=False)
def index_of(pose, bonds, kind, coefficient, station, k):
    """Index and mode of one bond.

    A criterion sees: axial force N, tension positive, shear force, bending and twisting moment, each of these without
    sign, strain, and the larger angle between the axis and its ends.
    """
    d, force, on_i, on_j = single_bond(pose, bonds, k)
    l = math.sqrt(scalar(d, d))
    e = d[0] / l, d[1] / l, d[2] / l
    if station < 0.0:
        bending = max(_across(on_i, e), _across(on_j, e))
    else:
        c, arm = cross(e, force), station * l
        bending = _across((on_i[0] + arm * c[0], on_i[1] + arm * c[1], on_i[2] + arm * c[2]), e)
    angle = 0.0
    if kind == 3:
        angle = max(_angle(pose, bonds.i[k], e, bonds, k), _angle(pose, bonds.j[k], e, bonds, k))
    load = (
        -scalar(force, e), _across(force, e), bending, math.fabs(scalar(on_i, e)), l / bonds.length[k] - 1.0, angle
    )  # fmt: skip
    return judged(kind, load, coefficient)


@device
def judge_bond(pose, bonds, breaks, k):
    """Index and mode of one bond, by the tables of `Breaks`."""
    return index_of(pose, bonds, breaks.kind, breaks.coefficient[k], breaks.station[k], k)


@loop(parallel=False)
def judge_block(pose, bonds, breaks, block, first, place):
    """Of the marked bonds first … place of a block keep those that break, and hold back their ends; how many.

    Those that begin to soften hold nobody back; what they hold now is written down.
    """
    count, softens = 0, breaks.softens
    if breaks.now[1] >= 0.0:
        for e in range(first, place):
            k = breaks.marked[e]
            if bonds.integrity[k] <= 0.0:
                continue
            index, mode = judge_bond(pose, bonds, breaks, k)
            if index >= 1.0:
                breaks.marked[first + count] = k
                if softens:
                    _, _, opening, sliding = whole_beam(pose, bonds, k)
                    breaks.onset[k, 0], breaks.onset[k, 1], breaks.onset[k, 2] = opening, sliding, mode
                else:
                    breaks.held[bonds.i[k]] = 1
                    breaks.held[bonds.j[k]] = 1
                count += 1
    breaks.found[block] = count
    return 0 if softens else count


@kernel(parallel=False)
def bond_indices(pose, bonds, kind, coefficient, station):
    """Index of every bond [-], 0 where broken, (m,)."""
    found = np.zeros(bonds.m)
    for k in range(bonds.m):
        if bonds.integrity[k] > 0.0:
            found[k] = index_of(pose, bonds, kind, coefficient[k], station[k], k)[0]
    return found
