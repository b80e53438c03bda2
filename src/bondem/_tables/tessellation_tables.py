"""Tables of `core/tables/tessellation_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints, Uint32s


class Bins(NamedTuple):
    """Centres of elements, sorted into boxes for the search of neighbours."""

    position: Floats  #: centres [m], (n, 3)
    radius: Floats  #: radii [m], (n,)
    lower: Floats  #: lower corner of the box around all cells [m], (3,)
    upper: Floats  #: upper corner of the box around all cells [m], (3,)
    period: Floats  #: edge lengths of the periodic cell, or 0 [m], (3,)
    boxes: Ints  #: number of boxes along each axis, (3,)
    start: Ints  #: start of the members of each box, (boxes + 1,)
    member: Ints  #: elements, box by box, (n,)
    bound: Floats  #: B of each element: no sphere at distance L has a radius above B + κ L [m], (n,)
    first: Floats  #: initial search distance of neighbours, less in crowded boxes [m], (n,)
    reach: float  #: usual distance of the farthest neighbour [m]
    tolerance: float  #: depth to which planes do not cut [m]


class Solids(NamedTuple):
    """Convex solids, k of them, with f faces and v corners."""

    cell: Ints  #: element whose cell each solid is part of, (solids,)
    face: Ints  #: faces of solid s are face[s] … face[s + 1] - 1, (solids + 1,)
    #: neighbour behind each face: an element; BOX - 0 … BOX - 5, sides of the box around the shape (x_min, x_max,
    #: y_min …); LOCAL, an arbitrary end; or SPLIT - 2 s and SPLIT - 2 s - 1, both sides of split s of the cell,
    #: (faces,)
    tag: Ints
    plane: Floats  #: outward unit normal and distance from the centre [-, m], (faces, 4)
    corner: Ints  #: corners of face g are corner[g] … corner[g + 1] - 1, (faces + 1,)
    vertex: Floats  #: corners relative to the centre of the element [m], (corners, 3)


class PolygonBuffer(NamedTuple):
    """Polygons in arrays with spare room. A pass that fills them ends; with larger ones it continues from there."""

    what: Ints  #: kind, tag, first corner and number of corners of each polygon, (*, 4)
    plane: Floats  #: outward unit normal and distance from the centre [-, m], (*, 4)
    vertex: Floats  #: corners [m], (*, 3)
    used: Ints  #: number of polygons, number of corners, 1 where the arrays were full, (3,)


class CellRequest(NamedTuple):
    """The required cells, and lists in which their neighbours are sorted."""

    chosen: Ints  #: elements, (cells,)
    half: Floats  #: half the edges of the boxes from which their cells are cut [m], (cells,)
    found: Ints  #: elements listed, (room,)
    offset: Floats  #: vector from the centre to each listed element, and distance [m], (room, 4)
    order: Ints  #: places in `found`, the nearest element first, (room,)
    end: Ints  #: number of polygons up to the end of each cell, (cells + 1,)
    done: Ints  #: number of cells made, and the element at which the pass ended, (2,)


class CellRoom(NamedTuple):
    """A cell under construction: face f has size[f] corners, from row f · MOST_CORNERS on."""

    plane: Floats  #: (402, 4)
    tag: Ints  #: (402,)
    size: Ints  #: (402,)
    vertex: Floats  #: (205824, 3)
    work: Floats  #: a polygon, (512, 3)
    other: Floats  #: a polygon, (512, 3)


class WallTree(NamedTuple):
    """Wall triangles in a tree of boxes, for the search of those near a cell.

    Box 1 contains all triangles, box b contains boxes 2 b and 2 b + 1, and each of the last p boxes contains one
    triangle or none.
    """

    corner: Floats  #: of the triangles [m], (triangles, 3, 3)
    plane: Floats  #: unit normal of each and its product with a point of the plane [-, m], (triangles, 4)
    lower: Floats  #: corners of the boxes [m], (boxes, 3)
    upper: Floats  #: corners of the boxes [m], (boxes, 3)
    owner: Ints  #: the triangle in each of the last boxes, or -1, (leaves,)


class Splitting(NamedTuple):
    """Data of the splitting of solids, and room for the pieces."""

    position: Floats  #: centres of all elements [m], (n, 3)
    tolerance: float  #: depth below which a wall or plane splits nothing [m]
    found: Ints  #: walls near a cell, (*,)
    below: Ints  #: first polygon of each piece on the stack, (*,)
    lid: Floats  #: polygons, (512, 3)
    work: Floats  #: polygons, (512, 3)
    other: Floats  #: polygons, (512, 3)
    cell: Ints  #: element whose cell each piece is part of, (pieces,)
    end: Ints  #: number of polygons up to the end of each piece, (pieces,)
    done: Ints  #: numbers of solids split and of pieces made, (2,)


class Dividing(NamedTuple):
    """Solids, the elements among which they are divided, and room for the parts."""

    sphere: Floats  #: centres and radii of all elements [m], (n, 4)
    near: Ints  #: solid s is divided among near[start[s]] … near[start[s + 1] - 1], (claims,)
    start: Ints  #: start of the elements of each solid in `near`, (solids + 1,)
    tolerance: float  #: depth below which a plane does not divide a solid [m]
    lid: Floats  #: polygons, (512, 3)
    work: Floats  #: polygons, (512, 3)
    cell: Ints  #: element whose cell each part was cut from, (parts,)
    owner: Ints  #: element to which each part belongs, (parts,)
    end: Ints  #: number of polygons up to the end of each part, (parts,)
    done: Ints  #: numbers of solids divided and of parts made, (2,)


class FaceGroups(NamedTuple):
    """Faces in one plane: those of group g begin at plus[first[g]] on one side, at minus[second[g]] on the other."""

    of_face: Ints  #: solid of each face, (faces,)
    plus: Ints  #: faces on one side, group by group, (forth,)
    first: Ints  #: start of each group in `plus`, (groups + 1,)
    minus: Ints  #: faces on the other side, group by group, (back,)
    second: Ints  #: start of each group in `minus`, (groups + 1,)
    #: vector from the centre of the element on the plus side to that of the element on the minus side [m], (groups,
    #: 3)
    shift: Floats
    tolerance: float  #: patches of less area are left out [m²]
    work: Floats  #: polygons, (512, 3)
    other: Floats  #: polygons, (512, 3)
    done: Ints  #: number of groups matched, (1,)


class PolygonMeasures(NamedTuple):
    """Polygons, and the measures of each."""

    corner: Ints  #: corners of polygon q are corner[q] … corner[q + 1] - 1, (polygons + 1,)
    vertex: Floats  #: corners [m], (corners, 3)
    area: Floats  #: [m²], (polygons,)
    centroid: Floats  #: [m], (polygons, 3)
    moment: Floats  #: second moments about the centroid [m⁴], (polygons, 3, 3)


class Bulk(NamedTuple):
    """Volumes, moments and extents of solids, all about the centre of the element."""

    volume: Floats  #: [m³], (solids,)
    first: Floats  #: ∫ x dV [m⁴], (solids, 3)
    second: Floats  #: ∫ x⊗x dV [m⁵], (solids, 3, 3)
    middle: Floats  #: a point inside, also of a thin solid [m], (solids, 3)
    farthest: Floats  #: distance of the farthest corner [m], (solids,)
    beyond: Floats  #: distance of the centre outside the solid, at most 0 if it lies inside [m], (solids,)


class CellBranches(NamedTuple):
    """Facets of each cell."""

    start: Ints  #: facets of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    other: Uint32s  #: cell on the other side, (sides,)
    branch: Floats  #: A / √W times the branch to the neighbour, W a weight [m^1.5], (sides, 3)


class BalanceField(NamedTuple):
    """A symmetric tensor of each cell, and the operator applied to it."""

    given: Floats  #: components of the tensors, those off the diagonal times √2, (n, 6)
    found: Floats  #: components of the result, those off the diagonal times √2, (n, 6)
