"""Gauges that are evaluated outside the core at each record: strains, and forces on faces that share cells."""

import numpy as np

from bondem._tables.columns import HistoryColumn
from bondem._types import Floats
from bondem.boundary.gauges import StrainGauge
from bondem.dynamics.face_gauges import FaceGauges
from bondem.dynamics.plan import Plan
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.affine_strain import gradient_weights


class StateGauges:
    """Gauges of a plan that are evaluated from the state; the object is False if the plan has none."""

    def __init__(self, model: Model, plan: Plan) -> None:
        """Compute the weights of the displacements in each strain.

        Raises:
            InputError: The elements of a gauge lie in a plane.
        """
        self._parts: list[tuple[int, np.ndarray, Floats]] = []
        self._faces = FaceGauges(model, plan)
        for g, (name, gauge) in enumerate(plan.gauges.items()):
            if not isinstance(gauge, StrainGauge):
                continue
            chosen = gauge.region.select(model.lattice)
            position = model.lattice.centre[chosen]
            if np.linalg.matrix_rank(position - position.mean(axis=0)) < 3:
                raise InputError(
                    f"gauge '{name}': the {len(chosen)} elements of its region lie in a plane or on a line; use a"
                    " region with at least four that do not"
                )
            self._parts.append((HistoryColumn.COUNT + 3 * g, chosen, gradient_weights(position)))

    def __bool__(self) -> bool:
        return bool(self._parts or self._faces)

    def fill(self, records: Floats, state: State) -> None:
        """Write what the gauges read in a state into the last row of `records`, (s, columns), in place.

        A line along e becomes F e = e + u' with u' = (∂u/∂x) e: its strain |F e| - 1 is 2 E / (1 + |F e|) with the
        Green strain E = e · u' + ½ |u'|², without loss of digits where it is small.
        """
        self._faces.fill(records, state)
        if not self._parts or not len(records):
            return
        moved = state.displacement
        for column, chosen, weights in self._parts:
            gradient = np.einsum("ni,nj->ij", moved[chosen], weights)
            green = gradient.diagonal() + 0.5 * (gradient**2).sum(axis=0)
            length = np.linalg.norm(np.eye(3) + gradient, axis=0)
            records[-1, column : column + 3] = 2.0 * green / (1.0 + length)
