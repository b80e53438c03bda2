"""Stress-free strains of cells that change in time: levers that grow, and the work this does.

A facet whose cells want to be larger by ε* has levers 1 + ε* times as long, and ∂U/∂ε* = f·(R_j b_j - R_i b_i) with f
what the opening bears and b the levers of the reference. The work is the trapezoid of that over dε*: half with the
forces before, and half with those after. Steps in which nothing changes cost nothing. Facets are taken in portions,
whose sums are added up in their order: no bit depends on threads.
"""

import numpy as np

from bondem._compile import device, kernel, loop, prange
from bondem.kernels.boundary import value_at
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cell_yield import stretch_cells, stretch_grips
from bondem.kernels.crack_tables import ACTIVE, CRACKS, FACET, STATUS
from bondem.kernels.single_facets import frame, lever, orientation, resistance
from bondem.laws.cell_energy import facet_force, scalar, turned_by

#: Facets of a portion.
PORTION = 2000
# Rows of the factors.
_NOW, _CAME, _BEFORE, _AFTER = range(4)


@device
def _growth(strained, k):
    growth = strained.still[k]
    for g in range(len(strained.schedule)):
        growth += strained.factor[_NOW, g] * strained.part[g, k]
    return growth


@device
def _wall_growth(strained, w):
    growth = strained.wall_still[w]
    for g in range(len(strained.schedule)):
        growth += strained.factor[_NOW, g] * strained.wall_part[g, w]
    return growth


@loop(parallel=False)
def _stretch_portion(strained, cells, d):
    lever_i, lever_j, pitch = cells.lever_i, cells.lever_j, cells.pitch
    base_i, base_j = strained.base_i, strained.base_j
    for k in range(d * PORTION, min(base_i.shape[1], (d + 1) * PORTION)):
        growth = _growth(strained, k)
        for a in range(3):
            lever_i[a, k] = np.int32(np.rint(growth * base_i[a, k] / pitch[a]))
            lever_j[a, k] = np.int32(np.rint(growth * base_j[a, k] / pitch[a]))


@loop(parallel=True)
def _stretch(strained, cells):
    """Bring the levers of all facets to the present strains."""
    for d in prange(len(strained.power)):
        _stretch_portion(strained, cells, np.int64(d))


@loop(parallel=False)
def _stretch_yielding(strained, grips, cells, cracks):
    """The same of cells with plastic strains, which act on the levers that they would have without."""
    if cracks is not None:  # decided when compiled
        if cracks.flow.yielding:
            m = strained.base_i.shape[1]
            cracks.flow.base_i[:, :m] = cells.lever_i[:, :m]
            cracks.flow.base_j[:, :m] = cells.lever_j[:, :m]
            cracks.flow.base_grip[:] = grips.arm
            stretch_cells(cells, cracks.flow, True, 0, len(cracks.flow.plastic))
            stretch_grips(grips, cracks.flow)


@loop(parallel=False)
def _set(strained, cells, grips, cracks):
    _stretch(strained, cells)
    for w in range(len(strained.wall_still)):
        growth = _wall_growth(strained, w)
        for a in range(3):
            grips.arm[w, a] = growth * strained.wall_base[w, a]
    _stretch_yielding(strained, grips, cells, cracks)


@kernel(parallel=False)
def strain_body(t, dt, first, schedules, body, strained):
    """Bring the stress-free strains to time t, where there are any; `first` where it is not reached by a step."""
    if strained is not None:  # decided when compiled
        changed = needed = first
        for g in range(len(strained.schedule)):
            now = value_at(schedules, strained.schedule[g], t)
            came = now - strained.factor[_NOW, g]
            strained.factor[_CAME, g] = 0.0 if first else came
            strained.factor[_NOW, g] = now
            changed |= came != 0.0
            needed |= value_at(schedules, strained.schedule[g], t + dt) != now
        if changed:
            _set(strained, body.cells, body.grips, body.cracks)
        strained.due[0] = changed or needed


@device
def _reach(p, q, a, b):
    """R_j b_j - R_i b_i."""
    one, other = turned_by(p, a), turned_by(q, b)
    return other[0] - one[0], other[1] - one[1], other[2] - one[2]


@loop(parallel=False)
def _portion_powers(pose, bonds, cells, strained, d):
    part, power = strained.part, strained.power
    for g in range(len(part)):
        power[d, g] = 0.0
    for k in range(d * PORTION, min(part.shape[1], (d + 1) * PORTION)):
        s = bonds.integrity[k]
        if s > 0.0:
            away, p, q, a, b, u, v = frame(pose, bonds, cells, k)
            f, _, _ = facet_force(
                away, p, q, a, b, u, v, s * cells.k[k], resistance(cells, s, k),
                s * pose[bonds.i[k], STRESS], s * pose[bonds.j[k], STRESS],
            )  # fmt: skip
            each = -scalar(f, _reach(p, q, a, b)) / _growth(strained, k)
            for g in range(len(part)):
                power[d, g] += each * part[g, k]


@loop(parallel=True)
def _facet_powers(pose, bonds, cells, strained):
    """∂U/∂factor of the facets that are no cracks, in portions."""
    for d in prange(len(strained.power)):
        _portion_powers(pose, bonds, cells, strained, np.int64(d))


@loop(parallel=False)
def _crack_powers(pose, bonds, cells, cracks, strained):
    """Add that of cracks, from what they bear."""
    if cracks is not None:  # decided when compiled
        rows, pull = cracks.facets.row, cracks.facets.pull
        for c in range(cracks.facets.sizes[CRACKS]):
            if rows[c, STATUS] == ACTIVE:
                k = np.int64(rows[c, FACET])
                p, q = orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k])
                reach = _reach(p, q, lever(cells.lever_i, cells.pitch, k), lever(cells.lever_j, cells.pitch, k))
                each = scalar((pull[c, 0], pull[c, 1], pull[c, 2]), reach) / _growth(strained, k)
                for g in range(len(strained.schedule)):
                    strained.factor[_AFTER, g] += each * strained.part[g, k]


@loop(parallel=False)
def book_strains(pose, bonds, body, strained, work):
    """The work of strains that change, when the forces after that are known."""
    if strained is not None:  # decided when compiled
        if strained.due[0] != 0:
            cells, grips, factor = body.cells, body.grips, strained.factor
            _facet_powers(pose, bonds, cells, strained)
            for g in range(len(strained.schedule)):
                factor[_AFTER, g] = strained.power[:, g].sum()
            _crack_powers(pose, bonds, cells, body.cracks, strained)
            for w in range(len(strained.wall_still)):
                arm = turned_by(orientation(pose, grips.cell[w]), (grips.arm[w, 0], grips.arm[w, 1], grips.arm[w, 2]))
                f = grips.load[w, 0], grips.load[w, 1], grips.load[w, 2]
                each = scalar(f, arm) / _wall_growth(strained, w)
                for g in range(len(strained.schedule)):
                    factor[_AFTER, g] -= each * strained.wall_part[g, w]
            for g in range(len(strained.schedule)):
                work[strained.place] += 0.5 * (factor[_BEFORE, g] + factor[_AFTER, g]) * factor[_CAME, g]
                factor[_BEFORE, g] = factor[_AFTER, g]
                factor[_CAME, g] = 0.0
            strained.due[0] = 0
