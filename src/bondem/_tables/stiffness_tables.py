"""Tables of `core/tables/stiffness_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Int32s, Ints, Uint32s


class BeamRows(NamedTuple):
    """Beams at rest, m of them."""

    i: Uint32s  #: elements, i < j, (m,)
    j: Uint32s  #: elements, i < j, (m,)
    direction: Floats  #: reference direction i→j [-], (3, m)
    length: Floats  #: at rest [m], (m,)
    lever: Floats  #: distance of the contact point from i [m], (m,)
    kn: Floats  #: [N/m], (m,)
    ks: Floats  #: [N/m], (m,)
    kb: Floats  #: [N·m], (m,)
    kt: Floats  #: [N·m], (m,)


class FacetRows(NamedTuple):
    """Constants of m facets, a row each; see `bondem.interactions.cells.cell_constants`."""

    i: Uint32s  #: cells, i < j, (m,)
    j: Uint32s  #: cells, i < j, (m,)
    k: Floats  #: [N/m], (m,)
    lever_i: Floats  #: from the centre of cell i to the facet [m], (m, 3)
    lever_j: Floats  #: from the centre of cell j to the facet [m], (m, 3)
    H: Floats  #: [N·m], (m, 3, 3)
    share_i: Floats  #: share in V θ of cell i [m²], (m, 3)
    share_j: Floats  #: share in V θ of cell j [m²], (m, 3)


class BlockRows(NamedTuple):
    """Block rows of a matrix, one per element: earlier neighbours, the diagonal, later neighbours."""

    in_start: Ints  #: bonds in_start[p] … in_start[p + 1] - 1 end in p, (n + 1,)
    out_start: Ints  #: bonds that begin in p are out_bond[out_start[p]] …, (n + 1,)
    out_bond: Uint32s  #: bonds by their first elements, (m,)
    indptr: Int32s  #: where the blocks of each row begin, (n + 1,)
    indices: Int32s  #: column of each block, (blocks,)
    data: Floats  #: blocks of (u, θ) [N/m, N, N·m], (blocks, 6, 6)


class StiffnessProduct(NamedTuple):
    """A small motion of each element, and the product of a stiffness with it."""

    given: Floats  #: displacements and rotations [m, rad], (n, 6)
    found: Floats  #: forces and torques [N, N·m], (n, 6)
    motion: Floats  #: displacement, change of λ θ, rotation, 0 [m, Pa, rad], (n, 8)
    sums: Floats  #: -force, 0, -torque, 0 [N, N·m], (n, 8)


class BondTangents(NamedTuple):
    """The second derivative of the energy of each bond by the motions (u, θ) of its two elements."""

    tangent: Floats  #: [N/m, N, N·m], (12, 12, m)


class DilatationRows(NamedTuple):
    """Rows of the matrix by which V θ of cells follows from motions, with the blocks of `BlockRows`."""

    forms: Floats  #: V θ under unit motions [m², m³], (blocks, 1, 6)
