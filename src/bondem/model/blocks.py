"""A step in blocks that fit into the cache.

Bonds are sorted by their farther element, so a contiguous range of them completes all elements up to some point but
those with bonds further on. Each element moves with the block that holds the last of its bonds; which block
that is changes no number.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Ints
from bondem.model.layout import Layout


@dataclass(frozen=True, eq=False)
class Blocks:
    """A step in portions: bonds of a block of elements, then the elements that have no bond left.

    Attributes:
        ready: elements in the order in which the last of their bonds is done, uint32, shape (n,).
        element: block b moves the elements ready[element[b] : element[b + 1]], shape (blocks + 1,).
        bond: block b computes the bonds bond[b] … bond[b + 1], shape (blocks + 1,).
    """

    ready: np.ndarray
    element: Ints
    bond: Ints

    @classmethod
    def of(cls, layout: Layout, size: int) -> "Blocks":
        """Blocks of `size` elements."""
        n = len(layout.order)
        last = np.arange(n)
        np.maximum.at(last, layout.i.astype(np.int64), layout.j.astype(np.int64))
        block = last // size
        ready = np.argsort(block, kind="stable")
        count = (n + size - 1) // size
        edges = np.minimum(np.arange(count + 1) * size, n)
        return cls(
            ready=ready.astype(np.uint32),
            element=np.searchsorted(block[ready], np.arange(count + 1)).astype(np.int64),
            bond=layout.in_start[edges],
        )
