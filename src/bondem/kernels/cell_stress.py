"""Mean stresses of cells, σ = sym Σ b⊗f / V over all facets, in space, from the forces of the step before.

Σ b⊗f is found as soon as the facets of a cell are done, while their forces are in the cache, with b in the frame of
the cell and in units of its levers, f in space; it is turned once a step begins.
"""

from bondem._compile import device, kernel, loop
from bondem.kernels.cell_pass import three_columns
from bondem.kernels.single_facets import orientation
from bondem.laws.cell_energy import turned_by


@device
def _moment(cells, p):
    """Σ b⊗f of a cell [N pitch], row by row: first over the facets where it is the second cell, then the others."""
    jx, jy, jz = three_columns(cells.lever_j)
    ix, iy, iz = three_columns(cells.lever_i)
    fx, fy, fz = three_columns(cells.force)
    xx = xy = xz = yx = yy = yz = zx = zy = zz = 0.0
    for k in range(cells.in_start[p], cells.in_start[p + 1]):
        f, g, h = -fx[k], -fy[k], -fz[k]
        xx, xy, xz = xx + jx[k] * f, xy + jx[k] * g, xz + jx[k] * h
        yx, yy, yz = yx + jy[k] * f, yy + jy[k] * g, yz + jy[k] * h
        zx, zy, zz = zx + jz[k] * f, zy + jz[k] * g, zz + jz[k] * h
    first = cells.in_start[0]
    for e in range(cells.out_start[p], cells.out_start[p + 1]):
        k = first + cells.out_bond[e]
        f, g, h = fx[k], fy[k], fz[k]
        xx, xy, xz = xx + ix[k] * f, xy + ix[k] * g, xz + ix[k] * h
        yx, yy, yz = yx + iy[k] * f, yy + iy[k] * g, yz + iy[k] * h
        zx, zy, zz = zx + iz[k] * f, zy + iz[k] * g, zz + iz[k] * h
    return xx, xy, xz, yx, yy, yz, zx, zy, zz


@kernel(parallel=False)
def cell_moments(cells, element, first, last):
    """Σ b⊗f of the cells first … last of a list into `cells.moment` [N pitch], where there is room for it."""
    moment = cells.moment
    if len(moment) == 0:
        return
    for e in range(first, last):
        p = element[e]
        found = _moment(cells, p)
        for d in range(9):
            moment[p, d] = found[d]


@device
def add_moment(moment, p, lever, k, sign, force):
    """Add b⊗f of facet k to that of cell p [N pitch]; `lever` are the columns of that side, `force` is on cell i."""
    for d in range(3):
        for c in range(3):
            moment[p, 3 * d + c] += sign * lever[d, k] * force[c]


@loop(parallel=False)
def cell_stresses(pose, cells, stress, first, last):
    """Stresses of the cells first … last, of their facets alone, into `stress.tensor` [Pa]."""
    px, py, pz = three_columns(cells.pitch)
    volume, tensor, moment = stress.volume, stress.tensor, cells.moment
    for p in range(first, last):
        q = orientation(pose, p)
        one = turned_by(q, (px * moment[p, 0], py * moment[p, 3], pz * moment[p, 6]))
        two = turned_by(q, (px * moment[p, 1], py * moment[p, 4], pz * moment[p, 7]))
        three = turned_by(q, (px * moment[p, 2], py * moment[p, 5], pz * moment[p, 8]))
        part = 1.0 / volume[p]
        tensor[p, 0], tensor[p, 1], tensor[p, 2] = part * one[0], part * two[1], part * three[2]
        tensor[p, 3], tensor[p, 4] = 0.5 * part * (one[1] + two[0]), 0.5 * part * (one[2] + three[0])
        tensor[p, 5] = 0.5 * part * (two[2] + three[1])


@device
def _symmetric(b, f):
    """Symmetric part of b⊗f: xx, yy, zz, xy, xz, yz."""
    return (
        b[0] * f[0], b[1] * f[1], b[2] * f[2],
        0.5 * (b[0] * f[1] + b[1] * f[0]), 0.5 * (b[0] * f[2] + b[2] * f[0]), 0.5 * (b[1] * f[2] + b[2] * f[1]),
    )  # fmt: skip


@loop(parallel=False)
def surface_stresses(pose, grips, presses, stress, pressed):
    """Add what walls and loads do to the stresses of surface cells [Pa]; `pressed` as `CellYield` has it."""
    tensor, volume = stress.tensor, stress.volume
    for l in range(len(pressed)):
        for p in range(len(tensor)):
            for d in range(6):
                tensor[p, d] += presses.factor[l] * pressed[l, p, d] / volume[p]
    for g in range(len(grips.cell)):
        p = grips.cell[g]
        b = turned_by(orientation(pose, p), (grips.arm[g, 0], grips.arm[g, 1], grips.arm[g, 2]))
        part = _symmetric(b, (grips.load[g, 0], grips.load[g, 1], grips.load[g, 2]))
        for d in range(6):
            tensor[p, d] += part[d] / volume[p]


@device
def pair_stress(tensor, i, j):
    """Mean of the stresses of two cells [Pa]."""
    return (
        0.5 * (tensor[i, 0] + tensor[j, 0]), 0.5 * (tensor[i, 1] + tensor[j, 1]),
        0.5 * (tensor[i, 2] + tensor[j, 2]), 0.5 * (tensor[i, 3] + tensor[j, 3]),
        0.5 * (tensor[i, 4] + tensor[j, 4]), 0.5 * (tensor[i, 5] + tensor[j, 5]),
    )  # fmt: skip
