"""Outlines of broken facets, which move with their cells; discs for broken beams."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints
from bondem.fracture.crack_faces import Faces, moved_points
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import Polyhedra
from bondem.specimen.tessellation.solids import ranges

# Corners of the polygon of a beam.
_CORNERS = 24


@dataclass(frozen=True, eq=False)
class CrackPolygons:
    """Outlines of facets as p polygons. A facet of a cell that walls divide, or of several pieces, may have several.

    Attributes:
        vertex: corners, polygon by polygon, half-way between both faces of the facet [m], shape (v, 3).
        start: corners of polygon q are start[q] … start[q + 1] - 1, shape (p + 1,).
        facet: row in `Cracks.facets` of each polygon, shape (p,).
        reference: corners in the reference, periodic image at element i [m], shape (v, 3).
    """

    vertex: Floats
    start: Ints
    facet: Ints
    reference: Floats

    def __len__(self) -> int:
        return len(self.facet)


def crack_polygons(
    lattice: Lattice, state: State, chosen: Ints, faces: Faces, solid: Callable[[], Polyhedra]
) -> CrackPolygons:
    """Return the outlines of the facets numbered `chosen`, user's order; for beams, discs of the area of the section.

    `solid` computes the polygons of all cells; it is called only for a body of cells.
    """
    reference, start, facet = _discs(faces) if lattice.facets is None else _outlines(lattice, chosen, solid)
    number = chosen[np.repeat(facet, np.diff(start))]
    on_i, gap = moved_points(lattice, state, number, reference)
    return CrackPolygons(on_i + 0.5 * gap, start, facet, reference)


def _outlines(lattice: Lattice, chosen: Ints, every: Callable[[], Polyhedra]) -> tuple[Floats, Ints, Ints]:
    if not len(chosen):
        return np.zeros((0, 3)), np.zeros(1, dtype=np.int64), np.zeros(0, dtype=np.int64)
    solid, n = every(), len(lattice.particles)
    i, j = lattice.pairs[chosen].T
    key = i * n + j
    order = np.argsort(key)
    wanted = np.where(solid.neighbour >= 0, solid.cell * n + solid.neighbour, -1)
    place = np.minimum(np.searchsorted(key, wanted, sorter=order), len(key) - 1)
    polygon = np.flatnonzero(key[order[place]] == wanted)
    facet = order[place[polygon]]
    by_facet = np.argsort(facet, kind="stable")
    corners, start = ranges(solid.start, polygon[by_facet])
    return solid.vertex[corners], start, facet[by_facet]


def _discs(faces: Faces) -> tuple[Floats, Ints, Ints]:
    k, n = len(faces.area), faces.straight
    aside = np.eye(3)[np.abs(n).argmin(axis=1)]
    u = np.cross(n, aside)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(n, u)
    angle = 2.0 * np.pi * np.arange(_CORNERS) / _CORNERS
    # a regular polygon of c corners has the area ½ c sin(2π/c) r²
    r = np.sqrt(faces.area / (0.5 * _CORNERS * np.sin(2.0 * np.pi / _CORNERS)))
    around = np.cos(angle)[None, :, None] * u[:, None, :] + np.sin(angle)[None, :, None] * v[:, None, :]
    corner = faces.reference[:, None, :] + r[:, None, None] * around
    return corner.reshape(-1, 3), _CORNERS * np.arange(k + 1), np.arange(k)
