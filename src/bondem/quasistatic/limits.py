"""At which load factor a facet begins to crack or goes on, where everything is proportional to it."""

import math
from typing import Protocol

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.kernels.stressed_facets import StressedFacets, stress_factors
from bondem.model.failure_table import FailureTable
from bondem.model.softening_table import SofteningTable
from bondem.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.quasistatic.teeth import SofteningLine, Teeth
from bondem.quasistatic.tensors import agreed, full_tensor, largest

# By what share factors of the closed form may be off.
_NEAR = 1e-5
# Least share of its strength that a facet begins with (`bondem.kernels.crack_list`).
_LEAST = 0.02


class FacetOnset(Protocol):
    """When whole facets begin to fail, and how they go on."""

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Facets of `whole` with their load factors, (c,) each: all that begin below a factor, and below the first.

        Args:
            found: what they bear.
            whole: facets that have not failed.
            below: that factor.
            close: how far above the least of theirs, as a share.
        """
        ...

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """How facet k goes on that begins at a load factor."""
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


class StressOnset:
    """When whole facets begin to crack: σ1(σ*) reaches the strength, they are pulled or sheared (`bd.Rankine`)."""

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._table, self._strength = body, table, table.strength

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        body, about = self._body, np.empty(len(whole))
        judged = StressedFacets(
            body.i, body.j, body.constants.normal, found.traction, found.bending, found.tensor
        )
        stress_factors(judged, self._strength, whole, below, (1.0 + close) * (1.0 + _NEAR), about)
        least = min(below, float(about.min(initial=np.inf)) * (1.0 + close))
        some = whole[about <= least * (1.0 + _NEAR)]
        return some, self._reached(found, some)

    def _reached(self, found: Loaded, facets: Ints) -> Floats:
        """Load factors at which some facets begin, inf for never, (c,)."""
        body = self._body
        mean, bent = body.mean(found.tensor, facets).T, body.bent(found.tensor, found.bending, facets)
        n, t = body.constants.normal[facets].T, found.traction[facets].T
        across, f = (t * n).sum(axis=0), self._strength[facets]
        shear = (t * t).sum(axis=0) - across**2
        pulled = np.where(bent > 0.0, bent + np.maximum(across, 0.0), across)
        high = largest(agreed(mean, n, t + (pulled - across) * n))
        reached = np.divide(f, high, out=np.full(len(f), np.inf), where=high > 0.0)
        return np.where(pulled > 0.0, reached, np.maximum(reached, _sheared_at(pulled, shear, f)))

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`: from the traction of `bondem.laws.softening` on."""
        body, n, t = self._body, self._body.constants.normal[k], factor * found.traction[k]
        alone = np.array([k])
        mean = factor * full_tensor(body.mean(found.tensor, alone)[0])
        bent = factor * float(body.bent(found.tensor, found.bending, alone)[0])
        along = max(float(n @ mean @ n), 0.0)
        direction = np.linalg.eigh(mean + max(bent - along, 0.0) * np.outer(n, n))[1][:, 2]
        opening = t - min(float(t @ n), 0.0) * n
        now = math.hypot(float(np.linalg.norm(opening)), bent)
        begun = min(now, float(self._strength[k]) * max(abs(float(n @ direction)), _LEAST))
        return Teeth.of(
            SofteningLine(begun, float(self._table.last[k]), self._table.kink, self._table.steep), ripple, now
        )


def _sheared_at(across: Floats, shear: Floats, strength: PerBond) -> Floats:
    """The factor at which a pressed traction t has σ1 = f by itself, t_s² = f (f - t_n); `shear` is t_s²."""
    bears = shear > 0.0
    root = strength * (np.sqrt(across**2 + 4.0 * np.maximum(shear, 0.0)) - across)
    return np.where(bears, root / np.where(bears, 2.0 * shear, 1.0), np.inf)
