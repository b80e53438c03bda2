"""Gauges of a plan as the core takes them."""

import numpy as np

from bondem._tables.step_tables import Gauges
from bondem.boundary.gauges import AnyGauge, Gauge, StrainGauge
from bondem.dynamics.plan import Plan
from bondem.errors import InputError
from bondem.model.model import Model

# Numbers of the quantities of elements, of those of walls, and of the reductions, as in the core.
_QUANTITIES = {"displacement": 0, "velocity": 1, "rotation": 2, "angular_velocity": 3, "force": 4}
_WALL_QUANTITIES = {
    "displacement": 5, "force": 6, "growth": 7, "velocity": 8, "torque": 9, "rotation": 10, "angular_velocity": 11,
    "power": 12,
}  # fmt: skip
_REDUCTIONS = {"mean": 0, "sum": 1, "max_abs": 2}


def gauge_tables(model: Model, plan: Plan) -> Gauges:
    """Return gauges as the core takes them."""
    gauges = list(plan.gauges.values())
    members = [_members(model, gauge) for gauge in gauges]
    return Gauges(
        start=np.concatenate([[0], np.cumsum([len(part) for part in members])]).astype(np.int64),
        element=np.concatenate(members) if members else np.zeros(0, dtype=np.int64),
        quantity=np.array([_quantity(gauge) for gauge in gauges], dtype=np.int64),
        reduction=np.array([_reduction(gauge) for gauge in gauges], dtype=np.int64),
    )


def _members(model: Model, gauge: AnyGauge) -> np.ndarray:
    """Return the elements of a gauge, internal order, or the index of its wall.

    Raises:
        InputError: The wall does not exist.
    """
    if isinstance(gauge, StrainGauge):
        return np.zeros(1, dtype=np.int64)  # the core fills its columns with the motion of any element
    if isinstance(gauge, Gauge):
        return np.sort(model.layout.rank[gauge.region.select(model.lattice)])
    if not 0 <= gauge.wall < len(model.walls):
        raise InputError(f"WallGauge: wall = {gauge.wall} does not exist; give 0 to {len(model.walls) - 1}")
    return np.array([gauge.wall], dtype=np.int64)


def _quantity(gauge: AnyGauge) -> int:
    if isinstance(gauge, StrainGauge):
        return _QUANTITIES["displacement"]
    if isinstance(gauge, Gauge):
        return _QUANTITIES[gauge.quantity]
    return _WALL_QUANTITIES[gauge.quantity]


def _reduction(gauge: AnyGauge) -> int:
    return _REDUCTIONS[gauge.reduction] if isinstance(gauge, Gauge) else _REDUCTIONS["mean"]
