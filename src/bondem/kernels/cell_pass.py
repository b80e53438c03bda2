"""The cell law in a step: dilatation of the cells first, then forces and torques of their facets.

The stress λ θ of a cell stands in the spare column of its row of the pose, where the second pass finds it with the
rest. Loops take WIDTH facets at a time; what they add to a cell is added in the order of the facets, whatever the
cuts.
"""

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.bond_pass import ahead, apart, group, groups, mark
from bondem.kernels.lane_memory import add_loads, add_numbers, add_rows, places, put_side, row, side, widened
from bondem.kernels.lanes import dot, fused, zero_of
from bondem.laws.cell_energy import bending_square, facet_force, facet_pull, swellings, turned_by

# Column of a row of the pose that holds λ θ of a cell [Pa].
STRESS = 3


@device
def three_columns(table):
    """The three columns of a table (3, m), taken once outside of a loop."""
    return table[0], table[1], table[2]


@device
def _triple(columns, k):
    return widened(columns[0], k), widened(columns[1], k), widened(columns[2], k)


@device
def _lever(columns, pitch, k):
    x, y, z = _triple(columns, k)
    return pitch[0] * x, pitch[1] * y, pitch[2] * z


@device
def _orientation(pose):
    return pose[4], pose[5], pose[6], pose[7]


@device
def _times(s, a):
    return s * a[0], s * a[1], s * a[2]


@device
def _away(a, b, period):
    """From centres a to centres b [m], over the nearest periodic images where there are any."""
    if period[3] == 0.0 and period[4] == 0.0 and period[5] == 0.0:
        return b[0] - a[0], b[1] - a[1], b[2] - a[2]
    return apart(a, b, period)


@kernel(parallel=False)
def swell(pose, bonds, cells, breaks, first, last):
    """Add what the facets first … last do to V θ of their cells, in `cells.swelling`.

    Those that bear more than their bounds stand in `breaks.marked` from `first` on, up to what is returned: they
    are looked at with the stresses of the step before.
    """
    place = np.int64(first)
    lever_i, lever_j = three_columns(cells.lever_i), three_columns(cells.lever_j)
    share_i, share_j, pitch = three_columns(cells.share_i), three_columns(cells.share_j), three_columns(cells.pitch)
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        ahead(bonds, pose, k, last)
        j = places(bonds.j, k)
        a, b = row(pose, places(bonds.i, k)), row(pose, j)
        s = side(bonds.integrity, k)
        one, other = swellings(
            _away(a, b, bonds.period), _orientation(a), _orientation(b),
            _lever(lever_i, pitch, k), _lever(lever_j, pitch, k), _triple(share_i, k), _triple(share_j, k),
        )  # fmt: skip
        add_numbers(cells.swelling, places(cells.to_i, k), j, s * one, s * other, known)
        if breaks is not None:  # decided when compiled
            f = facet_pull(
                _away(a, b, bonds.period), _orientation(a), _orientation(b), _lever(lever_i, pitch, k),
                _lever(lever_j, pitch, k), _triple(share_i, k), _triple(share_j, k), side(cells.k, k),
                a[STRESS], b[STRESS],
            )  # fmt: skip
            place = mark(breaks, k, known, (s * s) * (breaks.of_force * dot(f, f)), place)
    return place


@kernel(parallel=False)
def stress_cells(pose, cells, first, last):
    """Stresses of the cells first … last from their V θ, which is left at zero."""
    for p in range(first, last):
        pose[p, STRESS] = cells.weight[p] * (cells.swelling[p] + cells.given[p])
        cells.swelling[p] = 0.0


@loop(parallel=False)
def gather_swelling(cells, shared, part):
    """Add to the shared cells of a list what facets of other domains have left for them."""
    n = len(cells.weight)
    for e in range(len(shared)):
        for q in range(n + part[e], n + part[e + 1]):
            cells.swelling[shared[e]] += cells.swelling[q]
            cells.swelling[q] = 0.0


@device
def moment_of(b, f):
    """Symmetric part of b⊗f: xx, yy, zz, xy, xz, yz; of one facet or of many to the same bits, whoever adds to it."""
    zero = zero_of(f[0])
    return (
        fused(b[0], f[0], zero), fused(b[1], f[1], zero), fused(b[2], f[2], zero),
        0.5 * fused(b[0], f[1], b[1] * f[0]), 0.5 * fused(b[0], f[2], b[2] * f[0]),
        0.5 * fused(b[1], f[2], b[2] * f[1]),
    )  # fmt: skip


@device
def _keep(cells, row_i, row_j, k, known, arm_i, arm_j, force, bent):
    """Keep the forces of facets on their cells i, and add b⊗f and T_b² to the sums of both; `force` is that on j."""
    for d in range(3):
        put_side(cells.force[d], k, -force[d], known)
    a = moment_of(arm_i, (-force[0], -force[1], -force[2]))
    b, zero = moment_of(arm_j, force), zero_of(force[0])
    a, b = (a[0], a[1], a[2], bent, a[3], a[4], a[5], zero), (b[0], b[1], b[2], bent, b[3], b[4], b[5], zero)
    add_rows(cells.sums, places(row_i, k), places(row_j, k), a, b, known)


@kernel(parallel=False)
def facet_loads(pose, bonds, cells, moment, sums, row_i, row_j, first, last):
    """Add force and torques of the facets first … last to the rows of their two cells in `sums`.

    `moment` is that of `cells`, or None where neither forces are to be kept nor stresses to be found.
    """
    lever_i, lever_j = three_columns(cells.lever_i), three_columns(cells.lever_j)
    share_i, share_j, pitch = three_columns(cells.share_i), three_columns(cells.share_j), three_columns(cells.pitch)
    bend, mixed = three_columns(cells.H), three_columns(cells.H[3:])
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        ahead(bonds, pose, k, last)
        a, b = row(pose, places(bonds.i, k)), row(pose, places(bonds.j, k))
        b_i, b_j = _lever(lever_i, pitch, k), _lever(lever_j, pitch, k)
        s = side(bonds.integrity, k)
        H = (
            s * widened(bend[0], k), s * widened(bend[1], k), s * widened(bend[2], k),
            s * widened(mixed[0], k), s * widened(mixed[1], k), s * widened(mixed[2], k),
        )  # fmt: skip
        force, on_i, on_j = facet_force(
            _away(a, b, bonds.period), _orientation(a), _orientation(b), b_i, b_j,
            _triple(share_i, k), _triple(share_j, k), s * side(cells.k, k), H, s * a[STRESS], s * b[STRESS],
        )  # fmt: skip
        if moment is not None:  # decided when compiled
            arm_i, arm_j = turned_by(_orientation(a), b_i), turned_by(_orientation(b), b_j)
            bent = bending_square(_orientation(a), _orientation(b), side(cells.bends, k), H)
            _keep(cells, row_i, row_j, k, known, arm_i, arm_j, force, bent)
        add_loads(sums, places(row_i, k), places(row_j, k), force, on_i, on_j, known)
