"""Cracked facets in a step on a device, as `bondem.kernels.crack_pass` has it.

The functions of the CPU treat cracks or cells first … last of a list: here a thread calls them with one, of lists in
which every crack and cell stands in its own place. What concerns a cell (stress, weight, V θ of what rests) is done
by its thread, which finds its cracks by its facets and keeps them in the order of the CPU. Only cracks whose faces
part are treated by one thread, as what one releases depends on the others of its cell, and so is the log. All leave
at once where there are no cracks. The forces of a crack stand in the rows of its facet, in which the loop over facets
has left zeros: what moves the cells knows nothing of cracks.
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.crack_energy import bending, crack_energy, halves
from bondem.kernels.crack_list import known, read_three, weigh_cracked
from bondem.kernels.crack_nearness import wakes
from bondem.kernels.crack_states import (
    CALMED,
    TO_PART,
    WAKES,
    begin_bases,
    halve_crack,
    hand_over,
    leave_crack,
    let_go_crack,
    measure_crack,
    part_faces,
    relax_cells,
    soften,
    wake_crack,
)
from bondem.kernels.crack_tables import (
    ACTIVE,
    CRACKS,
    GAP,
    LOST,
    NORMAL,
    PARTED,
    RESTING,
    RUB,
    SHARE_I,
    SHARE_J,
    TORQUE_I,
    TORQUE_J,
)
from bondem.kernels.cracking import crack_forces, log_crack
from bondem.kernels.cuda.breaking import FOUND, put_in_order
from bondem.kernels.cuda.cells import book_hold, hand_on_hold, linear_stress
from bondem.kernels.cuda.facets import place_of
from bondem.kernels.cuda.sample import NORMAL as NORMAL_SUM
from bondem.kernels.single_facets import column, facet_of, facets_of, orientation, resistance
from bondem.laws.cell_energy import scalar
from bondem.laws.failure.criterion import SHEAR, TENSION


@cuda_kernel
def begin_stresses(clock, ahead, scheme, pose, weight, forces, adjacency, rows, schedules, grips, holds):
    """Stresses of all cells before their cracks open or press, and half the work of walls and tractions."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
    r = rows.of[p]
    if r >= 0:
        t = scheme.origin + (clock[0] + ahead) * scheme.dt
        book_hold(t, 1.0 if ahead > 0 else 0.0, pose, rows, schedules, grips, holds, p, r)
    pose[p, STRESS] = linear_stress(pose, weight, forces, adjacency, grips, holds, p, r)


@cuda_kernel
def end_stresses(pose, rows, grips, holds):
    """Forces of walls, and the other half of the work, with the stresses that cracks have left."""
    p = cuda.grid(1)
    if p < pose.shape[0] and rows.of[p] >= 0:
        hand_on_hold(pose, rows, grips, holds, p, rows.of[p])


@cuda_kernel
def take_up_holds(clock, scheme, pose, rows, schedules, grips, holds):
    """Walls and tractions where time has brought them, as a run begins with the stresses of its state."""
    p = cuda.grid(1)
    if p < pose.shape[0] and rows.of[p] >= 0:
        t, r = scheme.origin + clock[0] * scheme.dt, rows.of[p]
        book_hold(t, 0.0, pose, rows, schedules, grips, holds, p, r)
        hand_on_hold(pose, rows, grips, holds, p, r)


@cuda_kernel
def weigh_all_cracked(body, cracks):
    """λ / V of all cells, as a run begins."""
    p = cuda.grid(1)
    if p < cracks.head.shape[0]:
        weigh_cracked(body, cracks, p)


@device
def _link(body, cracks, lists, p):
    """Make the list of the halves of a cell that are treated one by one, the last crack first."""
    head, after, inward = -1, cracks.after, body.in_start[p + 1] - body.in_start[p]
    for e in range(facets_of(body, p)):
        k = facet_of(body, p, e)
        if cracks.listed[k] != 1 + ACTIVE:
            continue
        h = 2 * lists.crack[k] + (1 if e < inward else 0)
        if head < h:
            after[h], head = head, h
        else:
            q = head
            while after[q] > h:
                q = after[q]
            after[h], after[q] = after[q], h
    cracks.head[p] = head


@cuda_kernel
def link_cells(pose, body, cracks, lists, cracked):
    """The cracks of each cell, and its V θ without them."""
    p = cuda.grid(1)
    if p < pose.shape[0] and cracks.sizes[CRACKS] > 0 and cracked[p] != 0:
        _link(body, cracks, lists, p)
        begin_bases(pose, body, cracks, p, p + 1)


@cuda_kernel
def measure_some(pose, body, cracks):
    """What is known of the cracks that are treated one by one."""
    c = cuda.grid(1)
    if c >= cracks.sizes[CRACKS] or cracks.listed[cracks.facet[c]] != 1 + ACTIVE:
        return
    k = cracks.facet[c]
    measure_crack(cracks.geometry, c, place_of(pose, body, k), column(body.normal, k))
    halve_crack(cracks.half, cracks.geometry, c, body.k[k], cracks.part[k], cracks.integrity[k])


@cuda_kernel
def relax_some(pose, body, cracks):
    """Stresses of the cells with such cracks."""
    p = cuda.grid(1)
    if p < pose.shape[0] and cracks.sizes[CRACKS] > 0 and cracks.head[p] >= 0:
        relax_cells(pose, body, cracks, False, p, p + 1)


@cuda_kernel
def wake_some(pose, body, cracks):
    """Treat those resting cracks one by one that are about to soften or close, and flag them."""
    c = cuda.grid(1)
    if c >= cracks.sizes[CRACKS] or cracks.listed[cracks.facet[c]] != 1 + RESTING:
        return
    k = cracks.facet[c]
    place = place_of(pose, body, k)
    a, v = cuda.local.array((3, 3), "float64"), cuda.local.array((3, 3), "float64")
    cracks.flag[c] = 0
    if wakes(pose, body, body, cracks, c, place, a, v):
        if wake_crack(pose, body, body, None, cracks, c, k, place):
            cracks.flag[c] = WAKES


@device
def _handed_over(cracks, h):
    """What a half adds to V θ of its cell as it goes to rest [m³], as `kernels.crack_states.hand_over`."""
    c = h >> 1
    share = read_three(cracks.geometry, c, SHARE_I if h % 2 == 0 else SHARE_J)
    return cracks.integrity[cracks.facet[c]] * scalar(share, read_three(cracks.geometry, c, GAP))


@cuda_kernel
def wake_cells(pose, body, cracks, lists, cracked):
    """Stresses of the cells some of whose cracks have woken."""
    p = cuda.grid(1)
    if p >= pose.shape[0] or cracks.sizes[CRACKS] == 0 or cracked[p] == 0:
        return
    woken, inward = False, body.in_start[p + 1] - body.in_start[p]
    for e in range(facets_of(body, p)):
        k = facet_of(body, p, e)
        if cracks.listed[k] == 1 + ACTIVE and cracks.flag[lists.crack[k]] == WAKES:
            cracks.base[p] -= _handed_over(cracks, 2 * lists.crack[k] + (1 if e < inward else 0))
            woken = True
    if woken:
        weigh_cracked(body, cracks, p)
        _link(body, cracks, lists, p)
        relax_cells(pose, body, cracks, False, p, p + 1)


@cuda_kernel
def soften_some(pose, body, cracks, lists):
    """Integrities at the present openings; those that rest or part now are flagged, and the latter gathered."""
    c = cuda.grid(1)
    if c >= cracks.sizes[CRACKS] or cracks.listed[cracks.facet[c]] != 1 + ACTIVE:
        return
    a, v = cuda.local.array((3, 3), "float64"), cuda.local.array((3, 3), "float64")
    soften(pose, body, body, cracks, a, v, c, c + 1)
    if cracks.flag[c] == TO_PART:
        lists.found[cuda.atomic.add(lists.counts, FOUND, 1)] = c


@cuda_kernel
def part_cracks(pose, body, cracks, lists):
    """One thread: let the cracks part that were gathered, in their order."""
    if cuda.grid(1) > 0:
        return
    count = lists.counts[FOUND]
    lists.counts[FOUND] = 0
    put_in_order(lists.found, count)
    for e in range(count):
        c = lists.found[e]
        k = cracks.facet[c]
        cracks.released[0] += let_go_crack(pose, body, body, cracks, c)
        leave_crack(body, cracks, c, PARTED)
        hand_over(body, body, cracks, c, k, 1.0)
        part_faces(pose, body, None, cracks.row, c, k)


@cuda_kernel
def calm_cracks(body, cracks):
    """Let the cracks rest that were flagged."""
    c = cuda.grid(1)
    if c >= cracks.sizes[CRACKS] or cracks.listed[cracks.facet[c]] != 1 + ACTIVE:
        return
    if cracks.flag[c] == CALMED:
        leave_crack(body, cracks, c, RESTING)


@cuda_kernel
def change_cells(pose, body, cracks):
    """Stresses of the cells whose cracks have softened, gone to rest or parted."""
    p = cuda.grid(1)
    if p >= pose.shape[0] or cracks.sizes[CRACKS] == 0:
        return
    changed, calmed, h = False, False, cracks.head[p]
    while h >= 0:
        now = cracks.flag[h >> 1]
        changed = changed or now != 0
        if now == CALMED:
            cracks.base[p] += _handed_over(cracks, h)
            calmed = True
        h = cracks.after[h]
    if calmed:
        weigh_cracked(body, cracks, p)
    if changed:
        relax_cells(pose, body, cracks, False, p, p + 1)


@cuda_kernel
def load_cracks(pose, body, cracks, lists, change):
    """Forces and torques of cracks, into the rows of their facets; those of which nothing is left are gathered."""
    c = cuda.grid(1)
    if c >= cracks.sizes[CRACKS]:
        return
    crack_forces(pose, body, body, cracks, change, c, c + 1)
    k, forces = cracks.facet[c], body.forces
    if cracks.listed[k] != 1 + ACTIVE:
        return
    for d in range(3):
        forces[d, k] = -cracks.pull[c, d]
        forces[3 + d, k] = cracks.output[c, TORQUE_I + d]
        forces[6 + d, k] = cracks.output[c, TORQUE_J + d]
    if cracks.flag[c] != 0:
        lists.found[cuda.atomic.add(lists.counts, FOUND, 1)] = c


@cuda_kernel
def add_losses(cracks, lists):
    """What cracks have dissipated in this step, in parts: thread s takes cracks s, s + S …"""
    s = cuda.grid(1)
    if s >= lists.lost.size or cracks.sizes[CRACKS] == 0:
        return
    total = 0.0
    for c in range(s, cracks.sizes[CRACKS], lists.lost.size):
        if cracks.listed[cracks.facet[c]] == 1 + ACTIVE:
            total += cracks.output[c, LOST]
    lists.lost[s] = total


@cuda_kernel
def log_cracks(pose, body, cracks, lists):
    """One thread: add up these parts, and write down the cracks of which nothing is left, in their order."""
    if cuda.grid(1) > 0 or cracks.sizes[CRACKS] == 0:
        return
    total, count = 0.0, lists.counts[FOUND]
    for s in range(lists.lost.size):
        total += lists.lost[s]
    cracks.released[0] += total
    lists.counts[FOUND] = 0
    put_in_order(lists.found, count)
    for e in range(count):
        c = lists.found[e]
        gap = scalar(read_three(cracks.geometry, c, GAP), read_three(cracks.geometry, c, NORMAL))
        log_crack(pose, body, cracks, c, cracks.facet[c], TENSION if gap > 0.0 else SHEAR, gap)


@cuda_kernel
def crack_sums(pose, body, cracks, parts):
    """Add the elastic energies of cracks to those of facets, in `parts` (SUMS, S)."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    for c in range(s, cracks.sizes[CRACKS], stride):
        if cracks.listed[cracks.facet[c]] != 1 + ACTIVE:
            continue
        k, K, w, gap, n, shares, stresses = known(pose, body, body, cracks, c)
        left = cracks.integrity[k]
        (one, _), (other, _) = halves(K, w, gap, n, shares, stresses)
        across, along = crack_energy(K, w, left, gap, n, (one, other), read_three(cracks.row, c, RUB))
        p, q = orientation(pose, body.i[k]), orientation(pose, body.j[k])
        bent, _ = bending(p, q, resistance(body, left, k))
        parts[NORMAL_SUM, s] += across
        parts[NORMAL_SUM + 1, s] += along
        parts[NORMAL_SUM + 2, s] += bent
