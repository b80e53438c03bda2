"""Beams that soften on a device, as `bondem.kernels.beam_softening` has it, by the same functions of one beam.

A thread a beam that has begun changes its integrity before the forces of a step; what presses on it is added to
the force of its bond, whose bound is infinite by then, so that no judge sees it. One thread sorts what has parted,
adds up what was dissipated and writes the log. Beams that reach their strength are gathered by an atomic counter amid
the forces, before any end moves, and put into the list in the order of the bonds.
"""

import math

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.beam_softening import begin_row, lose_integrity, press_beam, pressed_beam
from bondem.kernels.breaking import write_break
from bondem.kernels.cuda.bonds import branch, stiffness
from bondem.kernels.cuda.breaking import FOUND, LOGGED, judge_one, put_in_order, reaches_bound
from bondem.kernels.cuda.sample import NORMAL, shear_of
from bondem.kernels.soft_tables import BEGUN, LOOKED_AT, LOST, MODE, PARTS, PUSH, SOFT_BOND, SPENT
from bondem.laws.beam_energy import bond_energy
from bondem.laws.beam_softening import opened_and_slid
from bondem.laws.cell_energy import scalar


@device
def _extended(pose, bonds, k):
    """Branch and extension of a beam [m]."""
    d = branch(pose, bonds.i[k], bonds.j[k], bonds.period)
    return d, math.sqrt(scalar(d, d)) - bonds.constants[3, k]


@device
def _whole(pose, bonds, share, k):
    """Branch and extension of a beam [m], and what opens and slides of its energy as if it were whole [J]."""
    a, b, constants, L = bonds.i[k], bonds.j[k], bonds.constants, bonds.constants[3, k]
    d, extension = _extended(pose, bonds, k)
    kn, A, B, C, kt = stiffness(constants, bonds.same, k, 1.0)
    ks, _ = shear_of(L, A, B, C)
    parts = bond_energy(
        d[0], d[1], d[2],
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7], pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        constants[0, k], constants[1, k], constants[2, k], L, kn, A, B, C, kt, ks, share[k] * L,
    )  # fmt: skip
    opening, sliding = opened_and_slid(parts, extension)
    return d, extension, opening, sliding


@cuda_kernel
def soften_beams(pose, bonds, breaks, soft, change):
    """Integrities of the beams that have begun, and what presses on each; those that part are gathered."""
    c = cuda.grid(1)
    if c >= soft.sizes[BEGUN]:
        return
    row, output, k = soft.row[c], soft.output[c], int(soft.row[c, SOFT_BOND])
    s = bonds.integrity[k]
    d, extension, opening, sliding = _whole(pose, bonds, breaks.share, k)
    new = lose_integrity(row, output, s, opening, sliding, change)
    if new < s:
        bonds.integrity[k] = new
    kn, _, _, _, _ = stiffness(bonds.constants, bonds.same, k, 1.0)
    press_beam(output, new, kn, bonds.constants[3, k], d, extension)
    if output[PARTS] != 0.0:
        breaks.found[cuda.atomic.add(breaks.counts, FOUND, 1)] = c


@cuda_kernel
def add_soft_losses(soft, lost):
    """What beams have dissipated in this step, in parts: thread s takes rows s, s + S …"""
    s = cuda.grid(1)
    if s >= lost.size or soft.sizes[BEGUN] == 0:
        return
    total = 0.0
    for c in range(s, soft.sizes[BEGUN], lost.size):
        total += soft.output[c, LOST]
    lost[s] = total


@cuda_kernel
def log_soft(clock, scheme, pose, bonds, breaks, soft, lost):
    """One thread: add up these parts, and write down the beams of which nothing is left, in their order."""
    if cuda.grid(1) > 0 or soft.sizes[BEGUN] == 0:
        return
    total, count, step = 0.0, breaks.counts[FOUND], clock[0] + 1
    for s in range(lost.size):
        total += lost[s]
    breaks.released[0] += total
    breaks.counts[FOUND] = 0
    put_in_order(breaks.found, count)
    now = scheme.origin + step * scheme.dt, step
    for e in range(count):
        row, k = soft.row[breaks.found[e]], int(soft.row[breaks.found[e], SOFT_BOND])
        a, share = bonds.i[k], breaks.share[k]
        d, gap = _extended(pose, bonds, k)
        place = pose[a, 0] + share * d[0], pose[a, 1] + share * d[1], pose[a, 2] + share * d[2]
        write_break(breaks.log[breaks.counts[LOGGED]], now, k, row[MODE], gap, row[SPENT], place)
        breaks.counts[LOGGED] += 1


@cuda_kernel
def press_some(bonds, soft):
    """Add what presses on beams that soften to the forces of their bonds."""
    c = cuda.grid(1)
    if c < soft.sizes[BEGUN]:
        k = int(soft.row[c, SOFT_BOND])
        for d in range(3):
            bonds.forces[d, k] += soft.output[c, PUSH + d]


@cuda_kernel
def find_soft(pose, bonds, breaks):
    """Gather the beams that begin to soften by their present force."""
    k = cuda.grid(1)
    if k < bonds.m and reaches_bound(bonds, breaks, k):
        index, _ = judge_one(pose, bonds, breaks, k)
        if index >= 1.0:
            breaks.found[cuda.atomic.add(breaks.counts, FOUND, 1)] = k


@cuda_kernel
def order_soft(breaks, soft):
    """One thread: put the beams that begin into their list, in order."""
    if cuda.grid(1) > 0:
        return
    count, begun = breaks.counts[FOUND], soft.sizes[BEGUN]
    breaks.counts[FOUND] = 0
    put_in_order(breaks.found, count)
    for e in range(count):
        soft.active[begun + e] = breaks.found[e]
    # until they are set up, as many as there were
    soft.sizes[LOOKED_AT], soft.sizes[BEGUN] = begun, begun + count


@cuda_kernel
def begin_soft(pose, bonds, breaks, soft):
    """Write down what the beams that begin hold, whose ends have not moved since they were judged."""
    c = soft.sizes[LOOKED_AT] + cuda.grid(1)
    if c >= soft.sizes[BEGUN]:
        return
    k = soft.active[c]
    _, mode = judge_one(pose, bonds, breaks, k)
    _, _, opening, sliding = _whole(pose, bonds, breaks.share, k)
    begin_row(soft.row[c], k, mode, opening, sliding, soft.tear[k], soft.shear[k])
    breaks.limit[k] = math.inf


@cuda_kernel
def soft_sums(pose, bonds, soft, parts):
    """Add the energies of what presses on beams that soften to those of bonds, in `parts` (SUMS, S)."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    for c in range(s, soft.sizes[BEGUN], stride):
        k = int(soft.row[c, SOFT_BOND])
        kn, _, _, _, _ = stiffness(bonds.constants, bonds.same, k, 1.0)
        _, extension = _extended(pose, bonds, k)
        parts[NORMAL, s] += pressed_beam(bonds.integrity[k], kn, extension)
