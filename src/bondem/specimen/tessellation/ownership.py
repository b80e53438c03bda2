"""Ownership of the pieces of cut cells by elements.

A wall may divide a cell, for example at a slot thinner than the cell, or at a notch. The part connected to the centre
is the cell. The rest is divided, by least power, among the elements to whose cells it is connected. No facet extends
across a slot, and every facet lies in the radical plane of its two elements.
"""

from dataclasses import dataclass

import numpy as np

from bondem._indices import components
from bondem._tables.tessellation_tables import Bulk, Solids
from bondem._types import Floats, Ints, Mask, PerElement3
from bondem.errors import InputError
from bondem.specimen.tessellation.divide import divided
from bondem.specimen.tessellation.interfaces import Patches, patches
from bondem.specimen.tessellation.solids import bulk, chosen_solids, joined, solid_count

# Volume, over that of a cell, below which parts without any neighbour are rounding errors.
_NOTHING = 1e-9
# Largest number of rounds of division, for parts that are connected only to other parts.
_ROUNDS = 100


@dataclass(frozen=True, eq=False)
class Owned:
    """Pieces of cut cells, and the elements to which they belong.

    Attributes:
        pieces: p pieces.
        measures: volumes and moments of the pieces.
        found: patches at which the pieces meet.
        owner: element to which each piece belongs, shape (p,).
    """

    pieces: Solids
    measures: Bulk
    found: Patches
    owner: Ints

    @property
    def sides(self) -> tuple[Ints, Ints]:
        """Elements on both sides of each patch, (k,) each; -1 for none, beyond a wall."""
        other = self.found.other
        return self.owner[self.found.piece], np.where(other >= 0, self.owner[other], self.found.element)


def owned(pieces: Solids, measures: Bulk, found: Patches, sphere: Floats, width: float, sliver: float) -> Owned:
    """Assign every piece to an element; pieces without an owner are divided first.

    Args:
        pieces: pieces of cut cells, inside the shape.
        measures: volumes and moments of the pieces.
        found: patches at which the pieces meet.
        sphere: centres and radii [m], shape (n, 4).
        width: usual width of a cell [m].
        sliver: area below which patches are left out [m²].

    Raises:
        InputError: A part of the shape is connected to no element.
    """
    owner = np.where(_with_centre(pieces.cell, measures, found), pieces.cell, -1)
    for _ in range(_ROUNDS):
        if (owner >= 0).all():
            break
        lone, near, start = _claims(owner, found)
        if not len(lone):
            lost = np.flatnonzero(owner < 0)
            _refuse_lost(pieces, measures, lost, sphere[:, :3], width)
            owner[lost] = pieces.cell[lost]
            break
        parts, theirs = divided(chosen_solids(pieces, lone), sphere, near, start, 1e-12 * width)
        retained = np.setdiff1d(np.arange(solid_count(pieces)), lone)
        pieces, owner = joined([chosen_solids(pieces, retained), parts]), np.concatenate([owner[retained], theirs])
        measures = bulk(pieces)
        found = patches(pieces, sphere[:, :3], sliver)
    return Owned(pieces, measures, found, owner)


def _with_centre(cell: Ints, measures: Bulk, found: Patches) -> Mask:
    """Return a mask (p,) of the pieces connected to the piece of their cell that is nearest to its centre."""
    a, b = found.piece, found.other
    same = (b >= 0) & (cell[a] == cell[b])
    part = components(np.column_stack([a, b])[same], len(cell))
    # the larger of two pieces that touch the centre
    order = np.lexsort((-measures.volume, np.maximum(measures.beyond, 0.0), cell))
    first = order[np.unique(cell[order], return_index=True)[1]]
    return np.isin(part, part[first])


def _claims(owner: Ints, found: Patches) -> tuple[Ints, Ints, Ints]:
    """Find connected sets of pieces without owner, of any cells, and the elements to which they are connected.

    Returns:
        Pieces, shape (k,), the elements of all pieces one after the other, and the start of those of each, (k + 1,).
    """
    a, b = found.piece, found.other
    two = b >= 0
    both = two & (owner[a] < 0) & (owner[b] < 0)
    part = components(np.column_stack([a, b])[both], len(owner))
    plain = (found.element >= 0) & (owner[a] < 0)
    forth = two & (owner[a] < 0) & (owner[b] >= 0)
    back = two & (owner[b] < 0) & (owner[a] >= 0)
    claim = np.unique(np.column_stack([
        np.concatenate([part[a[plain]], part[a[forth]], part[b[back]]]),
        np.concatenate([found.element[plain], owner[b[forth]], owner[a[back]]]),
    ]), axis=0)  # fmt: skip
    lone = np.flatnonzero((owner < 0) & np.isin(part, claim[:, 0]))
    low, high = (np.searchsorted(claim[:, 0], part[lone], side=side) for side in ("left", "right"))
    start = np.append(0, np.cumsum(high - low))
    rows = np.arange(start[-1]) + np.repeat(low - start[:-1], high - low)
    return lone, np.ascontiguousarray(claim[rows, 1]), start


def _refuse_lost(pieces: Solids, measures: Bulk, lost: Ints, position: PerElement3, width: float) -> None:
    volume = float(measures.volume[lost].sum())
    if volume > _NOTHING * width**3:
        worst = lost[np.argmax(measures.volume[lost])]
        middle = position[pieces.cell[worst]] + measures.middle[worst]
        raise InputError(
            f"{volume:.3g} m³ of the shape, near {tuple(map(float, middle.round(9)))} m, contain no element;"
            " add elements there, or remove that part"
        )
