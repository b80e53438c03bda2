"""Energy of the facets and cells of a body, and of the walls that hold some of them."""

from bondem._compile import device, kernel
from bondem.kernels.bond_pass import branch
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cracking import with_cracks
from bondem.kernels.grip_pass import grip_energy, swell_grips
from bondem.kernels.single_facets import lever
from bondem.laws.cell_energy import facet_energy, swellings


@device
def _dilated(pose, cells, cracks, swelling, p):
    """Energy of dilatation of a cell [J]."""
    W = cells.weight[p]
    if cracks is None:  # decided when compiled
        return 0.5 * W * swelling[p] ** 2
    return 0.5 * pose[p, STRESS] ** 2 / W if W != 0.0 else 0.0


@kernel(parallel=False)
def cell_energies(pose, rest, bonds, cells, grips, cracks):
    """Normal (with dilatation), shear, bending and twisting energy of all facets and cells [J].

    Where facets may crack, the stresses of the cells are those in `pose`, which the forces of this instant belong to.
    """
    normal = slip = bend = twist = 0.0
    swelling = cells.given.copy()
    swell_grips(pose, rest, grips, swelling)
    normal += grip_energy(pose, rest, grips)
    for k in range(bonds.m):
        i, j = bonds.i[k], bonds.j[k]
        d = branch(pose, i, j, bonds.period)
        p, q = (pose[i, 4], pose[i, 5], pose[i, 6], pose[i, 7]), (pose[j, 4], pose[j, 5], pose[j, 6], pose[j, 7])
        a, b = lever(cells.lever_i, cells.pitch, k), lever(cells.lever_j, cells.pitch, k)
        u = cells.share_i[0, k], cells.share_i[1, k], cells.share_i[2, k]
        v = cells.share_j[0, k], cells.share_j[1, k], cells.share_j[2, k]
        n = cells.normal[0, k], cells.normal[1, k], cells.normal[2, k]
        H = cells.H[0, k], cells.H[1, k], cells.H[2, k], cells.H[3, k], cells.H[4, k], cells.H[5, k]
        s = bonds.integrity[k]
        one, other = swellings(d, p, q, a, b, u, v)
        swelling[i] += s * one
        swelling[j] += s * other
        part = facet_energy(d, p, q, a, b, n, cells.k[k], H)
        normal += s * part[0]
        slip += s * part[1]
        bend += s * part[2]
        twist += s * part[3]
    for p in range(len(swelling)):
        normal += _dilated(pose, cells, cracks, swelling, p)
    return with_cracks(pose, bonds, cells, cracks, (normal, slip, bend, twist))
