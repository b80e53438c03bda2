"""Boundary conditions frozen at the final values of their schedules, times a factor, for an equilibrium."""

from collections.abc import Sequence
from dataclasses import replace

from bondem.boundary.conditions import BoundaryCondition, Drive, Load
from bondem.boundary.loads import BodyForce, Eigenstrain, Pressure
from bondem.boundary.schedules import Constant

#: Conditions whose load or strain is multiplied by a schedule.
Scheduled = Load | Pressure | BodyForce | Eigenstrain


def frozen_conditions(boundary: Sequence[BoundaryCondition], factor: float = 1.0) -> tuple[BoundaryCondition, ...]:
    """Return conditions whose displacements, loads and strains are those at the end of all schedules, times a factor.

    Args:
        boundary: conditions without prescribed velocities, which have no equilibrium.
        factor: factor of the values at the end of the schedules [-].
    """
    return tuple(_frozen(one, factor) for one in boundary)


def _frozen(one: BoundaryCondition, factor: float) -> BoundaryCondition:
    if isinstance(one, Drive):
        motion = {name: Constant(factor * schedule.final) for name, schedule in one.arguments.items()}
        return Drive(one.region, friction=one.friction, **motion)
    return replace(one, schedule=Constant(factor * one.schedule.final)) if isinstance(one, Scheduled) else one
