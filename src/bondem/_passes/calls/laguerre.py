"""Passes that Python calls, of `core/passes/tessellation/laguerre.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import Bins, CellRequest, CellRoom, PolygonBuffer


def make_cells(bins: Bins, cell_request: CellRequest, cell_room: CellRoom, polygon_buffer: PolygonBuffer) -> Call:
    """Cuts the cells of the chosen elements out of boxes about their centres: faces go to the pile, with the
    element behind each face as its tag.
    """
    return Call("make_cells", (bins, cell_request, cell_room, polygon_buffer))
