"""Passes that steps are composed of, of `core/passes/cells/facet_failure.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import Candidates, EventLog, Postponed, Strengths
from bondem._tables.step_tables import Moving, Rows


def break_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, event_log: EventLog
) -> StepEntry:
    """Removes the facets that fail, and updates the stresses of their cells.

    Over events of the step, such as failures, in their order. Reads `arm`, `given`, `wall`, `weight` at both
    ends; reads `pose` at both ends and at their neighbours; adds `pose.stress`, `weight` to elements.
    """
    return StepEntry("break_facets", (moving, elastic_facets, wall_constraints, facet_release, candidates, event_log))


def judge_facets_by_mohr_coulomb(
    moving: Moving, elastic_facets: ElasticFacets, facet_release: FacetRelease, strengths: Strengths, candidates:
    Candidates, postponed: Postponed
) -> StepEntry:
    """Evaluates marked facets by a criterion at the present stresses; postpones cells that lose facets, and their
    neighbours.

    Over events of the step, such as failures, in their order. Reads `pose`, `pose.stress` at both ends; adds
    `flag` to elements.
    """
    return StepEntry("judge_facets_by_mohr_coulomb", (
        moving, elastic_facets, facet_release, strengths, candidates, postponed
    ))


def renew_wall_rows(wall_constraints: WallConstraints, rows: Rows, candidates: Candidates) -> StepEntry:
    """Updates the forces of walls on the rows of their cells.

    Over rows of a table, in the order of the table. Reads `load` of an element; writes `support` of an element.
    """
    return StepEntry("renew_wall_rows", (wall_constraints, rows, candidates))


def restore_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Adds the loads of the remaining facets and of walls to the kept sums.

    Over events of the step, such as failures, in their order. Reads `arm`, `base`, `wall` of an element; reads
    `flag`, `pose.stress` at both ends; reads `pose` at both ends, of elements that are postponed; adds `sum`,
    `load` to elements.
    """
    return StepEntry("restore_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def withdraw_facets(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> StepEntry:
    """Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.

    Over events of the step, such as failures, in their order. Reads `load` of an element; reads `flag`,
    `pose.stress` at both ends; reads `pose` at both ends, of elements that are postponed; adds `flag`, `sum` to
    elements.
    """
    return StepEntry("withdraw_facets", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


#: Passes `judge_facets_by_…` by the name of their criterion.
JUDGE_FACETS_BY = {
    "mohr_coulomb": judge_facets_by_mohr_coulomb,
}
