"""Whether bonds or facets are turned too far."""

from bondem._compile import kernel
from bondem.kernels.bond_pass import branch
from bondem.kernels.single_facets import column, orientation, resistance
from bondem.laws.beam_energy import bond_cosines
from bondem.laws.cell_energy import relative, swing_square


@kernel(parallel=False)
def rotation_guard(pose, bonds, body):
    """How many unbroken bonds are turned beyond the valid range, and beyond its end.

    A twist that the facets of a `body` do not resist is no turn: a cell that hangs on one facet may spin about it.

    Returns:
        (count with c1 or c2 < 0.7 or w² < 0.75, count with c1 or c2 <= 0 or w² <= 0.25, whether a number
        was not finite).
    """
    wide = 0
    lost = 0
    sick = False
    for k in range(bonds.m):
        a = bonds.i[k]
        b = bonds.j[k]
        dx, dy, dz = branch(pose, a, b, bonds.period)
        c1, c2, w2 = bond_cosines(
            dx, dy, dz,
            pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
            pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
            bonds.X0[k], bonds.Y0[k], bonds.Z0[k],
        )  # fmt: skip
        c = min(c1, c2)
        sick |= not (c * c + w2 < 4.0)
        if bonds.integrity[k] > 0.0:
            if body is not None and w2 < 0.75:  # decided when compiled
                _, v, _ = relative(orientation(pose, a), orientation(pose, b))
                w2 = swing_square(w2, v, column(body.cells.normal, k), resistance(body.cells, 1.0, k))
            wide += (c < 0.7) | (w2 < 0.75)
            lost += (c <= 0.0) | (w2 <= 0.25)
    return wide, lost, sick
