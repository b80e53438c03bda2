"""Cracked facets in a step: their forces, which they bear one by one outside of the lanes, and their energies.

A facet that has begun to crack leaves the loops over facets (there its integrity is 0) and stands in a list, in the
order in which cracks began. Between the two passes over the facets the stresses of their cells are found anew, as
cracks open or press; then integrities fall, and forces are handed to the elements with those of contacts. A crack
that is open and does not soften rests: it is a facet of less stiffness among the others, which is the same to
rounding. All of it is done by one thread, in the order of the list: no bit depends on threads. See
`bondem.laws.softening`.
"""

import math

import numpy as np

from bondem._compile import device, loop
from bondem.kernels.breaking import write_break
from bondem.kernels.cell_yield import heat
from bondem.kernels.crack_energy import bending, crack_energy, halves, stretched
from bondem.kernels.crack_list import begin_cracks, known, read_three, write_three
from bondem.kernels.crack_onset import judge_body
from bondem.kernels.crack_states import measure_cracks, relax_cells, soften, wake_cracks
from bondem.kernels.crack_tables import (
    ACTIVE,
    ARM_I,
    ARM_J,
    BEFORE,
    FACET,
    RATE,
    RUB,
    SLIP,
    SPENT,
    STATUS,
)
from bondem.kernels.single_facets import orientation, resistance
from bondem.kernels.tables import RUBBED
from bondem.laws.cell_energy import cross, scalar, turned_by
from bondem.laws.failure.criterion import SHEAR, TENSION
from bondem.laws.softening import crack_couple, plus, rubbed


@device
def _log(pose, bonds, cracks, c, k, mode, gap):
    """Write down a crack of which nothing is left."""
    i, arm = bonds.i[k], read_three(cracks.geometry[c], ARM_I)
    place = pose[i, 0] + arm[0], pose[i, 1] + arm[1], pose[i, 2] + arm[2]
    write_break(cracks.log[cracks.sizes[2]], cracks.now, k, mode, gap, cracks.row[c, SPENT], place)
    cracks.sizes[2] += 1


@device
def _half_couple(k, w, s, gap, share, stress, opening):
    """e × σ g / w with e = w gap - u: of a half whose normal turns."""
    u = (1.0 - s) * w / k
    e = w * gap[0] - u * opening[0], w * gap[1] - u * opening[1], w * gap[2] - u * opening[2]
    c = cross(e, share)
    return stress / w * c[0], stress / w * c[1], stress / w * c[2]


@device
def _add(load, p, sign, force, torque):
    for d in range(3):
        load[p, d] += sign * force[d]
        load[p, 3 + d] += torque[d]


@loop(parallel=False)
def clear_cracks(cracks):
    """Take off `load` what cracks did a step ago; contacts write theirs anew."""
    if cracks is not None:  # decided when compiled
        for e in range(cracks.sizes[1]):
            cracks.load[cracks.cell[e], :] = 0.0


@loop(parallel=False)
def crack_forces(elements, bonds, cells, cracks, change):
    """Add forces and torques of all cracks to `load`; where it is to `change`, slip and energies are booked."""
    pose, load = elements.pose, cracks.load
    for c in range(cracks.sizes[0]):
        row = cracks.row[c]
        if row[STATUS] != ACTIVE:
            continue
        k, K, w, gap, normal, shares, stresses = known(pose, bonds, cells, cracks, c)
        (one, press_i), (other, press_j) = halves(K, w, gap, normal, shares, stresses)
        i, j, s = bonds.i[k], bonds.j[k], cracks.integrity[k]
        g = cracks.geometry[c]
        along = w * press_i + (1.0 - w) * press_j
        p, q = orientation(pose, i), orientation(pose, j)
        slip = turned_by(p, read_three(row, SLIP))
        rub, slip = rubbed(K, s, gap, normal, slip, -cracks.friction * (1.0 - s) * along)
        f = plus(plus(rub, s * w, one), s * (1.0 - w), other)
        f = plus(f, along, normal)
        ci = _half_couple(K, w, s, gap, shares[0], stresses[0], one)
        cj = _half_couple(K, 1.0 - w, s, gap, shares[1], stresses[1], other)
        n = crack_couple(gap, f, ci, cj)
        bent, h = bending(p, q, resistance(cells, 1.0, k))
        x, y = cross(read_three(g, ARM_I), f), cross(f, read_three(g, ARM_J))
        ti = plus(plus(plus(x, 1.0, ci), 0.5, n), s, h)
        tj = plus(plus(plus(y, 1.0, cj), 0.5, n), -s, h)
        _add(load, i, 1.0, f, ti)
        _add(load, j, -1.0, f, tj)
        write_three(cracks.pull[c], 0, f)
        if change:
            _book(elements, bonds, cells, cracks, c, (one, other, rub, slip, bent))
            if s == 0.0 and row[BEFORE] > 0.0:
                mode = TENSION if scalar(gap, normal) > 0.0 else SHEAR
                _log(pose, bonds, cracks, c, k, mode, scalar(gap, normal))


@device
def _book(elements, bonds, cells, cracks, c, found):
    """Energy that a crack has dissipated in this step, and its slip.

    The energy is s times a square of the opening, whose work both schemes book by the trapezoidal rule. What is left
    of its change is -Δs times the product of the openings before and after: the geometric mean of both rates, exactly
    so where the opening does not turn. (Their arithmetic mean misses Δs times the square of the change in opening.)
    """
    one, other, rub, slip, bent = found
    row = cracks.row[c]
    k = np.int64(row[FACET])
    w, s, K, i = cracks.part[k], cracks.integrity[k], cells.k[k], bonds.i[k]
    rate = 0.5 / K * (w * scalar(one, one) + (1.0 - w) * scalar(other, other)) + bent - stretched(K, s, rub)
    lost = math.sqrt(max(row[RATE] * rate, 0.0)) * (row[BEFORE] - s)
    row[RATE] = rate
    row[SPENT] += lost
    cracks.released[0] += lost
    q = elements.pose[i, 4], elements.pose[i, 5], elements.pose[i, 6], elements.pose[i, 7]
    own = turned_by((q[0], -q[1], -q[2], -q[3]), slip)
    came = plus(slip, -1.0, turned_by(q, read_three(row, SLIP)))
    elements.loss[i, RUBBED] += 0.5 * (scalar(read_three(row, RUB), came) + scalar(rub, came))
    write_three(row, SLIP, own)
    write_three(row, RUB, rub)


@loop(parallel=False)
def crack_energies(pose, bonds, cells, cracks):
    """Elastic energy of all cracks: normal, shear and bending [J]."""
    normal = shear = bend = 0.0
    for c in range(cracks.sizes[0]):
        if cracks.row[c, STATUS] == ACTIVE:
            k, K, w, gap, n, shares, stresses = known(pose, bonds, cells, cracks, c)
            s, rub = cracks.integrity[k], read_three(cracks.row[c], RUB)
            (one, _), (other, _) = halves(K, w, gap, n, shares, stresses)
            across, along = crack_energy(K, w, s, gap, n, (one, other), rub)
            p, q = orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
            bent, _ = bending(p, q, resistance(cells, s, k))
            normal += across
            shear += along
            bend += bent
    return normal, shear, bend


@device
def with_cracks(pose, bonds, cells, cracks, parts):
    """Normal, shear, bending and twisting energy of a body with those of its cracks [J]."""
    if cracks is None:  # decided when compiled
        return parts
    normal, shear, bend = crack_energies(pose, bonds, cells, cracks)
    return parts[0] + normal, parts[1] + shear, parts[2] + bend, parts[3]


@loop(parallel=False)
def dissipated(cracks):
    """Energies that cracks and cells that yield have dissipated [J]."""
    return cracks.released[0], heat(cracks.stress, cracks.flow)


@loop(parallel=False)
def crack_before(elements, bonds, body, rows, cracks, threaded):
    """As a step begins: cells yield, and facets begin to crack."""
    if cracks is not None:  # decided when compiled
        if cracks.now[1] >= 0.0:
            if judge_body(elements.pose, bonds, body, rows.work, cracks, threaded):
                begin_cracks(elements.pose, bonds, body.cells, cracks)


@loop(parallel=False)
def crack_between(elements, bonds, cells, contacts, cracks):
    """Between the passes over the facets: stresses of cells with cracks, and what these do."""
    if cracks is not None:
        if cracks.sizes[0] > 0:
            change = cracks.now[1] >= 0.0
            measure_cracks(elements.pose, bonds, cells, cracks)
            relax_cells(elements.pose, bonds, cells, cracks)
            if change:
                if wake_cracks(elements.pose, bonds, cells, contacts, cracks):
                    relax_cells(elements.pose, bonds, cells, cracks)
                if soften(elements.pose, bonds, cells, contacts, cracks):
                    relax_cells(elements.pose, bonds, cells, cracks)
            crack_forces(elements, bonds, cells, cracks, change)
