"""Tessellation of a shape into one cell per element: Laguerre cells of the spheres within the walls of the shape."""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from bondem._tables.tessellation_tables import Bins, Bulk, Solids, WallTree
from bondem._threads import current_threads
from bondem._types import Floats, Ints, Mask, Pairs, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import BoundingBox, Box, Cell
from bondem.geometry.shape import Shape
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.tessellation.clip_to_shape import trimmed
from bondem.specimen.tessellation.facet_tables import Polygons, facets, free_facets, together
from bondem.specimen.tessellation.facets import Cells, Facets
from bondem.specimen.tessellation.interfaces import patches
from bondem.specimen.tessellation.laguerre import bins, plain_cells, usual_reach
from bondem.specimen.tessellation.ownership import Owned, owned
from bondem.specimen.tessellation.raster import CENTRE_BITS, on_raster, pitch
from bondem.specimen.tessellation.shape_walls import faceted, wall_tree, wall_triangles
from bondem.specimen.tessellation.solids import (
    LOCAL,
    bulk,
    chosen_bulk,
    chosen_solids,
    joined,
    polygon_measures,
    solid_count,
    solid_of_face,
)

# Number of cells that are computed at once, between two reports of progress.
_BATCH = 4096
# Half the width of the initial boxes of cells, over the usual distance of the farthest neighbour.
_HALF = 0.67
# Width of the flat pieces of curved walls, about half an element, over that distance.
_FLAT = 0.25
# Least depth of a wall that splits a cell, over that distance, and least area of a facet, over its square.
_REACHED, _SLIVER = 3e-12, 1e-11
# Relative difference of volumes from which a part of the shape is lost; those of combined shapes are known to 1e-3.
_LOST = 0.02
# Largest distance of centres outside the walls by rounding, over the usual distance.
_OUTSIDE = 1e-9


@dataclass(frozen=True, eq=False)
class Tessellation:
    """All cells of a tessellation: whole cells, and those that walls cut into pieces.

    Attributes:
        centres: centres and radii of the elements, sorted into boxes.
        faces: polygons of whole cells, on walls or towards other whole cells, with one for each pair of cells.
        whole: elements whose cells are whole, shape (w,).
        whole_bulk: volumes and moments of the whole cells.
        cut: pieces of all other cells, inside the shape.
        is_cut: mask of the elements whose cells are cut by walls, shape (n,).
        outlines: whole cells as solids, if requested, else an empty list.
    """

    centres: Bins
    faces: Polygons
    whole: Ints
    whole_bulk: Bulk
    cut: Owned
    is_cut: Mask
    outlines: Solids


@dataclass(frozen=True, eq=False)
class _Walls:
    """Flat walls that cut cells: their shape, the search tree of their triangles, and distances of the centres."""

    shape: Shape
    tree: WallTree
    clear: PerElement  #: distance of each centre from the walls [m], shape (n,)


@dataclass(frozen=True, eq=False)
class _Batch:
    """Result of one batch of cells: whole cells (`plain`), with faces and volumes, and pieces inside the walls.

    Attributes:
        again: elements whose boxes were too small.
        ended: elements whose cells end at their boxes, but only outside the shape.
    """

    plain: Solids
    faces: Polygons
    whole: Ints
    whole_bulk: Bulk
    pieces: Solids
    piece_bulk: Bulk
    again: Ints
    ended: Ints


def _walls(particles: Particles, shape: Shape, reach: float) -> tuple[Shape, tuple[_Walls, ...]]:
    """Return the shape with flat walls, and its walls: none for a box, whose sides end all cells anyway.

    Raises:
        InputError: Centres lie outside the shape.
    """
    depth = shape.depth(particles.position)
    outside = np.flatnonzero(depth < -_OUTSIDE * reach)
    if outside.size:
        worst = int(np.argmin(depth))
        raise InputError(
            f"{outside.size} centres lie outside the {type(shape).__name__} that is to be cut into cells, that of"
            f" element {worst} by {-depth[worst]:.3g} m; remove these elements, or correct the shape"
        )
    if isinstance(shape, Box | BoundingBox | Cell):
        return shape, ()
    flat = faceted(shape, _FLAT * reach)
    return flat, (_Walls(flat, wall_tree(wall_triangles(flat)), flat.depth(particles.position)),)


def _retained_faces(plain: Solids, retained: np.ndarray, position: PerElement3) -> Polygons:
    """Return the faces of the `retained` cells that lie on walls, or have an element of higher number behind them."""
    of_face = solid_of_face(plain)
    cell = plain.cell[of_face]
    rows = np.flatnonzero(retained[of_face] & ((plain.tag < 0) | (plain.tag > cell)))
    own = plain.cell[of_face[rows]]
    area, centroid, moment = (values[rows] for values in polygon_measures(plain.corner, plain.vertex))
    other = np.maximum(plain.tag[rows], -1)
    return Polygons(own, other, area, plain.plane[rows, :3], centroid + position[own], moment)


def _batch(centres: Bins, walls: tuple[_Walls, ...], chosen: Ints, half: Floats) -> _Batch:
    """Compute the cells of chosen elements in boxes of half widths (k,) [m], and cut them by walls."""
    plain = plain_cells(centres, chosen, half)
    measures = bulk(plain)
    local = np.bincount(solid_of_face(plain), weights=plain.tag == LOCAL, minlength=len(chosen)) > 0
    clear = np.ones(len(chosen), dtype=bool)
    for one in walls:
        clear = measures.farthest < one.clear[chosen]
    retained = clear & ~local
    again = chosen[clear & local]
    pieces, piece_bulk = joined([]), bulk(joined([]))
    for one in () if clear.all() else walls:
        tolerance = max(_REACHED * centres.reach, centres.tolerance)
        pieces = trimmed(chosen_solids(plain, np.flatnonzero(~clear)), centres.position, one.tree, tolerance)
        piece_bulk = bulk(pieces)
        inside = one.shape.depth(piece_bulk.middle + centres.position[pieces.cell]) >= 0.0
        count = solid_count(pieces)
        open_ended = np.bincount(solid_of_face(pieces), weights=pieces.tag == LOCAL, minlength=count) > 0
        redo = np.unique(pieces.cell[inside & open_ended])
        again = np.concatenate([again, redo])
        good = np.flatnonzero(inside & ~np.isin(pieces.cell, redo))
        pieces, piece_bulk = chosen_solids(pieces, good), chosen_bulk(piece_bulk, good)
    rows = np.flatnonzero(retained)
    return _Batch(
        chosen_solids(plain, rows), _retained_faces(plain, retained, centres.position), chosen[rows],
        chosen_bulk(measures, rows), pieces, piece_bulk, again, np.setdiff1d(chosen[~clear & local], again),
    )  # fmt: skip


def _batches(
    centres: Bins, walls: tuple[_Walls, ...], chosen: Ints, half: Floats, report: Callable[[float], None]
) -> Iterator[_Batch]:
    """Yield batches of cells; cells that outgrow their boxes follow in boxes twice as wide, which doubles `half`."""
    waiting, done = chosen, 0
    with ThreadPoolExecutor(current_threads()) as pool:
        while waiting.size:
            some = [waiting[k : k + _BATCH] for k in range(0, len(waiting), _BATCH)]
            again = []
            for batch in pool.map(lambda part: _batch(centres, walls, part, half[part]), some):
                again.append(batch.again)
                done += len(batch.whole) + len(np.unique(batch.pieces.cell))
                report(min(done / len(chosen), 1.0))
                yield batch
            waiting = np.concatenate(again)
            half[waiting] *= 2.0


def tessellation(
    particles: Particles, progress: Callable[[float], None] | None = None, *, outlines: bool = False
) -> Tessellation:
    """Cut the shape of particles into cells, some of them in pieces; `tessellate` converts them to tables.

    Args:
        particles: spheres in a shape; without one, in the box around them.
        progress: function called repeatedly with the completed share, 0 … 1.
        outlines: True to return the whole cells as solids too.

    Raises:
        InputError: Centres coincide or lie outside the shape, a cell has no volume, a periodic cell is too small, or
            a part of the shape is connected to no element.
    """
    shape, n = particles.envelope, len(particles)
    reach = usual_reach(particles)
    flat, walls = _walls(particles, shape, reach)
    centres = bins(particles, *flat.bounds, reach)
    half = np.full(n, _HALF * centres.reach)
    made = [
        batch if outlines else replace(batch, plain=joined([]))
        for batch in _batches(centres, walls, np.arange(n), half, progress or (lambda share: None))
    ]
    pieces = joined([batch.pieces for batch in made])
    measures = _joined_bulk([batch.piece_bulk for batch in made])
    ended = np.concatenate([batch.ended for batch in made])
    sliver = _SLIVER * centres.reach**2
    while True:
        found = patches(pieces, centres.position, sliver)
        early = np.intersect1d(found.expected, ended)
        if not early.size:
            break
        half[early] *= 2.0
        more = list(_batches(centres, walls, early, half, lambda share: None))
        retained = np.flatnonzero(~np.isin(pieces.cell, early))
        pieces = joined([chosen_solids(pieces, retained), *(batch.pieces for batch in more)])
        measures = _joined_bulk([chosen_bulk(measures, retained), *(batch.piece_bulk for batch in more)])
        ended = np.concatenate([np.setdiff1d(ended, early), *(batch.ended for batch in more)])
    sphere = np.column_stack([centres.position, centres.radius])
    all_pieces = owned(pieces, measures, found, sphere, centres.reach, sliver)
    is_cut = np.zeros(n, dtype=bool)
    is_cut[pieces.cell] = True
    faces = together([batch.faces for batch in made])
    # facets between a whole cell and a cut one are those of the pieces of the latter
    faces = faces.chosen(((faces.b < 0) | ~is_cut[np.maximum(faces.b, 0)]) & (faces.area > sliver))
    return Tessellation(
        centres, faces, np.concatenate([batch.whole for batch in made]),
        _joined_bulk([batch.whole_bulk for batch in made]), all_pieces, is_cut,
        joined([batch.plain for batch in made]),
    )  # fmt: skip


def _joined_bulk(parts: list[Bulk]) -> Bulk:
    return Bulk(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def tessellate(particles: Particles, progress: Callable[[float], None] | None = None) -> tuple[Pairs, Facets, Cells]:
    """Cut the shape of particles into Laguerre cells.

    Args:
        particles: spheres in a shape; without one, in the box around them.
        progress: function called repeatedly with the completed share, 0 … 1.

    Returns:
        Pairs i < j of neighbours, sorted, shape (m, 2), the facets between them, and the cells. Curved walls become
        flat pieces half an element wide, with the volume of the shape.

    Raises:
        InputError: Centres coincide or lie outside the shape, a cell has no volume, a periodic cell is too small, or
            a part of the shape has no elements.
    """
    report = progress or (lambda share: None)
    made = tessellation(particles, lambda share: report(0.9 * share))
    found, (a, b) = made.cut.found, made.cut.sides
    shared = Polygons(a, b, found.area, found.normal, found.centroid, found.moment)
    every = together([made.faces, shared.chosen(a != b)])
    free = free_facets(particles.envelope, made.centres.position, made.centres.reach, every.chosen(every.b < 0))
    volume, centroid, inertia = _solid_tables(made)
    _check_volume(particles.envelope, float(volume.sum()))
    pairs, between, remainder = facets(particles, every.chosen(every.b >= 0).facing(), free, volume)
    report(1.0)
    grid = pitch(made.centres.reach, particles.period, CENTRE_BITS)
    return pairs, between, Cells(volume, freeze(on_raster(centroid, grid)), inertia, remainder, free)


def cell_centroids(particles: Particles) -> PerElement3:
    """Return the centroids of the Laguerre cells of particles [m], (n, 3), without the cost of their facets."""
    return _solid_tables(tessellation(particles))[1]


def _check_volume(shape: Shape, volume: float) -> None:
    """Raise InputError if the volume of all cells [m³] differs from that of the shape: a part has no elements."""
    whole = shape.volume
    if abs(volume / whole - 1.0) > _LOST:
        raise InputError(
            f"the cells fill {volume:.4g} m³ of the {whole:.4g} m³ of the shape: a part of it contains no"
            " element; add elements there, or remove that part"
        )


def _solid_tables(made: Tessellation) -> tuple[PerElement, PerElement3, Floats]:
    """Return volumes [m³], (n,), centroids [m], (n, 3), and inertia about them at density 1 [m⁵], (n, 3, 3)."""
    x, n = made.centres.position, len(made.centres.position)
    volume, first, second = np.zeros(n), np.zeros((n, 3)), np.zeros((n, 3, 3))
    volume[made.whole], first[made.whole] = made.whole_bulk.volume, made.whole_bulk.first
    second[made.whole] = made.whole_bulk.second
    part, owner = made.cut.measures, made.cut.owner
    shift = x[made.cut.pieces.cell] - x[owner]
    moved = part.volume[:, None] * shift
    np.add.at(volume, owner, part.volume)
    np.add.at(first, owner, part.first + moved)
    cross = part.first[:, :, None] * shift[:, None, :]
    np.add.at(second, owner, part.second + cross + cross.transpose(0, 2, 1) + moved[:, :, None] * shift[:, None, :])
    empty = np.flatnonzero(volume <= 1e-12 * made.centres.reach**3)
    if empty.size:
        raise InputError(
            f"the cell of element {empty[0]} has no volume ({empty.size} such cells): larger spheres enclose it, or"
            " walls pass through its centre; remove it, or make radii more alike"
        )
    middle = first / volume[:, None]
    second -= volume[:, None, None] * middle[:, :, None] * middle[:, None, :]
    trace = np.trace(second, axis1=1, axis2=2)
    return freeze(volume), freeze(x + middle), freeze(trace[:, None, None] * np.eye(3) - second)
