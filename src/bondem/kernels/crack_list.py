"""The list of cracked facets, in the order in which they began, and the cracks of each cell."""

import math

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_stress import pair_stress
from bondem.kernels.cell_yield import principal_stresses
from bondem.kernels.crack_tables import ACTIVE, BEFORE, FACET, GAP, NORMAL, ONSET, SHARE_I, SHARE_J, STATUS
from bondem.kernels.single_facets import column, present_normal
from bondem.kernels.stress_index import strength_along
from bondem.laws.cell_energy import scalar

# What stands for the integrity a step ago of a crack that begins: its rate is found first.
NEW = 2.0
# A facet begins at this share of its strength at least.
_LEAST = 0.02


@device
def read_three(row, first):
    """Three numbers of a row, from `first` on."""
    return row[first], row[first + 1], row[first + 2]


@device
def write_three(row, first, a):
    """Write them."""
    row[first], row[first + 1], row[first + 2] = a[0], a[1], a[2]


@device
def known(pose, bonds, cells, cracks, c):
    """Of a crack that is measured: facet, k, part w of cell i, gap, normal, and shares and stresses of both sides."""
    k, g = np.int64(cracks.row[c, FACET]), cracks.geometry[c]
    shares = read_three(g, SHARE_I), read_three(g, SHARE_J)
    stresses = pose[bonds.i[k], STRESS], pose[bonds.j[k], STRESS]
    return k, cells.k[k], cracks.part[k], read_three(g, GAP), read_three(g, NORMAL), shares, stresses


@device
def treat(bonds, cracks, c, k, status):
    """Treat a crack one by one from now on, or as a facet of its integrity among the others."""
    cracks.row[c, STATUS] = status
    cracks.onset.listed[k] = 1 if status == ACTIVE else 2
    bonds.integrity[k] = 0.0 if status == ACTIVE else cracks.integrity[k]


@device
def _link(bonds, cracks, c):
    """Put crack c into the lists of its two cells."""
    k = np.int64(cracks.row[c, FACET])
    i, j = bonds.i[k], bonds.j[k]
    for end in range(2):
        p = i if end == 0 else j
        if cracks.head[p] < 0:
            cracks.cell[cracks.sizes[1]] = p
            cracks.sizes[1] += 1
    cracks.after_i[c], cracks.after_j[c] = cracks.head[i], cracks.head[j]
    cracks.head[i] = cracks.head[j] = c
    treat(bonds, cracks, c, k, cracks.row[c, STATUS])


@loop(parallel=False)
def begin_cracks(pose, bonds, cells, cracks):
    """Facets that were marked begin to crack, in their order."""
    a, v = np.empty((3, 3)), np.empty((3, 3))
    marked, strength, force = cracks.onset.marked, cracks.onset.strength, cells.force
    for k in range(bonds.m):
        if marked[k] == 0:
            continue
        c = cracks.sizes[0]
        row, start = cracks.row[c], 0.0
        if marked[k] == 1:
            f, A = column(force, k), cracks.onset.area[k]
            mean = pair_stress(cracks.stress.tensor, bonds.i[k], bonds.j[k])
            high, _, one, _ = principal_stresses(mean, a, v)
            slope = abs(scalar(present_normal(pose, bonds, cells, k), (v[0, one], v[1, one], v[2, one])))
            most = strength[k]
            if cracks.onset.judge != 0:
                most = strength_along(cracks.onset, mean, high, most, a)
            start = min(math.sqrt(scalar(f, f)) / A, most * max(slope, _LEAST))
        row[:] = 0.0
        row[FACET], row[ONSET], row[BEFORE] = k, start, NEW
        write_three(cracks.pull[c], 0, column(force, k))
        cracks.sizes[0] += 1
        _link(bonds, cracks, c)
        cracks.onset.cracked[bonds.i[k]] = cracks.onset.cracked[bonds.j[k]] = 1
        marked[k] = 0


@kernel(parallel=False)
def link_cracks(bonds, cells, cracks):
    """Lists of all cracks, as a run begins."""
    for c in range(cracks.sizes[0]):
        _link(bonds, cracks, c)
    for e in range(cracks.sizes[1]):
        weigh_cracked(bonds, cells, cracks, cracks.cell[e])


@loop(parallel=False)
def weigh_cracked(bonds, cells, cracks, p):
    """λ / V of a cell: of what its cracks lack that are not treated one by one, they are free facets."""
    slack, c = 0.0, cracks.head[p]
    while c >= 0:
        k = np.int64(cracks.row[c, FACET])
        own = bonds.i[k] == p
        if cracks.row[c, STATUS] != ACTIVE:
            slack += (1.0 - cracks.integrity[k]) * (cracks.slack_i[k] if own else cracks.slack_j[k])
        c = cracks.after_i[c] if own else cracks.after_j[c]
    cells.weight[p] = cracks.weight[p] / (1.0 + cracks.weight[p] * slack)
