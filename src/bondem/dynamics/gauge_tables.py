"""Table of the gauges of a plan, in the layout of the core."""

import numpy as np

from bondem._tables.columns import GaugeQuantity, GaugeReduction, WallQuantity
from bondem._tables.step_tables import Gauges
from bondem.boundary.gauges import AnyGauge, Gauge, StrainGauge
from bondem.dynamics.plan import Plan
from bondem.errors import InputError
from bondem.model.model import Model


def gauge_tables(model: Model, plan: Plan) -> Gauges:
    """Return the table of the gauges of a plan; a missing wall or an empty region raises InputError."""
    entries = [_entry(model, gauge) for gauge in plan.gauges.values()]
    members = [part for part, *_ in entries]
    return Gauges(
        start=np.cumsum([0, *map(len, members)]).astype(np.int64),
        element=np.concatenate([np.zeros(0, dtype=np.int64), *members]),
        quantity=np.array([quantity for _, quantity, _ in entries], dtype=np.int64),
        reduction=np.array([reduction for *_, reduction in entries], dtype=np.int64),
    )


def _entry(model: Model, gauge: AnyGauge) -> tuple[np.ndarray, int, int]:
    """Return the elements of a gauge, internal order, or the index of its wall, with its quantity and reduction.

    Raises:
        InputError: The wall does not exist.
    """
    if isinstance(gauge, StrainGauge):  # the core writes a motion there, which `StateGauges` overwrites
        return np.zeros(1, dtype=np.int64), GaugeQuantity.DISPLACEMENT, GaugeReduction.MEAN
    if isinstance(gauge, Gauge):
        elements = np.sort(model.layout.rank[gauge.region.select(model.lattice)])
        return elements, GaugeQuantity[gauge.quantity.upper()], GaugeReduction[gauge.reduction.upper()]
    if not 0 <= gauge.wall < len(model.walls):
        known = f"give 0 to {len(model.walls) - 1}" if model.walls else "the model has no walls=; give it some"
        raise InputError(f"WallGauge: wall = {gauge.wall} does not exist; {known}")
    return np.array([gauge.wall], dtype=np.int64), WallQuantity[gauge.quantity.upper()], GaugeReduction.MEAN
