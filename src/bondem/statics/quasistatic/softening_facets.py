"""Facets that soften in steps: load factor of the next step of each facet, and its integrity after the step."""

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.onset import FacetOnset
from bondem.statics.quasistatic.sawtooth import Teeth


class SofteningFacets:
    """Facets of a body that soften, each along its own steps.

    Args:
        body: the body.
        onset: criterion of its facets.
        ripple: half-width of the band of the steps, as a share of the traction [-].
    """

    def __init__(self, body: DamagedBody, onset: FacetOnset, ripple: float) -> None:
        self._body, self._onset, self._ripple = body, onset, ripple
        self._teeth: dict[int, tuple[Teeth, int]] = {}
        # load at the next event of each facet over that of its curve, inf for none
        self._following = np.full(len(body.integrity), np.inf)

    def limits(self, found: Loaded) -> PerBond:
        """Return the load factors of the next events of cracked facets [-], (c,)."""
        following, one = self._following[found.cracked], self._body.in_one[found.cracked]
        limit, going = np.full(len(found.cracked), np.inf), np.isfinite(following)
        limit[going] = following[going] * self._onset.again(found, found.cracked[going], found.opening[going])
        limit[one] = np.minimum(limit[one], self._onset.beside(found, found.cracked[one], found.opening[one]))
        return limit

    def fail(self, found: Loaded, facets: Ints, factor: float) -> tuple[Floats, Floats]:
        """Return the integrities (c,) and the directions (c, 3) of facets after an event at a load factor.

        Directions are those of `DamagedBody.across`. A facet that softens in one direction, and cracks across another
        one, softens in all from then on.
        """
        left, across = self._body.integrity[facets], self._body.across[facets]
        for place, k in enumerate(facets.tolist()):
            one = facets[place : place + 1]
            if k not in self._teeth:
                self._teeth[k] = self._onset.teeth(found, k, factor, self._ripple), 0
                across[place] = self._onset.across(found, one)[0]
            elif across[place].any() and self._cracks_beside(found, one):
                across[place] = 0.0
                continue
            teeth, done = self._teeth[k]
            self._teeth[k] = teeth, done + 1
            self._following[k] = teeth.beyond[done] if done < len(teeth.beyond) else np.inf
            left[place] = teeth.integrity[done]
        return left, across

    def _cracks_beside(self, found: Loaded, one: Ints) -> bool:
        """Return True if the next event of a facet is a crack across another direction than its own."""
        opening = found.opening[found.cracked == one]
        along = self._following[one] * self._onset.again(found, one, opening)
        return bool(self._onset.beside(found, one, opening)[0] < along[0])
