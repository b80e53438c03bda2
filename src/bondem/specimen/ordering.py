"""The internal order, in which the core stores elements and bonds.

Bodies follow each other. The elements of each lie along a Morton curve, so that neighbours in space are neighbours
in memory. Bonds are sorted by their farther element j > i, then by i. A pass over the bonds then streams along the
elements j and reads elements i that are still in the cache. The opposite order would read elements that are not yet
in the cache, which takes twice the time at 100 000 elements. All public data stay in the user's order.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bondem._indices import group_starts, inverse
from bondem._types import Ints, PerBond, PerElement
from bondem.geometry.morton import morton_code
from bondem.specimen.lattice import Lattice


class Adjacency(NamedTuple):
    """Bonds of each element, internal order."""

    in_start: np.ndarray  #: bonds in_start[p] … in_start[p + 1] - 1 have j = p, (n + 1,)
    out_start: np.ndarray  #: start of the bonds with i = p in `out_bond`, (n + 1,)
    out_bond: np.ndarray  #: bonds with i = p at out_start[p] … out_start[p + 1] - 1, uint32, (m,)


class Reversed(NamedTuple):
    """Permutations from internal to user's order; each has the name of its inverse in `Layout`."""

    order: Ints
    rank: Ints
    bond_order: Ints
    flipped: np.ndarray


@dataclass(frozen=True, eq=False)
class Layout:
    """Internal order of elements and bonds: permutations to and from the user's order, and bonds of each element.

    Attributes:
        order: user's number of internal element k, shape (n,).
        rank: internal number of user's element, shape (n,).
        bond_order: user's number of internal bond k, shape (m,).
        flipped: mask of internal bonds that run against the user's direction, shape (m,).
        i, j: internal elements of each bond, i < j, uint32, shape (m,).
        in_start: bonds in_start[p] … in_start[p + 1] - 1 have j = p, shape (n + 1,).
        out_start, out_bond: out_bond[out_start[p] : out_start[p+1]] are the bonds with i = p, ascending.
    """

    order: Ints
    rank: Ints
    bond_order: Ints
    flipped: np.ndarray
    i: np.ndarray
    j: np.ndarray
    in_start: Ints
    out_start: Ints
    out_bond: np.ndarray

    @classmethod
    def of(cls, lattice: Lattice) -> "Layout":
        """Return the layout of a lattice."""
        n = len(lattice.particles)
        order = np.lexsort((morton_code(lattice.particles.position), lattice.body))
        rank = inverse(order)
        ends = rank[lattice.pairs]
        flipped = ends[:, 0] > ends[:, 1]
        i, j = ends.min(axis=1), ends.max(axis=1)
        bond_order = np.lexsort((i, j))
        i, j = i[bond_order], j[bond_order]
        out_bond = np.argsort(i, kind="stable")
        return cls(
            order, rank, bond_order, flipped[bond_order], i.astype(np.uint32), j.astype(np.uint32),
            group_starts(j, n), group_starts(i, n), out_bond.astype(np.uint32),
        )  # fmt: skip

    def of_elements(self, value: PerBond) -> PerElement:
        """Return means of values of bonds, internal order, (m,), over the bonds of each element, user's order, (n,).

        Elements without bonds get 0.
        """
        n = len(self.order)
        ends = np.concatenate([self.i, self.j]).astype(np.int64)
        count = np.maximum(np.bincount(ends, minlength=n), 1)
        return (np.bincount(ends, np.concatenate([value, value]), minlength=n) / count)[self.rank]

    @property
    def reversed(self) -> Reversed:
        """Permutations that reorder arrays from internal to user's order."""
        place = inverse(self.bond_order)
        return Reversed(self.rank, self.order, place, self.flipped[place])

    @property
    def blocks(self) -> tuple[Ints, Ints, Ints]:
        """Numbers of the blocks of a matrix, counted by rows: at (p, p), (n,), and at (i, j) and (j, i), (m,) each.

        Row p has a block for each bond with j = p, then the block (p, p), then one for each bond with i = p.
        """
        i, j, out = self.i.astype(np.int64), self.j.astype(np.int64), inverse(self.out_bond)
        diagonal = self.in_start[1:] + self.out_start[:-1] + np.arange(len(self.order))
        return diagonal, self.in_start[i + 1] + i + 1 + out, self.out_start[j] + j + np.arange(len(j))

    @property
    def adjacency(self) -> Adjacency:
        """Bonds of each element, as arrays of the core."""
        return Adjacency(self.in_start, self.out_start, self.out_bond)
