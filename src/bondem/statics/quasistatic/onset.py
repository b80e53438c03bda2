"""Load factors at which facets begin to crack or soften further, if all loads are proportional to the factor."""

import math
from typing import Protocol

import numpy as np

from bondem._tables.stress_onset_tables import SofteningSearch
from bondem._types import Floats, Ints, PerBond
from bondem.damage.failure_table import FailureTable
from bondem.damage.proportional_onset import onset_factors, softening_along
from bondem.damage.softening_table import SofteningTable
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.pressed_cracks import pressed_along
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth

_NEAR = math.sqrt(0.5)  # least cosine between the directions of facets of one crack


class FacetOnset(Protocol):
    """Interface of criteria for the onset of failure of uncracked facets, and for their softening.

    Attributes:
        strength: tensile strengths of the facets [Pa], inf for those that do not soften, (m,).
    """

    strength: PerBond

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

    def across(self, found: Loaded, facets: Ints) -> Floats:
        """Return the only direction in which each facet that begins to fail softens, zero if in all, (c, 3)."""
        ...

    def beside(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return the load factors at which facets that soften in one direction crack in another one [-], (c,).

        The arguments are those of `again`.
        """
        ...


class TractionOnset:
    """Onset of facets that break at once by their own traction (`bd.MohrCoulomb` without a fracture energy)."""

    def __init__(self, body: DamagedBody, table: FailureTable) -> None:
        self._body, self._table, self.strength = body, table, np.full(len(body.integrity), np.inf)

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

    def across(self, found: Loaded, facets: Ints) -> Floats:
        """Return zeros, (c, 3): facets break in all directions."""
        return np.zeros((len(facets), 3))

    beside = again


class StressOnset:
    """Onset of facets by the stress of their cells, and of those of material planes by their own traction.

    A facet of the material begins to crack if σ1 of the stress σ* of `bd.Rankine` reaches the strength, the facet is
    in tension or shear, and its opening along a principal direction is enough for softening. A facet under a pressure
    along its crack softens in one direction alone, so that the pressure remains (`pressed_cracks`).
    """

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._curve = body, (table.kink, table.steep)
        self._strengths, self.strength = table.strengths(), table.strength

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Return the facets that begin to fail first, and their factors; see `FacetOnset.factors`."""
        factor = onset_factors(self._body.facets(found), self._strengths, whole, below, 1.0 + close)
        near = factor <= min(below, float(factor.min(initial=np.inf)) * (1.0 + close))
        return whole[near], factor[near]

    def along(self, found: Loaded, facets: Ints, traction: Floats) -> SofteningSearch:
        """Return factors and directions of softening of facets, for tractions at full integrity [Pa], (c, 3)."""
        body = self._body
        loaded, left, across = body.facets(found), body.integrity[facets], body.across[facets]
        return softening_along(loaded, self._strengths, facets, traction, left, across)

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """Return the softening steps of facet k along the direction in which it begins; see `FacetOnset`."""
        opened = self.along(found, np.array([k]), found.traction[k : k + 1])
        traction, onset, last = opened.line[0, opened.factor[0].argmin()].tolist()
        return Teeth.of(SofteningLine(onset, last, *self._curve), ripple, factor * traction)

    def again(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return the load factors of further softening along any direction, (c,); see `FacetOnset.again`."""
        opened = self.along(found, facets, traction)
        return np.minimum(opened.factor.min(axis=1), opened.ended)

    def across(self, found: Loaded, facets: Ints) -> Floats:
        """Return the direction of softening of facets under a pressure along their crack, else zero, (c, 3).

        A facet takes the direction of the most damaged crack of its two cells if its own is within 45° of that:
        facets of one crack with different directions would block each other.
        """
        body = self._body
        opened, traction = self.along(found, facets, found.traction[facets]), found.traction[facets]
        own = opened.direction[np.arange(len(facets)), opened.factor.argmin(axis=1)]
        own = np.sign((traction * own).sum(axis=1))[:, None] * own
        cracks = found.cracked[body.in_one[found.cracked]]
        for row, k in enumerate(facets):
            ends = (body.i[k], body.j[k])
            near = cracks[np.isin(body.i[cracks], ends) | np.isin(body.j[cracks], ends)]
            if len(near):
                leading = body.across[near[body.integrity[near].argmin()]]
                cosine = float(leading @ own[row])
                own[row] = math.copysign(1.0, cosine) * leading if abs(cosine) > _NEAR else own[row]
        pressed = pressed_along(body, found, facets) & (self._strengths.plane[facets] == 0.0)
        return np.where(pressed[:, None], own, 0.0)

    def beside(self, found: Loaded, facets: Ints, traction: Floats) -> PerBond:
        """Return the load factors at which facets crack in another direction, (c,); see `FacetOnset.beside`."""
        across = self._body.across[facets]
        rest = traction - (traction * across).sum(axis=1)[:, None] * across
        opened = softening_along(self._body.facets(found), self._strengths, facets, rest, np.ones(len(facets)))
        other = np.abs(np.einsum("cdx,cx->cd", opened.direction, across)) < _NEAR
        return np.where(other, opened.factor, np.inf).min(axis=1)
