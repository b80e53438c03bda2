"""Load factors at which facets begin to crack or soften further, if everything is proportional to the factor."""

from typing import Protocol

import numpy as np

from bondem._tables.quasistatic_tables import LoadedFacets
from bondem._types import Floats, Ints, PerBond
from bondem.damage.failure_table import FailureTable
from bondem.damage.opened_facets import Opened
from bondem.damage.softening_table import SofteningTable
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.facet_passes import factors_by_stress
from bondem.statics.quasistatic.sawtooth_softening import SofteningLine, Teeth
from bondem.statics.quasistatic.tensors import agreed, largest

# By what share factors of the closed form may be off.
_NEAR = 1e-5


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

    def again(self, found: Loaded) -> PerBond:
        """Return load factors at which facets that have lost integrity soften further by their curve, (c,)."""
        ...


class TractionOnset:
    """Facets that break at once by their own traction (`bd.MohrCoulomb` without a fracture energy)."""

    def __init__(self, body: DamagedBody, table: FailureTable) -> None:
        self._body, self._coefficient = body, table.coefficient

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        n, s = self._body.constants.normal[whole], self._coefficient[whole].T
        force = found.traction[whole] * self._body.area[whole, None]
        across = (force * n).sum(axis=1)
        along = np.sqrt(np.maximum((force**2).sum(axis=1) - across**2, 0.0))
        index = np.maximum(across * s[0], s[1] * (along + s[2] * across))
        reached = np.divide(1.0, index, out=np.full(len(whole), np.inf), where=index > 0.0)
        least = min(below, float(reached.min(initial=np.inf)) * (1.0 + close))
        near = reached <= least
        return whole[near], reached[near]

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`."""
        return Teeth.of(SofteningLine(1.0, 0.0), ripple)

    def again(self, found: Loaded) -> PerBond:
        """See `FacetOnset`."""
        return np.full(len(found.cracked), np.inf)


class StressOnset:
    """Onset of facets by the stress of their cells, and of those of material planes by their own traction.

    A facet of the material begins to crack if three conditions hold (`bd.Rankine`): σ1(σ*) reaches the strength, the
    facet is in tension or shear, and its opening along a principal direction is enough for softening.
    """

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._table, self._strength = body, table, table.strength

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        body, planes = self._body, whole[self._table.plane[whole]]
        inner = whole if not len(planes) else whole[~self._table.plane[whole]]
        own = np.zeros(0)
        if len(planes):
            own = self._opened(found, planes, found.traction[planes]).reached(np.ones(len(planes)))
        below = min(below, float(own.min(initial=np.inf)) * (1.0 + close))
        loaded = LoadedFacets(
            body.i, body.j, body.constants.normal, found.traction, found.bending, found.tensor, self._strength
        )
        about = factors_by_stress(loaded, inner, below, (1.0 + close) * (1.0 + _NEAR))
        least = min(below, float(about.min(initial=np.inf)) * (1.0 + close))
        some = inner[about <= least * (1.0 + _NEAR)]
        return np.concatenate([some, planes]), np.concatenate([self._reached(found, some), own])

    def _opened(self, found: Loaded, facets: Ints, traction: Floats) -> Opened:
        return self._body.opened(found, facets, traction, self._table)

    def _reached(self, found: Loaded, facets: Ints) -> Floats:
        """Return load factors at which some facets of the material begin, inf for never, (c,)."""
        body = self._body
        mean, bent = body.mean(found.tensor, facets).T, body.bent(found.tensor, found.bending, facets)
        n, t = body.constants.normal[facets].T, found.traction[facets].T
        across, f = (t * n).sum(axis=0), self._strength[facets]
        shear = (t * t).sum(axis=0) - across**2
        pulled = np.where(bent > 0.0, bent + np.maximum(across, 0.0), across)
        high = largest(agreed(mean, n, t + (pulled - across) * n))
        reached = np.divide(f, high, out=np.full(len(f), np.inf), where=high > 0.0)
        reached = np.where(pulled > 0.0, reached, np.maximum(reached, _sheared_at(pulled, shear, f)))
        return np.maximum(reached, self._opened(found, facets, t.T).reached(np.ones(len(facets))))

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`; the steps are along the direction in which the facet begins."""
        alone = np.array([k])
        opened = self._opened(found, alone, found.traction[alone])
        d = int(opened.steepest()[0])
        line = SofteningLine(
            float(opened.strength[0, d]), float(opened.last[0, d]), self._table.kink, self._table.steep
        )
        return Teeth.of(line, ripple, factor * float(opened.traction[0, d]))

    def again(self, found: Loaded) -> PerBond:
        """See `FacetOnset`."""
        opened = self._opened(found, found.cracked, found.opening)
        return opened.reached(self._body.integrity[found.cracked])


def _sheared_at(across: Floats, shear: Floats, strength: PerBond) -> Floats:
    """Return the factor at which a compressive traction t has σ1 = f, t_s² = f (f - t_n); `shear` is t_s²."""
    bears = shear > 0.0
    root = strength * (np.sqrt(across**2 + 4.0 * np.maximum(shear, 0.0)) - across)
    return np.where(bears, root / np.where(bears, 2.0 * shear, 1.0), np.inf)
