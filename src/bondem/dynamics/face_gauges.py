"""Force gauges on faces of cells that other conditions act on too, evaluated outside the core at each record."""

import numpy as np

from bondem._tables.columns import HistoryColumn
from bondem._types import Floats, Ints
from bondem.boundary.conditions import Load
from bondem.boundary.gauges import Gauge
from bondem.boundary.loads import Pressure, facet_numbers, is_face
from bondem.dynamics.plan import Plan
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import wall_forces
from bondem.observables.facet_loads import loads_on_facets

_REDUCED = {"sum": np.sum, "mean": np.mean, "max_abs": lambda force, axis: np.abs(force).max(axis=axis)}


class FaceGauges:
    """Force gauges of a plan on faces of cells some of which have further facets that are fixed or loaded.

    The core adds up what acts on all facets of the cells of a gauge. Here it is what acts on the facets of the face,
    and on the centres of their cells. The object is False if the plan has no such gauge.
    """

    def __init__(self, model: Model, plan: Plan) -> None:
        self._model, self._parts = model, list[tuple[int, str, Ints, Ints]]()
        law, surface = model.interaction, model.lattice.elements.surface
        acting = np.zeros(len(surface), dtype=bool)
        acting[law.supports.fixed.facet] = True
        for condition in model.boundary:
            if isinstance(condition, Load | Pressure):
                acting[law.facet_forces(condition)[0]] = True
        for g, gauge in enumerate(plan.gauges.values()):
            if isinstance(gauge, Gauge) and gauge.quantity == "force" and is_face(gauge.region) and acting.any():
                cell, own = gauge.region.select(model.lattice), facet_numbers(gauge.region, model.lattice)
                if np.isin(surface[np.setdiff1d(np.flatnonzero(acting), own)], cell).any():
                    self._parts.append((HistoryColumn.COUNT + 3 * g, gauge.reduction, own, cell))

    def __bool__(self) -> bool:
        return bool(self._parts)

    def fill(self, records: Floats, state: State) -> None:
        """Write the forces in a state into the last row of `records`, (s, columns), in place."""
        if not self._parts or not len(records):
            return
        model, force = self._model, loads_on_facets(self._model, state.time, state.orientation)
        force[model.interaction.supports.fixed.facet] += wall_forces(model, state)
        on_centre = self._on_centres(state)
        for column, reduction, own, cell in self._parts:
            each = on_centre[cell]
            np.add.at(each, np.searchsorted(cell, model.lattice.elements.surface[own]), force[own])
            records[-1, column : column + 3] = _REDUCED[reduction](each, axis=0)

    def _on_centres(self, state: State) -> Floats:
        """Return the forces of loads and supports on the centres of all cells [N], (n, 3)."""
        model, held = self._model, self._model.constraints
        force = np.zeros((len(state.pose), 3))
        for condition in model.boundary:
            if isinstance(condition, Load) and not is_face(condition.region):
                chosen, nodal = condition.nodal(model.lattice)
                force[chosen] += condition.schedule.at(state.time) * nodal[:, :3]
        row = model.layout.order[held.element]
        force[row] = np.where(held.fixed[:, :3], state.reaction[:, :3], force[row])
        return force
