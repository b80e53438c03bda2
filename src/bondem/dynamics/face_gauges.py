"""Force gauges on faces of cells that other conditions act on too, evaluated outside the core at each record."""

from dataclasses import replace

import numpy as np

from bondem._tables.columns import HistoryColumn
from bondem._types import Floats, Ints
from bondem.boundary.conditions import Load
from bondem.boundary.couples import Couple
from bondem.boundary.gauges import Gauge
from bondem.boundary.loads import Pressure, facet_numbers, is_face
from bondem.dynamics.plan import Plan
from bondem.geometry.rotations import turned_vectors
from bondem.model.constraints import couple_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import wall_forces

_REDUCED = {"sum": np.sum, "mean": np.mean, "max_abs": lambda force, axis: np.abs(force).max(axis=axis)}


class FaceGauges:
    """Force gauges of a plan on faces of cells some of which have further facets that are fixed or loaded.

    The core adds up what acts on all facets of the cells of a gauge. Here it is what acts on the facets of the face,
    and on the centres of their cells. The object is False if the plan has no such gauge.
    """

    def __init__(self, model: Model, plan: Plan) -> None:
        self._model, self._gauges = model, list[tuple[int, str, Ints, Ints]]()
        self._loads: list[tuple[Load | Pressure, Ints, Floats, Couple | None]] = []
        law, lattice = model.interaction, model.lattice
        surface = lattice.elements.surface
        acting = np.isin(np.arange(len(surface)), law.supports.fixed.facet)
        for one in model.boundary if len(surface) else ():
            if isinstance(one, Load | Pressure):
                couple = couple_of(one, lattice, model.layout, 0)
                turns = couple is not None and isinstance(one, Load)
                straight = replace(one, moment=(0.0, 0.0, 0.0)) if turns else one
                at, force = law.facet_forces(straight) if is_face(one.region) else straight.nodal(lattice)
                acting[at if is_face(one.region) else []] = True
                self._loads.append((one, at, force[:, :3], couple))
        for g, gauge in enumerate(plan.gauges.values()):
            if isinstance(gauge, Gauge) and gauge.quantity == "force" and is_face(gauge.region) and acting.any():
                cell, own = gauge.region.select(lattice), facet_numbers(gauge.region, lattice)
                if np.isin(surface[np.setdiff1d(np.flatnonzero(acting), own)], cell).any():
                    self._gauges.append((HistoryColumn.COUNT + 3 * g, gauge.reduction, own, cell))

    def __bool__(self) -> bool:
        return bool(self._gauges)

    def fill(self, records: Floats, state: State) -> None:
        """Write the forces in a state into the last row of `records`, (s, columns), in place."""
        if not self._gauges or not len(records):
            return
        on_facet, on_centre, surface = *self._forces(state), self._model.lattice.elements.surface
        for column, reduction, own, cell in self._gauges:
            each = on_centre[cell]
            np.add.at(each, np.searchsorted(cell, surface[own]), on_facet[own])
            records[-1, column : column + 3] = _REDUCED[reduction](each, axis=0)

    def _forces(self, state: State) -> tuple[Floats, Floats]:
        """Return the forces of loads and supports on free facets, (k, 3), and on the centres of cells, (n, 3) [N]."""
        model, held, surface = self._model, self._model.constraints, self._model.lattice.elements.surface
        on_facet, on_centre = np.zeros((len(surface), 3)), np.zeros((len(state.pose), 3))
        for load, at, force, couple in self._loads:
            if isinstance(load, Pressure) and load.follows:
                force = turned_vectors(state.orientation[surface[at]], force)
            turning = 0.0 if couple is None else couple.forces(state.pose)[0]
            to = on_facet if is_face(load.region) else on_centre
            to[at] += load.schedule.at(state.time) * (force + turning)
        on_facet[model.interaction.supports.fixed.facet] += wall_forces(model, state)
        row = model.layout.order[held.element]
        on_centre[row] = np.where(held.fixed[:, :3], state.reaction[:, :3], on_centre[row])
        return on_facet, on_centre
