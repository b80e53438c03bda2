"""Failure criteria as the core takes them, and the indices of all bonds in any poses.

`core/tables/damage_tables.hpp` declares types and shapes.
"""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass
from bondem._types import Floats, PerBond
from bondem.damage.failure_table import FailureTable
from bondem.interactions.beams.beam_tables import Beams, Poses
from bondem.interactions.cells.cell_tables import ElasticFacets

#: Names of the criteria in the passes of the core, by their number (`BondCriterion.kind`).
CRITERION_NAMES = ("peripheral_stress", "mohr_coulomb", "linear_sum", "ellipse")


class Strengths(NamedTuple):
    """Coefficients of the criterion of each bond."""

    coefficient: Floats  #: (m, 4)
    station: Floats  #: place where the moment counts, from i over the length; below 0 for the larger end, (m,)


class FailureIndices(NamedTuple):
    """Index of the criterion of each bond."""

    index: Floats  #: 1 at failure, 0 of broken bonds [-], (m,)


_index_beams = [Pass(f"index_beams_by_{name}", Poses, Beams, Strengths, FailureIndices) for name in CRITERION_NAMES]

_index_facets = [
    Pass(f"index_facets_by_{name}", Poses, ElasticFacets, Strengths, FailureIndices) for name in CRITERION_NAMES
]


def strengths_of(table: FailureTable) -> Strengths:
    """Return the coefficients of a table as the core takes them."""
    return Strengths(np.ascontiguousarray(table.coefficient), np.ascontiguousarray(table.station, dtype=float))


def beam_indices(pose: Floats, beams: Beams, table: FailureTable) -> PerBond:
    """Return the index of every beam [-], 0 where broken, internal order, (m,)."""
    found = np.zeros(len(beams.i))
    _index_beams[table.kind](Poses(pose), beams, strengths_of(table), FailureIndices(found))
    return found[: len(table.station)]


def indices_of_facets(pose: Floats, facets: ElasticFacets, table: FailureTable) -> PerBond:
    """Return the index of every facet at the stresses in the poses [-], 0 where broken, internal order, (m,)."""
    found = np.zeros(len(facets.i))
    _index_facets[table.kind](Poses(pose), facets, strengths_of(table), FailureIndices(found))
    return found[: len(table.station)]
