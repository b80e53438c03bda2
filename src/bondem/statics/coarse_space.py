"""A coarse twin of a lattice: elements gathered in clumps that move as rigid bodies.

Slow bending and stretching of the whole are invisible to an element and its neighbours; the clumps represent them.
The stiffness of the clumps is that of the lattice restricted to motions that are rigid clump by clump, and small
enough to be eliminated. Together with the elements' own blocks it preconditions conjugate gradients (two-level
additive Schwarz with a Nicolaides coarse space). The number of iterations then hardly grows with the lattice.
"""

import math
from functools import cached_property

import numpy as np
from scipy.sparse import bsr_array, coo_array, csc_array, dia_array
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import SuperLU, splu

from bondem._types import Floats, Ints, Mask, PerBond, PerElement3
from bondem.interactions.stiffness import Stiffness
from bondem.statics.lanczos import lowest_modes

# Elements a clump at 10 000 elements; it grows with the root of n, so that elimination stays a small part.
_CLUMP = 25.0
# Keeps the coarse matrix regular where a clump has fewer than six motions of its own.
_REGULAR = 1e-9
# A bond that has lost more of its stiffness joins nothing.
_LOST = 0.5


def clump_of(position: PerElement3) -> Ints:
    """Return the clump of each element: cubes of a grid that hold about the same number each, shape (n,)."""
    n = len(position)
    lower = position.min(axis=0)
    extent = np.maximum(np.ptp(position, axis=0), 1e-300)
    clumps = max(n / (_CLUMP * math.sqrt(max(n, 100) / 1e4)), 1.0)
    # the edge for which a grid over the bounding box, thin directions rounded up, has that many cubes
    edge = float(extent.max())
    for _ in range(60):
        if np.maximum(extent / edge, 1.0).prod() >= clumps:
            break
        edge *= 0.9
    cells = np.maximum(np.rint(extent / edge), 1.0)
    cell = np.minimum(((position - lower) / extent * cells).astype(np.int64), cells.astype(np.int64) - 1)
    return np.unique(np.ravel_multi_index(tuple(cell.T), tuple(cells.astype(int))), return_inverse=True)[1]


def parted(clump: Ints, position: PerElement3, i: Ints, j: Ints, lost: PerBond) -> Ints:
    """Return clumps that do not reach across cracks, (n,), which more than halves the iterations on a cracked body.

    Elements that are not joined by a bond with half its stiffness are put into different clumps. A clump that remains
    joined, but by some bonds that have lost stiffness, is cut by a plane through their mean place, across their
    direction.

    Args:
        clump: clump of each element, (n,).
        position: positions of the elements [m], (n, 3).
        i, j: elements on both sides of a bond, (m,) each.
        lost: share of its stiffness that a bond has lost, (m,).
    """
    clump = _joined(clump, i, j, lost <= _LOST)
    weak = np.flatnonzero((clump[i] == clump[j]) & (lost > 0.0))
    across = position[j[weak]] - position[i[weak]]
    across *= np.sqrt(lost[weak] / (across**2).sum(axis=1))[:, None]
    count = int(clump.max()) + 1
    own, weight = clump[i[weak]], lost[weak]
    total = np.bincount(own, weight, count)
    cut = total > 0.0
    middle, fabric = np.zeros((count, 3)), np.zeros((count, 3, 3))
    np.add.at(middle, own, weight[:, None] * 0.5 * (position[i[weak]] + position[j[weak]]))
    np.add.at(fabric, own, across[:, :, None] * across[:, None, :])
    middle[cut] /= total[cut, None]
    normal = np.linalg.eigh(fabric)[1][:, :, 2]
    beyond = cut[clump] & (np.einsum("nk,nk->n", position - middle[clump], normal[clump]) > 0.0)
    return np.unique(2 * clump + beyond, return_inverse=True)[1]


def _joined(clump: Ints, i: Ints, j: Ints, bonds: Mask) -> Ints:
    """Return the parts of clumps joined by some of the bonds, (n,)."""
    inside = np.flatnonzero(bonds & (clump[i] == clump[j]))
    joined = coo_array((np.ones(len(inside)), (i[inside], j[inside])), shape=(len(clump), len(clump)))
    return connected_components(joined, directed=False)[1].astype(np.int64)


def clump_motions(position: PerElement3, clump: Ints) -> Floats:
    """Return the motion (u, R θ) of each element per motion of its clump about the clump's centre, shape (n, 6, 6).

    Rotations of a clump are scaled by the root mean square R of its arms, so that all six are displacements.
    """
    count = np.bincount(clump)
    centre = np.stack([np.bincount(clump, weights=x) / count for x in position.T], axis=1)
    arm = position - centre[clump]
    motions = np.zeros((len(position), 6, 6))
    motions[:, range(6), range(6)] = 1.0
    motions[:, [1, 2, 0], [5, 3, 4]] = arm[:, [0, 1, 2]]
    motions[:, [2, 0, 1], [4, 5, 3]] = -arm[:, [0, 1, 2]]
    return motions


class Clumps:
    """The coarse correction P (Pᵀ K P)⁻¹ Pᵀ.

    Args:
        matrix: symmetric, positive (semi-)definite matrix, 6×6 blocks.
        basis: motion of each element per motion of its clump, in the unknowns of the matrix, shape (n, 6, 6).
        clump: clump of each element, shape (n,).
    """

    def __init__(self, matrix: Stiffness, basis: Floats, clump: Ints) -> None:
        n, count = len(clump), int(clump.max()) + 1
        self._size = 6 * count
        self.prolongation = bsr_array((basis, clump, np.arange(n + 1)), shape=(6 * n, self._size))
        self.restriction = self.prolongation.T.tobsr((6, 6))
        self.matrix = matrix.projected(self.prolongation)
        diagonal = self.matrix.diagonal()
        # motions that do not exist (all held) get a number of their own
        extra = np.where(diagonal > 1e-12 * diagonal.max(), _REGULAR * diagonal, diagonal.max())
        self.regular = csc_array(self.matrix + dia_array((extra[None], [0]), shape=self.matrix.shape))

    @cached_property
    def _factors(self) -> SuperLU:
        return splu(
            self.regular, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )

    def __call__(self, residual: Floats) -> Floats:
        """Return the correction for a residual, shape (6 n,) or (6 n, k)."""
        return self.prolongation @ self._factors.solve(np.asfortranarray(self.restriction @ residual))

    def modes(self, mass: bsr_array, count: int) -> Floats:
        """Return the lowest modes of the pencil (matrix, mass) among motions of clumps, (6 n, count) or fewer."""
        coarse = csc_array((self.restriction @ (mass @ self.prolongation)).tocsc())
        start = coarse @ np.random.default_rng(0).standard_normal(self._size)
        solve = self._factors.solve
        return self.prolongation @ lowest_modes(
            self.matrix, solve, start, mass=coarse, count=min(count, self._size - 1), tolerance=1e-3
        )[1]
