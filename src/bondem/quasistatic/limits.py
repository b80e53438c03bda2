"""At which load factor a facet begins to crack or goes on, where everything is proportional to it."""

import math
from typing import Protocol

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.model.failure_table import FailureTable
from bondem.model.softening_table import SofteningTable
from bondem.quasistatic.damaged_body import DamagedBody, Loaded, full_tensor
from bondem.quasistatic.teeth import Teeth

# Facets that are looked at first, those whose bound is the least; then twice as many, and so on.
_FIRST = 256
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
        return Teeth.of(1.0, 0.0, ripple)


class StressOnset:
    """When whole facets begin to crack: σ1(σ*) reaches the strength, they are pulled or sheared (`bd.Rankine`)."""

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._strength, self._last = body, table.strength, table.last

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """See `FacetOnset`."""
        body, tensor = self._body, found.tensor
        size = np.sqrt((tensor[:, :3] ** 2).sum(axis=1) + 2.0 * (tensor[:, 3:] ** 2).sum(axis=1))
        # bending adds to the traction at most
        square = (np.linalg.norm(found.traction[whole], axis=1) + found.bending[whole]) ** 2
        # no eigenvalue of σ* is beyond |σ̄| + √2 |t - σ̄ n|
        most = 0.5 * (1.0 + np.sqrt(2.0)) * (size[body.i[whole]] + size[body.j[whole]]) + np.sqrt(2.0 * square)
        bound = self._strength[whole] / np.maximum(most, 1e-300)
        order = np.argsort(bound)
        kept: list[Ints] = []
        factor: list[Floats] = []
        first, count = 0, _FIRST
        while first < len(order) and bound[order[first]] < below:
            some, reached = self._below(found, whole[order[first : first + count]], below)
            if len(some):
                kept.append(some)
                factor.append(reached)
                below = min(below, float(reached.min()) * (1.0 + close))
            first, count = first + count, 2 * count
        if not kept:
            return whole[:0], np.zeros(0)
        return np.concatenate(kept), np.concatenate(factor)

    def _below(self, found: Loaded, facets: Ints, below: float) -> tuple[Ints, Floats]:
        """Those of some facets that may begin below a load factor, and their factors, (c,) each; inf for never."""
        body, n, t = self._body, self._body.constants.normal[facets], found.traction[facets]
        bent, across = body.bent(found.tensor, found.bending[facets], facets), (t * n).sum(axis=1)
        pulled = np.where(bent > 0.0, bent + np.maximum(across, 0.0), across)
        t = t + (pulled - across)[:, None] * n
        star = agreed(full_tensor(0.5 * (found.tensor[body.i[facets]] + found.tensor[body.j[facets]])), n, t)
        near = np.flatnonzero(self._strength[facets] <= below * np.sqrt(np.einsum("mab,mab->m", star, star)))
        facets, n, t = facets[near], n[near], t[near]
        f, across, square = self._strength[facets], (t * n).sum(axis=1), (t * t).sum(axis=1)
        high = np.linalg.eigvalsh(star[near])[:, 2]
        reached = np.where(high > 0.0, f / np.where(high > 0.0, high, 1.0), np.inf)
        alone = _sheared_at(across, square - across**2, f)
        return facets, np.where(across > 0.0, reached, np.maximum(reached, alone))

    def teeth(self, found: Loaded, k: int, factor: float, ripple: float) -> Teeth:
        """See `FacetOnset`: from the traction of `bondem.laws.softening` on."""
        body, n, t = self._body, self._body.constants.normal[k], factor * found.traction[k]
        mean = full_tensor(0.5 * factor * (found.tensor[body.i[k]] + found.tensor[body.j[k]]))
        bent = factor * float(body.bent(found.tensor, found.bending[[k]], np.array([k]))[0])
        along = max(float(n @ mean @ n), 0.0)
        direction = np.linalg.eigh(mean + max(bent - along, 0.0) * np.outer(n, n))[1][:, 2]
        opening = t - min(float(t @ n), 0.0) * n
        now = math.hypot(float(np.linalg.norm(opening)), bent)
        begun = min(now, float(self._strength[k]) * max(abs(float(n @ direction)), _LEAST))
        return Teeth.of(begun, float(self._last[k]), ripple, now)


def agreed(mean: Floats, n: Floats, t: Floats) -> Floats:
    """σ*: mean tensors (…, 3, 3) made to agree with the tractions t on facets of normals n, (…, 3)."""
    off = t - np.einsum("mab,mb->ma", mean, n)
    both = off[:, :, None] * n[:, None, :]
    along = (off * n).sum(axis=1)[:, None, None]
    return mean + both + np.swapaxes(both, 1, 2) - along * n[:, :, None] * n[:, None, :]


def _sheared_at(across: Floats, shear: Floats, strength: PerBond) -> Floats:
    """The factor at which a pressed traction t has σ1 = f by itself, t_s² = f (f - t_n); `shear` is t_s²."""
    bears = shear > 0.0
    root = strength * (np.sqrt(across**2 + 4.0 * np.maximum(shear, 0.0)) - across)
    return np.where(bears, root / np.where(bears, 2.0 * shear, 1.0), np.inf)
