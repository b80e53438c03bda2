"""Passes over an index, for devices, of `core/gpu/facet_breakage.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import ElasticFacets, FacetRelease, WallConstraints
from bondem._tables.damage_tables import Candidates, EventLog, FailureBounds, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, DeviceSpan, LoadsOfBonds, RowOrder
from bondem._tables.step_tables import Moving, Rows


def dilate_marked_facet(
    moving: Moving, elastic_facets: ElasticFacets, loads_of_bonds: LoadsOfBonds, failure_bounds: FailureBounds,
    bond_marks: BondMarks
) -> Kernel:
    """Marks facets by the stresses of the previous step, because stresses of this step need all facets."""
    return Kernel("dilate_marked_facet", (moving, elastic_facets, loads_of_bonds, failure_bounds, bond_marks))


def end_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Sets weight and stress of cell p without its failed facets, and the integrity of failed facets with i = p to
    zero.
    """
    return Kernel("end_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, bond_marks, candidates
    ))


def judge_facet_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, strengths: Strengths, bond_marks:
    BondMarks, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_facets`: evaluates marked facets by a criterion at the present stresses; postpones cells
    that lose facets, and their neighbours.

    Over one index.
    """
    return Kernel("judge_facet_by_mohr_coulomb", (
        device_span, moving, elastic_facets, strengths, bond_marks, candidates, postponed
    ))


def postpone_neighbour(
    elastic_facets: ElasticFacets, facet_release: FacetRelease, candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Launched for `judge_facets`: evaluates marked facets by a criterion at the present stresses; postpones cells
    that lose facets, and their neighbours.

    Over one index.
    """
    return Kernel("postpone_neighbour", (elastic_facets, facet_release, candidates, postponed))


def renew_wall_row(
    wall_constraints: WallConstraints, row_order: RowOrder, rows: Rows, candidates: Candidates
) -> Kernel:
    """Updates the forces of walls on the rows of their cells.

    Over one index.
    """
    return Kernel("renew_wall_row", (wall_constraints, row_order, rows, candidates))


def restore_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Adds the loads of the remaining facets and of walls to the kept sums.

    Over one index.
    """
    return Kernel("restore_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def withdraw_facets_of_cell(
    moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints, facet_release: FacetRelease,
    candidates: Candidates, postponed: Postponed
) -> Kernel:
    """Lists the cells whose loads change, and subtracts the loads of their facets and walls from the kept sums.

    Over one index.
    """
    return Kernel("withdraw_facets_of_cell", (
        moving, elastic_facets, wall_constraints, facet_release, candidates, postponed
    ))


def write_facet_failure(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, wall_constraints: WallConstraints,
    facet_release: FacetRelease, bond_marks: BondMarks, candidates: Candidates, event_log: EventLog
) -> Kernel:
    """Writes the event of failed facet number e; the facet keeps its integrity until all energies are known."""
    return Kernel("write_facet_failure", (
        device_span, moving, elastic_facets, wall_constraints, facet_release, bond_marks, candidates, event_log
    ))


#: Passes `judge_facet_by_…` by the name of their criterion.
JUDGE_FACET_BY = {
    "mohr_coulomb": judge_facet_by_mohr_coulomb,
}
