"""What a beam that softens would hold if it were whole."""

import math

from bondem._compile import loop
from bondem.kernels.bond_pass import branch
from bondem.laws.beam_energy import bond_energy
from bondem.laws.beam_softening import opened_and_slid
from bondem.laws.cell_energy import scalar


@loop(parallel=False)
def whole_beam(pose, bonds, k):
    """Branch and extension of a beam [m], and what opens and slides of its energy as if it were whole [J]."""
    a, b = bonds.i[k], bonds.j[k]
    d = branch(pose, a, b, bonds.period)
    parts = bond_energy(
        d[0], d[1], d[2],
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7], pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        bonds.X0[k], bonds.Y0[k], bonds.Z0[k], bonds.length[k],
        bonds.kn[k], bonds.A[k], bonds.B[k], bonds.C[k], bonds.kt[k], bonds.ks[k], bonds.lever[k],
    )  # fmt: skip
    extension = math.sqrt(scalar(d, d)) - bonds.length[k]
    opening, sliding = opened_and_slid(parts, extension)
    return d, extension, opening, sliding
