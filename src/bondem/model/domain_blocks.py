"""Division of a step into blocks that fit into the cache, and into domains for threads.

Bonds i < j are sorted by their element j, so that the bonds with j in a range of elements are contiguous too. A block
consists of such a range and its bonds, and adds their forces to the sums of both ends. An element moves, while
it is still in the cache, with the block of its last bond. Domains are ranges of blocks. A bond between domains
belongs to the domain of j, and its contribution to i has a row of its own. Such elements i are shared, and move when
all domains are done.

Contributions to an element are added one by one in the order of its bonds, for any division into blocks and domains.
The division, and with it the number of threads, therefore changes no bit.
"""

from dataclasses import dataclass

import numpy as np

from bondem._cache_lines import lines
from bondem._tables.step_tables import StepBlocks
from bondem._types import Ints, Mask
from bondem.interactions.beams.bond_table import GROUP, with_twins
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class Blocks:
    """Division of the work of a step into domains for threads, and of these into blocks of elements and bonds.

    An element uses a row for its sum of forces from the block with its first bond to the block that moves it. Later
    blocks reuse the row, so that the rows of a domain stay in the cache. Ranges a … b below exclude b.

    Attributes:
        domain: domain d has the blocks domain[d] … domain[d + 1], shape (domains + 1,).
        bond: block b has the bonds bond[b] … bond[b + 1], shape (blocks + 1,).
        move: block b moves the elements ready[move[b]] … ready[move[b + 1]], shape (blocks + 1,).
        first_owner: elements of block b from ready[first_owner[b]] on are fixed, driven or loaded, shape (blocks,).
        ready: all elements that are not shared, in the order in which they move, uint32.
        ready_row: rows of their sums, uint32.
        row_i, row_j: rows that each bond adds to, uint32, shape (m,), or longer as by `with_twins`.
        shared: elements with bonds in other domains; fixed, driven or loaded ones last, uint32, shape (s,).
        shared_first_owner: number of shared elements that are not fixed, driven or loaded.
        shared_row: rows of their sums, uint32, shape (s,).
        part: rows parts + part[e] … parts + part[e + 1] also belong to shared element e, shape (s + 1,).
        parts: first row of sums for bonds between domains.
    """

    domain: Ints
    bond: Ints
    move: Ints
    first_owner: Ints
    ready: np.ndarray
    ready_row: np.ndarray
    row_i: np.ndarray
    row_j: np.ndarray
    shared: np.ndarray
    shared_row: np.ndarray
    shared_first_owner: int
    part: Ints
    parts: int

    @classmethod
    def of(cls, layout: Layout, size: int, domains: int, owns: Mask) -> "Blocks":
        """Divide a step into blocks of about `size` elements, and these into domains of about equal work.

        The work is the number of bonds, or that of bonds and elements if there are fewer bonds than elements.

        Args:
            layout: internal order of elements and bonds.
            size: number of elements per block.
            domains: number of domains.
            owns: mask of the fixed, driven or loaded elements, internal order, shape (n,).
        """
        n, m = len(layout.order), len(layout.i)
        i, j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        work = layout.in_start if m >= n else layout.in_start + np.arange(n + 1)
        border = np.searchsorted(work, np.linspace(0, work[-1], domains + 1)[1:-1])
        count = max(1, -(-n // size))
        # a border between domains may divide a block, which costs nothing
        edges = np.unique(np.concatenate([np.arange(count) * size, border, [n]]))
        # a loop computes GROUP bonds at once, and completes the last group with earlier bonds: so many must exist
        before = layout.in_start[edges]
        edges = edges[(before == 0) | (before >= GROUP) | (edges == n)]
        domain = np.searchsorted(edges, np.concatenate([[0], border, [n]]))
        owner = np.repeat(np.arange(domains), np.diff(edges[domain]))
        block = np.repeat(np.arange(len(edges) - 1), np.diff(edges))
        across = np.flatnonzero(owner[i] != owner[j])
        across = across[np.lexsort((i[across], owns[i[across]]))]
        parts = np.bincount(i[across], minlength=n)
        shared = np.flatnonzero(parts)
        shared = shared[np.argsort(owns[shared], kind="stable")]
        parts = parts[shared]
        last = block.copy()
        np.maximum.at(last, i, block[j])
        last[shared] = len(edges)  # beyond all blocks
        ready = np.lexsort((owns, last))[: n - len(shared)]
        move = np.searchsorted(last[ready], np.arange(len(edges)))
        first_owner = move[1:] - np.bincount(last[ready][owns[ready]], minlength=len(edges) - 1)
        row, rows = _rows(edges, domain, ready, move)
        row_i = row[i]
        row_i[across] = rows + np.arange(len(across))
        return cls(
            domain=domain.astype(np.int64), bond=np.append(layout.in_start[edges[:-1]], len(with_twins(layout.i))),
            move=move.astype(np.int64), first_owner=first_owner.astype(np.int64),
            ready=ready.astype(np.uint32), ready_row=row[ready].astype(np.uint32),
            row_i=with_twins(row_i.astype(np.uint32)), row_j=with_twins(row[j].astype(np.uint32)),
            shared=shared.astype(np.uint32), shared_row=row[shared].astype(np.uint32),
            shared_first_owner=len(shared) - int(owns[shared].sum()),
            part=np.concatenate([[0], np.cumsum(parts)]).astype(np.int64), parts=rows,
        )  # fmt: skip

    def table(self, more: int = 0) -> StepBlocks:
        """Return the division as a table of the core, with new rows of sums and `more` rows after them, all zero."""
        return StepBlocks(
            domain=self.domain, bond=self.bond, move=self.move, first_owner=self.first_owner, ready=self.ready,
            ready_row=self.ready_row, row_i=self.row_i, row_j=self.row_j, shared=self.shared,
            shared_row=self.shared_row, shared_first_owner=self.shared_first_owner, part=self.part, parts=self.parts,
            sums=lines(self.rows + more),
        )  # fmt: skip

    @property
    def rows(self) -> int:
        """Total number of rows of sums."""
        return self.parts + int(self.part[-1])


def _rows(edges: Ints, domain: Ints, ready: Ints, move: Ints) -> tuple[Ints, int]:
    """Assign rows of sums to elements, (n,), reused within a domain when free; also return the number of rows."""
    row = np.empty(edges[-1], dtype=np.int64)
    count = 0
    for d in range(len(domain) - 1):
        free = np.zeros(0, dtype=np.int64)
        for b in range(domain[d], domain[d + 1]):
            needed = edges[b + 1] - edges[b]
            fresh = max(needed - len(free), 0)
            free = np.concatenate([free, count + np.arange(fresh)])
            count += fresh
            row[edges[b] : edges[b + 1]] = free[:needed]
            free = np.concatenate([np.sort(row[ready[move[b] : move[b + 1]]]), free[needed:]])
    return row, count
