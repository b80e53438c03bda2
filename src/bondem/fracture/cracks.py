"""Crack surfaces of a state: broken facets in their present place, and their connection."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import breadth_first_order, connected_components
from scipy.spatial import KDTree

from bondem._checks import instance, number, place, unit_vector
from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.fracture.crack_faces import faces_of
from bondem.fracture.crack_polygons import CrackPolygons, crack_polygons
from bondem.fracture.crack_surfaces import CrackSurfaces, crack_surfaces
from bondem.io.vtk_polygons import write_polygons
from bondem.model.state import State
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra

# Corners of facets nearer to each other than this, in mean radii, are the same corner.
_SAME = 1e-6
# Broken beams whose middles lie within this many mean diameters belong to one surface.
_NEAR = 1.5


@dataclass(frozen=True, eq=False)
class Cracks:
    """Broken facets of cells, or broken beams as discs of their sections, k of them, in the pose of a state.

    Each facet is shown half-way between its two faces, which move with their cells.

    Attributes:
        facets: user's numbers, ascending, shape (k,).
        areas: area of each facet in the reference, or of the section of a beam [m²], shape (k,).
        centroid: centroids [m], shape (k, 3).
        normal: mean of the normals of both faces, from element i to j [-], shape (k, 3).
        opening: distance of the two faces along the normal, negative where they overlap [m], shape (k,).
        sliding: displacement between the faces across the normal [m], shape (k,).
        surface: number of the surface to which each facet belongs, shape (k,).
        surfaces: sets of connected facets. Facets of cells are connected by a common edge, broken beams if their
            contact points lay within 1.5 mean diameters of each other.
        polygons: outlines, for pictures and files.
    """

    facets: Ints
    areas: Floats
    centroid: Floats
    normal: Floats
    opening: Floats
    sliding: Floats
    surface: Ints
    surfaces: CrackSurfaces
    polygons: CrackPolygons

    @property
    def area(self) -> float:
        """Total area of the facets, each counted once although it has two faces [m²]."""
        return float(self.areas.sum())

    def __len__(self) -> int:
        return len(self.facets)

    def projected_area(self, direction: Sequence[float]) -> float:
        """Return the area of all facets seen along a direction, Σ A |n·d| [m²]; overhanging parts count too.

        Raises:
            InputError: The direction is not a vector, or has zero length.
        """
        return float(self.areas @ np.abs(self.normal @ unit_vector("projected_area", "direction", direction)))

    def write_vtkhdf(self, path: str | Path) -> None:
        """Write the polygons as VTKHDF PolyData, which ParaView 5.11 and later opens.

        Each polygon has the fields facet, surface, area of the facet, opening, sliding and normal.

        Args:
            path: file to write, by custom with the suffix .vtkhdf.

        Raises:
            InputError: The file cannot be written.
            RunFileError: The disk is full, or another failure to write.
        """
        row = self.polygons.facet
        fields = {
            "facet": self.facets, "surface": self.surface, "area": self.areas, "opening": self.opening,
            "sliding": self.sliding, "normal": self.normal,
        }  # fmt: skip
        shown = {name: values[row] for name, values in fields.items()}
        write_polygons(place("Cracks.write_vtkhdf: path", path), self.polygons.vertex, self.polygons.start, shown)


def cracks(lattice: Lattice, state: State, *, integrity: float = 0.0) -> Cracks:
    """Extract the crack surfaces of a state.

    Args:
        lattice: lattice of the state.
        state: state of an explicit run, such as `run.state`.
        integrity: largest integrity of the facets that count as cracked [-], in [0, 1): 0 for broken facets only,
            more to include softening facets.

    Raises:
        InputError: The state belongs to another lattice, or the integrity is outside [0, 1).
    """
    instance("cracks", "lattice", lattice, Lattice, "the lattice of the model")
    instance("cracks", "state", state, State, "the state of a run, or model.state()")
    number("cracks", "integrity", integrity, least=0.0, below=1.0, advice="a share in [0, 1), 0 for broken facets")
    whole = state.bond_integrity
    if len(state.pose) != len(lattice.particles) or len(whole) != len(lattice.pairs):
        raise InputError(f"cracks: the state has {len(state.pose)} elements and other bonds; give its own lattice")
    chosen = np.flatnonzero(whole <= integrity)
    faces = faces_of(lattice, state, chosen)
    polygons = crack_polygons(lattice, state, chosen, faces, partial(polyhedra, lattice))
    k, reach = len(chosen), _NEAR * 2.0 * lattice.particles.mean_radius
    first, second = _edges(lattice, polygons, k) if lattice.facets else _close(lattice, faces.reference, reach).T
    links = coo_array((np.ones(len(first), dtype=bool), (first, second)), shape=(k, k)).tocsr()
    _, found = connected_components(links, directed=False)
    order = np.argsort(-np.bincount(found, faces.area), kind="stable")
    label = np.argsort(order)[found]
    shift = _unwrapped(lattice, links, faces.centroid, label)
    surfaces = crack_surfaces(faces, polygons, label, shift)
    return Cracks(
        facets=chosen, areas=faces.area, centroid=faces.centroid, normal=faces.normal, opening=faces.opening,
        sliding=faces.sliding, surface=label, surfaces=surfaces, polygons=polygons,
    )  # fmt: skip


def _edges(lattice: Lattice, polygons: CrackPolygons, k: int) -> tuple[Ints, Ints]:
    """Return pairs of facets that share an edge (two corners) in the reference."""
    facet, count = np.repeat(polygons.facet, np.diff(polygons.start)), len(polygons.reference)
    near = _close(lattice, polygons.reference, _SAME * lattice.particles.mean_radius)
    same = coo_array((np.ones(len(near), dtype=bool), near.T), shape=(count, count))
    points, spot = connected_components(same, directed=False)
    at = coo_array((np.ones(count, dtype=np.int32), (facet, spot)), shape=(k, points)).tocsr()
    at.data[:] = 1  # a corner counts once for a facet of several polygons
    shared = (at @ at.T).tocoo()
    pairs = (shared.data >= 2) & (shared.row < shared.col)
    return shared.row[pairs], shared.col[pairs]


def _close(lattice: Lattice, place: Floats, reach: float) -> Ints:
    """Return pairs of points that are at most `reach` apart, also across the border of a periodic cell, (p, 2)."""
    period = lattice.particles.period
    if period is not None:
        place = np.mod(place, period)
        place = np.where(place >= period, 0.0, place)  # rounding
    return KDTree(place, boxsize=period).query_pairs(reach, output_type="ndarray")


def _unwrapped(lattice: Lattice, links: csr_array, centroid: Floats, label: Ints) -> Floats:
    """Return the shifts that bring the facets of each surface of a periodic cell side by side [m], (k, 3)."""
    shift = np.zeros_like(centroid)
    if lattice.particles.period is None:
        return shift
    for surface in range(int(label.max(initial=-1)) + 1):
        order, before = breadth_first_order(links, int(np.argmax(label == surface)), directed=False)
        for one in order[1:]:
            there = centroid[before[one]] + shift[before[one]]
            branch = lattice.particles.nearest((centroid[one] - there)[None])[0]
            shift[one] = there + branch - centroid[one]
    return shift
