"""Facets of cells that begin to crack on a device, as `bondem.kernels.crack_onset` and `crack_list` have it.

Where a step ends, a thread a cell adds up V σ = sym Σ b⊗f of its facets, with levers and forces of one instant. As
the next one begins, a thread a cell makes the stress of it, and a thread a facet judges (`begins`); one thread puts
those that begin into the list of cracks, in the order of the facets, and a thread each of them sets it up. No bit
depends on the order of threads. `pulled_at_onset`, `begins`, `plane_begins`, `mean_at_onset` and `bent_traction` hold
the rule of onset, and call what the CPU calls; criteria that are functions of the stress have kernels of their own
(`bondem.kernels.cuda.stress_judging`).
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.boundary import value_at
from bondem.kernels.cell_stress import pair_stress
from bondem.kernels.cell_yield import is_hot
from bondem.kernels.crack_energy import bending_opening, bending_traction
from bondem.kernels.crack_list import NEW, bent_stress, treat, write_three
from bondem.kernels.crack_onset import agreed_stress, pulled_by_bending, sheared_off
from bondem.kernels.crack_tables import ACTIVE, BEFORE, CRACKS, FACET, ONSET, RUBBED_AWAY, TREATED
from bondem.kernels.cuda.breaking import FOUND, put_in_order
from bondem.kernels.single_facets import column, lever, orientation, present_normal, resistance
from bondem.kernels.tables import RUBBED
from bondem.laws.cell_energy import bending_square, scalar, turned_by
from bondem.laws.plasticity import below, principal
from bondem.laws.softening import left_on_plane

# Entry of `DeviceLists.counts` beside `FOUND`: how many cracks there were before this step.
BEFORE_STEP = 1


@device
def _pull(body, k):
    """Force of a facet on its cell i [N]."""
    return -body.forces[0, k], -body.forces[1, k], -body.forces[2, k]


@device
def _add_moment(table, pose, p, b, f):
    """Add sym b⊗f of a force on cell p at the lever b, in the reference, to its row."""
    b = turned_by(orientation(pose, p), b)
    table[p, 0] += b[0] * f[0]
    table[p, 1] += b[1] * f[1]
    table[p, 2] += b[2] * f[2]
    table[p, 3] += 0.5 * (b[0] * f[1] + b[1] * f[0])
    table[p, 4] += 0.5 * (b[0] * f[2] + b[2] * f[0])
    table[p, 5] += 0.5 * (b[1] * f[2] + b[2] * f[1])


@device
def _bent_square(pose, body, k):
    """T_b² of a facet of its present integrity [Pa²]."""
    p, q = orientation(pose, body.i[k]), orientation(pose, body.j[k])
    return bending_square(p, q, body.bends[k], resistance(body, body.integrity[k], k))


@cuda_kernel
def sum_moments(elements, body, cracks, change):
    """V σ and Σ T_b² of the facets of a cell that no crack has taken out of the loop; what its cracks rub away."""
    p = cuda.grid(1)
    pose, moment, listed = elements.pose, body.moment, cracks.listed
    if p >= pose.shape[0]:
        return
    for d in range(7):
        moment[p, d] = 0.0
    for k in range(body.in_start[p], body.in_start[p + 1]):
        if listed[k] != 1 + ACTIVE:
            f = _pull(body, k)
            _add_moment(moment, pose, p, lever(body.lever_j, body.pitch, k), (-f[0], -f[1], -f[2]))
            moment[p, 6] += _bent_square(pose, body, k)
    for e in range(body.out_start[p], body.out_start[p + 1]):
        k = body.out_bond[e]
        if listed[k] != 1 + ACTIVE:
            _add_moment(moment, pose, p, lever(body.lever_i, body.pitch, k), _pull(body, k))
            moment[p, 6] += _bent_square(pose, body, k)
    h = cracks.head[p] if change else -1
    while h >= 0:
        if h % 2 == 0 and cracks.half[h, TREATED] != 0.0:
            elements.loss[p, RUBBED] += cracks.output[h >> 1, RUBBED_AWAY]
        h = cracks.after[h]


@device
def _add_crack_moments(tensor, pose, body, cracks, p):
    """Add the forces of the cracks of a cell, a step ago, to its V σ."""
    h = cracks.head[p]
    while h >= 0:
        c = h >> 1
        k, pull = cracks.facet[c], cracks.pull
        if cracks.listed[k] == 1 + ACTIVE:
            if h == 2 * c:
                _add_moment(tensor, pose, p, lever(body.lever_i, body.pitch, k), (pull[c, 0], pull[c, 1], pull[c, 2]))
            else:
                away = -pull[c, 0], -pull[c, 1], -pull[c, 2]
                _add_moment(tensor, pose, p, lever(body.lever_j, body.pitch, k), away)
        h = cracks.after[h]


@device
def _add_surface_stress(t, pose, tensor, schedules, grips, holds, onset, p, r):
    """Add what loads and walls of row r do to the stress of its cell, as `kernels.cell_stress.surface_stresses`."""
    volume = onset.volume[p]
    for e in range(onset.load_start[r], onset.load_start[r + 1]):
        factor = value_at(schedules, onset.load_schedule[e], t)
        for d in range(6):
            tensor[p, d] += factor * onset.load_value[e, d] / volume
    for g in range(holds.grip_start[r], holds.grip_start[r + 1]):
        b = turned_by(orientation(pose, p), (grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2]))
        x, y, z = grips.load[g, 0], grips.load[g, 1], grips.load[g, 2]
        tensor[p, 0] += b[0] * x / volume
        tensor[p, 1] += b[1] * y / volume
        tensor[p, 2] += b[2] * z / volume
        tensor[p, 3] += 0.5 * (b[0] * y + b[1] * x) / volume
        tensor[p, 4] += 0.5 * (b[0] * z + b[2] * x) / volume
        tensor[p, 5] += 0.5 * (b[1] * z + b[2] * y) / volume


@cuda_kernel
def stress_tensors(pose, body, cracks, volume):
    """Stress of each cell a step ago, of its facets and cracks."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
    tensor = cracks.tensor
    for d in range(6):
        tensor[p, d] = body.moment[p, d]
    _add_crack_moments(tensor, pose, body, cracks, p)
    one = 1.0 / volume[p]
    for d in range(6):
        tensor[p, d] *= one


@cuda_kernel
def heat_cells(clock, ahead, scheme, pose, tensor, moment, rows, schedules, grips, holds, onset):
    """The stress of cells with walls and loads, now or in the step `ahead`; and whose facets are looked at."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
    r = rows.of[p]
    if r >= 0:
        t = scheme.origin + (clock[0] + ahead) * scheme.dt
        _add_surface_stress(t, pose, tensor, schedules, grips, holds, onset, p, r)
    s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
    onset.hotter[p] = 1 if onset.cracked[p] != 0 or is_hot(s, moment[p, 6], onset.hot) else 0


@device
def bent_traction(pose, body, cracks, k):
    """What bending adds to the traction of a facet that cracks or may [Pa]."""
    i, j = body.i[k], body.j[k]
    mean = pair_stress(cracks.tensor, i, j)
    return bending_opening(orientation(pose, i), orientation(pose, j), body.bends[k], resistance(body, 1.0, k), mean)


@device
def hotness(body, onset, k):
    """Whether facet k is looked at: 0 not, 1 by its stress, 2 as a cell of it has no cohesion."""
    return max(onset.hotter[body.i[k]], onset.hotter[body.j[k]])


@device
def pulled_at_onset(pose, body, cracks, k):
    """Normal and traction of a facet [Pa], what of it is along the normal, and the mean stress of its cells.

    Bending is added to the traction, as `bondem.kernels.crack_onset` has it.
    """
    i, j = body.i[k], body.j[k]
    n = turned_by(orientation(pose, i), column(body.normal, k))
    f, A = _pull(body, k), cracks.area[k]
    t = f[0] / A, f[1] / A, f[2] / A
    t, across = pulled_by_bending(t, scalar(t, n), n, bent_traction(pose, body, cracks, k))
    return n, t, across, pair_stress(cracks.tensor, i, j)


@device
def begins(pose, body, cracks, onset, k):
    """Whether facet k begins to crack: the rule of `bondem.kernels.crack_onset`."""
    hot = hotness(body, onset, k)
    if hot == 0 or cracks.listed[k] != 0:
        return False
    if hot == 2:
        return True
    if cracks.plane[k] != 0:
        return False
    n, t, across, mean = pulled_at_onset(pose, body, cracks, k)
    if across <= 0.0 and not sheared_off(t, across, onset.strength[k]):
        return False
    return not below(agreed_stress(mean, n, t), onset.strength[k])


@device
def plane_begins(pose, body, cracks, onset, k):
    """Whether facet k is of a material plane and begins to crack by its own traction."""
    if cracks.plane[k] == 0 or cracks.listed[k] != 0:
        return False
    f, A = _pull(body, k), cracks.area[k]
    p, q = orientation(pose, body.i[k]), orientation(pose, body.j[k])
    bent = bending_traction(p, q, body.bends[k], resistance(body, 1.0, k))
    left = left_on_plane(
        1.0, (f[0] / A, f[1] / A, f[2] / A), present_normal(pose, body, body, k), bent, onset.strength[k],
        cracks.last[k], cracks.cohesion[k], cracks.last_slip[k], cracks.friction[k], cracks.kink, cracks.steep,
    )  # fmt: skip
    return left < 1.0


@device
def mean_at_onset(pose, body, cracks, k, a, v):
    """Mean stress of the cells of facet k with bending, and its largest principal stress [Pa]; a, v (3, 3) to use."""
    bent, normal = bent_traction(pose, body, cracks, k), present_normal(pose, body, body, k)
    mean = bent_stress(pair_stress(cracks.tensor, body.i[k], body.j[k]), normal, bent)
    high, _, _, _ = principal(mean, a, v)
    return mean, high


@cuda_kernel
def mark_cracks(pose, body, cracks, onset, lists):
    """Gather the facets that begin to crack."""
    k = cuda.grid(1)
    if k >= body.m:
        return
    if begins(pose, body, cracks, onset, k) or plane_begins(pose, body, cracks, onset, k):
        # in the simulator only the file of a kernel knows of atomics
        lists.found[cuda.atomic.add(lists.counts, FOUND, 1)] = k


@cuda_kernel
def order_beginnings(clock, scheme, cracks, lists):
    """One thread: tell cracks the time, and put the facets that begin into their list, in order."""
    if cuda.grid(1) > 0:
        return
    step, count, before = clock[0] + 1, lists.counts[FOUND], cracks.sizes[CRACKS]
    cracks.now[0], cracks.now[1] = scheme.origin + step * scheme.dt, step
    lists.counts[FOUND], lists.counts[BEFORE_STEP] = 0, before
    put_in_order(lists.found, count)
    for e in range(count):
        cracks.facet[before + e] = lists.found[e]
    cracks.sizes[CRACKS] = before + count


@device
def set_up(body, cracks, lists, c, k, strength):
    """Crack c of facet k, that has a strength [Pa]."""
    row = cracks.row[c]
    for d in range(row.shape[0]):
        row[d] = 0.0
    row[FACET], row[ONSET], row[BEFORE] = k, strength, NEW
    write_three(cracks.pull, c, 0, _pull(body, k))
    treat(body, cracks, c, k, ACTIVE)
    lists.crack[k] = c


@cuda_kernel
def begin_cracks(pose, body, cracks, onset, lists):
    """Set up the cracks that begin."""
    c = lists.counts[BEFORE_STEP] + cuda.grid(1)
    if c >= cracks.sizes[CRACKS]:
        return
    k = cracks.facet[c]
    set_up(body, cracks, lists, c, k, 0.0 if hotness(body, onset, k) == 2 else onset.strength[k])
    # threads may write this together: it is the same number
    onset.cracked[body.i[k]] = onset.cracked[body.j[k]] = 1
