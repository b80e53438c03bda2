"""Bonds that break on a device, as `bondem.kernels.breaking` has it: the same instant, order and energies.

A thread a bond judges what its force has marked; what breaks is gathered by an atomic counter, and its ends hold
back: they close the step with the whole force, and do not open the next. One thread sorts what broke by the number of
the bond, so that no bit depends on the order of threads, books energies and writes the log. Then a thread an element
that waits adds up its bonds again, and opens the next step from its acceleration as after a pause. All of it leaves
at once where nothing breaks, so that the launches of a step are always the same.
"""

import math

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cuda.bonds import branch, stiffness
from bondem.kernels.cuda.elements import move_one, open_one
from bondem.kernels.cuda.sample import RELEASED, shear_of
from bondem.kernels.judging import judged
from bondem.kernels.tables import (
    BROKEN_BOND,
    BROKEN_ENERGY,
    BROKEN_GAP,
    BROKEN_MODE,
    BROKEN_PLACE,
    BROKEN_STEP,
    BROKEN_TIME,
)
from bondem.laws.beam_energy import bond_energy
from bondem.laws.cell_energy import cross, scalar
from bondem.laws.rotations import rotate

# Entries of `DeviceBreaks.counts`.
FOUND, LOGGED, WAITING = 0, 1, 2


@device
def _size(forces, breaks, k):
    """What is held against the limit of a bond [-]."""
    f, a, b = (
        (forces[0, k], forces[1, k], forces[2, k]), (forces[3, k], forces[4, k], forces[5, k]),
        (forces[6, k], forces[7, k], forces[8, k]),
    )  # fmt: skip
    return breaks.of_force * scalar(f, f) + breaks.of_moment * (scalar(a, a) + scalar(b, b))


@device
def _off(a, e):
    """Length of what of a vector is not along a unit vector."""
    c = cross(a, e)
    return math.sqrt(scalar(c, c))


@device
def _turned(pose, p, e, X, Y, Z):
    """Between a unit vector and a direction turned with an element [rad]."""
    q = rotate(pose[p, 4], pose[p, 5], pose[p, 6], pose[p, 7], X, Y, Z)
    return math.atan2(_off(q, e), scalar(q, e))


@device
def judge_one(pose, bonds, breaks, k):
    """Index and mode of a bond whose force is known, as `bondem.kernels.judging.index_of`."""
    a, b, constants, forces = bonds.i[k], bonds.j[k], bonds.constants, bonds.forces
    d = branch(pose, a, b, bonds.period)
    force = forces[0, k], forces[1, k], forces[2, k]
    on_i, on_j = (forces[3, k], forces[4, k], forces[5, k]), (forces[6, k], forces[7, k], forces[8, k])
    l = math.sqrt(scalar(d, d))
    e = d[0] / l, d[1] / l, d[2] / l
    station = breaks.station[k]
    if station < 0.0:
        bending = max(_off(on_i, e), _off(on_j, e))
    else:
        c, arm = cross(e, force), station * l
        bending = _off((on_i[0] + arm * c[0], on_i[1] + arm * c[1], on_i[2] + arm * c[2]), e)
    angle = 0.0
    if breaks.kind == 3:
        X, Y, Z = constants[0, k], constants[1, k], constants[2, k]
        angle = max(_turned(pose, a, e, X, Y, Z), _turned(pose, b, e, X, Y, Z))
    load = (
        -scalar(force, e), _off(force, e), bending, math.fabs(scalar(on_i, e)), l / constants[3, k] - 1.0, angle
    )  # fmt: skip
    return judged(breaks.kind, load, breaks.coefficient[k])


@device
def reaches_bound(bonds, breaks, k):
    """Whether a bond bears enough to be judged."""
    return _size(bonds.forces, breaks, k) >= breaks.limit[k] and bonds.integrity[k] > 0.0


@cuda_kernel
def judge_bonds(elements, bonds, breaks):
    """Gather the bonds that break by their present force, and hold back their ends."""
    k = cuda.grid(1)
    if k >= bonds.m:
        return
    if reaches_bound(bonds, breaks, k):
        index, _ = judge_one(elements.pose, bonds, breaks, k)
        if index >= 1.0:
            # the order of threads does not matter, as the list is sorted
            breaks.found[cuda.atomic.add(breaks.counts, FOUND, 1)] = k
            breaks.held[bonds.i[k]] = 1
            breaks.held[bonds.j[k]] = 1


@cuda_kernel
def move_or_wait(clock, tick, elements, adjacency, forces, rows, bodies, scheme, breaks, go_on):
    """`bondem.kernels.cuda.elements.move`, but what waits does not open the next step."""
    p = cuda.grid(1)
    if p == 0:
        clock[0] += tick
    if p >= elements.pose.shape[0]:
        return
    move_one(elements, adjacency, forces, rows, bodies, scheme, go_on and breaks.held[p] == 0, p)


@device
def _sift(found, root, count):
    """Let an entry sink to its place in a heap, the largest on top."""
    child = 2 * root + 1
    while child < count:
        if child + 1 < count and found[child] < found[child + 1]:
            child += 1
        if found[root] >= found[child]:
            return
        one, other = found[root], found[child]
        found[root], found[child] = other, one
        root, child = child, 2 * child + 1


@device
def put_in_order(found, count):
    """Sort the first `count` numbers of a list."""
    for back in range(1, count // 2 + 1):
        _sift(found, count // 2 - back, count)
    for last in range(count - 1, 0, -1):
        one, other = found[0], found[last]
        found[0], found[last] = other, one
        _sift(found, 0, last)


@device
def taken(breaks):
    """How many broke, and their list in order; the counter begins anew."""
    count = breaks.counts[FOUND]
    breaks.counts[FOUND] = 0
    breaks.counts[WAITING] = count
    put_in_order(breaks.found, count)
    return count


@device
def write_down(breaks, t, step, k, mode, gap, energy, place):
    """Write a row of the log, and book the energy."""
    row = breaks.counts[LOGGED]
    breaks.counts[LOGGED] = row + 1
    log = breaks.log
    log[row, BROKEN_TIME], log[row, BROKEN_STEP], log[row, BROKEN_BOND], log[row, BROKEN_MODE] = t, step, k, mode
    log[row, BROKEN_GAP], log[row, BROKEN_ENERGY] = gap, energy
    for d in range(3):
        log[row, BROKEN_PLACE + d] = place[d]
    breaks.released[0] += energy


@device
def _break_bond(pose, bonds, breaks, t, step, k):
    """Take the force of a bond off, while its ends are where they were when it was found."""
    constants, a, b, L = bonds.constants, bonds.i[k], bonds.j[k], bonds.constants[3, k]
    _, mode = judge_one(pose, bonds, breaks, k)
    d = branch(pose, a, b, bonds.period)
    kn, A, B, C, kt = stiffness(constants, bonds.same, k, 1.0)
    ks, _ = shear_of(L, A, B, C)
    share = breaks.share[k]
    part = bond_energy(
        d[0], d[1], d[2],
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7], pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        constants[0, k], constants[1, k], constants[2, k], L, kn, A, B, C, kt, ks, share * L,
    )  # fmt: skip
    energy = bonds.integrity[k] * (part[0] + part[1] + part[2] + part[3])
    gap = math.sqrt(scalar(d, d)) - L
    bonds.integrity[k] = 0.0
    for c in range(9):
        bonds.forces[c, k] = 0.0
    place = pose[a, 0] + share * d[0], pose[a, 1] + share * d[1], pose[a, 2] + share * d[2]
    write_down(breaks, t, step, k, mode, gap, energy, place)


@cuda_kernel
def break_bonds(clock, scheme, elements, bonds, breaks):
    """One thread: break the bonds that were found in this step, in their order."""
    if cuda.grid(1) > 0:
        return
    count, step = taken(breaks), clock[0]
    t = scheme.origin + step * scheme.dt
    for e in range(count):
        _break_bond(elements.pose, bonds, breaks, t, step, breaks.found[e])


@cuda_kernel
def let_go(elements, adjacency, forces, rows, bodies, still, scheme, breaks, go_on):
    """What has waited finds its acceleration without what broke, and opens the next step if it is to go on.

    `still` is the scheme of no time.
    """
    p = cuda.grid(1)
    if p >= elements.pose.shape[0] or breaks.counts[WAITING] == 0 or breaks.held[p] == 0:
        return
    breaks.held[p] = 0
    move_one(elements, adjacency, forces, rows, bodies, still, False, p)
    if go_on:
        open_one(elements, rows, bodies, scheme, p)


@cuda_kernel
def released_sum(breaks, parts):
    """What breaking has released, into `parts` (SUMS, S)."""
    if cuda.grid(1) == 0:
        parts[RELEASED, 0] = breaks.released[0]
