"""Division among elements of pieces that a wall separates from the centre of their cell."""

from typing import NamedTuple

import numpy as np

from bondem._core import Pass, room_for
from bondem._types import Floats, Ints
from bondem.specimen.tessellation.polygon_buffer import TAG, Pile, new_pile, polygon_buffer
from bondem.specimen.tessellation.solids import Solids


class Dividing(NamedTuple):
    """Solids, the elements among which they are divided, and room for the parts."""

    sphere: Floats  #: centres and radii of all elements [m], (n, 4)
    near: Ints  #: solid s is divided among near[start[s]] … near[start[s + 1] - 1]
    start: Ints  #: (solids + 1,)
    tolerance: float  #: planes that reach in less do not divide [m]
    lid: Floats  #: polygons, (MOST_CORNERS, 3)
    work: Floats
    cell: Ints  #: of which element's cell each part is part, (parts,)
    owner: Ints  #: the element it belongs to, (parts,)
    end: Ints  #: polygons up to the end of each part, (parts,)
    done: Ints  #: solids divided, parts made, (2,)

    def with_more_parts(self) -> "Dividing":
        """Return a copy with room for more parts."""
        cell, owner, end = (room_for(values, 2 * len(values)) for values in (self.cell, self.owner, self.end))
        return self._replace(cell=cell, owner=owner, end=end)


_divide = Pass("divide_solids", Solids, Dividing, Pile, Pile, Pile)


def divided(solids: Solids, sphere: Floats, near: Ints, start: Ints, tolerance: float) -> tuple[Solids, Ints]:
    """Divide solids among elements, each point to the one with the least power x² - R².

    Args:
        solids: k solids.
        sphere: centres and radii of all elements [m], shape (n, 4).
        near: elements that solid s is divided among, near[start[s]] … near[start[s + 1] - 1].
        start: start of these, shape (k + 1,).
        tolerance: depth of a plane in a solid below which it does not divide the solid [m].

    Returns:
        The parts, and the element that each belongs to; the planes between them are splits of the cells.
    """
    cell, owner, end = (np.empty(64, np.int64) for _ in range(3))
    lid, work = polygon_buffer(), polygon_buffer()
    dividing = Dividing(sphere, near, start, tolerance, lid, work, cell, owner, end, np.zeros(2, np.int64))
    part, spare, pile = new_pile(256, 2048), new_pile(256, 2048), new_pile(1024, 8192)
    while (ended := _divide(solids, dividing, part, spare, pile)) != "all_divided":
        if ended == "parts_full":
            dividing, pile = dividing.with_more_parts(), pile.roomier()
        else:
            part, spare = part.roomier(), spare.roomier()
    faces, parts = pile.size, int(dividing.done[1])
    made = Solids(
        dividing.cell[:parts], np.append(0, dividing.end[:parts]), pile.what[:faces, TAG].copy(), pile.plane[:faces],
        pile.corner, pile.corners,
    )  # fmt: skip
    return made, dividing.owner[:parts]
