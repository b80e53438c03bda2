"""What cracked facets bear and dissipate: forces and torques of each crack, their sums on cells, and energies."""

import math

from bondem._compile import device, loop
from bondem.kernels.breaking import write_break
from bondem.kernels.cell_stress import add_moment
from bondem.kernels.cell_yield import heat
from bondem.kernels.crack_energy import bending, crack_energy, halves
from bondem.kernels.crack_list import known, read_three, write_three
from bondem.kernels.crack_tables import (
    ACTIVE,
    ARM_I,
    ARM_J,
    BEFORE,
    CELLS,
    CRACKS,
    GAP,
    LOGGED,
    LOST,
    NORMAL,
    RATE,
    RUB,
    RUBBED_AWAY,
    SLIP,
    SPENT,
    STATUS,
    TORQUE_I,
    TORQUE_J,
    TREATED,
    TREATED_ONES,
)
from bondem.kernels.single_facets import column, lever, orientation, resistance
from bondem.kernels.tables import RUBBED
from bondem.laws.cell_energy import cross, scalar, turned_by
from bondem.laws.failure.criterion import SHEAR, TENSION
from bondem.laws.softening import crack_couple, plus, rubbed


@device
def log_crack(pose, bonds, cracks, c, k, mode, gap):
    """Write down a crack of which nothing is left."""
    i, arm = bonds.i[k], read_three(cracks.geometry, c, ARM_I)
    place = pose[i, 0] + arm[0], pose[i, 1] + arm[1], pose[i, 2] + arm[2]
    write_break(cracks.log[cracks.sizes[LOGGED]], cracks.now, k, mode, gap, cracks.row[c, SPENT], place)
    cracks.sizes[LOGGED] += 1


@device
def _half_couple(k, w, s, gap, share, stress, opening):
    """e × σ g / w with e = w gap - u: of a half whose normal turns."""
    u = (1.0 - s) * w / k
    e = w * gap[0] - u * opening[0], w * gap[1] - u * opening[1], w * gap[2] - u * opening[2]
    c = cross(e, share)
    return stress / w * c[0], stress / w * c[1], stress / w * c[2]


@device
def _normal_couples(both, slid, p, own, normal):
    """Torques on cells i and j of the normal (n_i + n_j) / |n_i + n_j| that turns with both, and of slip with i.

    Args:
        both: their sum, from the balance of angular momentum.
        slid: that of the slip, which turns with cell i.
        p: orientation of cell i.
        own: n_i in its frame.
        normal: that of the crack.
    """
    turning = plus(both, -1.0, slid)
    ni, m = turned_by(p, own), cross(turning, normal)
    t = cross(ni, m)
    half = 0.5 / scalar(ni, normal)  # 1 / |n_i + n_j|
    t = half * t[0], half * t[1], half * t[2]
    return plus(slid, 1.0, t), plus(turning, -1.0, t)


@loop(parallel=False)
def clear_cracks(cracks):
    """Take off `load` what cracks did a step ago; contacts write theirs anew."""
    for e in range(cracks.sizes[CELLS]):
        cracks.load[cracks.cell[e], :] = 0.0


@loop(parallel=False)
def crack_forces(pose, bonds, cells, cracks, change, first, last):
    """Forces and torques of the cracks first … last of those that are treated one by one.

    Where they are to `change`, slip and energies are booked.
    """
    rows, geometry, integrity = cracks.row, cracks.geometry, cracks.integrity
    pulls, outputs = cracks.pull, cracks.output
    at_i, at_j, flag, friction = bonds.i, bonds.j, cracks.flag, cracks.friction
    active, listed, facet, facing = cracks.active, cracks.listed, cracks.facet, cells.normal
    for e in range(first, last):
        c = active[e]
        flag[c] = 0
        if listed[facet[c]] != 1 + ACTIVE:  # it has just gone to rest
            continue
        k, K, w, gap, normal, shares, stresses = known(pose, bonds, cells, cracks, c)
        (one, press_i), (other, press_j) = halves(K, w, gap, normal, shares, stresses)
        s = integrity[k]
        along = w * press_i + (1.0 - w) * press_j
        p, q = orientation(pose, at_i[k]), orientation(pose, at_j[k])
        slip = turned_by(p, read_three(rows, c, SLIP))
        rub, now = rubbed(K, s, gap, normal, slip, -friction[facet[c]] * (1.0 - s) * along)
        f = plus(plus(rub, s * w, one), s * (1.0 - w), other)
        f = plus(f, along, normal)
        ci = _half_couple(K, w, s, gap, shares[0], stresses[0], one)
        cj = _half_couple(K, 1.0 - w, s, gap, shares[1], stresses[1], other)
        both, slid = crack_couple(gap, f, ci, cj), cross(now, rub)
        ni, nj = _normal_couples(both, slid, p, column(facing, k), normal)
        bent, h = bending(p, q, resistance(cells, 1.0, k))
        x, y = cross(read_three(geometry, c, ARM_I), f), cross(f, read_three(geometry, c, ARM_J))
        write_three(pulls, c, 0, f)
        write_three(outputs, c, TORQUE_I, plus(plus(plus(x, 1.0, ci), 1.0, ni), s, h))
        write_three(outputs, c, TORQUE_J, plus(plus(plus(y, 1.0, cj), 1.0, nj), -s, h))
        outputs[c, RUBBED_AWAY] = outputs[c, LOST] = 0.0
        if change:
            rate = 0.5 / K * (w * scalar(one, one) + (1.0 - w) * scalar(other, other)) + bent
            _book(rows, outputs, c, K, s, rate, rub, plus(now, -1.0, slip))
            write_three(rows, c, SLIP, turned_by((p[0], -p[1], -p[2], -p[3]), now))
            write_three(rows, c, RUB, rub)
            if s == 0.0 and rows[c, BEFORE] > 0.0:
                flag[c] = 1


@device
def _book(rows, outputs, c, K, s, rate, rub, came):
    """Energy that a crack has dissipated in this step, and what it has rubbed away by the slip that came.

    The energy is s times a square of the opening, whose work both schemes book by the trapezoidal rule. What is left
    of its change is -Δs times the product of the openings before and after: the geometric mean of both rates, exactly
    so where the opening does not turn. (Their arithmetic mean misses Δs times the square of the change in opening.)
    The spring of friction has 1 - s times the square of its stretch, and takes up Δs times the product of both.
    """
    before, last = rows[c, BEFORE], read_three(rows, c, RUB)
    lost = 0.0
    if s < before:
        lost = math.sqrt(max(rows[c, RATE] * rate, 0.0)) * (before - s)
        after = 1.0 / (K * (1.0 - s))
        stretch = after * rub[0], after * rub[1], after * rub[2]
        if before < 1.0:
            lost -= 0.5 * scalar(last, stretch) * (before - s) / (1.0 - before)
        else:
            lost -= 0.5 * K * scalar(plus(stretch, 1.0, came), stretch) * (before - s)
    rows[c, RATE] = rate
    rows[c, SPENT] += lost
    outputs[c, LOST] = lost
    outputs[c, RUBBED_AWAY] = 0.5 * (scalar(last, came) + scalar(rub, came))


@loop(parallel=False)
def hand_out_cracks(cracks, loss, first, last):
    """Forces and torques of the cracks of the cells first … last of the list, and what these lose."""
    cell, head, after, half = cracks.cell, cracks.head, cracks.after, cracks.half
    load, pull, output = cracks.load, cracks.pull, cracks.output
    for e in range(first, last):
        p = cell[e]
        h = head[p]
        while h >= 0:
            c = h >> 1
            if half[h, TREATED] != 0.0:
                own = h == 2 * c
                sign, torque = (1.0, TORQUE_I) if own else (-1.0, TORQUE_J)
                for d in range(3):
                    load[p, d] += sign * pull[c, d]
                    load[p, 3 + d] += output[c, torque + d]
                if own:
                    loss[p, RUBBED] += output[c, RUBBED_AWAY]
            h = after[h]


@loop(parallel=False)
def log_cracks(pose, bonds, cracks):
    """Add up what cracks have dissipated in this step, and write down those of which nothing is left."""
    lost = 0.0
    for e in range(cracks.sizes[TREATED_ONES]):
        c = cracks.active[e]
        k = cracks.facet[c]
        if cracks.listed[k] == 1 + ACTIVE:
            lost += cracks.output[c, LOST]
            if cracks.flag[c] != 0:
                gap = scalar(read_three(cracks.geometry, c, GAP), read_three(cracks.geometry, c, NORMAL))
                log_crack(pose, bonds, cracks, c, k, TENSION if gap > 0.0 else SHEAR, gap)
    cracks.released[0] += lost


@loop(parallel=False)
def add_crack_moments(pose, cells, cracks, first, last):
    """Add the forces of the cracks of the cells first … last of the list, a step ago, to V σ of these."""
    cell, head, after, pull = cracks.cell, cracks.head, cracks.after, cracks.pull
    listed, facet = cracks.listed, cracks.facet
    moment, lever_i, lever_j, pitch = cells.moment, cells.lever_i, cells.lever_j, cells.pitch
    for e in range(first, last):
        p = cell[e]
        h = head[p]
        while h >= 0:
            c = h >> 1
            k = facet[c]
            if listed[k] == 1 + ACTIVE:
                if h == 2 * c:
                    add_moment(moment, pose, p, lever(lever_i, pitch, k), read_three(pull, c, 0))
                else:
                    away = -pull[c, 0], -pull[c, 1], -pull[c, 2]
                    add_moment(moment, pose, p, lever(lever_j, pitch, k), away)
            h = after[h]


@loop(parallel=False)
def crack_energies(pose, bonds, cells, cracks):
    """Elastic energy of all cracks: normal, shear and bending [J]."""
    normal = shear = bend = 0.0
    for c in range(cracks.sizes[CRACKS]):
        if cracks.row[c, STATUS] == ACTIVE:
            k, K, w, gap, n, shares, stresses = known(pose, bonds, cells, cracks, c)
            s, rub = cracks.integrity[k], read_three(cracks.row, c, RUB)
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
    normal, shear, bend = crack_energies(pose, bonds, cells, cracks.facets)
    return parts[0] + normal, parts[1] + shear, parts[2] + bend, parts[3]


@loop(parallel=False)
def dissipated(cracks):
    """Energies that cracks and cells that yield have dissipated [J]."""
    return cracks.facets.released[0], heat(cracks.stress, cracks.flow)
