"""Index arrays: inverse permutations, lists sorted by group, and connected components."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from bondem._types import Ints, Uint32s


def inverse(order: Ints) -> Ints:
    """Return the inverse of a permutation, (k,)."""
    place = np.empty(len(order), dtype=np.int64)
    place[order] = np.arange(len(order))
    return place


def group_starts(group: Ints | Uint32s, count: int) -> Ints:
    """Return where each of `count` groups begins in a list sorted by group, and the end of the list, (count + 1,).

    `group` has the group of each entry, in any order, (k,).
    """
    return np.concatenate([[0], np.cumsum(np.bincount(group, minlength=count))]).astype(np.int64)


def components(pairs: Ints, count: int) -> Ints:
    """Return the connected component of each of `count` nodes, (count,), where `pairs` (m, 2) join nodes."""
    joined = coo_array((np.ones(len(pairs), dtype=np.int8), tuple(pairs.T)), shape=(count, count))
    return connected_components(joined, directed=False)[1].astype(np.int64)
