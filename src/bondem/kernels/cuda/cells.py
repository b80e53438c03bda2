"""One thread a cell: the stress that its facets, its walls and the tractions on it make; and a record's energies.

A cell that walls hold, or that has tractions on its free facets, owns a row of the boundary. The thread of the cell
does all that belongs to this row, so that no two threads write one number: walls and tractions come to the present
time, work is booked before and after the stress changes (`bondem.kernels.grip_pass`, `bondem.kernels.press_pass`),
and the forces of walls wait in `Rows.grip` for the motion of the cell. Work of walls and tractions is booked in the
row that it belongs to, not in the one place that all rows have on the CPU: the sum is the same.
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.boundary import value_at
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cuda.facets import OF_I, OF_J, energy_of
from bondem.kernels.cuda.sample import NORMAL
from bondem.kernels.grip_pass import grip_load, grip_swelling, held_energy, place_wall


@device
def _work(grips, holds, r, stress):
    """Half the work of the walls and tractions of row r on the way that they have come in this step [J]."""
    total = 0.0
    for g in range(holds.grip_start[r], holds.grip_start[r + 1]):
        for d in range(3):
            total += 0.5 * grips.load[g, d] * grips.came[g, d]
    for e in range(holds.press_start[r], holds.press_start[r + 1]):
        total += 0.5 * holds.press_came[e] * (stress * holds.press_value[e])
    return total


@device
def _arrive(t, schedules, grips, holds, r, moving):
    """Bring walls and tractions of row r to time t; `moving` where a step leads there."""
    for g in range(holds.grip_start[r], holds.grip_start[r + 1]):
        place_wall(t, grips, g)
        for d in range(3):
            grips.came[g, d] *= moving
    for e in range(holds.press_start[r], holds.press_start[r + 1]):
        now = value_at(schedules, holds.press_schedule[e], t)
        holds.press_came[e] = moving * (now - holds.press_factor[e])
        holds.press_factor[e] = now


@device
def _of_walls(pose, rest, grips, holds, r):
    """What the walls of row r add to V θ [m³]."""
    total = 0.0
    for g in range(holds.grip_start[r], holds.grip_start[r + 1]):
        total += grip_swelling(pose, rest, grips, g)
    return total


@device
def _of_tractions(holds, r):
    """What the tractions of row r add to V θ [m³]."""
    total = 0.0
    for e in range(holds.press_start[r], holds.press_start[r + 1]):
        total += holds.press_factor[e] * holds.press_value[e]
    return total


@device
def hand_on(pose, rest, grips, holds, rows, r):
    """Forces of the walls of row r, with the stress of its cell known."""
    for d in range(6):
        rows.grip[r, d] = 0.0
    for g in range(holds.grip_start[r], holds.grip_start[r + 1]):
        grip_load(pose, rest, grips, g)
        for d in range(6):
            rows.grip[r, d] += grips.load[g, d]


@device
def _swelling(forces, adjacency, p, start):
    """`start` and what the facets of a cell add to V θ: those with j = p, then those with i = p, both ascending."""
    total = start
    for k in range(adjacency.in_start[p], adjacency.in_start[p + 1]):
        total += forces[OF_J, k]
    for e in range(adjacency.out_start[p], adjacency.out_start[p + 1]):
        total += forces[OF_I, adjacency.out_bond[e]]
    return total


@device
def linear_stress(pose, weight, forces, adjacency, grips, holds, p, r):
    """Stress of cell p, of row r of the boundary or -1 without one, in proportion to its V θ [Pa]."""
    if r < 0:
        return weight[p] * _swelling(forces, adjacency, p, 0.0)
    swelling = _swelling(forces, adjacency, p, _of_walls(pose, holds.rest, grips, holds, r))
    return weight[p] * (swelling + _of_tractions(holds, r))


@device
def book_hold(t, moving, pose, rows, schedules, grips, holds, p, r):
    """Bring walls and tractions of row r to time t, and book half their work with the stress before."""
    _arrive(t, schedules, grips, holds, r, moving)
    rows.work[r] += _work(grips, holds, r, pose[p, STRESS])


@device
def hand_on_hold(pose, rows, grips, holds, p, r):
    """Forces of the walls of row r, and half the work of walls and tractions with the stress after."""
    hand_on(pose, holds.rest, grips, holds, rows, r)
    rows.work[r] += _work(grips, holds, r, pose[p, STRESS])


@cuda_kernel
def stress_cells(clock, ahead, scheme, pose, weight, forces, adjacency, rows, schedules, grips, holds):
    """Stresses of all cells, `ahead` steps from now; where that is 0, walls and tractions do no work."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
    r = rows.of[p]
    if r >= 0:
        t = scheme.origin + (clock[0] + ahead) * scheme.dt
        book_hold(t, 1.0 if ahead > 0 else 0.0, pose, rows, schedules, grips, holds, p, r)
    pose[p, STRESS] = linear_stress(pose, weight, forces, adjacency, grips, holds, p, r)
    if r >= 0:
        hand_on_hold(pose, rows, grips, holds, p, r)


@cuda_kernel
def facet_sums(elements, facets, grips, holds, parts):
    """The four elastic energies, into `parts` (SUMS, S): of facets, then of walls and of the dilatation of cells."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    pose = elements.pose
    normal = slip = bend = twist = 0.0
    for k in range(s, facets.m, stride):
        part = energy_of(pose, facets, k)
        normal += part[0]
        slip += part[1]
        bend += part[2]
        twist += part[3]
    for g in range(s, holds.g, stride):
        normal += held_energy(pose, holds.rest, grips, g)
    for p in range(s, pose.shape[0], stride):
        weight = facets.weight[p]
        if weight != 0.0:  # without λ there is no stress
            normal += 0.5 * pose[p, STRESS] ** 2 / weight
    parts[NORMAL, s] = normal
    parts[NORMAL + 1, s] = slip
    parts[NORMAL + 2, s] = bend
    parts[NORMAL + 3, s] = twist
