"""Mean stresses of cells from the forces of their facets: V σ = sym Σ b⊗f, with b from the centre to the facet.

Levers b and forces f are those of one instant, in space. The sums are found with those of the forces
(`bondem.kernels.cell_pass`), and taken over where they are complete.
"""

import numpy as np

from bondem._compile import device, kernel, loop
from bondem.kernels.cell_pass import moment_of
from bondem.kernels.element_pass import collect_parts
from bondem.kernels.single_facets import column, facet_of, facets_of, lever, orientation, resistance
from bondem.laws.cell_energy import bending_square, turned_by


@loop(parallel=False)
def take_moments(moment, sums, element, row_of_sums, first, last):
    """Take over V σ and Σ T_b² of the cells first … last of a list, whose sums are complete; leave zeros there."""
    if moment is None:  # decided when compiled
        return
    for e in range(first, last):
        p, s = np.uint64(element[e]), np.uint64(row_of_sums[e])
        moment[p, 0], moment[p, 1], moment[p, 2] = sums[s, 0], sums[s, 1], sums[s, 2]
        moment[p, 3], moment[p, 4], moment[p, 5], moment[p, 6] = sums[s, 4], sums[s, 5], sums[s, 6], sums[s, 3]
        sums[s, :] = 0.0


@loop(parallel=False)
def take_shared_moments(moment, sums, cut, first, last):
    """The same of shared cells, when the facets of all domains are done."""
    if moment is not None:  # decided when compiled
        collect_parts(sums, cut.shared_row, cut.parts, cut.part, first, last)
        take_moments(moment, sums, cut.shared, cut.shared_row, first, last)


@device
def add_moment(moment, pose, p, b, f):
    """Add that of a force f on cell p at the lever b, in the reference."""
    part = moment_of(turned_by(orientation(pose, p), b), f)
    for d in range(6):
        moment[p, d] += part[d]


@kernel(parallel=False)
def sum_moments(pose, bonds, cells):
    """V σ and Σ T_b² of all cells from the forces that are kept, as a run begins: to the bits of the sums above."""
    moment, force = cells.moment, cells.force
    moment[:, :] = 0.0
    for p in range(len(pose)):
        inward = cells.in_start[p + 1] - cells.in_start[p]
        for e in range(facets_of(cells, p)):
            k = facet_of(cells, p, e)
            f, at = column(force, k), (orientation(pose, bonds.i[k]), orientation(pose, bonds.j[k]))
            moment[p, 6] += bending_square(at[0], at[1], cells.bends[k], resistance(cells, bonds.integrity[k], k))
            if e < inward:
                add_moment(moment, pose, p, lever(cells.lever_j, cells.pitch, k), (-f[0], -f[1], -f[2]))
            else:
                add_moment(moment, pose, p, lever(cells.lever_i, cells.pitch, k), f)


@loop(parallel=False)
def cell_stresses(moment, stress, first, last):
    """Stresses of the cells first … last, of their facets alone, into `stress.tensor` [Pa]."""
    volume, tensor = stress.volume, stress.tensor
    for p in range(first, last):
        one = 1.0 / volume[p]
        for d in range(6):
            tensor[p, d] = one * moment[p, d]
        stress.bending[p] = moment[p, 6]


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
        part = moment_of(b, (grips.load[g, 0], grips.load[g, 1], grips.load[g, 2]))
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
