"""Facets of cells that break: they are free facets of both cells from then on, whose dilatation weighs less.

With a facet its two cells change their stress, and with these all their other facets their force. So the neighbours
of both cells wait for it too (`bondem.kernels.breaking`). Facets are judged between the two passes over them, when
stresses are known and nobody has moved.

What is called from several places here is compiled once for all of them (`kernel`), as it runs for few facets.
"""

import math

from bondem._compile import device, kernel, loop
from bondem.kernels.breaking import log_break, take_dashpot, take_off
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.contact_pairs import begin_contact
from bondem.kernels.grip_pass import grip_load, grip_swelling
from bondem.kernels.judging import judged
from bondem.kernels.lanes import fused
from bondem.kernels.single_facets import column, facet_of, facets_of, frame, present_normal, resistance, single_facet
from bondem.laws.cell_energy import facet_energy, opened, scalar, swellings, turned_by

# What an element waits for: a neighbour, or a facet of its own; and one that is listed.
_NEAR, _OWN, _LISTED = 1, 2, 3


@loop(parallel=False)
def judge_facet(pose, bonds, cells, kind, coefficient, k):
    """Index and mode of a facet: a criterion sees its normal force, tension positive, and its shear force."""
    force, _, _ = single_facet(pose, bonds, cells, k)
    n = present_normal(pose, bonds, cells, k)
    along = -scalar(force, n)
    x, y, z = force[0] + along * n[0], force[1] + along * n[1], force[2] + along * n[2]
    return judged(kind, (along, math.sqrt(x * x + y * y + z * z), 0.0, 0.0, 0.0, 0.0), coefficient)


@device
def _hold(bonds, breaks, p):
    """A cell waits, and all its neighbours."""
    for e in range(facets_of(breaks, p)):
        k = facet_of(breaks, p, e)
        other = bonds.i[k] if bonds.i[k] != p else bonds.j[k]
        if bonds.integrity[k] > 0.0 and breaks.held[other] == 0:
            breaks.held[other] = _NEAR
    breaks.held[p] = _OWN


@loop(parallel=False)
def judge_facets(pose, bonds, cells, breaks):
    """Of the marked facets keep those that break, and hold back their cells and the neighbours of these."""
    for d in range(len(breaks.found)):
        first, count = breaks.begin[d], 0
        if breaks.now[1] >= 0.0:
            for e in range(first, first + breaks.found[d]):
                k = breaks.marked[e]
                if bonds.integrity[k] <= 0.0:
                    continue
                if judge_facet(pose, bonds, cells, breaks.kind, breaks.coefficient[k], k)[0] >= 1.0:
                    breaks.marked[first + count] = k
                    _hold(bonds, breaks, bonds.i[k])
                    _hold(bonds, breaks, bonds.j[k])
                    count += 1
        breaks.found[d] = count


@loop(parallel=False)
def weigh(bonds, cells, breaks, p):
    """λ / V of a cell with the facets that it has left: those that broke open until they bear nothing."""
    inward = outward = 0.0
    for e in range(facets_of(breaks, p)):
        k = facet_of(breaks, p, e)
        if bonds.j[k] == p:
            inward += (1.0 - bonds.integrity[k]) * breaks.slack_j[k]
        else:
            outward += (1.0 - bonds.integrity[k]) * breaks.slack_i[k]
    cells.weight[p] = breaks.weight[p] / fused(breaks.weight[p], inward + outward, 1.0)


@kernel(parallel=False)
def weigh_all(bonds, cells, breaks):
    """The same of all cells, as a run begins."""
    for p in range(len(breaks.weight)):
        weigh(bonds, cells, breaks, p)


@device
def _swelling(pose, rest, bonds, body, breaks, p):
    """V θ of a cell [m³]."""
    cells, grips = body.cells, body.grips
    total = cells.given[p]
    for g in range(len(grips.cell)):
        if grips.cell[g] == p:
            total += grip_swelling(pose, rest, grips, g)
    for e in range(facets_of(breaks, p)):
        k = facet_of(breaks, p, e)
        if bonds.integrity[k] > 0.0:
            d, a, b, u, v, x, y = frame(pose, bonds, cells, k)
            one, other = swellings(d, a, b, u, v, x, y)
            total += bonds.integrity[k] * (one if bonds.i[k] == p else other)
    return total


@loop(parallel=False)
def dilated(pose, rest, bonds, body, breaks, p):
    """Energy of dilatation of a cell [J]; its stress is brought up to date."""
    total = _swelling(pose, rest, bonds, body, breaks, p)
    pose[p, STRESS] = body.cells.weight[p] * total
    return 0.5 * body.cells.weight[p] * total * total


@device
def _exchange(elements, bonds, body, sums, rows, breaks, count, sign):
    """Add what all facets and walls of the listed cells do, times `sign`, to the sums of those that wait."""
    pose, grips = elements.pose, body.grips
    for c in range(count):
        p = breaks.turn[c]
        for e in range(facets_of(breaks, p)):
            k = facet_of(breaks, p, e)
            i, j = bonds.i[k], bonds.j[k]
            other = i if i != p else j
            if bonds.integrity[k] <= 0.0 or (breaks.held[other] == _LISTED and other < p):
                continue
            force, on_i, on_j = single_facet(pose, bonds, body.cells, k)
            take_off(sums, breaks.first_row + i, sign, -sign, force, on_i)
            take_off(sums, breaks.first_row + j, -sign, -sign, force, on_j)
    for g in range(len(grips.cell)):
        if breaks.held[grips.cell[g]] == _LISTED:
            if sign > 0.0:
                grip_load(pose, elements.rest, grips, g)
            for d in range(6):
                rows.grip[grips.row[g], d] += sign * grips.load[g, d]


@device
def _break_facet(elements, bonds, body, sums, added, contacts, breaks, k):
    pose, cells, i, j = elements.pose, body.cells, bonds.i[k], bonds.j[k]
    _, mode = judge_facet(pose, bonds, cells, breaks.kind, breaks.coefficient[k], k)
    d, p, q, a, b, _, _ = frame(pose, bonds, cells, k)
    if added is not None:
        if len(added.dashed) > 0:
            take_dashpot(elements, bonds, added, breaks.first_row, k, d)
    s = bonds.integrity[k]
    part = facet_energy(d, p, q, a, b, column(cells.normal, k), cells.k[k], resistance(cells, 1.0, k))
    energy = s * (part[0] + part[1] + part[2] + part[3])
    energy += dilated(pose, elements.rest, bonds, body, breaks, i)
    energy += dilated(pose, elements.rest, bonds, body, breaks, j)
    bonds.integrity[k] = 0.0
    weigh(bonds, cells, breaks, i)
    weigh(bonds, cells, breaks, j)
    energy -= dilated(pose, elements.rest, bonds, body, breaks, i)
    energy -= dilated(pose, elements.rest, bonds, body, breaks, j)
    if contacts is not None:  # decided when compiled
        energy -= begin_contact(elements, bonds, contacts, sums, breaks.first_row, k)
    arm = turned_by(p, a)
    gap = scalar(opened(d, arm, turned_by(q, b)), present_normal(pose, bonds, cells, k))
    log_break(breaks, k, mode, gap, energy, (pose[i, 0] + arm[0], pose[i, 1] + arm[1], pose[i, 2] + arm[2]))


@loop(parallel=False)
def break_facets(elements, bonds, body, sums, rows, added, contacts, breaks):
    """Break the facets that were found in this step, in their order, and correct the sums of those that wait.

    Cells that are pressed together bear on at once, as spheres.
    """
    count = 0
    for d in range(len(breaks.found)):
        for e in range(breaks.begin[d], breaks.begin[d] + breaks.found[d]):
            k = breaks.marked[e]
            for end in range(2):
                p = bonds.i[k] if end == 0 else bonds.j[k]
                if breaks.held[p] == _OWN:
                    breaks.held[p] = _LISTED
                    breaks.turn[count] = p
                    count += 1
    if count == 0:
        return
    _exchange(elements, bonds, body, sums, rows, breaks, count, -1.0)
    for d in range(len(breaks.found)):
        for e in range(breaks.begin[d], breaks.begin[d] + breaks.found[d]):
            _break_facet(elements, bonds, body, sums, added, contacts, breaks, breaks.marked[e])
    _exchange(elements, bonds, body, sums, rows, breaks, count, 1.0)


@kernel(parallel=False)
def facet_indices(pose, bonds, cells, kind, coefficient, found):
    """Index of every facet [-], 0 where broken, into `found`, (m,)."""
    for k in range(bonds.m):
        found[k] = 0.0
        if bonds.integrity[k] > 0.0:
            found[k] = judge_facet(pose, bonds, cells, kind, coefficient[k], k)[0]
