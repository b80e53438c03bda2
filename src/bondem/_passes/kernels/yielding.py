"""Passes over an index, for devices, of `core/gpu/yielding.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import CellStrains, ElasticFacets, FacetsOfCells, FacetTractions, WallConstraints
from bondem._tables.crack_tables import CohesiveCracks, CrackOnset, StressesOfCells, YieldingCells
from bondem._tables.device_tables import DeviceSpan
from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks


def add_crack_power(
    moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets, cohesive_cracks: CohesiveCracks
) -> Kernel:
    """Adds ∂U/∂factor of the stress-free strains at active cracks, in steps that need it.

    Over one index.
    """
    return Kernel("add_crack_power", (moving, cell_strains, elastic_facets, cohesive_cracks))


def add_yielding_work_of_row(
    device_span: DeviceSpan, step_blocks: StepBlocks, facet_tractions: FacetTractions, stresses_of_cells:
    StressesOfCells, yielding_cells: YieldingCells, rows: Rows
) -> Kernel:
    """Adds the work of loads on free facets of cell number h of those that own rows of the boundary."""
    return Kernel("add_yielding_work_of_row", (
        device_span, step_blocks, facet_tractions, stresses_of_cells, yielding_cells, rows
    ))


def begin_crack_power(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets,
    cohesive_cracks: CohesiveCracks
) -> Kernel:
    """Adds ∂U/∂factor of the stress-free strains by the forces of active cracks, before the first step of a call.

    Over one index.
    """
    return Kernel("begin_crack_power", (device_span, moving, cell_strains, elastic_facets, cohesive_cracks))


def keep_base_levers(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, yielding_cells: YieldingCells
) -> Kernel:
    """Keeps the levers without plastic strain where strains have changed them."""
    return Kernel("keep_base_levers", (cell_strains, elastic_facets, yielding_cells))


def stretch_cell_anew(
    cell_strains: CellStrains, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells:
    YieldingCells
) -> Kernel:
    """Launched for `stretch_anew`: stretches levers with the plastic deformation of their cells, where stress-free
    strains have changed them.

    Over one index.
    """
    return Kernel("stretch_cell_anew", (cell_strains, elastic_facets, facets_of_cells, yielding_cells))


def stretch_crack_of_cells(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, yielding_cells: YieldingCells, cohesive_cracks:
    CohesiveCracks
) -> Kernel:
    """Launched for `stretch_walls_and_cracks`: stretches levers of walls and cracks with the plastic deformation
    of their cells, where it has grown.

    Over one index.
    """
    return Kernel("stretch_crack_of_cells", (device_span, elastic_facets, yielding_cells, cohesive_cracks))


def stretch_growing_cell(
    device_span: DeviceSpan, elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells:
    YieldingCells
) -> Kernel:
    """Stretches levers of facets with the plastic deformation of their cells, where it has grown.

    Over one index.
    """
    return Kernel("stretch_growing_cell", (device_span, elastic_facets, facets_of_cells, yielding_cells))


def stretch_wall_anew(
    cell_strains: CellStrains, wall_constraints: WallConstraints, yielding_cells: YieldingCells
) -> Kernel:
    """Launched for `stretch_anew`: stretches levers with the plastic deformation of their cells, where stress-free
    strains have changed them.

    Over one index.
    """
    return Kernel("stretch_wall_anew", (cell_strains, wall_constraints, yielding_cells))


def stretch_wall_of_cell(
    device_span: DeviceSpan, wall_constraints: WallConstraints, yielding_cells: YieldingCells
) -> Kernel:
    """Launched for `stretch_walls_and_cracks`: stretches levers of walls and cracks with the plastic deformation
    of their cells, where it has grown.

    Over one index.
    """
    return Kernel("stretch_wall_of_cell", (device_span, wall_constraints, yielding_cells))


def stretch_yielded_cell(
    elastic_facets: ElasticFacets, facets_of_cells: FacetsOfCells, yielding_cells: YieldingCells
) -> Kernel:
    """Stretches levers of all facets with the plastic deformation of their cells, as a run begins.

    Over one index.
    """
    return Kernel("stretch_yielded_cell", (elastic_facets, facets_of_cells, yielding_cells))


def sum_portion_of_heat(
    device_span: DeviceSpan, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells, ledger: Ledger
) -> Kernel:
    """Sums the energy that the cells of a portion have dissipated by yielding [J].

    Over one index.
    """
    return Kernel("sum_portion_of_heat", (device_span, stresses_of_cells, yielding_cells, ledger))


def yield_cell(
    device_span: DeviceSpan, moving: Moving, stresses_of_cells: StressesOfCells, yielding_cells: YieldingCells,
    crack_onset: CrackOnset
) -> Kernel:
    """Applies plastic flow to the cells of a portion whose stress reaches their yield surface.

    Over one index.
    """
    return Kernel("yield_cell", (device_span, moving, stresses_of_cells, yielding_cells, crack_onset))
