"""How cracks are treated in a step: stresses of their cells, integrities, and when they rest or part."""

import math

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.contact_pairs import let_touch
from bondem.kernels.crack_energy import crack_energy, halves
from bondem.kernels.crack_list import NEW, known, read_three, treat, weigh_cracked, write_three
from bondem.kernels.crack_tables import (
    ACTIVE,
    ARM_I,
    ARM_J,
    BEFORE,
    FACET,
    FACING,
    GAP,
    NORMAL,
    ONSET,
    PARTED,
    RESTING,
    RUB,
    SHARE_I,
    SHARE_J,
    SLIP,
    STATUS,
    TOP,
)
from bondem.kernels.single_facets import column, frame
from bondem.laws.cell_energy import opened, scalar, turned_by
from bondem.laws.softening import crack_softness, crack_swelling, opening_force, plus, softened, whole_force

# By how much the integrity of a facet that softens falls in a step at most.
_FASTEST = 0.1
# A resting crack wakes at these shares of the force at which it softens, and of its force across it; it goes to rest
# well below. Too early costs time only.
_CALM, _ASLEEP, _GRAZING = 0.98, 0.9, 0.1
# Faces whose normals are further apart than this cosine do not bear on each other as planes any more.
_FACING = 0.7


@loop(parallel=False)
def _measure(g, place, n):
    """Write what is known of a crack into g; `place` is its `frame`, n its normal in the frames of both cells."""
    d, p, q, a, b, u, v = place
    a, b = turned_by(p, a), turned_by(q, b)
    n, m = turned_by(p, n), turned_by(q, n)
    write_three(g, GAP, opened(d, a, b))
    write_three(g, SHARE_I, turned_by(p, u))
    write_three(g, SHARE_J, turned_by(q, v))
    write_three(g, ARM_I, a)
    write_three(g, ARM_J, b)
    g[FACING] = scalar(n, m)
    n = plus(n, 1.0, m)
    l = math.sqrt(scalar(n, n))
    write_three(g, NORMAL, (n[0] / l, n[1] / l, n[2] / l))


@loop(parallel=False)
def measure_cracks(pose, bonds, cells, cracks):
    """What is known of all cracks that are treated one by one, and V θ of their cells without these."""
    for c in range(cracks.sizes[0]):
        if cracks.row[c, STATUS] == ACTIVE:
            k = np.int64(cracks.row[c, FACET])
            _measure(cracks.geometry[c], frame(pose, bonds, cells, k), column(cells.normal, k))
    for e in range(cracks.sizes[1]):
        p = cracks.cell[e]
        cracks.base[p] = pose[p, STRESS] / cells.weight[p] if cells.weight[p] != 0.0 else 0.0


@loop(parallel=False)
def relax_cells(pose, bonds, cells, cracks):
    """Stresses of cells with cracks, by Newton's method on a piecewise linear, rising function."""
    for e in range(cracks.sizes[1]):
        p = cracks.cell[e]
        W, stress = cells.weight[p], pose[p, STRESS]
        for _ in range(30):
            swelling, softness, c = cracks.base[p], 0.0, cracks.head[p]
            while c >= 0:
                k = np.int64(cracks.row[c, FACET])
                own = bonds.i[k] == p
                if cracks.row[c, STATUS] == ACTIVE:
                    g, s = cracks.geometry[c], cracks.integrity[k]
                    gap, normal = read_three(g, GAP), read_three(g, NORMAL)
                    share = read_three(g, SHARE_I) if own else read_three(g, SHARE_J)
                    part = cracks.part[k] if own else 1.0 - cracks.part[k]
                    opening, along = opening_force(whole_force(cells.k[k], part, gap, share, stress), normal)
                    swelling += crack_swelling(cells.k[k], s, gap, share, opening)
                    softness += crack_softness(cells.k[k], s, part, share, normal, along < 0.0)
                c = cracks.after_i[c] if own else cracks.after_j[c]
            change = (W * swelling - stress) / (1.0 + W * softness)
            stress += change
            if abs(change) <= 1e-14 * abs(stress):
                break
        pose[p, STRESS] = stress


@device
def _hand_over(bonds, cells, cracks, c, k, sign):
    """Add what a resting crack does to V θ of its cells to `base`, or take it off."""
    g, s = cracks.geometry[c], sign * cracks.integrity[k]
    gap = read_three(g, GAP)
    cracks.base[bonds.i[k]] += s * scalar(read_three(g, SHARE_I), gap)
    cracks.base[bonds.j[k]] += s * scalar(read_three(g, SHARE_J), gap)
    weigh_cracked(bonds, cells, cracks, bonds.i[k])
    weigh_cracked(bonds, cells, cracks, bonds.j[k])


@loop(parallel=False)
def wake_cracks(pose, bonds, cells, contacts, cracks):
    """Treat those resting cracks one by one that are about to soften or close; whether there are any."""
    woken = False
    for c in range(cracks.sizes[0]):
        row = cracks.row[c]
        if row[STATUS] != RESTING:
            continue
        k = np.int64(row[FACET])
        place = frame(pose, bonds, cells, k)
        d, p, q, a, b, u, v = place
        gap, u, v = opened(d, turned_by(p, a), turned_by(q, b)), turned_by(p, u), turned_by(q, v)
        K, one, other = cells.k[k], pose[bonds.i[k], STRESS], pose[bonds.j[k], STRESS]
        f = plus(plus((K * gap[0], K * gap[1], K * gap[2]), one, u), other, v)
        across = plus(u, 1.0, v)  # about along the normal
        square = scalar(f, f)
        if square < (_CALM * row[TOP]) ** 2:
            if scalar(f, across) > _GRAZING * math.sqrt(square * scalar(across, across)):
                continue
        _measure(cracks.geometry[c], place, column(cells.normal, k))
        if cracks.integrity[k] == 0.0 and _leaves(cracks, c, k):
            treat(bonds, cracks, c, k, PARTED)
            _part(pose, bonds, contacts, row, k)
            continue
        treat(bonds, cracks, c, k, ACTIVE)
        row[BEFORE] = NEW
        normal = read_three(cracks.geometry[c], NORMAL)
        write_three(row, SLIP, turned_by((p[0], -p[1], -p[2], -p[3]), plus(gap, -scalar(gap, normal), normal)))
        _hand_over(bonds, cells, cracks, c, k, -1.0)
        woken = True
    return woken


@loop(parallel=False)
def soften(pose, bonds, cells, contacts, cracks):
    """Integrities of all cracks at the present openings; some come to rest, some part. Whether any changed."""
    changed = False
    for c in range(cracks.sizes[0]):
        row = cracks.row[c]
        if row[STATUS] != ACTIVE:
            continue
        k, K, w, gap, normal, shares, stresses = known(pose, bonds, cells, cracks, c)
        (one, press_i), (other, press_j) = halves(K, w, gap, normal, shares, stresses)
        s = cracks.integrity[k]
        whole = plus((w * one[0], w * one[1], w * one[2]), 1.0 - w, other)
        force = math.sqrt(scalar(whole, whole))
        if row[BEFORE] == NEW:
            row[BEFORE] = s
            row[TOP] = max(row[TOP], force)
            continue
        row[BEFORE] = s
        new = 0.0
        if s > 0.0:
            at_once = row[ONSET] == 0.0 or cracks.last[k] == 0.0
            most = cracks.fastest[k] if at_once else _FASTEST
            new = max(softened(s, force / cracks.onset.area[k], row[ONSET], cracks.last[k]), s - most)
            if new < 1e-9:
                new = 0.0
        if new < s:
            cracks.integrity[k] = new
            row[TOP] = max(row[TOP], force)
            changed = True
        elif s == 0.0 and _leaves(cracks, c, k):
            across, along = crack_energy(K, w, s, gap, normal, (one, other), read_three(row, RUB))
            cracks.released[0] += across + along  # none of bending is left
            _leave(bonds, cells, cracks, c, k, PARTED)
            _part(pose, bonds, contacts, row, k)
            changed = True
        elif press_i == 0.0 and press_j == 0.0:
            calm = s == 0.0 or force < _ASLEEP * row[TOP]
            if calm and scalar(whole, normal) > 2.0 * _GRAZING * force:
                _leave(bonds, cells, cracks, c, k, RESTING)
                changed = True
    return changed


@device
def _leaves(cracks, c, k):
    """Whether the faces of a crack no longer face each other."""
    g = cracks.geometry[c]
    gap, normal = read_three(g, GAP), read_three(g, NORMAL)
    along = max(scalar(gap, normal), 0.0)
    across = plus(gap, -scalar(gap, normal), normal)
    return g[FACING] < _FACING or max(along * along, scalar(across, across)) > cracks.onset.area[k]


@device
def _part(pose, bonds, contacts, row, k):
    """Let the cells of a facet touch like others from now on, where cells do."""
    row[TOP] = math.inf
    if contacts is not None:  # decided when compiled
        row[TOP] = let_touch(pose, bonds.period, contacts, k)


@device
def _leave(bonds, cells, cracks, c, k, status):
    """Treat a crack one by one no longer."""
    row = cracks.row[c]
    treat(bonds, cracks, c, k, status)
    if cracks.integrity[k] == 0.0:
        row[TOP] = math.inf
    write_three(cracks.pull[c], 0, (0.0, 0.0, 0.0))
    write_three(row, RUB, (0.0, 0.0, 0.0))
    write_three(row, SLIP, (0.0, 0.0, 0.0))
    _hand_over(bonds, cells, cracks, c, k, 1.0)
