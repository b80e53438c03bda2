"""Bonds that break at the end of a step: their ends close it with the whole force, and open the next without them.

Then the energy of the bonds is released between two steps, and the ledger of energies is as exact through it as the
scheme is. Elements are held back by their bonds (`bondem.kernels.judging`), whatever threads and blocks there are,
and what is done with them is done in the order of the bonds by one thread: no bit depends on the cuts, nor on where a
run pauses, as an element goes on from its stored acceleration in either case.
"""

import math

from bondem._compile import device, loop
from bondem.kernels.bond_pass import branch
from bondem.kernels.contact_pairs import begin_contact
from bondem.kernels.element_pass import move, move_held, open_list
from bondem.kernels.judging import judge_bond, single_bond
from bondem.kernels.tables import (
    BROKEN_BOND,
    BROKEN_ENERGY,
    BROKEN_GAP,
    BROKEN_MODE,
    BROKEN_PLACE,
    BROKEN_STEP,
    BROKEN_TIME,
    StepScheme,
)
from bondem.laws.beam_energy import bond_energy
from bondem.laws.damping import dashpot_force


@device
def _kept(table, first_row, p, s):
    """Keep a row of sums in the row of its element."""
    for d in range(8):
        table[first_row + p, d] = table[s, d]


@loop(parallel=False)
def part_waiting(sums, added, breaks, element, row_of_sums, first, last, place):
    """Put the elements first … last of a list into `breaks.turn` from `place` on, those that are held back last.

    The sums of these are kept. Returns where they begin.
    """
    front, back = place, place + last - first
    for e in range(first, last):
        p, s = element[e], row_of_sums[e]
        if breaks.held[p] == 0:
            breaks.turn[front], breaks.turn_row[front] = p, s
            front += 1
        else:
            back -= 1
            breaks.turn[back], breaks.turn_row[back] = p, s
            _kept(sums, breaks.first_row, p, s)
            if added is not None:
                if len(added.dashed) > 0:
                    _kept(added.dashed, breaks.first_row, p, s)
    return front


@device
def lists(sums, added, breaks, element, row_of_sums, span, waiting):
    """The elements first … held … last of a list as two lists: those that go on, and those that are held back.

    Each is elements, rows of sums, and where in these it begins, where those that own rows begin, and where it ends.
    `span` is first, held, last, and the place in `breaks.turn` for them; `waiting` whether any may be held back.
    """
    first, held, last, place = span
    whole = element, row_of_sums, first, held, held, last
    if breaks is not None:
        if waiting:
            middle, end = place + held - first, place + last - first
            free = part_waiting(sums, added, breaks, element, row_of_sums, first, held, place)
            own = part_waiting(sums, added, breaks, element, row_of_sums, held, last, middle)
            on = breaks.turn, breaks.turn_row, place, free, middle, own
            return on, (breaks.turn, breaks.turn_row, free, middle, own, end)
    return whole, (element, row_of_sums, last, last, last, last)


@device
def take_off(sums, row, sign, turning, force, torque):
    """Take a force and a torque, times numbers, off a row of sums."""
    for d in range(3):
        sums[row, d] -= sign * force[d]
        sums[row, 4 + d] -= turning * torque[d]


@device
def take_dashpot(elements, bonds, added, first_row, k, d):
    """Take the dashpot of a bond off the sums of its ends."""
    a, b, motion, s = bonds.i[k], bonds.j[k], elements.motion, bonds.integrity[k]
    fx, fy, fz, ax, ay, az, bx, by, bz = dashpot_force(
        d[0], d[1], d[2],
        motion[b, 0] - motion[a, 0], motion[b, 1] - motion[a, 1], motion[b, 2] - motion[a, 2],
        motion[a, 4], motion[a, 5], motion[a, 6], motion[b, 4], motion[b, 5], motion[b, 6], added.share[k],
        s * added.dashpot[0, k], s * added.dashpot[1, k], s * added.dashpot[2, k], s * added.dashpot[3, k],
    )  # fmt: skip
    take_off(added.dashed, first_row + a, -1.0, 1.0, (fx, fy, fz), (ax, ay, az))
    take_off(added.dashed, first_row + b, 1.0, 1.0, (fx, fy, fz), (bx, by, bz))


@device
def write_break(row, now, k, mode, gap, energy, place):
    """Write a row of what broke (`BROKEN_…`): when, which, how, how far open [m], with what energy [J], where [m]."""
    row[BROKEN_TIME], row[BROKEN_STEP], row[BROKEN_BOND], row[BROKEN_MODE] = now[0], now[1], k, mode
    row[BROKEN_GAP], row[BROKEN_ENERGY] = gap, energy
    for d in range(3):
        row[BROKEN_PLACE + d] = place[d]


@device
def log_break(breaks, k, mode, gap, energy, place):
    """Write down what broke."""
    write_break(breaks.log[breaks.logged[0]], breaks.now, k, mode, gap, energy, place)
    breaks.logged[0] += 1
    breaks.released[0] += energy


@loop(parallel=False)
def stored_energy(pose, bonds, k):
    """Energy of one bond of the total formulation [J]."""
    a, b = bonds.i[k], bonds.j[k]
    d = branch(pose, a, b, bonds.period)
    part = bond_energy(
        d[0], d[1], d[2],
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7], pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        bonds.X0[k], bonds.Y0[k], bonds.Z0[k], bonds.length[k],
        bonds.kn[k], bonds.A[k], bonds.B[k], bonds.C[k], bonds.kt[k], bonds.ks[k], bonds.lever[k],
    )  # fmt: skip
    return bonds.integrity[k] * (part[0] + part[1] + part[2] + part[3])


@device
def _break_bond(elements, bonds, sums, added, contacts, breaks, k):
    """Take the force of a bond off the sums of its ends, which are where they were when it was found."""
    pose, first_row = elements.pose, breaks.first_row
    a, b = bonds.i[k], bonds.j[k]
    _, mode = judge_bond(pose, bonds, breaks, k)
    d, force, on_i, on_j = single_bond(pose, bonds, k)
    take_off(sums, first_row + a, -1.0, 1.0, force, on_i)
    take_off(sums, first_row + b, 1.0, 1.0, force, on_j)
    if added is not None:
        if len(added.dashed) > 0:
            take_dashpot(elements, bonds, added, first_row, k, d)
    gap = math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - bonds.length[k]
    share = bonds.lever[k] / bonds.length[k]
    place = pose[a, 0] + share * d[0], pose[a, 1] + share * d[1], pose[a, 2] + share * d[2]
    energy = stored_energy(pose, bonds, k)
    bonds.integrity[k] = 0.0
    if len(bonds.hold) > 0:
        bonds.hold[k] = 0.0
    if contacts is not None:  # decided when compiled
        energy -= begin_contact(elements, bonds, contacts, sums, first_row, k)
    log_break(breaks, k, mode, gap, energy, place)


@loop(parallel=False)
def break_bonds(elements, bonds, sums, added, contacts, breaks):
    """Break the bonds that were found in this step, in their order; what is pressed together bears on at once."""
    for block in range(len(breaks.found)):
        for e in range(breaks.begin[block], breaks.begin[block] + breaks.found[block]):
            _break_bond(elements, bonds, sums, added, contacts, breaks, breaks.marked[e])


@loop(parallel=False)
def list_waiting(rows, breaks):
    """Put all that wait into `breaks.turn`, those that own rows last; how many, and how many own none."""
    if breaks.found.sum() == 0:
        return 0, 0
    count = free = 0
    for own in range(2):
        for p in range(len(breaks.held)):
            if breaks.held[p] != 0 and (rows.of[p] >= 0) == (own == 1):
                breaks.held[p] = 0
                breaks.turn[count], breaks.turn_row[count] = p, breaks.first_row + p
                count += 1
        if own == 0:
            free = count
    breaks.found[:] = 0
    return count, free


@loop(parallel=False)
def let_go(elements, sums, rows, scheme, added, breaks, go_on):
    """What has waited finds its acceleration without what broke, and opens the next step if it is to go on."""
    count, free = list_waiting(rows, breaks)
    if count > 0:
        still = StepScheme(0.0, 0.0, 0.0, 0.0, scheme.gamma, scheme.origin)
        move(elements, sums, rows, still, added, False, breaks.turn, breaks.turn_row, 0, free)
        move_held(elements, sums, rows, still, added, False, breaks.turn, breaks.turn_row, free, count)
        if go_on:
            open_list(elements, rows, scheme, added, breaks.turn, count)
