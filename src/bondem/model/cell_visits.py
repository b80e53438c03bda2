"""Order in which cells visit their facets: WIDTH cells at a time, each its own facets one by one.

Cells that are consecutive in memory are sorted by their number of facets and visited in groups of WIDTH. Few visits
of a group are then idle. A cell without remaining facets visits itself, with constants of zero.
"""

from dataclasses import dataclass

import numpy as np

from bondem._types import Ints, Mask
from bondem.kernels.lanes import WIDTH
from bondem.model.layout import Layout

# Cells that are sorted by their number of facets: more fill the groups better, and reach farther in memory.
_SORTED = 128


@dataclass(frozen=True, eq=False)
class CellVisits:
    """Visits of cells to facets, v of them.

    Attributes:
        element: cells of each group, uint32, shape (groups · WIDTH,); the last group is padded with cell 0.
        target: cells of each group, n where padded, uint32.
        start: group g makes WIDTH visits start[g] … start[g + 1] times, shape (groups + 1,).
        facet: visited facet, kernels' order, shape (v,).
        from_j: mask of visits from cell j of the facet, shape (v,).
        idle: mask of visits of cells without remaining facets, shape (v,).
        other: cell on the other side, uint32, shape (v,).
        visit: visits to each facet from i and from j, shape (2, m).
    """

    element: np.ndarray
    target: np.ndarray
    start: Ints
    facet: Ints
    from_j: Mask
    idle: Mask
    other: np.ndarray
    visit: Ints

    @classmethod
    def of(cls, layout: Layout) -> "CellVisits":
        """Return the visits of a body."""
        n, m = len(layout.order), len(layout.i)
        inward = np.diff(layout.in_start)
        count = inward + np.diff(layout.out_start)
        target = np.lexsort((-count, np.arange(n) // _SORTED))
        target = np.append(target, np.full(-n % WIDTH, n)).reshape(-1, WIDTH)
        element = np.where(target < n, target, 0)
        count = np.where(target < n, count[element], 0)
        longest = count.max(axis=1)
        start = np.concatenate([[0], np.cumsum(longest)]).astype(np.int64)
        group = np.repeat(np.arange(len(longest)), longest)
        nth = (np.arange(len(group)) - start[group])[:, None]
        cell, idle = element[group], nth >= count[group]
        from_j = nth < inward[cell]
        leaving = np.clip(layout.out_start[cell] + nth - inward[cell], 0, m - 1)
        facet = np.where(from_j, layout.in_start[cell] + nth, layout.out_bond[leaving].astype(np.int64))
        facet[idle] = 0
        other = np.where(idle, cell, np.where(from_j, layout.i[facet], layout.j[facet]))
        facet, from_j, idle, other = facet.ravel(), from_j.ravel(), idle.ravel(), other.ravel()
        visit = np.empty((2, m), dtype=np.int64)
        made = np.flatnonzero(~idle)
        visit[from_j[made].astype(np.int64), facet[made]] = made
        return cls(
            element.ravel().astype(np.uint32), target.ravel().astype(np.uint32), start, facet, from_j, idle,
            other.astype(np.uint32), visit,
        )  # fmt: skip
