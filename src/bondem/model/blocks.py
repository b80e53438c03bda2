"""A step in blocks that fit into the cache, and in domains that threads take in one go.

Bonds are sorted by their farther element j, so a contiguous range of elements owns a contiguous range of bonds: those
with j in it. A block computes its bonds and adds their forces to the sums of both ends; an element moves, while it is
still in the cache, with the block that holds the last of its bonds. Domains are ranges of blocks. A bond between
domains belongs to that of j, and leaves what it adds to i in a row of its own: such elements i are shared, and move
when all domains are done.

Contributions to an element are added one by one in the order of its bonds, however elements are cut into blocks and
domains: the cuts, and with them the number of threads, change no bit.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Ints
from bondem.model.layout import Layout


@dataclass(frozen=True, eq=False)
class Blocks:
    """How a step is cut.

    Attributes:
        domain: domain d has the blocks domain[d] … domain[d + 1], shape (domains + 1,).
        bond: block b has the bonds bond[b] … bond[b + 1], shape (blocks + 1,).
        move: block b moves the elements ready[move[b]] … ready[move[b + 1]], shape (blocks + 1,).
        ready: all elements that are not shared, in the order in which they move, uint32.
        target: row of sums that each bond's part for i goes to, uint32, shape (m,).
        shared: elements with bonds that another domain computes, ascending, uint32, shape (s,).
        part: rows n + part[e] … n + part[e + 1] of the sums belong to shared element e, shape (s + 1,).
    """

    domain: Ints
    bond: Ints
    move: Ints
    ready: np.ndarray
    target: np.ndarray
    shared: np.ndarray
    part: Ints

    @classmethod
    def of(cls, layout: Layout, size: int, domains: int) -> "Blocks":
        """Blocks of about `size` elements, in `domains` of about as many bonds each."""
        n, m = len(layout.order), len(layout.i)
        i, j = layout.i.astype(np.int64), layout.j.astype(np.int64)
        border = np.searchsorted(layout.in_start, np.linspace(0, m, domains + 1)[1:-1])
        count = max(1, -(-n // size))
        edges = np.unique(np.concatenate([np.arange(count) * size, border, [n]]))
        # in the middle of a block of bonds a border makes two small blocks, which costs nothing
        domain = np.searchsorted(edges, np.concatenate([[0], border, [n]]))
        owner = np.repeat(np.arange(domains), np.diff(edges[domain]))
        block = np.repeat(np.arange(len(edges) - 1), np.diff(edges))
        across = np.flatnonzero(owner[i] != owner[j])
        across = across[np.argsort(i[across], kind="stable")]
        target = layout.i.copy()
        target[across] = n + np.arange(len(across))
        shared, parts = np.unique(i[across], return_counts=True)
        last = block.copy()
        np.maximum.at(last, i, block[j])
        single = np.ones(n, dtype=bool)
        single[shared] = False
        ready = np.flatnonzero(single)
        ready = ready[np.argsort(last[ready], kind="stable")]
        return cls(
            domain=domain.astype(np.int64),
            bond=layout.in_start[edges],
            move=np.searchsorted(last[ready], np.arange(len(edges))).astype(np.int64),
            ready=ready.astype(np.uint32),
            target=target,
            shared=shared.astype(np.uint32),
            part=np.concatenate([[0], np.cumsum(parts)]).astype(np.int64),
        )

    @property
    def rows(self) -> int:
        """Rows of sums beyond those of the elements."""
        return int(self.part[-1])
