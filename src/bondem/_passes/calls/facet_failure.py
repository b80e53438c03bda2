"""Passes that Python calls, of `core/passes/cells/facet_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.cell_tables import ElasticFacets, FacetRelease
from bondem._tables.damage_tables import FailureIndices, LoadedTractions, Strengths
from bondem._tables.step_tables import Poses


def index_facets_by_mohr_coulomb(
    poses: Poses, elastic_facets: ElasticFacets, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, at the stresses in the poses."""
    return Call("index_facets_by_mohr_coulomb", (poses, elastic_facets, strengths, failure_indices))


def index_tractions_by_mohr_coulomb(
    loaded_tractions: LoadedTractions, strengths: Strengths, failure_indices: FailureIndices
) -> Call:
    """Finds the index of every facet by a criterion, under tractions."""
    return Call("index_tractions_by_mohr_coulomb", (loaded_tractions, strengths, failure_indices))


def weigh_cells(elastic_facets: ElasticFacets, facet_release: FacetRelease) -> Call:
    """Computes the weights of all cells from their unbroken facets at the start of a run."""
    return Call("weigh_cells", (elastic_facets, facet_release))


#: Passes `index_facets_by_…` by the name of their criterion.
INDEX_FACETS_BY = {
    "mohr_coulomb": index_facets_by_mohr_coulomb,
}
#: Passes `index_tractions_by_…` by the name of their criterion.
INDEX_TRACTIONS_BY = {
    "mohr_coulomb": index_tractions_by_mohr_coulomb,
}
