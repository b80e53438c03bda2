"""Passes that Python calls, of `core/passes/tessellation`; written by `python -m tests.core.passes`."""

from bondem._passes import Call
from bondem._tables.tessellation_tables import (
    BalanceField,
    Bins,
    Bulk,
    CellBranches,
    CellRequest,
    CellRoom,
    Dividing,
    FaceGroups,
    PolygonBuffer,
    PolygonMeasures,
    Solids,
    Splitting,
    WallTree,
)


def apply_balance(cell_branches: CellBranches, balance_field: BalanceField) -> Call:
    """Computes the equation of each cell for given multipliers: its column sums of facet corrections."""
    return Call("apply_balance", (cell_branches, balance_field))


def divide_solids(
    solids: Solids, dividing: Dividing, part: PolygonBuffer, spare: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Divides solids among elements, each point to the one with the least power x² - R²."""
    return Call("divide_solids", (solids, dividing, part, spare, pile))


def make_cells(bins: Bins, cell_request: CellRequest, cell_room: CellRoom, polygon_buffer: PolygonBuffer) -> Call:
    """Cuts the cells of the chosen elements out of boxes about their centres: faces go to the pile, with the
    element behind each face as its tag.
    """
    return Call("make_cells", (bins, cell_request, cell_room, polygon_buffer))


def match_faces(
    solids: Solids, groups: FaceGroups, rest: PolygonBuffer, left: PolygonBuffer, pile: PolygonBuffer
) -> Call:
    """Lays the faces of each group over each other: patches go to the pile, with their face as kind and the face
    on the other side, or -1, as tag.
    """
    return Call("match_faces", (solids, groups, rest, left, pile))


def measure_polygons(polygon_measures: PolygonMeasures) -> Call:
    """Areas, centroids and second moments of polygons."""
    return Call("measure_polygons", (polygon_measures,))


def measure_solids(solids: Solids, bulk: Bulk) -> Call:
    """Volumes and moments of solids."""
    return Call("measure_solids", (solids, bulk))


def split_by_walls(
    solids: Solids, walls: WallTree, splitting: Splitting, stack: PolygonBuffer, piece: PolygonBuffer, pile:
    PolygonBuffer
) -> Call:
    """Splits cells by walls: the faces of their pieces go to the pile."""
    return Call("split_by_walls", (solids, walls, splitting, stack, piece, pile))
