"""Tables of `core/tables/quasistatic_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Bytes, Floats, Ints, Singles


class WeakenedFacets(NamedTuple):
    """Constants and states of m facets; see `bondem.interactions.cells.cell_constants`."""

    i: Ints  #: (m,)
    j: Ints  #: (m,)
    k: Floats  #: [N/m], (m,)
    area: Floats  #: [m²], (m,)
    part: Floats  #: part of cell i in the compliance [-], (m,)
    lever_i: Floats  #: [m], (m, 3)
    lever_j: Floats  #: [m], (m, 3)
    share_i: Floats  #: A w m [m²], (m, 3)
    share_j: Floats  #: A w m [m²], (m, 3)
    normal: Floats  #: [-], (m, 3)
    H: Floats  #: [N·m], (m, 3, 3)
    integrity: Floats  #: [-], (m,)
    closed: Bytes  #: 1 for halves that press, (m, 2)
    across: Floats  #: direction in which a facet softens alone, zero for all directions [-], (m, 3)


class SmallMotions(NamedTuple):
    """Small motions of n cells, and their gaps and dilatations."""

    displacement: Floats  #: [m], (n, 3)
    rotation: Floats  #: [rad], (n, 3)
    gap: Floats  #: of the facets [m], (m, 3)
    swelling: Floats  #: V θ of the cells [m³], to which facets add, (n,)


class FacetLoading(NamedTuple):
    """Loads of facets and cells at given stresses."""

    stress: Floats  #: λ θ of the cells [Pa], (n,)
    traction: Floats  #: [Pa], (m, 3)
    bending: Floats  #: T_b of each facet, as if it were whole [Pa], (m,)
    opening: Floats  #: traction of facets that have lost integrity, as if they were whole [Pa], (m, 3)
    opened: Floats  #: |F⁺| / A of these facets [Pa], (m,)
    turned: Bytes  #: 1 for halves of these facets that close or open, (m, 2)
    moment: Floats  #: V σ of the cells, to which facets add, xx, yy, zz, xy, xz, yz [J], (n, 6)


class ScaledMatrix(NamedTuple):
    """Sᵀ K S = B + Fᵀ W F of n cells, in b blocks."""

    start: Ints  #: first block of each row, (n + 1,)
    column: Ints  #: (b,)
    diagonal: Ints  #: block on the diagonal of each row; those after it are above the diagonal, (n,)
    block: Floats  #: B, (b, 6, 6)
    form: Floats  #: F, (b, 6)
    rounded_block: Singles  #: B in half the memory, (b, 6, 6)
    rounded_form: Singles  #: F in half the memory, (b, 6)
    weight: Floats  #: W, (n,)


class ClumpCorrection(NamedTuple):
    """Coarse correction by clumps of cells that move rigidly: c unknowns, and a factor L of half-width w - 1."""

    place: Ints  #: first coarse unknown of the clump of each cell, (n,)
    order: Ints  #: place of each coarse unknown in L, (c,)
    basis: Floats  #: motion of each cell per motion of its clump, (n, 6, 6)
    factor: Floats  #: columns of L from the diagonal down, (c, w)
    rigid: Floats  #: rigid motions that are free, orthonormal, (r, x)
    coarse: Floats  #: values of the coarse unknowns, (c,)


class ConjugateGradients(NamedTuple):
    """State of conjugate gradients in 6 n unknowns."""

    limits: Floats  #: |r| and r·z at which the search ends, (2,)
    most: int  #: largest number of rounds
    residual: Floats  #: right-hand side before, residual afterwards, (x,)
    found: Floats  #: guess before, solution afterwards, (x,)
    work: Floats  #: z, p, K p and f, (4, x)
    stress: Floats  #: W F p, (n,)
    rounds: Ints  #: number of rounds, (1,)
    first: Floats  #: r·z at the beginning, (1,)
