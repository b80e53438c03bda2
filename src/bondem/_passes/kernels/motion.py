"""Passes over an index, for devices, of `core/gpu/motion.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.device_tables import BondsOfElements, DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import BodyForces, Dashpots, Moving, Resistance, Rows, StepBlocks


def add_body_force(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, body_forces: BodyForces
) -> Kernel:
    """Adds body forces to the sums, and their work over the half of the step that ends.

    Over one index.
    """
    return Kernel("add_body_force", (device_span, moving, step_blocks, body_forces))


def add_work_of_body(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, body_forces: BodyForces
) -> Kernel:
    """Adds the work of body forces over the half of the step that begins, by its velocities; none at a pause.

    Over one index.
    """
    return Kernel("add_work_of_body", (device_span, moving, step_blocks, body_forces))


def gather_dashpots(
    step_blocks: StepBlocks, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds, dashpots: Dashpots
) -> Kernel:
    """Adds loads of dashpots of other domains to the sums of shared elements, and sets their rows to zero.

    Over one index.
    """
    return Kernel("gather_dashpots", (step_blocks, bonds_of_elements, loads_of_bonds, dashpots))


def gather_loads(step_blocks: StepBlocks, bonds_of_elements: BondsOfElements, loads_of_bonds: LoadsOfBonds) -> Kernel:
    """Adds the loads of the bonds of an element to its sum in memory, to which other passes add further loads."""
    return Kernel("gather_loads", (step_blocks, bonds_of_elements, loads_of_bonds))


def move_gathered(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `move_elements`: closes the step, and opens the next, for elements that own no row of the
    boundary.

    Over one index.
    """
    return Kernel("move_gathered", (device_span, moving, step_blocks, bonds_of_elements, loads_of_bonds))


def move_gathered_resisted(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, bonds_of_elements: BondsOfElements,
    loads_of_bonds: LoadsOfBonds, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted`: closes the step, and opens the next, for damped elements that own no row of
    the boundary.

    Over one index.
    """
    return Kernel("move_gathered_resisted", (
        device_span, moving, step_blocks, bonds_of_elements, loads_of_bonds, resistance
    ))


def move_gathered_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows, bonds_of_elements:
    BondsOfElements, loads_of_bonds: LoadsOfBonds, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted_rows`: closes the step, and opens the next, for damped elements that own rows of
    the boundary.

    Over one index.
    """
    return Kernel("move_gathered_resisted_row", (
        device_span, moving, step_blocks, rows, bonds_of_elements, loads_of_bonds, resistance
    ))


def move_gathered_row(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows, bonds_of_elements:
    BondsOfElements, loads_of_bonds: LoadsOfBonds
) -> Kernel:
    """Launched for `move_rows`: closes the step, and opens the next, for elements that own rows of the boundary.

    Over one index.
    """
    return Kernel("move_gathered_row", (device_span, moving, step_blocks, rows, bonds_of_elements, loads_of_bonds))


def move_summed(device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks) -> Kernel:
    """Launched for `move_elements`: closes the step, and opens the next, for elements that own no row of the
    boundary.

    Over one index.
    """
    return Kernel("move_summed", (device_span, moving, step_blocks))


def move_summed_resisted(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted`: closes the step, and opens the next, for damped elements that own no row of
    the boundary.

    Over one index.
    """
    return Kernel("move_summed_resisted", (device_span, moving, step_blocks, resistance))


def move_summed_resisted_row(
    device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows, resistance: Resistance
) -> Kernel:
    """Launched for `move_resisted_rows`: closes the step, and opens the next, for damped elements that own rows of
    the boundary.

    Over one index.
    """
    return Kernel("move_summed_resisted_row", (device_span, moving, step_blocks, rows, resistance))


def move_summed_row(device_span: DeviceSpan, moving: Moving, step_blocks: StepBlocks, rows: Rows) -> Kernel:
    """Launched for `move_rows`: closes the step, and opens the next, for elements that own rows of the boundary.

    Over one index.
    """
    return Kernel("move_summed_row", (device_span, moving, step_blocks, rows))


def open_element(device_span: DeviceSpan, moving: Moving) -> Kernel:
    """Opens a step after a pause for all elements, none of which owns a row of the boundary.

    Over one index.
    """
    return Kernel("open_element", (device_span, moving))


def open_element_or_row(device_span: DeviceSpan, moving: Moving, rows: Rows) -> Kernel:
    """Opens a step after a pause for all elements, some of which own rows of the boundary.

    Over one index.
    """
    return Kernel("open_element_or_row", (device_span, moving, rows))


def open_work_of_body(device_span: DeviceSpan, moving: Moving, body_forces: BodyForces) -> Kernel:
    """Adds the work of body forces over the half of the step that begins after a pause.

    Over one index.
    """
    return Kernel("open_work_of_body", (device_span, moving, body_forces))
