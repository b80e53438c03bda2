"""What the bonds of a state do to their elements, one by one, for whoever looks at a state."""

from bondem._compile import kernel
from bondem.kernels.bond_pass import branch
from bondem.kernels.judging import single_bond
from bondem.kernels.non_local import FORCE, TORQUE_I, TORQUE_J, load_bonds
from bondem.laws.cell_energy import cross
from bondem.laws.incremental import axis, levers

#: Columns of a report: force on j, torque on i, torque on j.
ON_J, TURN_I, TURN_J, COLUMNS = 0, 3, 6, 9


@kernel(parallel=False)
def report_beams(pose, bonds, found):
    """Bonds of the total formulation, (m, 9) [N, N·m]."""
    for k in range(bonds.m):
        _, force, on_i, on_j = single_bond(pose, bonds, k)
        for c in range(3):
            found[k, ON_J + c], found[k, TURN_I + c], found[k, TURN_J + c] = force[c], on_i[c], on_j[c]


@kernel(parallel=False)
def report_stored(pose, bonds, history, found):
    """Bonds that store force and moment (`bondem.kernels.incremental`), (m, 9) [N, N·m]."""
    for k in range(bonds.m):
        s = bonds.integrity[k]
        dx, dy, dz = branch(pose, bonds.i[k], bonds.j[k], bonds.period)
        nx, ny, nz, l = axis(dx, dy, dz)
        near, far = levers(l, bonds.length[k], bonds.lever[k])
        arm = cross((nx, ny, nz), (history[0, k], history[1, k], history[2, k]))
        for c in range(3):
            found[k, ON_J + c] = -s * history[c, k]
            found[k, TURN_I + c] = s * (near * arm[c] + history[3 + c, k])
            found[k, TURN_J + c] = s * (far * arm[c] - history[3 + c, k])


@kernel(parallel=False)
def report_non_local(pose, bonds, table, found):
    """Bonds of the non-local law, (m, 9) [N, N·m]; the table is written on."""
    load_bonds(pose, bonds, table, 0.0, 0, len(bonds.i))
    output = table.output
    for k in range(bonds.m):
        for c in range(3):
            found[k, ON_J + c] = -output[FORCE + c, k]
            found[k, TURN_I + c], found[k, TURN_J + c] = output[TORQUE_I + c, k], -output[TORQUE_J + c, k]
