"""Cells as polyhedra, for pictures and files."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, Ints
from bondem.specimen.joining import parts
from bondem.specimen.lattice import Lattice
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.tessellation.cutting import tessellation
from bondem.specimen.tessellation.solids import ranges, solid_of_face


@dataclass(frozen=True, eq=False)
class Polyhedra:
    """Boundary polygons of all cells, sorted by cell. Each facet occurs twice, once for either cell.

    Attributes:
        vertex: corners, polygon by polygon, counter-clockwise seen from outside [m], shape (v, 3).
        start: corners of polygon q are start[q] … start[q + 1] - 1, shape (p + 1,).
        cell: cell of each polygon, shape (p,).
        neighbour: the cell on the other side, or -1 on a wall, shape (p,).
    """

    vertex: Floats
    start: Ints
    cell: Ints
    neighbour: Ints


def polyhedra(lattice: Lattice) -> Polyhedra:
    """Compute the boundary polygons of each cell of a body.

    A cell that is divided by walls, or made of pieces, has several polygons in one plane.

    Args:
        lattice: a body of cells, from `bd.connect(..., method="laguerre")`.

    Returns:
        Convex polygons. In a periodic cell the polygons of an element lie in the image at its centre.

    Raises:
        InputError: The lattice has no cells.
    """
    instance("polyhedra", "lattice", lattice, Lattice, 'a body, from bd.connect(..., method="laguerre")')
    lattice.elements.require_cells(
        'polyhedra: the lattice has no cells; make it with bd.connect(..., method="laguerre")'
    )
    made = [_moved_on(_of_body(particles), own) for own, particles in parts(lattice)]
    if len(made) == 1:
        return made[0]
    start = np.concatenate([[0], *(np.diff(one.start) for one in made)]).cumsum()
    cell = np.concatenate([one.cell for one in made])
    order = np.argsort(cell, kind="stable")
    rows, begin = ranges(start, order)
    vertex, neighbour = (np.concatenate([getattr(one, name) for one in made]) for name in ("vertex", "neighbour"))
    return Polyhedra(freeze(vertex[rows]), freeze(begin), freeze(cell[order]), freeze(neighbour[order]))


def _moved_on(solid: Polyhedra, own: Ints) -> Polyhedra:
    """Renumber the cells of a body by `own`, the numbers of its elements in the scene."""
    if len(own) == 0 or own[-1] == len(own) - 1:
        return solid
    neighbour = np.where(solid.neighbour >= 0, own[np.maximum(solid.neighbour, 0)], -1)
    return Polyhedra(solid.vertex, solid.start, freeze(own[solid.cell]), freeze(neighbour))


def _of_body(particles: Particles) -> Polyhedra:
    made = tessellation(particles, outlines=True)
    position, plain = made.centres.position, made.outlines
    found = made.cut.found
    own = plain.cell[solid_of_face(plain)]
    behind = np.maximum(plain.tag, -1)
    retained = np.flatnonzero((behind < 0) | ~made.is_cut[np.maximum(behind, 0)])
    corners, begin = ranges(plain.corner, retained)
    a, b = made.cut.sides
    outer = np.flatnonzero(a != b)
    back = outer[b[outer] >= 0]
    forth, size_forth = ranges(found.corner, outer)
    turned, size_turned = ranges(found.corner, back)
    # the corners of each polygon in reverse order
    turned = turned[np.repeat(size_turned[:-1] + size_turned[1:] - 1, np.diff(size_turned)) - np.arange(len(turned))]
    vertex = np.concatenate([
        plain.vertex[corners] + np.repeat(position[own[retained]], np.diff(begin), axis=0), found.vertex[forth],
        found.vertex[turned],
    ])  # fmt: skip
    size = np.concatenate([np.diff(begin), np.diff(size_forth), np.diff(size_turned)])
    cell = np.concatenate([own[retained], a[outer], b[back]])
    neighbour = np.concatenate([behind[retained], b[outer], a[back]])
    order = np.argsort(cell, kind="stable")
    rows, start = ranges(np.append(0, np.cumsum(size)), order)
    return Polyhedra(freeze(vertex[rows]), freeze(start), freeze(cell[order]), freeze(neighbour[order]))
