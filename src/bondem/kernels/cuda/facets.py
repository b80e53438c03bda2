"""One thread a facet of a body of cells: what it does to dilatation, its force and torques.

The two passes of `bondem.kernels.cell_pass`. What the first one finds, V θ of both sides, stands in two of the rows
that the second one fills with forces: it has been read by then.
"""

from bondem._compile import device
from bondem._compile_cuda import cuda, cuda_kernel
from bondem.kernels.cell_pass import STRESS
from bondem.kernels.cuda.bonds import branch
from bondem.kernels.single_facets import column, lever, orientation, resistance
from bondem.laws.cell_energy import facet_energy, facet_force, swellings

# Rows of `DeviceFacets.forces` that hold V θ of cells i and j between the two passes.
OF_I, OF_J = 0, 1


@device
def between(pose, facets, k):
    """From the centre of i to that of j [m]."""
    return branch(pose, facets.i[k], facets.j[k], facets.period)


@device
def levers(facets, k):
    """From both centres to a facet, in the reference [m]."""
    return lever(facets.lever_i, facets.pitch, k), lever(facets.lever_j, facets.pitch, k)


@device
def place_of(pose, facets, k):
    """Branch, orientations, levers and shares of a facet, as `bondem.kernels.single_facets.frame` has them."""
    a, b = levers(facets, k)
    return (
        between(pose, facets, k), orientation(pose, facets.i[k]), orientation(pose, facets.j[k]), a, b,
        column(facets.share_i, k), column(facets.share_j, k),
    )  # fmt: skip


@device
def swell_facet(pose, facets, k):
    """What a facet adds to V θ of its two cells, into its rows."""
    s = facets.integrity[k]
    d, p, q, a, b, u, v = place_of(pose, facets, k)
    one, other = swellings(d, p, q, a, b, u, v)
    facets.forces[OF_I, k], facets.forces[OF_J, k] = s * one, s * other


@device
def load_facet(pose, facets, n):
    """Force on j and torques on i and j of a facet, into its rows, with the stresses of the cells known."""
    forces, s = facets.forces, facets.integrity[n]
    i, j = facets.i[n], facets.j[n]
    d, p, q, a, b, u, v = place_of(pose, facets, n)
    f, on_i, on_j = facet_force(
        d, p, q, a, b, u, v, s * facets.k[n], resistance(facets, s, n), s * pose[i, STRESS], s * pose[j, STRESS],
    )  # fmt: skip
    forces[0, n], forces[1, n], forces[2, n] = f
    forces[3, n], forces[4, n], forces[5, n] = on_i
    forces[6, n], forces[7, n], forces[8, n] = on_j


@cuda_kernel
def swell(elements, facets):
    """What every facet adds to V θ of its two cells."""
    k = cuda.grid(1)
    if k < facets.m:
        swell_facet(elements.pose, facets, k)


@cuda_kernel
def facet_loads(elements, facets):
    """Force on j and torques on i and j of every facet, with the stresses of the cells known."""
    k = cuda.grid(1)
    if k < facets.m:
        load_facet(elements.pose, facets, k)


@device
def energy_of(pose, facets, k):
    """Normal, shear, bending and twisting energy of a facet, without dilatation [J]."""
    d, p, q = between(pose, facets, k), orientation(pose, facets.i[k]), orientation(pose, facets.j[k])
    a, b = levers(facets, k)
    s = facets.integrity[k]
    part = facet_energy(d, p, q, a, b, column(facets.normal, k), facets.k[k], resistance(facets, 1.0, k))
    return s * part[0], s * part[1], s * part[2], s * part[3]
