"""Passes over an index, for devices, of `core/gpu/strains.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.cell_tables import CellStrains, ElasticFacets, WallConstraints
from bondem._tables.device_tables import DeviceSpan
from bondem._tables.step_tables import Beams, Moving, Rows, Strain, Timeline


def add_work_of_cell_strains(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints, rows:
    Rows
) -> Kernel:
    """Adds the work of strains that have changed, once the forces after the change are known.

    Over one index.
    """
    return Kernel("add_work_of_cell_strains", (device_span, moving, cell_strains, wall_constraints, rows))


def add_work_of_strains(device_span: DeviceSpan, strain: Strain, rows: Rows) -> Kernel:
    """Launched for `follow_strains`: adapts strained beams to their lengths L (1 + ε*), and adds the work of the
    strains.

    Over one index.
    """
    return Kernel("add_work_of_strains", (device_span, strain, rows))


def begin_cell_strains(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, wall_constraints: WallConstraints
) -> Kernel:
    """Launched for `begin_strain_work`: finds ∂U/∂factor from the stresses in the poses, before the first step of
    a call.

    Over one index.
    """
    return Kernel("begin_cell_strains", (device_span, moving, cell_strains, wall_constraints))


def begin_strain_portion(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets
) -> Kernel:
    """Launched for `begin_strain_work`: finds ∂U/∂factor from the stresses in the poses, before the first step of
    a call.

    Over one index.
    """
    return Kernel("begin_strain_portion", (device_span, moving, cell_strains, elastic_facets))


def follow_cell_factors(device_span: DeviceSpan, timeline: Timeline, cell_strains: CellStrains) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index.
    """
    return Kernel("follow_cell_factors", (device_span, timeline, cell_strains))


def follow_strain_factors(device_span: DeviceSpan, timeline: Timeline, strain: Strain) -> Kernel:
    """Launched for `follow_strains`: adapts strained beams to their lengths L (1 + ε*), and adds the work of the
    strains.

    Over one index.
    """
    return Kernel("follow_strain_factors", (device_span, timeline, strain))


def stretch_facet_of_step(cell_strains: CellStrains, elastic_facets: ElasticFacets) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index.
    """
    return Kernel("stretch_facet_of_step", (cell_strains, elastic_facets))


def stretch_strained_beam(moving: Moving, strain: Strain, beams: Beams) -> Kernel:
    """Launched for `follow_strains`: adapts strained beams to their lengths L (1 + ε*), and adds the work of the
    strains.

    Over one index.
    """
    return Kernel("stretch_strained_beam", (moving, strain, beams))


def stretch_wall_of_step(cell_strains: CellStrains, wall_constraints: WallConstraints) -> Kernel:
    """Launched for `follow_cell_strains`: sets stress-free strains, and with them the levers of facets and walls,
    to the time of the clock.

    Over one index.
    """
    return Kernel("stretch_wall_of_step", (cell_strains, wall_constraints))


def sum_strain_portion(
    device_span: DeviceSpan, moving: Moving, cell_strains: CellStrains, elastic_facets: ElasticFacets
) -> Kernel:
    """Sums ∂U/∂factor of the facets of a portion, in steps that need this sum.

    Over one index.
    """
    return Kernel("sum_strain_portion", (device_span, moving, cell_strains, elastic_facets))
