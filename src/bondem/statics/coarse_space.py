"""Coarse space of a lattice: clusters of elements (`Clumps`), each of which moves as a rigid body.

Motions of clusters represent the slow bending and stretching of the lattice, which an element and its neighbours do
not determine. The stiffness of the lattice restricted to these motions is small enough to be eliminated. Together
with the elements' own blocks it preconditions conjugate gradients (two-level additive Schwarz with a Nicolaides
coarse space). The number of iterations then hardly grows with the lattice.
"""

import math
from functools import cached_property

import numpy as np
from scipy.sparse import bsr_array, csc_array, dia_array
from scipy.sparse.linalg import SuperLU, splu

from bondem._indices import components
from bondem._types import Floats, Ints, PerBond, PerElement3
from bondem.interactions.stiffness import Stiffness
from bondem.statics.lanczos import lowest_modes

# Elements per cluster at 10 000 elements. It grows with the root of n, so that elimination stays a small part.
_CLUMP = 25.0
# Share of the diagonal that keeps the coarse matrix regular if a cluster has fewer than six motions.
_REGULAR = 1e-9
# Lost share of its stiffness above which a bond does not join a cluster.
_LOST = 0.5


def clump_of(position: PerElement3) -> Ints:
    """Return the cluster of each element, (n,): the number of its box in a grid of equal, nearly cubic boxes."""
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
    """Return clusters that do not reach across cracks, (n,), which more than halves the iterations on a cracked body.

    Elements without a connection by bonds of at least half their stiffness are put into different clusters. A cluster
    that is still connected, but has bonds that have lost stiffness, is cut by a plane through the mean position of
    these bonds, normal to their main direction.

    Args:
        clump: number of the cluster of each element, (n,).
        position: positions of the elements [m], (n, 3).
        i, j: elements on both sides of a bond, (m,) each.
        lost: share of its stiffness that a bond has lost, (m,).
    """
    connecting = (lost <= _LOST) & (clump[i] == clump[j])
    clump = components(np.column_stack([i, j])[connecting], len(clump))
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


def clump_motions(position: PerElement3, clump: Ints) -> Floats:
    """Return the motion (u, θ) of each element per rigid motion (u, θ) of its cluster, shape (n, 6, 6)."""
    count = np.bincount(clump)
    centre = np.stack([np.bincount(clump, weights=x) / count for x in position.T], axis=1)
    arm = position - centre[clump]
    motions = np.zeros((len(position), 6, 6))
    motions[:, range(6), range(6)] = 1.0
    motions[:, [1, 2, 0], [5, 3, 4]] = arm[:, [0, 1, 2]]
    motions[:, [2, 0, 1], [4, 5, 3]] = -arm[:, [0, 1, 2]]
    return motions


def symmetric_factors(matrix: csc_array) -> SuperLU:
    """Return the factors of a symmetric matrix, without a search for pivots; raise RuntimeError if it is singular."""
    return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})


class Clumps:
    """Coarse correction P (Pᵀ K P)⁻¹ Pᵀ, with P the rigid motions of clusters of elements.

    Args:
        matrix: symmetric, positive (semi-)definite matrix, 6×6 blocks.
        basis: motion of each element per motion of its cluster, in the unknowns of the matrix, shape (n, 6, 6).
        clump: number of the cluster of each element, shape (n,).
    """

    def __init__(self, matrix: Stiffness, basis: Floats, clump: Ints) -> None:
        n, count = len(clump), int(clump.max()) + 1
        self._size = 6 * count
        self.prolongation = bsr_array((basis, clump, np.arange(n + 1)), shape=(6 * n, self._size))
        self.restriction = self.prolongation.T.tobsr((6, 6))
        self.matrix = matrix.projected(self.prolongation)
        diagonal = self.matrix.diagonal()
        # motions that do not exist, because supports prevent them, get a diagonal entry
        extra = np.where(diagonal > 1e-12 * diagonal.max(), _REGULAR * diagonal, diagonal.max())
        self.regular = csc_array(self.matrix + dia_array((extra[None], [0]), shape=self.matrix.shape))

    @cached_property
    def _factors(self) -> SuperLU:
        return symmetric_factors(self.regular)

    def __call__(self, residual: Floats) -> Floats:
        """Return the correction for a residual, shape (6 n,) or (6 n, k)."""
        return self.prolongation @ self._factors.solve(np.asfortranarray(self.restriction @ residual))

    def modes(self, mass: bsr_array, count: int) -> Floats:
        """Return the lowest modes of the pencil (matrix, mass) among motions of clusters, (6 n, count) or fewer."""
        coarse = csc_array((self.restriction @ (mass @ self.prolongation)).tocsc())
        start = coarse @ np.random.default_rng(0).standard_normal(self._size)
        solve = self._factors.solve
        return self.prolongation @ lowest_modes(
            self.matrix, solve, start, mass=coarse, count=min(count, self._size - 1), tolerance=1e-3
        )[1]
