"""Load factors at which facets begin to crack or soften further, if everything is proportional to the factor."""

from typing import Protocol

import numpy as np

from bondem._tables.stress_onset_tables import SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.failure_passes import traction_indices
from bondem.damage.failure_table import FailureTable
from bondem.damage.proportional_onset import onset_factors, softening_along
from bondem.damage.softening_table import SofteningTable
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth


class FacetOnset(Protocol):
    """Onset of failure of whole facets, and their softening."""

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Return the facets of `whole` that begin below a factor and the first one, and their factors, (c,) each.

        Args:
            found: loads of the facets.
            whole: facets that have not failed.
            below: largest factor of interest.
            close: distance above the least of their factors, as a share.
        """
        ...

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """Return the softening steps of facet k that begins to fail at a load factor."""
        ...

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return load factors at which facets that have lost integrity soften further by their curve, (c,).

        Args:
            found: loads of the facets.
            facets: facets that have lost some of their integrity, (c,).
            traction: traction of these, as if they were whole [Pa], (c, 3).
        """
        ...


class TractionOnset:
    """Facets that break at once by their own traction (`bd.MohrCoulomb` without a fracture energy)."""

    def __init__(self, body: DamagedBody, table: FailureTable) -> None:
        self._body, self._table = body, table

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        index = traction_indices(self._body.weakened.normal, found.traction, self._body.area, self._table)[whole]
        reached = np.divide(1.0, index, out=np.full(len(whole), np.inf), where=index > 0.0)
        least = min(below, float(reached.min(initial=np.inf)) * (1.0 + close))
        near = reached <= least
        return whole[near], reached[near]

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`."""
        return Teeth.of(SofteningLine(1.0, 0.0), ripple)

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """See `FacetOnset`."""
        return np.full(len(facets), np.inf)


class StressOnset:
    """Onset of facets by the stress of their cells, and of those of material planes by their own traction.

    A facet of the material begins to crack if three conditions hold (`bd.Rankine`): σ1(σ*) reaches the strength, the
    facet is in tension or shear, and its opening along a principal direction is enough for softening.
    """

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._curve = body, (table.kink, table.steep)
        self._strengths = table.strengths()

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        factor = onset_factors(self._body.facets(found), self._strengths, whole, below, 1.0 + close)
        near = factor <= min(below, float(factor.min(initial=np.inf)) * (1.0 + close))
        return whole[near], factor[near]

    def along(self, found: Loaded, facets: Ints, traction: Floats) -> SofteningSearch:
        """Return the components of tractions (c, 3) that open facets along the directions of their criterion."""
        body = self._body
        return softening_along(body.facets(found), self._strengths, facets, traction, body.integrity[facets])

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`; the steps are along the direction in which the facet begins."""
        opened = self.along(found, np.array([k]), found.traction[k : k + 1])
        traction, onset, last = opened.line[0, opened.factor[0].argmin()].tolist()
        return Teeth.of(SofteningLine(onset, last, *self._curve), ripple, factor * traction)

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """See `FacetOnset`."""
        opened = self.along(found, facets, traction)
        return np.minimum(opened.factor.min(axis=1), opened.ended)
