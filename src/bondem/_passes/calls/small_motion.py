"""Passes that Python calls, of `core/passes/quasistatic/small_motion.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.quasistatic_tables import FacetLoading, SmallMotions, WeakenedFacets


def load_weakened_facets(
    weakened_facets: WeakenedFacets, small_motions: SmallMotions, facet_loading: FacetLoading
) -> Call:
    """Finds the loads of facets at the stresses of their cells, and adds sym(b⊗F), F the force on a cell, to its
    sum.
    """
    return Call("load_weakened_facets", (weakened_facets, small_motions, facet_loading))


def open_weakened_facets(weakened_facets: WeakenedFacets, small_motions: SmallMotions) -> Call:
    """Finds the gaps of facets, and adds V θ to their cells."""
    return Call("open_weakened_facets", (weakened_facets, small_motions))
