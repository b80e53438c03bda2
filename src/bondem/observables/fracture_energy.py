"""Energy that broken bonds or facets have dissipated per area, compared with the criterion's fracture energy."""

import math
from dataclasses import dataclass
from typing import cast

import numpy as np

from bondem._tables.columns import EventColumn, SoftColumn
from bondem._types import Floats, Ints
from bondem.damage.crack_columns import FACET, ONSET, SPENT
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.regions import Region


@dataclass(frozen=True)
class FractureEnergy:
    """Energy that the broken bonds or facets of one criterion have dissipated, over their own area.

    A facet dissipates G_f per area projected on its crack, at most G_f per own area. For a single crack through cells
    `per_area` is therefore 0.7 to 0.8 of `entered`. A larger value means that facets have released more stored energy
    than their surface absorbs: crushing under pressure, or a time step too long for the opening of fast cracks.
    Facets of cells without cohesion are not counted.

    Attributes:
        region: region or pair of regions of the criterion; None for a criterion of the whole model.
        area: own area of the facets, or of the sections of the beams [m²].
        dissipated: energy dissipated by these facets or beams [J].
        crushed: part of `dissipated` beyond the fracture energy [J].
        entered: mean energy that fracture can absorb per own area [J/m²]; NaN for brittle bonds or without breakage.
    """

    region: Region | tuple[Region, Region] | None
    area: float
    dissipated: float
    crushed: float
    entered: float

    @property
    def per_area(self) -> float:
        """Energy dissipated over the area [J/m²]; NaN if nothing has broken."""
        return self.dissipated / self.area if self.area > 0.0 else math.nan

    @property
    def ratio(self) -> float:
        """Energy dissipated over the fracture energy of `area` [-]; NaN without breakage, or for brittle bonds."""
        return self.per_area / self.entered

    @property
    def fractured(self) -> float:
        """Energy dissipated without crushing over the fracture energy of `area`, up to 1 [-]; NaN like `ratio`."""
        return self.ratio - self.crushed / (self.area * self.entered) if self.area > 0.0 else math.nan


def fracture_energies(state: State) -> tuple[FractureEnergy, ...]:
    """Return the energy that broken bonds or facets have dissipated, for each criterion of `failure=` in its order.

    All broken bonds of the state count, also those of earlier runs. The result is empty without a criterion.
    """
    model = cast(Model, state.model)
    broken, dissipated, absorbed = _broken(model, state)
    bond = model.layout.bond_order[broken]
    area = model.lattice.elements.bond_area(model.stiffness.radius)[bond]
    parts = model.failure_parts
    of_bond = np.zeros(len(state.integrity), dtype=np.int64)
    for number, part in enumerate(parts):
        of_bond[part.bonds] = number
        if part.open:
            absorbed[np.isin(bond, part.bonds)] = np.inf
    crushed = np.maximum(dissipated - absorbed, 0.0)
    each = [np.bincount(of_bond[bond], one, len(parts)) for one in (area, dissipated, crushed, absorbed)]
    regions = tuple(model.failure) if isinstance(model.failure, dict) else (None,)
    return tuple(
        FractureEnergy(where, *map(float, (A, spent, beyond, taken / A if A > 0.0 and taken < np.inf else np.nan)))
        for _, where, A, spent, beyond, taken in zip(parts, regions, *each, strict=False)
    )


def _broken(model: Model, state: State) -> tuple[Ints, Floats, Floats]:
    """Return internal numbers of broken bonds, dissipated energy and energy that fracture can absorb [J], (b,) each.

    Brittle bonds can absorb an infinite energy, so that none of their energy counts as crushing.
    """
    if model.softening is not None:
        rows, absorbed = state.cracks, model.softening.absorbed_by(state.cracks)
        number, spent, chosen = rows[:, FACET], rows[:, SPENT], rows[:, ONSET] > 0.0
    elif model.beam_softening is not None:
        rows, absorbed = state.softened, model.beam_softening.absorbed(state.softened)
        number, spent, chosen = rows[:, SoftColumn.BOND], rows[:, SoftColumn.SPENT], np.ones(len(rows), dtype=bool)
    else:
        rows = state.broken
        number, spent, chosen = rows[:, EventColumn.BOND], rows[:, EventColumn.ENERGY], np.ones(len(rows), dtype=bool)
        absorbed = np.full(len(rows), np.inf)
    bond = number.astype(np.int64)
    chosen = chosen & (state.integrity[bond] == 0.0)
    return bond[chosen], spent[chosen], absorbed[chosen]
