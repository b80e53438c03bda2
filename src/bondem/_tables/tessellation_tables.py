"""Tables of `core/tables/tessellation_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats, Ints, Uint32s


class Bins(NamedTuple):
    """Centres sorted into boxes, for the search of neighbours.

    Attributes: position: centres [m], shape (n, 3). radius: radii [m], shape (n,). lower, upper: the box around all
    cells [m], (3,). period: edge lengths of the periodic cell, or 0 [m], (3,). boxes: number of boxes along each
    axis, (3,). start: start of the members of each box, (boxes + 1,). member: elements, box by box, (n,). bound: B of
    each element: no sphere at distance L has a radius above B + κ L [m], (n,). first: initial search distance of
    neighbours, less in crowded boxes [m], (n,). reach: usual distance of the farthest neighbour [m]. tolerance: depth
    to which planes do not cut [m].
    """

    position: Floats  #: centres [m], (n, 3)
    radius: Floats  #: [m], (n,)
    lower: Floats  #: the box around all cells [m], (3,)
    upper: Floats  #: the box around all cells [m], (3,)
    period: Floats  #: edge lengths of the periodic cell, or 0 [m], (3,)
    boxes: Ints  #: along each axis, (3,)
    start: Ints  #: where the members of each box begin, (boxes + 1,)
    member: Ints  #: elements, box by box, (n,)
    bound: Floats  #: B: no sphere at distance L has a radius above B + κ L [m], (n,)
    first: Floats  #: distance to which neighbours are looked for at first [m], (n,)
    reach: float  #: usual distance of the farthest neighbour [m]
    tolerance: float  #: depth to which planes do not cut [m]


class Solids(NamedTuple):
    """Convex solids, k of them, with f faces and v corners.

    Attributes: cell: element of the cell that each solid is part of, shape (k,). face: faces of solid s are face[s] …
    face[s + 1] - 1, shape (k + 1,). tag: neighbour behind each face, shape (f,): an element; BOX - 0 … BOX - 5, the
    sides of the box around the shape (x_min, x_max, y_min …); LOCAL, an arbitrary end; or SPLIT - 2 s and SPLIT - 2 s
    - 1, the two sides of split s of the cell. plane: outward unit normal and distance from the centre, shape (f, 4)
    [-, m]. corner: corners of face g are corner[g] … corner[g + 1] - 1, shape (f + 1,). vertex: corners relative to
    the centre of the element [m], shape (v, 3).
    """

    cell: Ints  #: of which element's cell each is part, (solids,)
    face: Ints  #: faces of solid s are face[s] … face[s + 1] - 1, (solids + 1,)
    tag: Ints  #: what is behind each face, (faces,)
    plane: Floats  #: outward unit normal and distance from the centre [-, m], (faces, 4)
    corner: Ints  #: corners of face g are corner[g] … corner[g + 1] - 1, (faces + 1,)
    vertex: Floats  #: corners, from the centre of the element [m], (corners, 3)


class PolygonBuffer(NamedTuple):
    """A list of polygons with room for more.

    A pass that fills the list ends, and continues from there when there is more room.
    """

    what: Ints  #: kind, tag, first corner, number of corners, shape, (*, 4)
    plane: Floats  #: shape, (*, 4)
    vertex: Floats  #: shape, (*, 3)
    used: Ints  #: polygons, corners, 1 where it was full, shape, (3,)


class CellRequest(NamedTuple):
    """The required cells, and lists in which their neighbours are sorted."""

    chosen: Ints  #: elements, (cells,)
    half: Floats  #: half the widths of the boxes that their cells begin as [m], (cells,)
    found: Ints  #: elements listed, (room,)
    offset: Floats  #: from the centre to them, and distance [m], (room, 4)
    order: Ints  #: the nearest first, (room,)
    end: Ints  #: polygons up to the end of each cell, (cells + 1,)
    done: Ints  #: cells made; the element at which it ended, (2,)


class CellRoom(NamedTuple):
    """A cell under construction: face f has size[f] corners, from row f · MOST_CORNERS on."""

    plane: Floats  #: (402, 4)
    tag: Ints  #: (402,)
    size: Ints  #: (402,)
    vertex: Floats  #: (205824, 3)
    work: Floats  #: a polygon, (512, 3)
    other: Floats  #: a polygon, (512, 3)


class WallTree(NamedTuple):
    """Triangles in a tree of boxes, for the search of those near a cell.

    Attributes: corner: corners of the triangles [m], shape (t, 3, 3). plane: unit normal of each and its product with
    a point of the plane, shape (t, 4) [-, m]. lower, upper: corners of the boxes [m], shape (2 p, 3): box 1 holds
    all, box b boxes 2 b and 2 b + 1, the last p one triangle each or none. owner: triangle in each of the last p
    boxes, shape (p,).
    """

    corner: Floats  #: of the triangles [m], (triangles, 3, 3)
    plane: Floats  #: unit normal of each and its product with a point of the plane [-, m], (triangles, 4)
    lower: Floats  #: corners of the boxes [m], (boxes, 3)
    upper: Floats  #: corners of the boxes [m], (boxes, 3)
    owner: Ints  #: the triangle in each of the last boxes, or -1, (leaves,)


class Splitting(NamedTuple):
    """Data of the splitting of solids, and room for the pieces."""

    position: Floats  #: centres of all elements [m], (n, 3)
    tolerance: float  #: what reaches in less than this splits nothing [m]
    found: Ints  #: walls near a cell, (*,)
    below: Ints  #: where each piece on the stack begins, (*,)
    lid: Floats  #: polygons, (512, 3)
    work: Floats  #: polygons, (512, 3)
    other: Floats  #: polygons, (512, 3)
    cell: Ints  #: of which element's cell each piece is part, (pieces,)
    end: Ints  #: polygons up to the end of each piece, (pieces,)
    done: Ints  #: solids split, pieces made, (2,)


class Dividing(NamedTuple):
    """Solids, the elements among which they are divided, and room for the parts."""

    sphere: Floats  #: centres and radii of all elements [m], (n, 4)
    near: Ints  #: solid s is divided among near[start[s]] … near[start[s + 1] - 1], (claims,)
    start: Ints  #: solid s is divided among near[start[s]] … near[start[s + 1] - 1], (solids + 1,)
    tolerance: float  #: planes that reach in less do not divide [m]
    lid: Floats  #: polygons, (512, 3)
    work: Floats  #: polygons, (512, 3)
    cell: Ints  #: of which element's cell each part is part, (parts,)
    owner: Ints  #: the element it belongs to, (parts,)
    end: Ints  #: polygons up to the end of each part, (parts,)
    done: Ints  #: solids divided, parts made, (2,)


class FaceGroups(NamedTuple):
    """Faces in one plane: those of group g begin at plus[first[g]] on one side, minus[second[g]] on the other."""

    of_face: Ints  #: the solid that each face is of, (faces,)
    plus: Ints  #: (forth,)
    first: Ints  #: (groups + 1,)
    minus: Ints  #: (back,)
    second: Ints  #: (groups + 1,)
    shift: Floats  #: vector from the centre of the corners of the first side to that of the other side, (groups, 3)
    tolerance: float  #: patches of less area are left out [m²]
    work: Floats  #: polygons, (512, 3)
    other: Floats  #: polygons, (512, 3)
    done: Ints  #: groups matched, (1,)


class PolygonMeasures(NamedTuple):
    """Polygons, f of them, and the measures of each."""

    corner: Ints  #: corners of polygon q are corner[q] … corner[q + 1] - 1, (polygons + 1,)
    vertex: Floats  #: corners [m], (corners, 3)
    area: Floats  #: [m²], (polygons,)
    centroid: Floats  #: [m], (polygons, 3)
    moment: Floats  #: second moments about the centroid [m⁴], (polygons, 3, 3)


class Bulk(NamedTuple):
    """Volumes, surfaces and moments of solids, all about the centre of the element.

    Attributes: volume: ∫ dV [m³], shape (k,). first: ∫ x dV [m⁴], shape (k, 3). second: ∫ x⊗x dV [m⁵], shape (k, 3,
    3). middle: a point inside, also of a thin solid [m], shape (k, 3). farthest: distance of the farthest corner [m],
    shape (k,). beyond: distance of the centre outside the solid, at most 0 if it lies inside [m], shape (k,).
    """

    volume: Floats  #: [m³], (solids,)
    first: Floats  #: ∫ x dV [m⁴], (solids, 3)
    second: Floats  #: ∫ x⊗x dV [m⁵], (solids, 3, 3)
    middle: Floats  #: a point inside, however thin the solid is [m], (solids, 3)
    farthest: Floats  #: distance of the farthest corner [m], (solids,)
    beyond: Floats  #: how far the centre lies outside, at most 0 if it lies inside [m], (solids,)


class CellBranches(NamedTuple):
    """Facets of each cell."""

    start: Ints  #: facets of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    other: Uint32s  #: cell on the other side, (sides,)
    branch: Floats  #: weighted branch A / √W times the branch to its neighbour [m^1.5], (sides, 3)


class BalanceField(NamedTuple):
    """A symmetric tensor of each cell, and the operator applied to it."""

    given: Floats  #: (n, 6)
    found: Floats  #: (n, 6)
