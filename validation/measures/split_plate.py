"""A square plate split between two strips as a continuum with one cohesive crack along its axis of load.

One quarter in plane stress, by bilinear finite elements. The strips are rigid and smooth. The crack begins at the
centre; the place of its tip is the control (Petersson 1981), so that snap-back does no harm. It softens along a
straight line of last opening 2 G_f/f_t.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.linalg import splu

from bondem._types import Floats
from validation.measures.cohesive_crack import quad

_ROUNDS = 100


@dataclass(frozen=True)
class SplitPlate:
    """Loads of a plate, an entry for each place of the crack's tip.

    Attributes:
        stress: 2 P / (π D t) over f_t [-], (k,).
        elastic: the same as the first facet cracks, by elasticity alone [-].
    """

    stress: Floats
    elastic: float

    @property
    def peak(self) -> float:
        """First maximum of the stress [-]; the largest where it has none."""
        rising = np.flatnonzero((self.stress[1:-1] >= self.stress[:-2]) & (self.stress[1:-1] > self.stress[2:]))
        return float(self.stress[rising[0] + 1] if rising.size else self.stress.max())


def split_plate(length: float, strip: float, nu: float, across: int = 50) -> SplitPlate:
    """Path of a plate of edge 1, strength 1 and E G_f / f_t² of a given length.

    Args:
        length: E G_f / f_t² over the edge [-].
        strip: width of the strips over the edge [-].
        nu: Poisson's ratio [-].
        across: elements across a quarter, along each axis.
    """
    K = _condensed(strip, nu, across)
    area = np.full(across + 1, 0.5 / across)
    area[0] = area[-1] = 0.25 / across
    last, E = 2.0 * length, 1.0  # in units of f_t/E
    stress = []
    for tip in range(across):
        broken = np.zeros(tip, dtype=bool)
        for _ in range(_ROUNDS):
            # unknown: half openings above the centre, and how far the strip moves; the tip is closed and carries f_t
            moved = np.append(np.arange(tip), across + 1)
            A = K[np.ix_(np.arange(tip + 1), moved)].copy()
            slope = np.where(broken, 0.0, 2.0 * E / last)
            A[np.arange(tip), np.arange(tip)] -= slope * area[:tip]
            right = -area[: tip + 1] * np.append(np.where(broken, 0.0, 1.0), 1.0)
            found = np.linalg.solve(A, right)
            now = 2.0 * found[:tip] > last
            if (now == broken).all():
                break
            broken = now
        force = 2.0 * abs(float(K[-1, moved] @ found))
        stress.append(2.0 * force / np.pi)
    return SplitPlate(np.array(stress), stress[0])


def _condensed(strip: float, nu: float, across: int) -> Floats:
    """Stiffness of the crack's nodes along x, from the centre, and of the strip along y, last; E = t = 1."""
    at = np.linspace(0.0, 0.5, across + 1)
    number = np.arange((across + 1) ** 2).reshape(across + 1, across + 1)  # x, y
    corner = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
    side = np.full(len(corner), 0.5 / across)
    block = quad(side, side, 1.0, nu, 1.0)
    dof = (2 * corner[:, :, None] + np.arange(2)).reshape(-1, 8)
    size = 2 * number.size
    under = 2 * number[at <= 0.5 * strip + 1e-9, -1] + 1
    new = np.full(size, -1)
    free = np.setdiff1d(np.arange(size), under)
    new[free], new[under] = np.arange(len(free)), len(free)
    own = new[dof]
    i, j = np.broadcast_to(own[:, :, None], block.shape), np.broadcast_to(own[:, None, :], block.shape)
    whole: Any = coo_array((block.ravel(), (i.ravel(), j.ravel())), shape=(len(free) + 1, len(free) + 1)).tocsc()
    crack, held = new[2 * number[0]], new[2 * number[:, 0] + 1]
    kept = np.append(crack, len(free))
    inner = np.setdiff1d(np.arange(len(free) + 1), np.append(kept, held))
    mixed = whole[:, kept][inner].toarray()
    return whole[:, kept][kept].toarray() - mixed.T @ splu(whole[:, inner][inner]).solve(mixed)
