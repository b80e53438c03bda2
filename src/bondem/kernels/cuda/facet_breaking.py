"""Facets of cells that break at once on a device, as `bondem.kernels.facet_breaking` has it.

Before the stresses of a step a thread a facet holds its force, with the stresses of the step before, against its
bound; with the forces of the step it judges what the bound has marked. What breaks is gathered and sorted as among
beams. Its two cells change their stress, and with it the forces of all their facets: they and their neighbours wait.
One thread books energies in the order of the facets, as the order of two of one cell matters. Then weights, V θ,
stresses and forces are found again where a cell has lost a facet, by the functions of the step itself: in another
order of sums a run that goes on would have other bits than one that never paused.
"""

import math

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cuda.breaking import FOUND, WAITING, taken, write_down
from bondem.kernels.cuda.cells import hand_on, linear_stress
from bondem.kernels.cuda.facets import energy_of, load_facet, place_of, swell_facet
from bondem.kernels.judging import judged
from bondem.kernels.single_facets import facet_of, facets_of, present_normal
from bondem.laws.cell_energy import facet_pull, opened, scalar, swellings, turned_by

# What a cell waits for: a neighbour, or a facet of its own.
_NEAR, _OWN = 1, 2


@cuda_kernel
def mark_facets(pose, facets, breaks, marked):
    """Mark the facets that bear more than their bounds, with the stresses of the step before."""
    k = cuda.grid(1)
    if k >= facets.m:
        return
    d, p, q, a, b, u, v = place_of(pose, facets, k)
    s = facets.integrity[k]
    f = facet_pull(d, p, q, a, b, u, v, facets.k[k], pose[facets.i[k], STRESS], pose[facets.j[k], STRESS])
    marked[k] = 1 if s * s * (breaks.of_force * scalar(f, f)) >= breaks.limit[k] else 0


@device
def _judge(pose, facets, breaks, k):
    """Index and mode of a facet whose force is known, as `bondem.kernels.facet_breaking.judge_facet`."""
    force = facets.forces[0, k], facets.forces[1, k], facets.forces[2, k]
    n = present_normal(pose, facets, facets, k)
    along = -scalar(force, n)
    x, y, z = force[0] + along * n[0], force[1] + along * n[1], force[2] + along * n[2]
    return judged(breaks.kind, (along, math.sqrt(x * x + y * y + z * z), 0.0, 0.0, 0.0, 0.0), breaks.coefficient[k])


@cuda_kernel
def judge_facets(pose, facets, breaks, marked):
    """Gather those of the marked facets that break by their present force, and hold back their cells."""
    k = cuda.grid(1)
    if k >= facets.m or marked[k] == 0 or facets.integrity[k] <= 0.0:
        return
    index, _ = _judge(pose, facets, breaks, k)
    if index >= 1.0:
        breaks.found[cuda.atomic.add(breaks.counts, FOUND, 1)] = k
        breaks.held[facets.i[k]] = _OWN
        breaks.held[facets.j[k]] = _OWN


@cuda_kernel
def hold_neighbours(facets, adjacency, breaks):
    """Hold back the neighbours of cells that are about to lose a facet."""
    p = cuda.grid(1)
    if p >= breaks.held.shape[0] or breaks.counts[FOUND] == 0 or breaks.held[p] != 0:
        return
    for e in range(facets_of(adjacency, p)):
        k = facet_of(adjacency, p, e)
        other = facets.i[k] if facets.i[k] != p else facets.j[k]
        if facets.integrity[k] > 0.0 and breaks.held[other] == _OWN:
            breaks.held[p] = _NEAR


@device
def _weight(facets, adjacency, whole, p):
    """λ / V of a cell with the facets that it has left [Pa/m³], as `bondem.kernels.facet_breaking.weigh`."""
    inward = outward = 0.0
    for k in range(adjacency.in_start[p], adjacency.in_start[p + 1]):
        inward += (1.0 - facets.integrity[k]) * whole.slack_j[k]
    for e in range(adjacency.out_start[p], adjacency.out_start[p + 1]):
        k = adjacency.out_bond[e]
        outward += (1.0 - facets.integrity[k]) * whole.slack_i[k]
    return whole.weight[p] / (1.0 + whole.weight[p] * (inward + outward))


@cuda_kernel
def weigh_cells(facets, adjacency, whole, breaks, every):
    """λ / V of the cells that have lost a facet, or of `every` one as a run begins."""
    p = cuda.grid(1)
    if p >= breaks.held.shape[0] or (not every and (breaks.counts[WAITING] == 0 or breaks.held[p] != _OWN)):
        return
    facets.weight[p] = _weight(facets, adjacency, whole, p)


@device
def _parted(pose, facets, adjacency, whole, p, swelling):
    """Energy of dilatation that a cell gives off as it loses a facet that had a part in its V θ [J]."""
    before = facets.weight[p]
    if before == 0.0:  # without λ there is no stress
        return 0.0
    total = pose[p, STRESS] / before
    after, rest = _weight(facets, adjacency, whole, p), total - swelling
    facets.weight[p], pose[p, STRESS] = after, after * rest
    return 0.5 * before * total * total - 0.5 * after * rest * rest


@device
def _break_facet(pose, facets, adjacency, whole, breaks, t, step, k):
    """Book what a facet releases, and leave both cells with the stress that they have without it."""
    i, j, s = facets.i[k], facets.j[k], facets.integrity[k]
    _, mode = _judge(pose, facets, breaks, k)
    d, p, q, a, b, u, v = place_of(pose, facets, k)
    part = energy_of(pose, facets, k)
    energy = part[0] + part[1] + part[2] + part[3]
    one, other = swellings(d, p, q, a, b, u, v)
    facets.integrity[k] = 0.0
    energy += _parted(pose, facets, adjacency, whole, i, s * one)
    energy += _parted(pose, facets, adjacency, whole, j, s * other)
    arm = turned_by(p, a)
    gap = scalar(opened(d, arm, turned_by(q, b)), present_normal(pose, facets, facets, k))
    place = pose[i, 0] + arm[0], pose[i, 1] + arm[1], pose[i, 2] + arm[2]
    write_down(breaks, t, step, k, mode, gap, energy, place)


@cuda_kernel
def break_facets(clock, scheme, pose, facets, adjacency, whole, breaks):
    """One thread: break the facets that were found in this step, in their order."""
    if cuda.grid(1) > 0:
        return
    count, step = taken(breaks), clock[0]
    t = scheme.origin + step * scheme.dt
    for e in range(count):
        _break_facet(pose, facets, adjacency, whole, breaks, t, step, breaks.found[e])


@device
def _changed(facets, breaks, k):
    """Whether a cell of a facet has lost one in this step."""
    return breaks.held[facets.i[k]] == _OWN or breaks.held[facets.j[k]] == _OWN


@cuda_kernel
def swell_again(pose, facets, breaks):
    """V θ of the facets of cells that have lost one."""
    k = cuda.grid(1)
    if k < facets.m and breaks.counts[WAITING] > 0 and _changed(facets, breaks, k):
        swell_facet(pose, facets, k)


@cuda_kernel
def stress_again(pose, weight, forces, adjacency, rows, grips, holds, held, counts):
    """Stresses of the cells that have lost a facet, and the forces of their walls."""
    p = cuda.grid(1)
    if p >= pose.shape[0] or counts[WAITING] == 0 or held[p] != _OWN:
        return
    r = rows.of[p]
    pose[p, STRESS] = linear_stress(pose, weight, forces, adjacency, grips, holds, p, r)
    if r >= 0:
        hand_on(pose, holds.rest, grips, holds, rows, r)


@cuda_kernel
def load_again(pose, facets, breaks):
    """Forces of the facets of cells that have lost one."""
    k = cuda.grid(1)
    if k < facets.m and breaks.counts[WAITING] > 0 and _changed(facets, breaks, k):
        load_facet(pose, facets, k)
