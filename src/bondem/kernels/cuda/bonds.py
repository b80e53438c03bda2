"""One thread a bond: its force and torques."""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.whole import whole
from bondem.laws.beam_energy import bond_force


@device
def _nearest(d, period, inverse):
    return d - period * whole(d * inverse)


@device
def branch(pose, a, b, period):
    """Centre b minus centre a over the nearest periodic image [m]; the inverse period of a free specimen is 0."""
    return (
        _nearest(pose[b, 0] - pose[a, 0], period[0], period[3]),
        _nearest(pose[b, 1] - pose[a, 1], period[1], period[4]),
        _nearest(pose[b, 2] - pose[a, 2], period[2], period[5]),
    )


@device
def stiffness(constants, same, k, s):
    """s times kn, A, B, C and kt of bond k, from its own constants or, where it has four, from those all share."""
    if constants.shape[0] > 4:
        return s * constants[4, k], s * constants[5, k], s * constants[6, k], s * constants[7, k], s * constants[8, k]
    inverse = s / constants[3, k]
    return same[0] * inverse, same[1] * inverse, same[2] * inverse, same[1] * inverse, same[3] * inverse


@cuda_kernel
def bond_forces(elements, bonds):
    """Force on j and torques on i and j of every bond, into the nine rows of `bonds.forces`."""
    k = cuda.grid(1)
    if k >= bonds.m:
        return
    pose, constants, forces = elements.pose, bonds.constants, bonds.forces
    a = bonds.i[k]
    b = bonds.j[k]
    dx, dy, dz = branch(pose, a, b, bonds.period)
    kn, A, B, C, kt = stiffness(constants, bonds.same, k, bonds.integrity[k])
    fx, fy, fz, ax, ay, az, bx, by, bz = bond_force(
        dx, dy, dz,
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
        pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        constants[0, k], constants[1, k], constants[2, k], constants[3, k], kn, A, B, C, kt,
    )  # fmt: skip
    forces[0, k], forces[1, k], forces[2, k] = fx, fy, fz
    forces[3, k], forces[4, k], forces[5, k] = ax, ay, az
    forces[6, k], forces[7, k], forces[8, k] = bx, by, bz
