"""Bonds of the non-local law that break: judged by the mean stress of their two elements, eq (5).

They are judged when the stresses of the step are known and nobody has moved. σ1 of a mean is at most the mean of
both σ1, and σ3 at least the mean of both σ3: only bonds that reach the criterion by these are looked at closely.
What breaks holds its ends back as other bonds do (`bondem.kernels.breaking`); the stresses of these, which the next
step takes, are then without the bond and with the contact that follows it.
"""

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.bond_pass import branch, group, groups
from bondem.kernels.breaking import log_break, take_dashpot, take_off
from bondem.kernels.cell_yield import principal_stresses
from bondem.kernels.contact_pairs import begin_contact
from bondem.kernels.lagged_stress import LARGEST, LEAST, pair_mean, replace_force, turn_stresses
from bondem.kernels.lane_memory import entry, places_below, places_from, row, side
from bondem.kernels.lanes import WIDTH, reached, where_positive, zero_of
from bondem.kernels.non_local import FORCE, OUTPUT_ROWS, TORQUE_I, TORQUE_J, normal_gap
from bondem.laws.failure.principal import principal_index, principal_size


@loop(parallel=False)
def pair_index(space, coefficient, i, j, a, v):
    """Index and mode of a bond by the stresses of its elements in space; a and v are (3, 3) to use."""
    high, low, _, _ = principal_stresses(pair_mean(space, i, j), a, v)
    return principal_index(high, low, coefficient)


@device
def _near(bonds, space, coefficient, k, m):
    """Which of the bonds k … reach the criterion by the bounds of both ends, as bits."""
    u, v = row(space, places_below(bonds.i, k, m)), row(space, places_below(bonds.j, k, m))
    p, s = places_from(k, m), side(bonds.integrity, k)
    own = entry(coefficient, p, 0), entry(coefficient, p, 1), entry(coefficient, p, 2)
    size = principal_size(0.5 * (u[LARGEST] + v[LARGEST]), 0.5 * (u[LEAST] + v[LEAST]), own)
    none = zero_of(size)
    return reached(where_positive(s, size, none), none + 1.0)


@loop(parallel=False)
def _judge_domain(bonds, table, breaks, cut, d):
    """Mark the bonds of a domain that break."""
    first, count, last = breaks.begin[d], 0, cut.bond[cut.domain[d + 1]]
    coefficient, a, v = breaks.coefficient, np.empty((3, 3)), np.empty((3, 3))
    for g in range(groups(cut.bond[cut.domain[d]], last)):
        k, known = group(cut.bond[cut.domain[d]], last, g)
        near = _near(bonds, table.space, coefficient, k, np.uint64(len(coefficient)))
        if near != 0:
            for n in range(known, WIDTH):
                if (near >> n) & 1:
                    e = np.int64(k) + n
                    if pair_index(table.space, coefficient[e], bonds.i[e], bonds.j[e], a, v)[0] >= 1.0:
                        breaks.marked[first + count] = e
                        count += 1
    breaks.found[d] = count


@loop(parallel=True)
def _judge_domains(bonds, table, breaks, cut):
    for d in prange(len(cut.domain) - 1):
        _judge_domain(bonds, table, breaks, cut, np.int64(d))


@loop(parallel=False)
def judge_pairs(bonds, table, breaks, cut):
    """Mark the bonds that break in this step, and hold back their ends."""
    if breaks.now[1] < 0.0:
        breaks.found[:] = 0
        return
    if len(cut.domain) > 2:
        _judge_domains(bonds, table, breaks, cut)
    else:
        _judge_domain(bonds, table, breaks, cut, 0)
    for d in range(len(breaks.found)):
        for e in range(breaks.begin[d], breaks.begin[d] + breaks.found[d]):
            k = breaks.marked[e]
            breaks.held[bonds.i[k]] = breaks.held[bonds.j[k]] = 1


@loop(parallel=False)
def _break_pair(elements, bonds, table, sums, added, contacts, breaks, k):
    """Take the force of a bond off the sums of its ends, which are where they were when it was found."""
    pose, first_row, output = elements.pose, breaks.first_row, table.output
    i, j = bonds.i[k], bonds.j[k]
    _, mode = pair_index(table.space, breaks.coefficient[k], i, j, np.empty((3, 3)), np.empty((3, 3)))
    force = output[FORCE, k], output[FORCE + 1, k], output[FORCE + 2, k]
    on_i = output[TORQUE_I, k], output[TORQUE_I + 1, k], output[TORQUE_I + 2, k]
    on_j = output[TORQUE_J, k], output[TORQUE_J + 1, k], output[TORQUE_J + 2, k]
    take_off(sums, first_row + i, 1.0, 1.0, force, on_i)
    take_off(sums, first_row + j, -1.0, -1.0, force, on_j)
    if added is not None:
        if len(added.dashed) > 0:
            take_dashpot(elements, bonds, added, first_row, k, branch(pose, i, j, bonds.period))
    gap, slip, place = normal_gap(pose, bonds, table, k)
    energy = 0.5 * bonds.integrity[k] * (table.kn[k] * gap * gap + table.kt[k] * slip)
    bonds.integrity[k] = 0.0
    if contacts is not None:  # decided when compiled
        energy -= begin_contact(elements, bonds, contacts, sums, first_row, k)
    replace_force(pose, bonds.period, table, contacts, k, i, j)
    for c in range(OUTPUT_ROWS):
        output[c, k] = 0.0
    log_break(breaks, k, mode, gap, energy, place)


@loop(parallel=False)
def break_pairs(elements, bonds, table, sums, added, contacts, breaks):
    """Break the bonds that were found in this step, in their order; what is pressed together bears on at once.

    The energy released is that of the springs, less what the contact takes over; what extra forces have taken up
    stays in an entry of its own.
    """
    for d in range(len(breaks.found)):
        for e in range(breaks.begin[d], breaks.begin[d] + breaks.found[d]):
            _break_pair(elements, bonds, table, sums, added, contacts, breaks, breaks.marked[e])


@kernel(parallel=False)
def pair_indices(pose, bonds, table, coefficient, found):
    """Index of every bond by the stresses of a state [-], 0 where broken, into `found`, (m,)."""
    turn_stresses(pose, table, 0, len(table.inverse))
    a, v = np.empty((3, 3)), np.empty((3, 3))
    for k in range(bonds.m):
        found[k] = 0.0
        if bonds.integrity[k] > 0.0:
            found[k] = pair_index(table.space, coefficient[k], bonds.i[k], bonds.j[k], a, v)[0]
