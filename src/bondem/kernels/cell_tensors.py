"""Mean stresses of cells, from the forces of the step before, and what follows: cells that yield, facets that crack.

They are found as a step begins, with the elements where they have come to, so that no bit depends on where a run
pauses. σ = sym Σ b⊗f / V over all facets, in space. Each cell is on its own, whatever thread it is on.
"""


import numpy as np

from bondem._compile import device, kernel, prange
from bondem.kernels.crack_tables import DEFORMATION, FACET, GAMMA, HEAT, INCREMENT
from bondem.kernels.single_facets import column, facet_of, facets_of, lever, orientation
from bondem.laws.cell_energy import scalar, turned_by
from bondem.laws.plasticity import below, flow, invariants, largest_at_most, principal, yield_bound

# Below this many cells launching threads costs more than the loop.
_SERIAL = 1000
# Cells of one portion of work.
_PORTION = 500


@device
def _back(q):
    """The inverse of a unit quaternion."""
    return q[0], -q[1], -q[2], -q[3]


@device
def _moment(pose, bonds, cells, p, k, f):
    """Part of a facet in V σ of cell p, xx, yy, zz, xy, xz, yz [J]; f is the force on its cell i [N]."""
    q = orientation(pose, p)
    if bonds.i[k] == p:
        b = turned_by(q, lever(cells.lever_i, cells.pitch, k))
    else:
        b = turned_by(q, lever(cells.lever_j, cells.pitch, k))
        f = -f[0], -f[1], -f[2]
    return _symmetric(b, f)


@device
def _symmetric(b, f):
    """Symmetric part of b⊗f: xx, yy, zz, xy, xz, yz."""
    return (
        b[0] * f[0], b[1] * f[1], b[2] * f[2],
        0.5 * (b[0] * f[1] + b[1] * f[0]), 0.5 * (b[0] * f[2] + b[2] * f[0]), 0.5 * (b[1] * f[2] + b[2] * f[1]),
    )  # fmt: skip


@device
def _sum(a, b):
    return a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5]


@device
def _tensor(p, pose, bonds, cells, cracks):
    """Mean stress of a cell, of the facets in the lanes and of its cracks that are treated one by one."""
    total = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for e in range(facets_of(cracks, p)):
        k = facet_of(cracks, p, e)
        if cracks.listed[k] != 1:
            total = _sum(total, _moment(pose, bonds, cells, p, k, column(cracks.force, k)))
    c = cracks.head[p]
    while c >= 0:
        k = np.int64(cracks.row[c, FACET])
        if cracks.listed[k] == 1:
            pull = cracks.pull[c, 0], cracks.pull[c, 1], cracks.pull[c, 2]
            total = _sum(total, _moment(pose, bonds, cells, p, k, pull))
        c = cracks.after_i[c] if bonds.i[k] == p else cracks.after_j[c]
    for d in range(6):
        cracks.tensor[p, d] = total[d] / cracks.volume[p]


@kernel(parallel=False)
def _tensors(pose, bonds, cells, cracks, first, last):
    for p in range(first, last):
        _tensor(p, pose, bonds, cells, cracks)


@kernel(parallel=False)
def _of_surface(pose, grips, presses, cracks):
    """Add what walls and loads do to the tensors of the cells on the surface."""
    tensor = cracks.tensor
    for l in range(len(cracks.pressed)):
        for p in range(len(tensor)):
            for d in range(6):
                tensor[p, d] += presses.factor[l] * cracks.pressed[l, p, d] / cracks.volume[p]
    for g in range(len(grips.cell)):
        p = grips.cell[g]
        b = turned_by(orientation(pose, p), (grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2]))
        part = _symmetric(b, (grips.load[g, 0], grips.load[g, 1], grips.load[g, 2]))
        for d in range(6):
            tensor[p, d] += part[d] / cracks.volume[p]


@device
def _work(s, plastic, p):
    """σ:Δε of the last increment of a cell [Pa]."""
    d = INCREMENT
    return (
        s[0] * plastic[p, d] + s[1] * plastic[p, d + 1] + s[2] * plastic[p, d + 2]
        + 2.0 * (s[3] * plastic[p, d + 3] + s[4] * plastic[p, d + 4] + s[5] * plastic[p, d + 5])
    )  # fmt: skip


@device
def _deformed(plastic, p, b):
    """P b: a lever of a cell with its plastic deformation."""
    D = plastic[p]
    return (
        b[0] + (D[0] * b[0] + D[1] * b[1] + D[2] * b[2]),
        b[1] + (D[3] * b[0] + D[4] * b[1] + D[5] * b[2]),
        b[2] + (D[6] * b[0] + D[7] * b[1] + D[8] * b[2]),
    )


@kernel(parallel=False)
def stretch_cell(bonds, cells, cracks, p):
    """Levers of a cell with its plastic deformation."""
    for f in range(facets_of(cracks, p)):
        k = facet_of(cracks, p, f)
        own = bonds.i[k] == p
        b = lever(cracks.base_i, cells.pitch, k) if own else lever(cracks.base_j, cells.pitch, k)
        b = _deformed(cracks.plastic, p, b)
        for d in range(3):
            whole = np.int32(np.rint(b[d] / cells.pitch[d]))
            if own:
                cells.lever_i[d, k] = whole
            else:
                cells.lever_j[d, k] = whole


@kernel(parallel=False)
def principal_stresses(s, a, v):
    """Largest and least principal stress and the columns of v that they point along, compiled once for all uses."""
    return principal(s, a, v)


@device
def _yield_cell(p, pose, bonds, cells, cracks, a, v):
    """Let a cell yield under its stress; whether its cohesion is gone."""
    s, plastic = cracks.tensor[p], cracks.plastic
    V = cracks.volume[p]
    if plastic[p, GAMMA] > 0.0:
        plastic[p, HEAT] += 0.5 * V * _work(s, plastic, p)
        for d in range(6):
            plastic[p, INCREMENT + d] = 0.0
    kept = max(0.0, 1.0 - cracks.fade[p] * plastic[p, GAMMA])
    strength = kept * cracks.cohesion[p]
    mean, deviator = invariants(s)
    if yield_bound(mean, deviator, cracks.sine, strength) > 0.0:
        high, low, one, three = principal_stresses((s[0], s[1], s[2], s[3], s[4], s[5]), a, v)
        gamma = flow(high, low, cracks.sine, strength, cracks.G[p])
        if gamma > 0.0:
            up, down = 0.5 * gamma * (1.0 + cracks.dilation), -0.5 * gamma * (1.0 - cracks.dilation)
            e1, e3 = (v[0, one], v[1, one], v[2, one]), (v[0, three], v[1, three], v[2, three])
            _add_flow(plastic, p, INCREMENT, up, e1)
            _add_flow(plastic, p, INCREMENT, down, e3)
            back = _back(orientation(pose, p))
            _deform(plastic, p, up, turned_by(back, e1))
            _deform(plastic, p, down, turned_by(back, e3))
            plastic[p, GAMMA] += gamma
            plastic[p, HEAT] += 0.5 * V * _work(s, plastic, p)
            stretch_cell(bonds, cells, cracks, p)
    return kept <= 0.0


@device
def _add_flow(plastic, p, first, size, e):
    plastic[p, first] += size * e[0] * e[0]
    plastic[p, first + 1] += size * e[1] * e[1]
    plastic[p, first + 2] += size * e[2] * e[2]
    plastic[p, first + 3] += size * e[0] * e[1]
    plastic[p, first + 4] += size * e[0] * e[2]
    plastic[p, first + 5] += size * e[1] * e[2]


@device
def _deform(plastic, p, size, e):
    """P becomes (1 + size e⊗e) P."""
    for d in range(3):
        along = e[d]
        for c in range(3):
            along += e[c] * plastic[p, DEFORMATION + 3 * c + d]
        for c in range(3):
            plastic[p, DEFORMATION + 3 * c + d] += size * e[c] * along


@device
def _may_yield(cracks, p, mean, deviator):
    """Whether a cell has yielded, or may do so now: few do, and to hand on all tables costs more than the rest."""
    if not cracks.yielding:
        return False
    if cracks.plastic[p, GAMMA] > 0.0:
        return True
    return yield_bound(mean, deviator, cracks.sine, cracks.cohesion[p]) > 0.0


@kernel(parallel=False)
def _judge_cells(pose, bonds, cells, cracks, first, last):
    """Let cells yield, and find those whose facets are to be looked at."""
    a, v = np.empty((3, 3)), np.empty((3, 3))
    for p in range(first, last):
        mean, deviator = invariants(cracks.tensor[p])
        hot = 1 if largest_at_most(mean, deviator) > cracks.hot else 0
        if _may_yield(cracks, p, mean, deviator):
            if _yield_cell(p, pose, bonds, cells, cracks, a, v):
                hot = 2
        cracks.hotter[p] = hot


@device
def _star(s, n, t):
    """Mean tensor of two cells made to agree with the traction t of their facet [Pa]."""
    x = t[0] - (s[0] * n[0] + s[3] * n[1] + s[4] * n[2])
    y = t[1] - (s[3] * n[0] + s[1] * n[1] + s[5] * n[2])
    z = t[2] - (s[4] * n[0] + s[5] * n[1] + s[2] * n[2])
    along = x * n[0] + y * n[1] + z * n[2]
    return (
        s[0] + 2.0 * x * n[0] - along * n[0] * n[0],
        s[1] + 2.0 * y * n[1] - along * n[1] * n[1],
        s[2] + 2.0 * z * n[2] - along * n[2] * n[2],
        s[3] + x * n[1] + y * n[0] - along * n[0] * n[1],
        s[4] + x * n[2] + z * n[0] - along * n[0] * n[2],
        s[5] + y * n[2] + z * n[1] - along * n[1] * n[2],
    )


@device
def pair_stress(tensor, i, j):
    """Mean of the stresses of two cells."""
    return (
        0.5 * (tensor[i, 0] + tensor[j, 0]), 0.5 * (tensor[i, 1] + tensor[j, 1]),
        0.5 * (tensor[i, 2] + tensor[j, 2]), 0.5 * (tensor[i, 3] + tensor[j, 3]),
        0.5 * (tensor[i, 4] + tensor[j, 4]), 0.5 * (tensor[i, 5] + tensor[j, 5]),
    )  # fmt: skip


@kernel(parallel=False)
def _judge_facets(pose, bonds, cells, cracks, first, last):
    """Find facets that begin to crack: the largest principal stress reaches f_t, and they are pulled."""
    for k in range(first, last):
        i, j = bonds.i[k], bonds.j[k]
        cracks.onset[k] = 0
        hot = max(cracks.hotter[i], cracks.hotter[j])
        if hot == 0 or cracks.listed[k] != 0:
            continue
        if hot == 2:
            cracks.onset[k] = 2
            continue
        n = turned_by(orientation(pose, i), column(cells.normal, k))
        f, A = column(cracks.force, k), cracks.area[k]
        t = f[0] / A, f[1] / A, f[2] / A
        if scalar(t, n) > 0.0:
            if not below(_star(pair_stress(cracks.tensor, i, j), n, t), cracks.strength[k]):
                cracks.onset[k] = 1


@kernel(parallel=True)
def _in_parallel(pose, bonds, cells, cracks, portions, kind):
    n, m = len(pose), bonds.m
    for d in prange(portions):
        first, last = n * d // portions, n * (d + 1) // portions
        if kind == 0:
            _tensors(pose, bonds, cells, cracks, first, last)
        elif kind == 1:
            _judge_cells(pose, bonds, cells, cracks, first, last)
        else:
            _judge_facets(pose, bonds, cells, cracks, m * d // portions, m * (d + 1) // portions)


@kernel(parallel=False)
def _everywhere(pose, bonds, cells, cracks, kind, threaded):
    n = len(pose)
    if threaded and n >= _SERIAL:
        _in_parallel(pose, bonds, cells, cracks, n // _PORTION, kind)
    elif kind == 0:
        _tensors(pose, bonds, cells, cracks, 0, n)
    elif kind == 1:
        _judge_cells(pose, bonds, cells, cracks, 0, n)
    else:
        _judge_facets(pose, bonds, cells, cracks, 0, bonds.m)


@kernel(parallel=False)
def _book_loads(presses, cracks, work):
    """Work of loads on free facets that move as their cells yield."""
    for l in range(len(cracks.pressed)):
        power = 0.0
        for p in range(len(cracks.plastic)):
            power += _work(cracks.pressed[l, p], cracks.plastic, p)
        work[presses.place] += presses.factor[l] * power


@kernel(parallel=False)
def judge_body(pose, bonds, body, work, cracks, threaded):
    """Stresses of all cells a step ago; cells yield, and facets that begin to crack are marked. Whether any do."""
    cells, grips = body.cells, body.grips
    for kind in range(3):  # one call in the code, as everything in it is compiled for each
        if kind == 2 and cracks.hotter.max() == 0:
            return False
        _everywhere(pose, bonds, cells, cracks, kind, threaded)
        if kind == 0:
            _of_surface(pose, grips, body.presses, cracks)
        elif kind == 1:
            _book_loads(body.presses, cracks, work)
            for g in range(len(grips.cell)):
                _stretch_grip(grips, cracks, g)
    return cracks.onset.max() > 0


@device
def _stretch_grip(grips, cracks, g):
    """Lever of a wall with the plastic deformation of its cell."""
    if cracks.yielding:
        base = cracks.base_grip[g]
        b = _deformed(cracks.plastic, grips.cell[g], (base[0], base[1], base[2]))
        grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2] = b


@kernel(parallel=False)
def stretch_body(bonds, cells, grips, cracks):
    """Levers of all cells and walls with their plastic strains, as a run begins."""
    if cracks.yielding:
        for p in range(len(cracks.plastic)):
            if cracks.plastic[p, GAMMA] > 0.0:
                stretch_cell(bonds, cells, cracks, p)
    for g in range(len(grips.cell)):
        _stretch_grip(grips, cracks, g)


@device
def heat(cracks):
    """Energy that cells have dissipated by yielding, until now [J]."""
    total = 0.0
    for p in range(len(cracks.plastic)):
        total += cracks.plastic[p, HEAT]
        total += 0.5 * cracks.volume[p] * _work(cracks.tensor[p], cracks.plastic, p)
    return total
