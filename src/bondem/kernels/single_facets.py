"""One facet of a body of cells at a time, for what concerns few of them: frame, forces, neighbours.

What is called from several places is compiled once for all of them (`kernel`).
"""

import math

from bondem._compile import device, loop
from bondem.kernels.bond_pass import branch
from bondem.kernels.cell_pass import STRESS
from bondem.laws.cell_energy import facet_force, scalar, turned_by


@device
def lever(columns, pitch, k):
    """Lever k from its columns of whole numbers [m]."""
    return pitch[0] * columns[0, k], pitch[1] * columns[1, k], pitch[2] * columns[2, k]


@device
def orientation(pose, p):
    """Quaternion of a cell."""
    return pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7]


@device
def column(table, k):
    """Column k of a table of three rows."""
    return table[0, k], table[1, k], table[2, k]


@device
def frame(pose, bonds, cells, k):
    """Branch, orientations, levers and shares of a facet."""
    i, j = bonds.i[k], bonds.j[k]
    d = branch(pose, i, j, bonds.period)
    return (
        d, orientation(pose, i), orientation(pose, j), lever(cells.lever_i, cells.pitch, k),
        lever(cells.lever_j, cells.pitch, k), column(cells.share_i, k), column(cells.share_j, k),
    )  # fmt: skip


@device
def resistance(cells, s, k):
    """H of a facet of integrity s."""
    H = cells.H
    return s * H[0, k], s * H[1, k], s * H[2, k], s * H[3, k], s * H[4, k], s * H[5, k]


@loop(parallel=False)
def single_facet(pose, bonds, cells, k):
    """Force on j and torques on i and j of a facet [N, N·m], with the stresses of its cells known."""
    d, p, q, a, b, u, v = frame(pose, bonds, cells, k)
    s = bonds.integrity[k]
    return facet_force(
        d, p, q, a, b, u, v, s * cells.k[k], resistance(cells, s, k),
        s * pose[bonds.i[k], STRESS], s * pose[bonds.j[k], STRESS],
    )  # fmt: skip


@device
def present_normal(pose, bonds, cells, k):
    """Normal of a facet [-]: that of the reference turned with both cells, in the middle."""
    n = column(cells.normal, k)
    a, b = turned_by(orientation(pose, bonds.i[k]), n), turned_by(orientation(pose, bonds.j[k]), n)
    n = a[0] + b[0], a[1] + b[1], a[2] + b[2]
    l = math.sqrt(scalar(n, n))
    return n[0] / l, n[1] / l, n[2] / l


@device
def facets_of(adjacency, p):
    """How many facets a cell has: first those where it is the second one, then those where it is the first."""
    inward = adjacency.in_start[p + 1] - adjacency.in_start[p]
    return inward + adjacency.out_start[p + 1] - adjacency.out_start[p]


@device
def facet_of(adjacency, p, e):
    """Facet e of a cell."""
    inward = adjacency.in_start[p + 1] - adjacency.in_start[p]
    if e < inward:
        return adjacency.in_start[p] + e
    return adjacency.in_start[0] + adjacency.out_bond[adjacency.out_start[p] + e - inward]
