"""Passes over an index, for devices, of `core/gpu/crack_onset.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import ElasticFacets, FacetForces, FacetsOfCells, FacetTractions, WallConstraints
from bondem._tables.crack_tables import CohesiveCracks, CrackOnset, FacetStrengths, StressesOfCells
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, FacetArms, LoadsOfBonds, RowOrder
from bondem._tables.step_tables import Moving


def add_still_surface_stress(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder,
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells, where no step is taken.

    Over one index.
    """
    return Kernel("add_still_surface_stress", (
        device_span, moving, wall_constraints, row_order, facet_tractions, stresses_of_cells
    ))


def add_surface_stress(
    device_span: DeviceSpan, moving: Moving, wall_constraints: WallConstraints, row_order: RowOrder,
    facet_tractions: FacetTractions, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Adds forces of walls and of loads on free facets to the stresses of surface cells.

    Over one index.
    """
    return Kernel("add_surface_stress", (
        device_span, moving, wall_constraints, row_order, facet_tractions, stresses_of_cells
    ))


def begin_marked_crack(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, facet_forces: FacetForces, facet_strengths:
    FacetStrengths, crack_onset: CrackOnset, cohesive_cracks: CohesiveCracks
) -> Kernel:
    """Begins the cracks of facets that are marked.

    Over one index.
    """
    return Kernel("begin_marked_crack", (
        device_span, elastic_facets, facet_forces, facet_strengths, crack_onset, cohesive_cracks
    ))


def find_cell_stress(
    device_span: DeviceSpan, moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Finds the mean stresses of cells from the forces of the last step on their facets and cracks.

    Over one index.
    """
    return Kernel("find_cell_stress", (device_span, moving, facet_forces, stresses_of_cells))


def find_still_stress(
    device_span: DeviceSpan, moving: Moving, facet_forces: FacetForces, stresses_of_cells: StressesOfCells
) -> Kernel:
    """Finds the mean stresses of cells from present forces, where no step is taken.

    Over one index.
    """
    return Kernel("find_still_stress", (device_span, moving, facet_forces, stresses_of_cells))


def gather_facet_moments(
    facet_forces: FacetForces, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, facet_arms:
    FacetArms
) -> Kernel:
    """Sets V σ and Σ `bending_square` of cells from their complete sums, which are set to zero.

    Over one index.
    """
    return Kernel("gather_facet_moments", (facet_forces, bonds_of_elements, loads_of_bonds, facet_arms))


def judge_cell(
    device_span: DeviceSpan, facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset:
    CrackOnset
) -> Kernel:
    """Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.

    Over one index.
    """
    return Kernel("judge_cell", (device_span, facet_strengths, stresses_of_cells, crack_onset))


def load_stored_facet(
    moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces, loads_of_bonds: LoadsOfBonds,
    facet_arms: FacetArms
) -> Kernel:
    """Adds and stores the forces of the facets of a block, and adds up the moments V σ of their cells.

    Over one index.
    """
    return Kernel("load_stored_facet", (moving, elastic_facets, facet_forces, loads_of_bonds, facet_arms))


def mark_facet(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    facet_strengths: FacetStrengths, stresses_of_cells: StressesOfCells, crack_onset: CrackOnset
) -> Kernel:
    """Marks facets of the material that begin to crack, and all whole facets of cells without cohesion.

    Over one index.
    """
    return Kernel("mark_facet", (
        device_span, moving, elastic_facets, facet_forces, facet_strengths, stresses_of_cells, crack_onset
    ))


def mark_plane(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facet_forces: FacetForces,
    facet_strengths: FacetStrengths, crack_onset: CrackOnset
) -> Kernel:
    """Evaluates facet number e of the material planes."""
    return Kernel("mark_plane", (device_span, moving, elastic_facets, facet_forces, facet_strengths, crack_onset))


def sum_moments_of_cell(
    device_span: DeviceSpan, moving: Moving, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells,
    facet_forces: FacetForces
) -> Kernel:
    """Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.

    Over one index.
    """
    return Kernel("sum_moments_of_cell", (device_span, moving, elastic_facets, facets_of_cells, facet_forces))
