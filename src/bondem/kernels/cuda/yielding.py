"""Cells that yield on a device: the functions of `bondem.kernels.cell_yield`, a thread a cell.

A cell yields by its own stress, and stretches the levers of its own side of its facets: no two threads write one
number. What a cell of the boundary does to its walls and loads is done by its thread too, in a launch of its own, as
all tables in one would exceed the parameters of a launch.
"""

from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.boundary import value_at
from bondem.kernels.cell_yield import heat_of, stretch_cells, stretch_grip, work_of, yield_cell
from bondem.kernels.crack_tables import HEAT, INCREMENT
from bondem.kernels.cuda.sample import HEATED


@cuda_kernel
def stretch_all(body, flow):
    """Levers of all cells with their plastic deformation, as a run begins."""
    p = cuda.grid(1)
    if p < flow.plastic.shape[0]:
        stretch_cells(body, flow, True, p, p + 1)


@cuda_kernel
def stretch_holds(count, grips, flow):
    """The same of `count` walls."""
    g = cuda.grid(1)
    if g < count:
        stretch_grip(grips, flow, g)


@cuda_kernel
def yield_some(pose, body, tensor, onset, flow):
    """Let cells yield by their stresses; facets of those without cohesion break."""
    p = cuda.grid(1)
    if p >= pose.shape[0]:
        return
    a, v = cuda.local.array((3, 3), "float64"), cuda.local.array((3, 3), "float64")
    s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
    given = flow.fade[p], flow.sine[p], flow.cohesion[p], flow.dilation[p], flow.G[p]
    if yield_cell(pose, s, onset.volume[p], flow.plastic, flow.cone, given, p, a, v):
        onset.hotter[p] = 2
    stretch_cells(body, flow, False, p, p + 1)


@cuda_kernel
def follow_cells(clock, scheme, row_of, work, schedules, grips, grip_start, onset, flow):
    """Work of loads on free facets of cells that yield, in the step to come; and the levers of their walls."""
    p = cuda.grid(1)
    if p >= flow.plastic.shape[0] or row_of[p] < 0:
        return
    r, t = row_of[p], scheme.origin + (clock[0] + 1) * scheme.dt
    for e in range(onset.load_start[r], onset.load_start[r + 1]):
        power = work_of(onset.load_value[e], flow.plastic[p, INCREMENT:HEAT])
        work[r] += value_at(schedules, onset.load_schedule[e], t) * power
    for g in range(grip_start[r], grip_start[r + 1]):
        stretch_grip(grips, flow, g)


@cuda_kernel
def heat_sums(tensor, volume, plastic, parts):
    """What cells have dissipated by yielding, into `parts` (SUMS, S)."""
    s = cuda.grid(1)
    stride = parts.shape[1]
    if s >= stride:
        return
    total = 0.0
    for p in range(s, plastic.shape[0], stride):
        total += heat_of(tensor, volume[p], plastic, p)
    parts[HEATED, s] = total
