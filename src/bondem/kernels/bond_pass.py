"""Forces and torques of the bonds, and their sums for each element; what they store, and how far they have turned.

The loop over the bonds takes WIDTH of them at a time (`bondem.kernels.lanes`) and adds what each does to the sums of
its two ends, in the order of the bonds.
"""

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.lane_memory import add_loads, places, prefetch, row, side, widened
from bondem.kernels.lanes import WIDTH, dot, reached
from bondem.laws.beam_energy import bond_energy, bond_force

# Bonds ahead of the loop whose first elements are asked for: those of the second ends follow one another.
_AHEAD = 32


@device
def nearest(d, edge, inverse):
    """A component of a branch over the nearest periodic image [m]; the inverse edge of a free specimen is 0."""
    return d - edge * np.rint(d * inverse)


@device
def branch(pose, a, b, period):
    """Centre b minus centre a over the nearest periodic image [m]."""
    return (
        nearest(pose[b, 0] - pose[a, 0], period[0], period[3]),
        nearest(pose[b, 1] - pose[a, 1], period[1], period[4]),
        nearest(pose[b, 2] - pose[a, 2], period[2], period[5]),
    )


@device
def group(first, last, g):
    """Where group g of WIDTH of the bonds first … last begins, and how many of it belong to the group before.

    The last group is moved back to end with the last bond, so that it is read as a whole like the others. There must
    be WIDTH bonds from the start of the tables to `last`.
    """
    begin, end, width = np.uint64(first), np.uint64(last), np.uint64(WIDTH)
    k = begin + width * np.uint64(g)
    if k + width <= end:
        return k, 0
    return end - width, np.int64(k + width - end)


@device
def groups(first, last):
    """How many groups of WIDTH the bonds first … last are."""
    return (last - first + WIDTH - 1) // WIDTH


@device
def ahead(bonds, pose, k, last):
    """Ask for the first elements of bonds that are to come."""
    prefetch(pose, places(bonds.i, min(k + np.uint64(_AHEAD), np.uint64(last - WIDTH))))


@device
def apart(a, b, period):
    """Centre b minus centre a over the nearest periodic image [m], of rows or of many rows of poses."""
    return (
        nearest(b[0] - a[0], period[0], period[3]),
        nearest(b[1] - a[1], period[1], period[4]),
        nearest(b[2] - a[2], period[2], period[5]),
    )


@device
def stiffness(bonds, same, k):
    """kn, A, B, C and kt of bonds k …, times their integrity: their own, or those they share over their length."""
    if same is None:  # decided when compiled
        s = side(bonds.integrity, k)
        return (
            s * side(bonds.kn, k), s * side(bonds.A, k), s * side(bonds.B, k), s * side(bonds.C, k),
            s * side(bonds.kt, k),
        )  # fmt: skip
    hold = side(bonds.hold, k)
    return same.knL * hold, same.AL * hold, same.BL * hold, same.AL * hold, same.ktL * hold


@device
def mark(breaks, k, known, size, place):
    """Write down those of bonds k + known … whose size reaches its bound, from `place` on; where the next goes."""
    strong = reached(size, widened(breaks.limit, k))
    if strong != 0:
        for n in range(known, WIDTH):
            if (strong >> n) & 1:
                breaks.marked[place] = k + np.uint64(n)
                place += 1
    return place


@kernel(parallel=False)
def bond_loads(pose, bonds, same, sums, row_i, row_j, breaks, first, last):
    """Add force and torques of the bonds first … last to the rows of their two ends in `sums`.

    Those that bear more than their bounds stand in `breaks.marked` from `first` on, up to what is returned.
    """
    place = np.int64(first)
    for g in range(groups(first, last)):
        k, known = group(first, last, g)
        ahead(bonds, pose, k, last)
        a, b = row(pose, places(bonds.i, k)), row(pose, places(bonds.j, k))
        dx, dy, dz = apart(a, b, bonds.period)
        kn, A, B, C, kt = stiffness(bonds, same, k)
        fx, fy, fz, ax, ay, az, bx, by, bz = bond_force(
            dx, dy, dz, a[4], a[5], a[6], a[7], b[4], b[5], b[6], b[7],
            side(bonds.X0, k), side(bonds.Y0, k), side(bonds.Z0, k), side(bonds.length, k), kn, A, B, C, kt,
        )  # fmt: skip
        add_loads(sums, places(row_i, k), places(row_j, k), (fx, fy, fz), (ax, ay, az), (bx, by, bz), known)
        if breaks is not None:  # decided when compiled
            moments = dot((ax, ay, az), (ax, ay, az)) + dot((bx, by, bz), (bx, by, bz))
            size = breaks.of_force * dot((fx, fy, fz), (fx, fy, fz)) + breaks.of_moment * moments
            place = mark(breaks, k, known, size, place)
    return place


@kernel(parallel=False)
def bond_energies(pose, bonds):
    """Normal, shear, bending and twisting energy of all bonds [J]."""
    # without threads: it runs once a record, often on a few bonds, where launching them costs far more
    normal = slip = bend = twist = 0.0
    for k in range(bonds.m):
        a = bonds.i[k]
        b = bonds.j[k]
        dx, dy, dz = branch(pose, a, b, bonds.period)
        part = bond_energy(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            bonds.X0[k], bonds.Y0[k], bonds.Z0[k], bonds.length[k], bonds.kn[k],
            bonds.A[k], bonds.B[k], bonds.C[k], bonds.kt[k], bonds.ks[k], bonds.lever[k],
        )  # fmt: skip
        s = bonds.integrity[k]
        normal += s * part[0]
        slip += s * part[1]
        bend += s * part[2]
        twist += s * part[3]
    return normal, slip, bend, twist
