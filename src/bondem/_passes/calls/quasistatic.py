"""Passes that Python calls, of `core/passes/quasistatic`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.quasistatic_tables import (
    ClumpCorrection,
    ConjugateGradients,
    FacetLoading,
    ScaledMatrix,
    SmallMotions,
    WeakenedFacets,
)


def conjugate_gradients(
    scaled_matrix: ScaledMatrix, clump_correction: ClumpCorrection, conjugate_gradients: ConjugateGradients
) -> Call:
    """Solves Sᵀ K S x = f by conjugate gradients from a guess, preconditioned by the clumps; returns 0 if they
    converge, else 1.
    """
    return Call("conjugate_gradients", (scaled_matrix, clump_correction, conjugate_gradients))


def load_weakened_facets(
    weakened_facets: WeakenedFacets, small_motions: SmallMotions, facet_loading: FacetLoading
) -> Call:
    """Finds the loads of facets at the stresses of their cells, and adds their moments to those of the cells."""
    return Call("load_weakened_facets", (weakened_facets, small_motions, facet_loading))


def open_weakened_facets(weakened_facets: WeakenedFacets, small_motions: SmallMotions) -> Call:
    """Finds the gaps of facets, and adds V θ to their cells."""
    return Call("open_weakened_facets", (weakened_facets, small_motions))
