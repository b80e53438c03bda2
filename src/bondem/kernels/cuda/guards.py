"""One thread a bond or facet: whether it has turned too far."""

import math

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cuda.bonds import branch
from bondem.kernels.cuda.facets import between, levers
from bondem.kernels.single_facets import column, orientation, resistance
from bondem.laws.beam_energy import bond_cosines
from bondem.laws.cell_energy import relative, swing_square


@device
def _count(flags, c, w2, integrity):
    """Count a bond in what `rotation_guard` finds."""
    # counts of whole numbers: the order in which threads add changes nothing
    if not (c * c + w2 < 4.0):
        cuda.atomic.add(flags, 2, 1)
    if integrity > 0.0:
        if c < 0.7 or w2 < 0.75:
            cuda.atomic.add(flags, 0, 1)
        if c <= 0.0 or w2 <= 0.25:
            cuda.atomic.add(flags, 1, 1)


@cuda_kernel
def rotation_guard(elements, bonds, flags):
    """Add to `flags` (3,) the bonds beyond the valid range, beyond its end, and with numbers that are not finite."""
    k = cuda.grid(1)
    if k >= bonds.m:
        return
    pose, constants = elements.pose, bonds.constants
    a = bonds.i[k]
    b = bonds.j[k]
    dx, dy, dz = branch(pose, a, b, bonds.period)
    c1, c2, w2 = bond_cosines(
        dx, dy, dz,
        pose[a, 4], pose[a, 5], pose[a, 6], pose[a, 7],
        pose[b, 4], pose[b, 5], pose[b, 6], pose[b, 7],
        constants[0, k], constants[1, k], constants[2, k],
    )  # fmt: skip
    _count(flags, min(c1, c2), w2, bonds.integrity[k])


@device
def _direction(facets, k):
    """From the centre of i to that of j in the reference [-]: between two levers to one point."""
    a, b = levers(facets, k)
    x, y, z = a[0] - b[0], a[1] - b[1], a[2] - b[2]
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length


@cuda_kernel
def turn_guard(elements, facets, flags):
    """`rotation_guard` for facets."""
    k = cuda.grid(1)
    if k >= facets.m:
        return
    pose = elements.pose
    d, p, q = between(pose, facets, k), orientation(pose, facets.i[k]), orientation(pose, facets.j[k])
    x, y, z = _direction(facets, k)
    c1, c2, w2 = bond_cosines(
        d[0], d[1], d[2], p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3], x, y, z
    )  # fmt: skip
    _, v, _ = relative(p, q)
    w2 = swing_square(w2, v, column(facets.normal, k), resistance(facets, 1.0, k))
    _count(flags, min(c1, c2), w2, facets.integrity[k])
