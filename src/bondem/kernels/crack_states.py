"""How cracks are treated in a step: stresses of their cells, integrities, and when they rest or part.

What a function does with the cracks or cells first … last of a list concerns each of them alone, and is done by
whatever thread; what concerns others too is done by one thread, in the order of the list: no bit depends on threads.
"""

import math

from bondem._compile import device, kernel, loop
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_stress import pair_stress
from bondem.kernels.contact_pairs import let_touch
from bondem.kernels.crack_energy import bending_traction, halves, opened_at_most, stretched
from bondem.kernels.crack_list import NEW, known, link_cracks, read_three, treat, weigh_cracked, write_three
from bondem.kernels.crack_nearness import GRAZING, integrity_at, unsoftened_below, wakes
from bondem.kernels.crack_tables import (
    ACTIVE,
    ALONG,
    ARM_I,
    ARM_J,
    AT_REST,
    BEFORE,
    CLOSED,
    FACING,
    GAP,
    LOOSE,
    NORMAL,
    ONSET,
    PARTED,
    PRESSED,
    PULLED,
    RESTING,
    RUB,
    SHARE_I,
    SHARE_J,
    SLIP,
    SQUARE,
    SWOLLEN,
    TOP,
    TREATED,
    TREATED_ONES,
)
from bondem.kernels.single_facets import column, frame, orientation, resistance
from bondem.laws.cell_energy import opened, scalar, turned_by
from bondem.laws.softening import plus

# By how much the integrity of a facet that softens falls in a step at most.
_FASTEST = 0.1
# A crack goes to rest at this share of the traction at which it softens, and twice `GRAZING` of its force across it.
_ASLEEP = 0.9
# Faces whose normals are further apart than this cosine do not bear on each other as planes any more.
_FACING = 0.7
# What is to be done with a crack, beside nothing: its integrity fell, it goes to rest, its faces part, or it wakes.
FELL, CALMED, TO_PART, WAKES = 1, 2, 3, 4


@loop(parallel=False)
def measure_crack(geometry, c, place, n):
    """Write what is known of crack c; `place` is its `frame`, n its normal in the frames of both cells."""
    d, p, q, a, b, u, v = place
    a, b = turned_by(p, a), turned_by(q, b)
    n, m = turned_by(p, n), turned_by(q, n)
    write_three(geometry, c, GAP, opened(d, a, b))
    write_three(geometry, c, SHARE_I, turned_by(p, u))
    write_three(geometry, c, SHARE_J, turned_by(q, v))
    write_three(geometry, c, ARM_I, a)
    write_three(geometry, c, ARM_J, b)
    geometry[c, FACING] = scalar(n, m)
    n = plus(n, 1.0, m)
    l = math.sqrt(scalar(n, n))
    write_three(geometry, c, NORMAL, (n[0] / l, n[1] / l, n[2] / l))


@loop(parallel=False)
def halve_crack(half, geometry, c, k, w, s):
    """Write the halves of a crack of stiffness k [N/m], part w of cell i and integrity s."""
    gap, normal = read_three(geometry, c, GAP), read_three(geometry, c, NORMAL)
    along = k * scalar(gap, normal)
    for side in range(2):
        share, part = read_three(geometry, c, SHARE_I if side == 0 else SHARE_J), w if side == 0 else 1.0 - w
        swollen, across, h = scalar(share, gap), scalar(share, normal), 2 * c + side
        half[h, SWOLLEN], half[h, PULLED], half[h, SQUARE] = swollen, k * swollen, scalar(share, share) / part
        half[h, ALONG], half[h, PRESSED], half[h, CLOSED] = across, across / part, along
        half[h, LOOSE], half[h, TREATED] = (1.0 - s) / k, 1.0


@loop(parallel=False)
def measure_cracks(pose, bonds, cells, cracks, first, last):
    """What is known of the cracks first … last of those that are treated one by one."""
    facet, geometry, half, part, integrity = cracks.facet, cracks.geometry, cracks.half, cracks.part, cracks.integrity
    active, normal, stiff = cracks.active, cells.normal, cells.k
    for e in range(first, last):
        c = active[e]
        k = facet[c]
        measure_crack(geometry, c, frame(pose, bonds, cells, k), column(normal, k))
        halve_crack(half, geometry, c, stiff[k], part[k], integrity[k])


@kernel(parallel=False)
def take_up_cracks(pose, bonds, cells, cracks):
    """Lists, weights and geometry of all cracks, as a run begins: its first record has their energies."""
    link_cracks(bonds, cells, cracks)
    measure_cracks(pose, bonds, cells, cracks, 0, cracks.sizes[TREATED_ONES])


@loop(parallel=False)
def begin_bases(pose, cells, cracks, first, last):
    """V θ of the cells first … last of all, without what their cracks that are treated one by one do."""
    base, weight = cracks.base, cells.weight
    for p in range(first, last):
        base[p] = pose[p, STRESS] / weight[p] if weight[p] != 0.0 else 0.0


@loop(parallel=False)
def relax_cells(pose, cells, cracks, again, first, last):
    """Stresses of the cells first … last of the list, by Newton's method on a piecewise linear, rising function.

    V θ = Σ g·δ - (1 - s) g·F⁺ / k of each half (`bondem.laws.softening`), all but the stress in the table of halves.
    A step of Newton's is exact where no half begins or ceases to press on the way. `again`: those that are stale.
    """
    cell, base, head, after, half = cracks.cell, cracks.base, cracks.head, cracks.after, cracks.half
    weight, stale = cells.weight, cracks.stale
    for e in range(first, last):
        p = cell[e]
        if again and stale[p] == 0:
            continue
        stale[p] = 0
        W, stress = weight[p], pose[p, STRESS]
        for _ in range(30):
            swelling, softness, h, up, down = base[p], 0.0, head[p], math.inf, -math.inf
            while h >= 0:
                along, square = half[h, ALONG], half[h, SQUARE]
                press = half[h, CLOSED] + stress * half[h, PRESSED]
                turns = -press / half[h, PRESSED]  # how far the stress is from where this half turns
                if turns > 0.0:
                    up = min(up, turns)
                elif turns <= 0.0:
                    down = max(down, turns)
                opening = half[h, PULLED] + stress * square
                if press < 0.0:
                    opening -= press * along
                    square -= half[h, PRESSED] * along
                swelling += half[h, SWOLLEN] - half[h, LOOSE] * opening
                softness += half[h, LOOSE] * square
                h = after[h]
            change = (W * swelling - stress) / (1.0 + W * softness)
            stress += change
            if (down < change and change < up) or abs(change) <= 1e-14 * abs(stress):
                break
        pose[p, STRESS] = stress


@device
def hand_over(bonds, cells, cracks, c, k, sign):
    """Add what a resting crack does to V θ of its cells to `base`, or take it off."""
    geometry, s = cracks.geometry, sign * cracks.integrity[k]
    gap = read_three(geometry, c, GAP)
    cracks.base[bonds.i[k]] += s * scalar(read_three(geometry, c, SHARE_I), gap)
    cracks.base[bonds.j[k]] += s * scalar(read_three(geometry, c, SHARE_J), gap)
    weigh_cracked(cells, cracks, bonds.i[k])
    weigh_cracked(cells, cracks, bonds.j[k])


@loop(parallel=False)
def look_at_rest(pose, bonds, cells, cracks, a, v, first, last):
    """Flag those of the resting cracks first … last that are about to soften or close; a and v are (3, 3) to use."""
    flag, resting, facet = cracks.flag, cracks.resting, cracks.facet
    for e in range(first, last):
        c = resting[e]
        flag[c] = WAKES if wakes(pose, bonds, cells, cracks, c, frame(pose, bonds, cells, facet[c]), a, v) else 0


@device
def wake_crack(pose, bonds, cells, contacts, cracks, c, k, place):
    """Treat a resting crack one by one, or not at all where its faces part; whether it is treated now.

    `place` is its `frame`. Its cells do not know of it yet (`hand_over`).
    """
    row = cracks.row
    measure_crack(cracks.geometry, c, place, column(cells.normal, k))
    if cracks.integrity[k] == 0.0 and turned_away(cracks.geometry, c, cracks.area[k]):
        treat(bonds, cracks, c, k, PARTED)
        part_faces(pose, bonds, contacts, row, c, k)
        return False
    treat(bonds, cracks, c, k, ACTIVE)
    halve_crack(cracks.half, cracks.geometry, c, cells.k[k], cracks.part[k], cracks.integrity[k])
    row[c, BEFORE] = NEW
    gap, normal, p = read_three(cracks.geometry, c, GAP), read_three(cracks.geometry, c, NORMAL), place[1]
    write_three(row, c, SLIP, turned_by((p[0], -p[1], -p[2], -p[3]), plus(gap, -scalar(gap, normal), normal)))
    return True


@loop(parallel=False)
def wake_cracks(pose, bonds, cells, contacts, cracks):
    """Treat those resting cracks one by one that were flagged; whether there are any."""
    woken = False
    for e in range(cracks.sizes[AT_REST]):
        c = cracks.resting[e]
        if cracks.flag[c] != WAKES:
            continue
        k = cracks.facet[c]
        if not wake_crack(pose, bonds, cells, contacts, cracks, c, k, frame(pose, bonds, cells, k)):
            continue
        hand_over(bonds, cells, cracks, c, k, -1.0)
        cracks.stale[bonds.i[k]] = cracks.stale[bonds.j[k]] = 1
        woken = True
    return woken


@loop(parallel=False)
def soften(pose, bonds, cells, cracks, a, v, first, last):
    """Integrities of the cracks first … last of those that are treated one by one, at their present openings.

    Those that rest or part now are flagged; a and v are (3, 3) to use.
    """
    rows, active, flag, integrity = cracks.row, cracks.active, cracks.flag, cracks.integrity
    half, geometry, at_i, at_j = cracks.half, cracks.geometry, bonds.i, bonds.j
    lasting, fastest, area, tensor, bends = cracks.last, cracks.fastest, cracks.area, cracks.tensor, cells.bends
    for e in range(first, last):
        c = active[e]
        flag[c] = 0
        k, K, w, gap, normal, shares, stresses = known(pose, bonds, cells, cracks, c)
        s, before, strength = integrity[k], rows[c, BEFORE], rows[c, ONSET]
        rows[c, BEFORE] = s
        if before == NEW:
            continue
        if s == 0.0 and turned_away(geometry, c, area[k]):
            flag[c] = TO_PART
            continue
        f = plus(plus((K * gap[0], K * gap[1], K * gap[2]), stresses[0], shares[0]), stresses[1], shares[1])
        new, calm = s, s == 0.0
        if s > 0.0:
            i, j, A = at_i[k], at_j[k], area[k]
            t, mean = (f[0] / A, f[1] / A, f[2] / A), pair_stress(tensor, i, j)
            bent = bending_traction(
                orientation(pose, i), orientation(pose, j), bends[k], resistance(cells, 1.0, k)
            )
            opens = bent if cracks.plane[k] != 0 or strength == 0.0 else opened_at_most(bent, mean)
            least = unsoftened_below(
                s, strength, lasting[k], cracks.plane[k], cracks.cohesion[k], cracks.friction[k], cracks.kink,
                cracks.steep,
            )  # fmt: skip
            calm = math.sqrt(scalar(t, t) + opens * opens) < _ASLEEP * least
            rows[c, TOP] = A * least
            if not calm:
                most = fastest[k] if strength == 0.0 or lasting[k] == 0.0 else _FASTEST
                new = max(integrity_at(cracks, c, k, s, t, normal, bent, mean, a, v), s - most)
                new = 0.0 if new < 1e-9 else new
                if new == s:
                    near = 1.0 / _ASLEEP
                    t = near * t[0], near * t[1], near * t[2]
                    calm = integrity_at(cracks, c, k, s, t, normal, near * bent, mean, a, v) == s
        if new < s:
            integrity[k] = new
            half[2 * c, LOOSE] = half[2 * c + 1, LOOSE] = (1.0 - new) / K
            flag[c] = FELL
        elif calm:
            (_, press_i), (_, press_j) = halves(K, w, gap, normal, shares, stresses)
            opened_so = press_i == 0.0 and press_j == 0.0
            if opened_so and scalar(f, normal) > 2.0 * GRAZING * math.sqrt(scalar(f, f)):
                flag[c] = CALMED


@loop(parallel=False)
def leave_cracks(pose, bonds, cells, contacts, cracks):
    """Let cracks rest or part that were flagged; whether these, or integrities, changed."""
    changed = False
    for e in range(cracks.sizes[TREATED_ONES]):
        c = cracks.active[e]
        now = cracks.flag[c]
        if now == 0:
            continue
        changed = True
        if now == CALMED:
            leave_crack(bonds, cracks, c, RESTING)
        elif now == TO_PART:
            cracks.released[0] += let_go_crack(pose, bonds, cells, cracks, c)
            leave_crack(bonds, cracks, c, PARTED)
            part_faces(pose, bonds, contacts, cracks.row, c, cracks.facet[c])
        k = cracks.facet[c]
        cracks.stale[bonds.i[k]] = cracks.stale[bonds.j[k]] = 1
        if now != FELL:
            hand_over(bonds, cells, cracks, c, k, 1.0)
    return changed


@device
def let_go_crack(pose, bonds, cells, cracks, c):
    """Energy of a broken facet whose faces no longer bear on each other [J].

    Of each half that of the force that presses, less what its cell takes up as its stress changes by it; and that of
    friction.
    """
    k, K, w, gap, normal, shares, stresses = known(pose, bonds, cells, cracks, c)
    (_, press_i), (_, press_j) = halves(K, w, gap, normal, shares, stresses)
    lost = stretched(K, 0.0, read_three(cracks.row, c, RUB))
    for side in range(2):
        p, part, press = (bonds.i[k], w, press_i) if side == 0 else (bonds.j[k], 1.0 - w, press_j)
        if press < 0.0:
            h = 2 * c + side
            more = press / K * cracks.half[h, ALONG]
            lost += 0.5 * (part * press * press / K - more * more * _stiffness(pose, cells, cracks, p, h))
    return lost


@device
def _stiffness(pose, cells, cracks, p, without):
    """By how much the stress of a cell changes with V θ [Pa/m³], with the half `without` open."""
    half, after, h, softness = cracks.half, cracks.after, cracks.head[p], 0.0
    while h >= 0:
        square = half[h, SQUARE]
        if h != without and half[h, CLOSED] + pose[p, STRESS] * half[h, PRESSED] < 0.0:
            square -= half[h, PRESSED] * half[h, ALONG]
        softness += half[h, LOOSE] * square
        h = after[h]
    return cells.weight[p] / (1.0 + cells.weight[p] * softness)


@device
def turned_away(geometry, c, area):
    """Whether the faces of a crack no longer face each other."""
    gap, normal = read_three(geometry, c, GAP), read_three(geometry, c, NORMAL)
    along = max(scalar(gap, normal), 0.0)
    across = plus(gap, -scalar(gap, normal), normal)
    return geometry[c, FACING] < _FACING or max(along * along, scalar(across, across)) > area


@device
def part_faces(pose, bonds, contacts, rows, c, k):
    """Let the cells of a facet touch like others from now on, where cells do."""
    rows[c, TOP] = math.inf
    if contacts is not None:  # decided when compiled
        rows[c, TOP] = let_touch(pose, bonds.period, contacts, k)


@device
def leave_crack(bonds, cracks, c, status):
    """Treat a crack one by one no longer; its cells do not know yet (`hand_over`)."""
    k, row = cracks.facet[c], cracks.row
    treat(bonds, cracks, c, k, status)
    if cracks.integrity[k] == 0.0:
        row[c, TOP] = math.inf
    write_three(row, c, RUB, (0.0, 0.0, 0.0))
    write_three(row, c, SLIP, (0.0, 0.0, 0.0))
    write_three(cracks.pull, c, 0, (0.0, 0.0, 0.0))
    cracks.half[2 * c, :] = 0.0
    cracks.half[2 * c + 1, :] = 0.0
