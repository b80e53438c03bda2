"""Load factors at which facets begin to crack or soften further, if all loads are proportional to the factor."""

from typing import Protocol

import numpy as np

from bondem._tables.stress_onset_tables import SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.failure_table import FailureTable
from bondem.damage.proportional_onset import onset_factors, softening_along
from bondem.damage.softening_table import SofteningTable
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth


class FacetOnset(Protocol):
    """Interface of criteria for the onset of failure of uncracked facets, and for their softening."""

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Return the facets of `whole` that begin to fail first, and their load factors, (c,) each.

        Args:
            found: loads of the facets.
            whole: numbers of uncracked facets, (k,).
            below: largest factor of interest [-].
            close: largest distance of factors above the least one, as a share of it [-].
        """
        ...

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """Return the softening steps of facet k, which begins to fail at the load factor `factor`.

        `ripple` is the half-width of the band of the steps, as a share of the traction [-].
        """
        ...

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return the load factors at which cracked facets soften further along their curve [-], (c,).

        Args:
            found: loads of the facets.
            facets: numbers of the cracked facets, (c,).
            traction: traction of these facets as if they had full integrity [Pa], (c, 3).
        """
        ...


class TractionOnset:
    """Onset of facets that break at once by their own traction (`bd.MohrCoulomb` without a fracture energy)."""

    def __init__(self, body: DamagedBody, table: FailureTable) -> None:
        self._body, self._table = body, table

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Return the facets that begin to fail first, and their factors; see `FacetOnset.factors`."""
        index = self._table.traction_indices(self._body.weakened.normal, found.traction, self._body.area)[whole]
        reached = np.divide(1.0, index, out=np.full(len(whole), np.inf), where=index > 0.0)
        least = min(below, float(reached.min(initial=np.inf)) * (1.0 + close))
        near = reached <= least
        return whole[near], reached[near]

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """Return the only step of facet k, which loses all of its integrity."""
        return Teeth.of(SofteningLine(1.0, 0.0), ripple)

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return infinite factors, (c,), because facets break at once."""
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
        """Return the facets that begin to fail first, and their factors; see `FacetOnset.factors`."""
        factor = onset_factors(self._body.facets(found), self._strengths, whole, below, 1.0 + close)
        near = factor <= min(below, float(factor.min(initial=np.inf)) * (1.0 + close))
        return whole[near], factor[near]

    def along(self, found: Loaded, facets: Ints, traction: Floats) -> SofteningSearch:
        """Return `softening_along` of facets for tractions as if they had full integrity [Pa], (c, 3)."""
        body = self._body
        return softening_along(body.facets(found), self._strengths, facets, traction, body.integrity[facets])

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """Return the softening steps of facet k along the direction in which it begins; see `FacetOnset`."""
        opened = self.along(found, np.array([k]), found.traction[k : k + 1])
        traction, onset, last = opened.line[0, opened.factor[0].argmin()].tolist()
        return Teeth.of(SofteningLine(onset, last, *self._curve), ripple, factor * traction)

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return the load factors of further softening along any direction, (c,); see `FacetOnset.again`."""
        opened = self.along(found, facets, traction)
        return np.minimum(opened.factor.min(axis=1), opened.ended)
