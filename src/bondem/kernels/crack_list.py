"""The list of cracked facets, in the order in which they began, and the cracks of each cell."""

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_stress import pair_stress
from bondem.kernels.cell_yield import principal_stresses
from bondem.kernels.crack_energy import bending_opening
from bondem.kernels.crack_tables import (
    ACTIVE,
    AT_REST,
    BEFORE,
    CELLS,
    CRACKS,
    FACET,
    GAP,
    NORMAL,
    ONSET,
    RESTING,
    SHARE_I,
    SHARE_J,
    STATUS,
    TREATED_ONES,
)
from bondem.kernels.single_facets import column, facet_of, facets_of, orientation, present_normal, resistance
from bondem.kernels.stress_index import by_address, strength_along

# What stands for the integrity a step ago of a crack that begins: its rate is found first.
NEW = 2.0


@device
def read_three(table, r, first):
    """Three numbers of row r, from `first` on: no view of the row, whose references would be counted."""
    return table[r, first], table[r, first + 1], table[r, first + 2]


@device
def write_three(table, r, first, a):
    """Write them."""
    table[r, first], table[r, first + 1], table[r, first + 2] = a[0], a[1], a[2]


@device
def known(pose, bonds, cells, cracks, c):
    """Of a crack that is measured: facet, k, part w of cell i, gap, normal, and shares and stresses of both sides."""
    k, geometry = np.int64(cracks.facet[c]), cracks.geometry
    shares = read_three(geometry, c, SHARE_I), read_three(geometry, c, SHARE_J)
    stresses = pose[bonds.i[k], STRESS], pose[bonds.j[k], STRESS]
    gap, normal = read_three(geometry, c, GAP), read_three(geometry, c, NORMAL)
    return k, cells.k[k], cracks.part[k], gap, normal, shares, stresses


@device
def treat(bonds, cracks, c, k, status):
    """Treat a crack one by one from now on, or as a facet of its integrity among the others."""
    cracks.row[c, STATUS] = status
    cracks.listed[k] = 1 + status
    bonds.integrity[k] = 0.0 if status == ACTIVE else cracks.integrity[k]


@loop(parallel=False)
def list_cracks(bonds, cracks):
    """Make the lists anew: cracks that are treated one by one, those that rest, and halves of the first, by cell."""
    sizes, active, resting, listed, facet = cracks.sizes, cracks.active, cracks.resting, cracks.listed, cracks.facet
    cell, head, after, at_i, at_j = cracks.cell, cracks.head, cracks.after, bonds.i, bonds.j
    for e in range(sizes[CELLS]):
        head[cell[e]] = -1
    treated = rest = count = 0
    for c in range(sizes[CRACKS]):
        k = facet[c]
        if listed[k] == 1 + RESTING:
            resting[rest] = c
            rest += 1
        elif listed[k] == 1 + ACTIVE:
            active[treated] = c
            treated += 1
            for side in range(2):
                p = at_i[k] if side == 0 else at_j[k]
                if head[p] < 0:
                    cell[count] = p
                    count += 1
                after[2 * c + side], head[p] = head[p], 2 * c + side
    sizes[CELLS], sizes[TREATED_ONES], sizes[AT_REST] = count, treated, rest


@device
def bent_stress(s, n, bent):
    """Mean stress s of two cells with what bending pulls along n beyond it, by which a criterion is judged [Pa]."""
    along = (
        s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + s[2] * n[2] * n[2]
        + 2.0 * (s[3] * n[0] * n[1] + s[4] * n[0] * n[2] + s[5] * n[1] * n[2])
    )  # fmt: skip
    more = max(bent - max(along, 0.0), 0.0)
    return (
        s[0] + more * n[0] * n[0], s[1] + more * n[1] * n[1], s[2] + more * n[2] * n[2],
        s[3] + more * n[0] * n[1], s[4] + more * n[0] * n[2], s[5] + more * n[1] * n[2],
    )  # fmt: skip


@loop(parallel=False)
def begin_cracks(pose, bonds, cells, stress, onset, cracks):
    """Facets that were marked begin to crack, in their order."""
    a, v = np.empty((3, 3)), np.empty((3, 3))
    marked, force = onset.marked, cells.force
    for k in range(bonds.m):
        if marked[k] == 0:
            continue
        c = cracks.sizes[CRACKS]
        row, strength = cracks.row[c], 0.0
        if marked[k] == 1:
            strength = onset.strength[k]
        if marked[k] == 1 and onset.judge != 0:
            mean = pair_stress(stress.tensor, bonds.i[k], bonds.j[k])
            i, j = orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
            bent = bending_opening(i, j, cells.bends[k], resistance(cells, 1.0, k), mean)
            mean = bent_stress(mean, present_normal(pose, bonds, cells, k), bent)
            high, _, _, _ = principal_stresses(mean, a, v)
            strength = strength_along(by_address, onset, mean, high, strength, a)
        row[:] = 0.0
        row[FACET], row[ONSET], row[BEFORE] = k, strength, NEW
        write_three(cracks.pull, c, 0, column(force, k))
        cracks.sizes[CRACKS] += 1
        cracks.facet[c] = k
        treat(bonds, cracks, c, k, ACTIVE)
        onset.cracked[bonds.i[k]] = onset.cracked[bonds.j[k]] = 1
        marked[k] = 0


@loop(parallel=False)
def link_cracks(bonds, cells, cracks):
    """Lists and weights of all cracks, as a run begins."""
    for c in range(cracks.sizes[CRACKS]):
        k = np.int64(cracks.row[c, FACET])
        cracks.facet[c] = k
        treat(bonds, cracks, c, k, np.int64(cracks.row[c, STATUS]))
    for c in range(cracks.sizes[CRACKS]):
        weigh_cracked(cells, cracks, bonds.i[cracks.facet[c]])
        weigh_cracked(cells, cracks, bonds.j[cracks.facet[c]])
    list_cracks(bonds, cracks)


@loop(parallel=False)
def weigh_cracked(cells, cracks, p):
    """λ / V of a cell: of what its cracks lack that are not treated one by one, they are free facets."""
    slack, inward = 0.0, cells.in_start[p + 1] - cells.in_start[p]
    for e in range(facets_of(cells, p)):
        k = facet_of(cells, p, e)
        if cracks.listed[k] > 1 + ACTIVE:
            slack += (1.0 - cracks.integrity[k]) * (cracks.slack_j[k] if e < inward else cracks.slack_i[k])
    cells.weight[p] = cracks.weight[p] / (1.0 + cracks.weight[p] * slack)
