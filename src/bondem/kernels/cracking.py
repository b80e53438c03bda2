"""Cracked facets in a step: their stresses, integrity and forces, which they bear one by one outside of the lanes.

A facet that has begun to crack leaves the loops over facets for good (there its integrity is 0) and stands in a list,
in the order in which cracks began. Between the two passes over the facets the stresses of their cells are found anew,
as cracks open or press; then integrities fall, and forces are handed to the elements with those of contacts. All of
it is done by one thread, in the order of the list: no bit depends on threads. See `bondem.laws.softening`.
"""

import math

import numpy as np

from bondem._compile import device, kernel
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_tensors import heat, judge_body
from bondem.kernels.crack_list import NEW, begin_cracks, place_normals, put, three, weigh_parted
from bondem.kernels.crack_tables import (
    BEFORE,
    FACET,
    GAP,
    NORMAL,
    ONSET,
    PARTED,
    RATE,
    RUB,
    SHARE_I,
    SHARE_J,
    SLIP,
    SPENT,
)
from bondem.kernels.single_facets import frame, orientation, present_normal, resistance
from bondem.kernels.tables import (
    BROKEN_BOND,
    BROKEN_ENERGY,
    BROKEN_GAP,
    BROKEN_MODE,
    BROKEN_PLACE,
    BROKEN_STEP,
    BROKEN_TIME,
    RUBBED,
)
from bondem.laws.cell_energy import cross, opened, relative, resisted_turn, scalar, turned_by
from bondem.laws.failure.criterion import SHEAR, TENSION
from bondem.laws.softening import (
    crack_couple,
    crack_softness,
    crack_swelling,
    opening_force,
    plus,
    rubbed,
    softened,
    whole_force,
)

# By how much an integrity falls in a step at most: what breaks at once does so in ten, and the ledger stays exact.
_FASTEST = 0.1


@kernel(parallel=False)
def measure_cracks(pose, bonds, cells, cracks):
    """Gap, normal and shares of all cracks, and V θ of their cells without them."""
    for c in range(cracks.sizes[0]):
        k = np.int64(cracks.row[c, FACET])
        if cracks.row[c, PARTED] != 0.0:
            continue
        d, p, q, a, b, u, v = frame(pose, bonds, cells, k)
        g = cracks.geometry[c]
        put(g, GAP, opened(d, turned_by(p, a), turned_by(q, b)))
        put(g, NORMAL, present_normal(pose, bonds, cells, k))
        put(g, SHARE_I, turned_by(p, u))
        put(g, SHARE_J, turned_by(q, v))
    for e in range(cracks.sizes[1]):
        p = cracks.cell[e]
        cracks.base[p] = pose[p, STRESS] / cells.weight[p] if cells.weight[p] != 0.0 else 0.0


@kernel(parallel=False)
def relax_cells(pose, bonds, cells, cracks):
    """Stresses of cells with cracks, by Newton's method on a piecewise linear, rising function."""
    for e in range(cracks.sizes[1]):
        p = cracks.cell[e]
        W, stress = cells.weight[p], pose[p, STRESS]
        for _ in range(30):
            swelling, softness, c = cracks.base[p], 0.0, cracks.head[p]
            while c >= 0:
                k = np.int64(cracks.row[c, FACET])
                own = bonds.i[k] == p
                if cracks.row[c, PARTED] == 0.0:
                    g, s = cracks.geometry[c], cracks.integrity[k]
                    gap, normal = three(g, GAP), three(g, NORMAL)
                    share = three(g, SHARE_I) if own else three(g, SHARE_J)
                    part = cracks.part[k] if own else 1.0 - cracks.part[k]
                    opening, along = opening_force(whole_force(cells.k[k], part, gap, share, stress), normal)
                    swelling += crack_swelling(cells.k[k], s, gap, share, opening)
                    softness += crack_softness(cells.k[k], s, part, share, normal, along < 0.0)
                c = cracks.after_i[c] if own else cracks.after_j[c]
            change = (W * swelling - stress) / (1.0 + W * softness)
            stress += change
            if abs(change) <= 1e-14 * abs(stress):
                break
        pose[p, STRESS] = stress


@device
def _halves(pose, bonds, cells, cracks, c):
    """Facet of a crack, its gap and normal, and F⁺ and pressing force of both halves."""
    k = np.int64(cracks.row[c, FACET])
    g, w = cracks.geometry[c], cracks.part[k]
    gap, normal = three(g, GAP), three(g, NORMAL)
    one = whole_force(cells.k[k], w, gap, three(g, SHARE_I), pose[bonds.i[k], STRESS])
    other = whole_force(cells.k[k], 1.0 - w, gap, three(g, SHARE_J), pose[bonds.j[k], STRESS])
    return k, gap, normal, opening_force(one, normal), opening_force(other, normal)


@kernel(parallel=False)
def soften(pose, bonds, cells, cracks):
    """Integrities of all cracks at the present openings; faces that no longer face each other part."""
    changed = False
    for c in range(cracks.sizes[0]):
        row = cracks.row[c]
        if row[PARTED] != 0.0:
            continue
        k, gap, normal, (one, press_i), (other, press_j) = _halves(pose, bonds, cells, cracks, c)
        w, s, A = cracks.part[k], cracks.integrity[k], cracks.area[k]
        if row[BEFORE] == NEW:
            row[BEFORE] = s
            continue
        row[BEFORE] = s
        if s > 0.0:
            whole = (w * one[0], w * one[1], w * one[2])
            whole = plus(whole, 1.0 - w, other)
            traction = math.sqrt(scalar(whole, whole)) / A
            new = max(softened(s, traction, row[ONSET], cracks.last[k]), s - _FASTEST)
            if new < 1e-9:
                new = 0.0
            if new < s:
                cracks.integrity[k] = new
                changed = True
        elif press_i == 0.0 and press_j == 0.0:
            along = scalar(gap, normal)
            across = plus(gap, -along, normal)
            if along * along > A or scalar(across, across) > A:
                row[PARTED] = 1.0
                put(cracks.pull[c], 0, (0.0, 0.0, 0.0))
                row[RATE] = 0.0
                weigh_parted(bonds, cells, cracks, bonds.i[k])
                weigh_parted(bonds, cells, cracks, bonds.j[k])
                changed = True
    return changed


@device
def _log(pose, cells, bonds, cracks, c, k, mode, gap):
    row = cracks.log[cracks.sizes[2]]
    i = bonds.i[k]
    arm = turned_by(orientation(pose, i), frame(pose, bonds, cells, k)[3])
    row[BROKEN_TIME], row[BROKEN_STEP], row[BROKEN_BOND], row[BROKEN_MODE] = cracks.now[0], cracks.now[1], k, mode
    row[BROKEN_GAP], row[BROKEN_ENERGY] = gap, cracks.row[c, SPENT]
    for d in range(3):
        row[BROKEN_PLACE + d] = pose[i, d] + arm[d]
    cracks.sizes[2] += 1


@device
def _half_couple(k, w, s, gap, share, stress, opening):
    """e × σ g / w with e = w gap - u: of a half whose normal turns."""
    u = (1.0 - s) * w / k
    e = w * gap[0] - u * opening[0], w * gap[1] - u * opening[1], w * gap[2] - u * opening[2]
    c = cross(e, share)
    return stress / w * c[0], stress / w * c[1], stress / w * c[2]


@device
def _bending(pose, bonds, cells, k):
    """Energy [J] and torque on cell i [N·m] of the bending of a whole facet."""
    p, q = orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
    w, v, space = relative(p, q)
    turned = resisted_turn(resistance(cells, 1.0, k), v)
    h = turned_by(p, turned)
    c = cross(space, h)
    return 2.0 * scalar(v, turned), (2.0 * (w * h[0] + c[0]), 2.0 * (w * h[1] + c[1]), 2.0 * (w * h[2] + c[2]))


@device
def _add(load, p, sign, force, torque):
    for d in range(3):
        load[p, d] += sign * force[d]
        load[p, 3 + d] += torque[d]


@kernel(parallel=False)
def crack_forces(elements, bonds, cells, cracks, change):
    """Forces and torques of all cracks into `load`; where it is to `change`, slip and energies are booked."""
    pose, load = elements.pose, cracks.load
    for e in range(cracks.sizes[1]):
        load[cracks.cell[e], :] = 0.0
    for c in range(cracks.sizes[0]):
        row = cracks.row[c]
        if row[PARTED] != 0.0:
            continue
        k, gap, normal, (one, press_i), (other, press_j) = _halves(pose, bonds, cells, cracks, c)
        i, j, w, s, K = bonds.i[k], bonds.j[k], cracks.part[k], cracks.integrity[k], cells.k[k]
        g = cracks.geometry[c]
        along = w * press_i + (1.0 - w) * press_j
        q = orientation(pose, i)
        slip = turned_by(q, three(row, SLIP))
        rub, slip = rubbed(K, s, gap, normal, slip, -cracks.friction * (1.0 - s) * along)
        f = plus(plus(rub, s * w, one), s * (1.0 - w), other)
        f = plus(f, along, normal)
        ci = _half_couple(K, w, s, gap, three(g, SHARE_I), pose[i, STRESS], one)
        cj = _half_couple(K, 1.0 - w, s, gap, three(g, SHARE_J), pose[j, STRESS], other)
        n = crack_couple(gap, f, ci, cj)
        bent, h = _bending(pose, bonds, cells, k)
        a = turned_by(q, frame(pose, bonds, cells, k)[3])
        b = turned_by(orientation(pose, j), frame(pose, bonds, cells, k)[4])
        x, y = cross(a, f), cross(f, b)
        ti = plus(plus(plus(x, 1.0, ci), 0.5, n), s, h)
        tj = plus(plus(plus(y, 1.0, cj), 0.5, n), -s, h)
        _add(load, i, 1.0, f, ti)
        _add(load, j, -1.0, f, tj)
        put(cracks.pull[c], 0, f)
        if change:
            _book(elements, bonds, cells, cracks, c, (one, other, rub, slip, bent))
            if s == 0.0 and row[BEFORE] > 0.0:
                mode = TENSION if scalar(gap, normal) > 0.0 else SHEAR
                _log(pose, cells, bonds, cracks, c, k, mode, scalar(gap, normal))


@device
def _stretched(K, s, rub):
    """Energy over 1 - s of the spring of friction [J]."""
    return 0.0 if s >= 1.0 else 0.5 * scalar(rub, rub) / (K * (1.0 - s) ** 2)


@device
def _book(elements, bonds, cells, cracks, c, found):
    """Energy that a crack has dissipated in this step, by the trapezoidal rule, and its slip."""
    one, other, rub, slip, bent = found
    row = cracks.row[c]
    k = np.int64(row[FACET])
    w, s, K, i = cracks.part[k], cracks.integrity[k], cells.k[k], bonds.i[k]
    rate = 0.5 / K * (w * scalar(one, one) + (1.0 - w) * scalar(other, other)) + bent - _stretched(K, s, rub)
    lost = 0.5 * (row[RATE] + rate) * (row[BEFORE] - s)
    row[RATE] = rate
    row[SPENT] += lost
    cracks.released[0] += lost
    q = elements.pose[i, 4], elements.pose[i, 5], elements.pose[i, 6], elements.pose[i, 7]
    own = turned_by((q[0], -q[1], -q[2], -q[3]), slip)
    came = plus(slip, -1.0, turned_by(q, three(row, SLIP)))
    elements.loss[i, RUBBED] += 0.5 * (scalar(three(row, RUB), came) + scalar(rub, came))
    put(row, SLIP, own)
    put(row, RUB, rub)


@device
def _crack_energy(pose, bonds, cells, cracks, c):
    """Elastic energy of a crack: across, along and of bending [J]."""
    k, gap, normal, (one, _), (other, _) = _halves(pose, bonds, cells, cracks, c)
    w, s, K = cracks.part[k], cracks.integrity[k], cells.k[k]
    across = along = 0.0
    for half in range(2):
        part, opening = (w, one) if half == 0 else (1.0 - w, other)
        u = (1.0 - s) * part / K
        e = part * gap[0] - u * opening[0], part * gap[1] - u * opening[1], part * gap[2] - u * opening[2]
        normal_part = scalar(e, normal)
        across += 0.5 * K / part * normal_part * normal_part
        along += 0.5 * K / part * (scalar(e, e) - normal_part * normal_part)
        across += 0.5 * s * (1.0 - s) * part / K * scalar(opening, opening)
    bent, _ = _bending(pose, bonds, cells, k)
    along += (1.0 - s) * _stretched(K, s, three(cracks.row[c], RUB))
    return across, along, s * bent


@kernel(parallel=False)
def crack_energies(pose, bonds, cells, cracks):
    """Elastic energy of all cracks: normal, shear and bending [J]."""
    normal = shear = bend = 0.0
    for c in range(cracks.sizes[0]):
        if cracks.row[c, PARTED] == 0.0:
            one, other, bent = _crack_energy(pose, bonds, cells, cracks, c)
            normal += one
            shear += other
            bend += bent
    return normal, shear, bend


@device
def with_cracks(pose, bonds, cells, cracks, parts):
    """Normal, shear, bending and twisting energy of a body with those of its cracks [J]."""
    if cracks is None:  # decided when compiled
        return parts
    normal, shear, bend = crack_energies(pose, bonds, cells, cracks)
    return parts[0] + normal, parts[1] + shear, parts[2] + bend, parts[3]


@kernel(parallel=False)
def dissipated(cracks):
    """Energies that cracks and cells that yield have dissipated [J]."""
    return cracks.released[0], heat(cracks)


@kernel(parallel=False)
def crack_before(elements, bonds, body, cracks, threaded):
    """As a step begins: cells yield, and facets begin to crack."""
    if cracks is not None:  # decided when compiled
        if cracks.now[1] >= 0.0:
            if judge_body(elements.pose, bonds, body, cracks, threaded):
                place_normals(elements.pose, bonds, body.cells, cracks)
                begin_cracks(bonds, cracks)


@kernel(parallel=False)
def crack_between(elements, bonds, cells, cracks):
    """Between the passes over the facets: stresses of cells with cracks, and what these do."""
    if cracks is not None:
        if cracks.sizes[0] > 0:
            change = cracks.now[1] >= 0.0
            measure_cracks(elements.pose, bonds, cells, cracks)
            relax_cells(elements.pose, bonds, cells, cracks)
            if change:
                if soften(elements.pose, bonds, cells, cracks):
                    relax_cells(elements.pose, bonds, cells, cracks)
            crack_forces(elements, bonds, cells, cracks, change)
