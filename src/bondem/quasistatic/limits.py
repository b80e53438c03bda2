"""At which load factor a facet begins to crack or goes on, where everything is proportional to it."""

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.model.softening_table import SofteningTable
from bondem.quasistatic.damaged_body import DamagedBody, Loaded

# Facets that are looked at first, those whose bound is the least.
_FIRST = 64
# Least share of its strength that a facet begins with (`bondem.kernels.crack_list`).
_LEAST = 0.02


def full_tensor(s: Floats) -> Floats:
    """(…, 3, 3) of xx, yy, zz, xy, xz, yz."""
    return s[..., [[0, 3, 4], [3, 1, 5], [4, 5, 2]]]


class FacetOnset:
    """When whole facets begin to crack: σ1(σ*) reaches the strength, they are pulled or sheared (`bd.Rankine`)."""

    def __init__(self, body: DamagedBody, table: SofteningTable) -> None:
        self._body, self._strength = body, table.strength

    def factors(self, found: Loaded, whole: Ints, below: float, close: float) -> tuple[Ints, Floats]:
        """Facets of `whole` with their load factors, (c,) each: all that begin below a factor, and below the first.

        Args:
            found: what they bear.
            whole: facets that have not cracked.
            below: that factor.
            close: how far above the least of theirs, as a share.
        """
        n, t, f = self._body.constants.normal[whole], found.traction[whole], self._strength[whole]
        across, square = (t * n).sum(axis=1), (t * t).sum(axis=1)
        mean = full_tensor(0.5 * (found.tensor[self._body.i[whole]] + found.tensor[self._body.j[whole]]))
        star = agreed(mean, n, t)
        # no eigenvalue is beyond the norm
        bound = f / np.maximum(np.sqrt(np.einsum("mab,mab->m", star, star)), 1e-300)
        alone = _sheared_at(across, square - across**2, f)
        bound = np.where(across > 0.0, bound, np.maximum(bound, alone))
        order = np.argsort(bound, kind="stable")
        kept: list[Ints] = []
        factor: list[Floats] = []
        first = 0
        while first < len(order) and bound[order[first]] < below:
            some = order[first : first + _FIRST]
            high = np.linalg.eigvalsh(star[some])[:, 2]
            reached = np.where(high > 0.0, f[some] / np.where(high > 0.0, high, 1.0), np.inf)
            reached = np.where(across[some] > 0.0, reached, np.maximum(reached, alone[some]))
            kept.append(whole[some])
            factor.append(reached)
            below = min(below, float(reached.min()) * (1.0 + close))
            first += _FIRST
        if not kept:
            return whole[:0], np.zeros(0)
        return np.concatenate(kept), np.concatenate(factor)

    def traction(self, found: Loaded, k: int, factor: float) -> tuple[float, float]:
        """The traction from which a facet softens that begins at a load factor, and |F⁺| / A then [Pa].

        See `bondem.laws.softening`.
        """
        n, t = self._body.constants.normal[k], factor * found.traction[k]
        mean = full_tensor(0.5 * factor * (found.tensor[self._body.i[k]] + found.tensor[self._body.j[k]]))
        direction = np.linalg.eigh(mean)[1][:, 2]
        opening = t - min(float(t @ n), 0.0) * n
        now = float(np.linalg.norm(opening))
        return min(now, float(self._strength[k]) * max(abs(float(n @ direction)), _LEAST)), now


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
