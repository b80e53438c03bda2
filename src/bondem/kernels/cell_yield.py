"""Cells that yield under their mean stress: plastic deformation, levers that it stretches, energy it dissipates."""

import math

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.crack_tables import DEFORMATION, GAMMA, HEAT, INCREMENT
from bondem.kernels.single_facets import orientation
from bondem.kernels.whole import whole
from bondem.laws.cell_energy import turned_by
from bondem.laws.plasticity import cone_flow, flow, invariants, largest_at_most, principal, yield_bound

# No stress σ is beyond Mohr and Coulomb's planes or a cone by more than √2 |σ| less their strength, its largest
# principal stress not above |σ|; the square, and something for rounding.
_REACH = 2.01


@device
def work_of(s, increment):
    """σ:Δε of the last increment of a cell [Pa]."""
    return (
        s[0] * increment[0] + s[1] * increment[1] + s[2] * increment[2]
        + 2.0 * (s[3] * increment[3] + s[4] * increment[4] + s[5] * increment[5])
    )  # fmt: skip


@loop(parallel=False)
def principal_stresses(s, a, v):
    """Largest and least principal stress and the columns of v that they point along, compiled once for all uses."""
    return principal(s, a, v)


@device
def _add_flow(increment, size, e):
    increment[0] += size * e[0] * e[0]
    increment[1] += size * e[1] * e[1]
    increment[2] += size * e[2] * e[2]
    increment[3] += size * e[0] * e[1]
    increment[4] += size * e[0] * e[2]
    increment[5] += size * e[1] * e[2]


@device
def _deform(deformation, size, e):
    """P becomes (1 + size e⊗e) P."""
    for d in range(3):
        along = e[d]
        for c in range(3):
            along += e[c] * deformation[3 * c + d]
        for c in range(3):
            deformation[3 * c + d] += size * e[c] * along


@device
def _flow_on_cone(pose, s, plastic, p, gamma, dilation, a, v):
    """Let cell p yield by Δγ on Drucker–Prager's cone."""
    mean, deviator = invariants(s)
    principal_stresses(s, a, v)
    increment, deformation = plastic[p, INCREMENT:HEAT], plastic[p, DEFORMATION:GAMMA]
    w, x, y, z = orientation(pose, p)
    for d in range(3):
        size = gamma * (0.5 * (a[d, d] - mean) / deviator + dilation)
        e = v[0, d], v[1, d], v[2, d]
        _add_flow(increment, size, e)
        _deform(deformation, size, turned_by((w, -x, -y, -z), e))


@device
def _flow_in_plane(pose, s, plastic, p, given, strength, a, v):
    """Let cell p yield by Mohr–Coulomb's Δγ in the plane of its largest and least principal stress; Δγ."""
    _, sine, _, dilation, G = given
    high, low, one, three = principal_stresses(s, a, v)
    gamma = flow(high, low, sine, strength, G)
    if gamma > 0.0:
        increment, deformation = plastic[p, INCREMENT:HEAT], plastic[p, DEFORMATION:GAMMA]
        up, down = 0.5 * gamma * (1.0 + dilation), -0.5 * gamma * (1.0 - dilation)
        e1, e3 = (v[0, one], v[1, one], v[2, one]), (v[0, three], v[1, three], v[2, three])
        _add_flow(increment, up, e1)
        _add_flow(increment, down, e3)
        w, x, y, z = orientation(pose, p)
        _deform(deformation, up, turned_by((w, -x, -y, -z), e1))
        _deform(deformation, down, turned_by((w, -x, -y, -z), e3))
    return gamma


@device
def _square(s):
    """σ:σ [Pa²]."""
    return s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])


@device
def is_hot(s, square, hot):
    """Whether facets of a cell of stress s, that bend by Σ T_b² `square` [Pa²], are looked at, from `hot` on [Pa]."""
    mean, deviator = invariants(s)
    return largest_at_most(mean, deviator) + max(math.sqrt(max(square, 0.0)) + min(mean, 0.0), 0.0) > hot


@device
def _flow_bound(cone, mean, deviator, slope, strength):
    """Whether a cell may flow: above 0, by Drucker–Prager's cone or Mohr–Coulomb's planes [Pa]."""
    if cone:
        return -1.0 if mean > 0.0 else deviator + 3.0 * slope * mean - strength
    return yield_bound(mean, deviator, slope, strength)


@device
def yield_cell(pose, s, V, plastic, cone, given, p, a, v):
    """Let cell p of stress s [Pa] and volume V yield; whether its cohesion is gone.

    `given` are numbers of the cell as `CellYield` has them: fade, slope, cohesion, dilation, G; the table itself is
    not handed on, as all its arrays would have their references counted. a and v are (3, 3) to use.
    """
    kept, (fade, slope, cohesion, dilation, G) = 1.0, given
    if plastic[p, GAMMA] > 0.0:
        done = plastic[p, INCREMENT:HEAT]
        plastic[p, HEAT] += 0.5 * V * work_of(s, done)
        done[:] = 0.0
        kept = max(0.0, 1.0 - fade * plastic[p, GAMMA])
    strength, gamma = kept * cohesion, 0.0
    mean, deviator = invariants(s)
    if cone:
        gamma = cone_flow(mean, deviator, slope, strength, G)
        if gamma > 0.0:
            _flow_on_cone(pose, s, plastic, p, gamma, dilation, a, v)
    elif yield_bound(mean, deviator, slope, strength) > 0.0:
        gamma = _flow_in_plane(pose, s, plastic, p, given, strength, a, v)
    if gamma > 0.0:
        plastic[p, GAMMA] += gamma
        plastic[p, HEAT] += 0.5 * V * work_of(s, plastic[p, INCREMENT:HEAT])
    return kept == 0.0


@loop(parallel=False)
def yield_cells(pose, stress, cells, hot, cracked, hotter, first, last):
    """Let the cells first … last yield, and find those whose facets are to be looked at, from `hot` on [Pa].

    Args:
        pose: of all cells.
        stress: `CellStresses`.
        cells: `CellYield`.
        hot: largest principal stress from which facets are looked at [Pa].
        cracked: 1 for cells with cracks: their stress says little about their other facets, all are looked at.
        hotter: 0, 1, or 2 for cells without cohesion, into it.
        first: number of the first cell.
        last: one behind the last.
    """
    a, v = np.empty((3, 3)), np.empty((3, 3))
    tensor, bending, volume, yielding, cone = stress.tensor, stress.bending, stress.volume, cells.yielding, cells.cone
    plastic, fade, slope, cohesion = cells.plastic, cells.fade, cells.sine, cells.cohesion
    dilation, G = cells.dilation, cells.G
    least = max(hot, 0.0) ** 2
    for p in range(first, last):
        s = tensor[p, 0], tensor[p, 1], tensor[p, 2], tensor[p, 3], tensor[p, 4], tensor[p, 5]
        square = _square(s)
        calm = (_REACH * (square + bending[p]) < least) & (cracked[p] == 0)
        if calm and not (yielding and (_REACH * square >= cohesion[p] ** 2 or plastic[p, GAMMA] > 0.0)):
            hotter[p] = 0
            continue
        hotter[p] = 1 if cracked[p] != 0 or is_hot(s, bending[p], hot) else 0
        if not yielding:
            continue
        mean, deviator = invariants(s)
        if plastic[p, GAMMA] == 0.0 and _flow_bound(cone, mean, deviator, slope[p], cohesion[p]) <= 0.0:
            continue
        given = fade[p], slope[p], cohesion[p], dilation[p], G[p]
        if yield_cell(pose, s, volume[p], plastic, cone, given, p, a, v):
            hotter[p] = 2


@device
def _deformed(deformation, b):
    """P b: a lever of a cell with its plastic deformation."""
    return (
        b[0] + (deformation[0] * b[0] + deformation[1] * b[1] + deformation[2] * b[2]),
        b[1] + (deformation[3] * b[0] + deformation[4] * b[1] + deformation[5] * b[2]),
        b[2] + (deformation[6] * b[0] + deformation[7] * b[1] + deformation[8] * b[2]),
    )


@device
def _stretch(lever, base, pitch, deformation, k):
    b = _deformed(deformation, (pitch[0] * base[0, k], pitch[1] * base[1, k], pitch[2] * base[2, k]))
    for d in range(3):
        lever[d, k] = np.int32(whole(b[d] / pitch[d]))


@kernel(parallel=False)
def stretch_cells(table, cells, every, first, last):
    """Levers of the cells first … last with their plastic deformation: where it has grown now, or of `every` one."""
    in_start, out_start, out_bond = table.in_start, table.out_start, table.out_bond
    plastic, pitch = cells.plastic, table.pitch
    for p in range(first, last):
        if plastic[p, GAMMA] == 0.0:
            continue
        increment = plastic[p, INCREMENT:HEAT]
        if not (every or work_of(increment, increment) > 0.0):
            continue
        deformation = plastic[p, DEFORMATION:GAMMA]
        for k in range(in_start[p], in_start[p + 1]):
            _stretch(table.lever_j, cells.base_j, pitch, deformation, k)
        for e in range(out_start[p], out_start[p + 1]):
            _stretch(table.lever_i, cells.base_i, pitch, deformation, in_start[0] + out_bond[e])


@device
def stretch_grip(grips, cells, g):
    """The lever of a wall with the plastic deformation of its cell."""
    base = cells.base_grip[g]
    deformation = cells.plastic[grips.cell[g], DEFORMATION:GAMMA]
    grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2] = _deformed(deformation, (base[0], base[1], base[2]))


@kernel(parallel=False)
def stretch_grips(grips, cells):
    """Levers of walls with the plastic deformation of their cells."""
    if cells.yielding:
        for g in range(len(grips.cell)):
            stretch_grip(grips, cells, g)


@loop(parallel=False)
def book_loads(presses, cells, work):
    """Work of loads on free facets that move as their cells yield."""
    for l in range(len(cells.pressed)):
        power = 0.0
        for p in range(len(cells.plastic)):
            power += work_of(cells.pressed[l, p], cells.plastic[p, INCREMENT:HEAT])
        work[presses.place] += presses.factor[l] * power


@device
def heat_of(tensor, V, plastic, p):
    """Energy that cell p of volume V has dissipated by yielding, until now [J]."""
    if plastic[p, GAMMA] == 0.0:
        return 0.0
    return plastic[p, HEAT] + 0.5 * V * work_of(tensor[p], plastic[p, INCREMENT:HEAT])


@kernel(parallel=False)
def heat(stress, cells):
    """Energy that cells have dissipated by yielding, until now [J]."""
    total, plastic = 0.0, cells.plastic
    for p in range(len(plastic)):
        total += heat_of(stress.tensor, stress.volume[p], plastic, p)
    return total
