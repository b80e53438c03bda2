"""Division, among other elements, of the pieces that a wall separates from the centre of their cell."""

import numpy as np

from bondem._core import run_pass, with_room
from bondem._passes import calls
from bondem._tables.tessellation_tables import Dividing, Solids
from bondem._types import Floats, Ints
from bondem.specimen.tessellation.polygon_buffer import new_buffer, polygon_buffer, roomier_buffer, solids_in


def divided(solids: Solids, sphere: Floats, near: Ints, start: Ints, tolerance: float) -> tuple[Solids, Ints]:
    """Divide solids among elements: each point belongs to the element whose power |x - c|² - R² is least there.

    Args:
        solids: k solids.
        sphere: centres and radii of all elements [m], shape (n, 4).
        near: elements among which solid s is divided: near[start[s]] … near[start[s + 1] - 1].
        start: start of the elements of each solid in `near`, shape (k + 1,).
        tolerance: least depth to which a plane reaches into a solid that it divides [m].

    Returns:
        The parts, and the element to which each belongs, (parts,). `Solids.tag` of a face between two parts is not
        the number of a neighbour, but -16 or less: two numbers for each dividing plane, one for each side.
    """
    cell, owner, end = (np.empty(64, np.int64) for _ in range(3))
    lid, work = polygon_buffer(), polygon_buffer()
    dividing = Dividing(sphere, near, start, tolerance, lid, work, cell, owner, end, np.zeros(2, np.int64))
    part, spare, pile = new_buffer(256, 2048), new_buffer(256, 2048), new_buffer(1024, 8192)
    while (ended := run_pass(calls.divide_solids(solids, dividing, part, spare, pile))) != "all_divided":
        if ended == "parts_full":
            dividing, pile = with_room(dividing, "cell", "owner", "end"), roomier_buffer(pile)
        else:
            part, spare = roomier_buffer(part), roomier_buffer(spare)
    parts = int(dividing.done[1])
    return solids_in(pile, dividing.cell[:parts], np.append(0, dividing.end[:parts])), dividing.owner[:parts]
