"""Table of the gauges of a plan, in the layout of the core."""

import numpy as np

from bondem._tables.columns import GaugeQuantity, GaugeReduction, WallQuantity
from bondem._tables.step_tables import Gauges
from bondem.boundary.gauges import AnyGauge, Gauge, StrainGauge
from bondem.dynamics.plan import Plan
from bondem.errors import InputError
from bondem.model.model import Model


def gauge_tables(model: Model, plan: Plan) -> Gauges:
    """Return the table of the gauges of a plan: their elements or walls, quantities and reductions."""
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
        return np.zeros(1, dtype=np.int64)  # the core writes a motion there, which `StrainGauges` overwrites
    if isinstance(gauge, Gauge):
        return np.sort(model.layout.rank[gauge.region.select(model.lattice)])
    if not 0 <= gauge.wall < len(model.walls):
        raise InputError(f"WallGauge: wall = {gauge.wall} does not exist; give 0 to {len(model.walls) - 1}")
    return np.array([gauge.wall], dtype=np.int64)


def _quantity(gauge: AnyGauge) -> int:
    if isinstance(gauge, StrainGauge):
        return GaugeQuantity.DISPLACEMENT
    if isinstance(gauge, Gauge):
        return GaugeQuantity[gauge.quantity.upper()]
    return WallQuantity[gauge.quantity.upper()]


def _reduction(gauge: AnyGauge) -> int:
    return GaugeReduction[gauge.reduction.upper()] if isinstance(gauge, Gauge) else GaugeReduction.MEAN
