"""Which element each piece of the cut cells belongs to.

A wall may part a cell: a slot thinner than the cell, the other side of a notch. What hangs together with the centre
is the cell; the rest goes to the neighbour it has most in common with, so that no facet reaches through a slot.
"""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from bondem._types import Floats, Ints, PerElement3
from bondem.errors import InputError
from bondem.specimen.cells.interfaces import Patches
from bondem.specimen.cells.solids import Bulk


def owners(cell: Ints, measures: Bulk, found: Patches, position: PerElement3) -> Ints:
    """The element that each piece belongs to, shape (p,).

    Args:
        cell: the element that each piece was cut off, shape (p,).
        measures: volumes of the pieces.
        found: where they meet.
        position: centres [m], shape (n, 3).

    Raises:
        InputError: a part of the shape hangs together with no element.
    """
    count = len(cell)
    a, b = found.piece, found.other
    same = (b >= 0) & (cell[a] == cell[b])
    graph = coo_matrix((np.ones(int(same.sum()), dtype=np.int8), (a[same], b[same])), shape=(count, count))
    parts, part = connected_components(graph, directed=False)
    owner = np.full(parts, -1)
    # the piece that holds the centre, or lies nearest to it; of two that touch it the larger
    order = np.lexsort((-measures.volume, np.maximum(measures.beyond, 0.0), cell))
    first = order[np.unique(cell[order], return_index=True)[1]]
    owner[part[first]] = cell[first]
    while (owner < 0).any():
        wanting, giver, area = _claims(part, owner, found)
        if not len(wanting):
            lost = np.flatnonzero(owner[part] < 0)
            middle = position[cell[lost[0]]] + measures.first[lost[0]] / measures.volume[lost[0]]
            raise InputError(
                f"{measures.volume[lost].sum():.3g} m³ of the shape, at {tuple(map(float, middle.round(9)))} m, hangs"
                " together with no element; put elements there, or cut it off"
            )
        claim, inverse = np.unique(np.column_stack([wanting, giver]), axis=0, return_inverse=True)
        shared = np.bincount(inverse.ravel(), weights=area)
        best = np.lexsort((shared, claim[:, 0]))
        last = np.append(claim[best[1:], 0] != claim[best[:-1], 0], True)
        owner[claim[best[last], 0]] = claim[best[last], 1]
    return owner[part]


def _claims(part: Ints, owner: Ints, found: Patches) -> tuple[Ints, Ints, Floats]:
    """Parts without owner, elements next to them, and the area they share [m²], a row for each patch."""
    a, b = part[found.piece], part[found.other]
    two = found.other >= 0
    plain = (found.element >= 0) & (owner[a] < 0)
    forth = two & (owner[a] < 0) & (owner[b] >= 0)
    back = two & (owner[b] < 0) & (owner[a] >= 0)
    return (
        np.concatenate([a[plain], a[forth], b[back]]),
        np.concatenate([found.element[plain], owner[b[forth]], owner[a[back]]]),
        np.concatenate([found.area[plain], found.area[forth], found.area[back]]),
    )
