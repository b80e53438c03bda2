"""Beams that soften in a step: those that have begun stand in a list, and are looked at before the forces.

They stay in the loop over the bonds, with the integrity that they have; what presses on them is added to the loads of
their ends, beside those of contacts. A beam that reaches its strength is found by that loop as one that breaks is
(`bondem.kernels.judging`), and put into the list after it, in the order of the bonds; nobody waits, as its force goes
on. What concerns a beam alone is done on all threads, sums by one, in the order of the list: no bit depends on
threads. See `bondem.laws.beam_softening`.
"""

import math

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.bond_pass import branch
from bondem.kernels.breaking import write_break
from bondem.kernels.contact_pairs import press_on
from bondem.kernels.soft_beam import whole_beam
from bondem.kernels.soft_tables import BEGUN, FIRST, LAST, LOOKED_AT, LOST, MODE, PARTS, PUSH, RATE, SOFT_BOND, SPENT
from bondem.laws.beam_softening import last_opening
from bondem.laws.cell_energy import scalar
from bondem.laws.softening import softened

# Below this many beams launching threads costs more than the loop.
_SERIAL = 500
# Beams of one portion of work.
_PORTION = 250
# Integrity below which nothing is left.
_NOTHING = 1e-9


@loop(parallel=False)
def clear_pushes(bonds, soft):
    """Take off `load` what beams that soften did a step ago, where there are any; contacts write theirs anew."""
    if soft is not None:  # decided when compiled
        for e in range(soft.sizes[LOOKED_AT]):
            k = np.int64(soft.row[soft.active[e], SOFT_BOND])
            soft.load[bonds.i[k], :] = 0.0
            soft.load[bonds.j[k], :] = 0.0


@device
def _list_soft(bonds, soft):
    """Which rows are looked at: all but those that have broken, where contacts bear what presses on these."""
    row, active, integrity, count = soft.row, soft.active, bonds.integrity, 0
    for c in range(soft.sizes[BEGUN]):
        if not soft.handed or integrity[np.int64(row[c, SOFT_BOND])] > 0.0:
            active[count] = c
            count += 1
    soft.sizes[LOOKED_AT] = count


@device
def lose_integrity(row, output, s, opening, sliding, change):
    """Integrity of a beam that had s, and what it dissipates by it; `opening` and `sliding` as `whole_beam` has them.

    The energy is s times a square of the opening, whose work both schemes book by the trapezoidal rule: what is left
    is -Δs times the product of the openings before and after, the root of the product of Y before and after.
    """
    rate, new = opening + sliding, s
    if change and s > 0.0:
        new = softened(s, math.sqrt(rate), row[FIRST], row[LAST], 0.0, 1.0)
        if new < _NOTHING:
            new = 0.0
    output[LOST] = math.sqrt(row[RATE] * rate) * (s - new)
    output[PARTS] = 1.0 if new == 0.0 and s > 0.0 else 0.0
    row[RATE] = rate
    row[SPENT] += output[LOST]
    return new


@device
def press_beam(output, s, kn, length, d, extension):
    """What presses on a beam of integrity s beside the beam: force on its second end, along its branch d [N]."""
    push = (1.0 - s) * kn * max(-extension, 0.0) / (length + extension)
    for n in range(3):
        output[PUSH + n] = push * d[n]


@device
def begin_row(row, k, mode, opening, sliding, tear, shear):
    """The row of beam k that begins to soften; `tear` and `shear` are G_f A and G_II A [J]."""
    rate = opening + sliding
    row[SOFT_BOND], row[MODE], row[RATE], row[SPENT] = k, mode, rate, 0.0
    row[FIRST] = math.sqrt(rate)
    row[LAST] = last_opening(opening, sliding, tear, shear, row[FIRST])


@device
def pressed_beam(s, kn, extension):
    """Energy of what presses on a beam of integrity s, beside that of the beam [J]."""
    pressed = max(-extension, 0.0)
    return (1.0 - s) * 0.5 * kn * pressed * pressed


@loop(parallel=False)
def _look_at(pose, bonds, soft, change, first, last):
    """Integrity of the beams first … last of those that are looked at, and what presses on each."""
    rows, outputs, active, integrity, hold = soft.row, soft.output, soft.active, bonds.integrity, bonds.hold
    length, kn = bonds.length, bonds.kn
    for e in range(first, last):
        c = active[e]
        row, output = rows[c], outputs[c]
        k = np.int64(row[SOFT_BOND])
        s = integrity[k]
        d, extension, opening, sliding = whole_beam(pose, bonds, k)
        new = lose_integrity(row, output, s, opening, sliding, change)
        if new < s:
            integrity[k] = new
            if len(hold) > 0:
                hold[k] = new / length[k]
        press_beam(output, new, kn[k], length[k], d, extension)


@loop(parallel=True)
def _look_in_portions(pose, bonds, soft, change, count):
    for q in prange(count):
        first, last = soft.sizes[LOOKED_AT] * q // count, soft.sizes[LOOKED_AT] * (q + 1) // count
        _look_at(pose, bonds, soft, change, first, last)


@loop(parallel=False)
def _parted(elements, bonds, contacts, breaks, soft, c):
    """Write down a beam of which nothing is left; what presses on it is a contact's, where there is one."""
    pose, row, k = elements.pose, soft.row[c], np.int64(soft.row[c, SOFT_BOND])
    a, share = bonds.i[k], bonds.lever[k] / bonds.length[k]
    d = branch(pose, a, bonds.j[k], bonds.period)
    gap = math.sqrt(scalar(d, d)) - bonds.length[k]
    place = pose[a, 0] + share * d[0], pose[a, 1] + share * d[1], pose[a, 2] + share * d[2]
    write_break(breaks.log[breaks.logged[0]], breaks.now, k, row[MODE], gap, row[SPENT], place)
    breaks.logged[0] += 1
    if contacts is not None:  # decided when compiled
        if soft.handed:
            soft.output[c, PUSH : PUSH + 3] = 0.0
            press_on(elements, bonds.period, contacts, soft.load, k)


@loop(parallel=False)
def soften_beams(elements, bonds, contacts, breaks, soft, threaded):
    """Before the forces of a step: beams lose integrity, and what presses on them goes to their ends."""
    if soft.sizes[BEGUN] == 0:
        return
    _list_soft(bonds, soft)
    count, change = soft.sizes[LOOKED_AT], breaks.now[1] >= 0.0
    if threaded and count >= _SERIAL:
        _look_in_portions(elements.pose, bonds, soft, change, count // _PORTION)
    else:
        _look_at(elements.pose, bonds, soft, change, 0, count)
    load, lost = soft.load, 0.0
    for e in range(count):
        c = soft.active[e]
        lost += soft.output[c, LOST]
        if soft.output[c, PARTS] != 0.0:
            _parted(elements, bonds, contacts, breaks, soft, c)
        k = np.int64(soft.row[c, SOFT_BOND])
        for n in range(3):
            load[bonds.i[k], n] -= soft.output[c, PUSH + n]
            load[bonds.j[k], n] += soft.output[c, PUSH + n]
    breaks.released[0] += lost


@loop(parallel=False)
def begin_to_soften(breaks, soft):
    """Put the beams that were found to reach their strength into the list, in the order of the bonds.

    What they held then was written down as they were judged: by now their ends may have moved.
    """
    for block in range(len(breaks.found)):
        for e in range(breaks.begin[block], breaks.begin[block] + breaks.found[block]):
            k = breaks.marked[e]
            row, held = soft.row[soft.sizes[BEGUN]], breaks.onset[k]
            begin_row(row, k, held[2], held[0], held[1], soft.tear[k], soft.shear[k])
            soft.sizes[BEGUN] += 1
            breaks.limit[k] = np.inf
        breaks.found[block] = 0


@kernel(parallel=False)
def pressed_energy(pose, bonds, row, count, handed):
    """Energy of what presses on the first `count` beams that soften, beside that of the beams [J]."""
    total = 0.0
    for c in range(count):
        k = np.int64(row[c, SOFT_BOND])
        s = bonds.integrity[k]
        if s > 0.0 or not handed:
            d = branch(pose, bonds.i[k], bonds.j[k], bonds.period)
            total += pressed_beam(s, bonds.kn[k], math.sqrt(scalar(d, d)) - bonds.length[k])
    return total
