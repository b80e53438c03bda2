"""Conversion of polygons to tables: the polygons of a pair of elements, or of a wall of a cell, become one facet."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, Pairs, PerBond, PerElement, PerElement3
from bondem.errors import InputError
from bondem.geometry.shape import Shape
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.tessellation.balanced_shares import balanced_shares
from bondem.specimen.tessellation.facets import Facets, FreeFacets

# Differences of normals, and of depths over the width of a cell, below which free polygons lie on one wall.
_EQUAL = 1e-9
# Distance inside a wall, over the width of a cell, at which the face of the shape is determined.
_INSIDE = 0.1


@dataclass(frozen=True, eq=False)
class Polygons:
    """Flat polygons between element `a` and element `b` on the other side, which is -1 on a wall; p of them.

    Attributes:
        a, b: elements, shape (p,).
        area: areas [m²], shape (p,).
        normal: normals away from a [-], shape (p, 3).
        centroid: centroids in the image next to a [m], shape (p, 3).
        moment: second moments of area about the centroid [m⁴], shape (p, 3, 3).
    """

    a: Ints
    b: Ints
    area: Floats
    normal: Floats
    centroid: Floats
    moment: Floats

    def chosen(self, rows: np.ndarray) -> "Polygons":
        """Return the polygons in the given rows."""
        return Polygons(*(values[rows] for values in vars(self).values()))

    def facing(self) -> "Polygons":
        """Return the polygons with `a` and `b` exchanged, and the normal reversed, where a > b."""
        turn = self.a > self.b
        return Polygons(
            np.minimum(self.a, self.b), np.maximum(self.a, self.b), self.area,
            np.where(turn[:, None], -self.normal, self.normal), self.centroid, self.moment,
        )  # fmt: skip


def together(parts: list[Polygons]) -> Polygons:
    """Concatenate lists of polygons."""
    return Polygons(*(np.concatenate(column) for column in zip(*(vars(p).values() for p in parts), strict=True)))


def _merged(polygons: Polygons, key: Ints) -> Polygons:
    """Merge each run of equal keys, (p,), of sorted polygons into one polygon; those of a run lie in one plane."""
    start = np.flatnonzero(np.diff(key, prepend=key[:1] - 1))
    if len(start) == len(key):
        return polygons
    run = np.repeat(np.arange(len(start)), np.diff(start, append=len(key)))
    weight = polygons.area[:, None]
    total = np.add.reduceat(polygons.area, start)
    vector = np.add.reduceat(weight * polygons.normal, start)
    size = np.linalg.norm(vector, axis=1)
    normal = vector / np.where(size > 0.0, size, 1.0)[:, None]
    centroid = np.add.reduceat(weight * polygons.centroid, start) / total[:, None]
    off = polygons.centroid - centroid[run]
    moment = polygons.moment + weight[:, :, None] * off[:, :, None] * off[:, None, :]
    return Polygons(polygons.a[start], polygons.b[start], size, normal, centroid, np.add.reduceat(moment, start))


def facets(
    particles: Particles, polygons: Polygons, free: FreeFacets, volume: PerElement
) -> tuple[Pairs, Facets, PerElement]:
    """Convert the polygons between elements to facets, one per pair, with their shares in the dilatation of cells.

    Args:
        particles: the elements.
        polygons: polygons with a < b.
        free: facets on the surface.
        volume: volumes of the cells [m³], (n,).

    Returns:
        Pairs of elements, facets, and the remainders of the shares [-], (n,).

    Raises:
        InputError: A facet does not lie between its centres.
    """
    order = np.lexsort((polygons.b, polygons.a))
    polygons = polygons.chosen(order)
    one = _merged(polygons, polygons.a * len(particles) + polygons.b)
    i, j = one.a, one.b
    pairs, branch = np.column_stack([i, j]), particles.separation(i, j)
    depth_i = ((one.centroid - particles.position[i]) * one.normal).sum(axis=1)
    span = (branch * one.normal).sum(axis=1)
    depth_j = span - depth_i
    _check_depths(pairs, depth_i, depth_j)
    shares = balanced_shares(
        pairs, one.area[:, None] * one.normal, (depth_i / span, depth_j / span), branch, free, volume,
        particles.position,
    )  # fmt: skip
    table = Facets(*map(freeze, (
        one.area, one.normal, one.centroid, one.moment, depth_i, depth_j, shares.i, shares.j,
    )))  # fmt: skip
    return pairs, table, freeze(shares.remainder)


def _check_depths(pairs: Pairs, depth_i: PerBond, depth_j: PerBond) -> None:
    """Raise InputError for facets that do not lie between their centres: their springs would have negative length."""
    bad = np.flatnonzero(~((depth_i > 0.0) & (depth_j > 0.0)))
    if bad.size:
        i, j = map(int, pairs[bad[0]])
        raise InputError(
            f"the facet of elements {i} and {j} does not lie between their centres ({bad.size} such facets): one"
            " sphere holds most of the other; remove the smaller one, or make radii more alike"
        )


def free_facets(shape: Shape, position: PerElement3, width: float, polygons: Polygons) -> FreeFacets:
    """Convert the polygons on walls to free facets, one for each plane of each cell.

    Args:
        shape: shape that names the faces.
        position: centres [m], shape (n, 3).
        width: usual width of a cell [m].
        polygons: polygons without a neighbour.
    """
    depth = ((polygons.centroid - position[polygons.a]) * polygons.normal).sum(axis=1)
    plane = np.rint(np.column_stack([polygons.normal, depth / width]) / _EQUAL).astype(np.int64)
    order = np.lexsort((*plane.T, polygons.a))
    row = np.column_stack([polygons.a, plane])[order]
    key = np.cumsum((np.diff(row, axis=0, prepend=row[:1]) != 0).any(axis=1))
    one = _merged(polygons.chosen(order), key)
    depth = ((one.centroid - position[one.a]) * one.normal).sum(axis=1)
    face = _faces(shape, one.centroid, one.normal, _INSIDE * width)
    share = one.area[:, None] * one.normal
    return FreeFacets(*map(freeze, (one.a, one.area, one.normal, one.centroid, one.moment, depth, face, share)))


def _faces(shape: Shape, centroid: Floats, normal: Floats, inside: float) -> Ints:
    """Return the face index of points on walls, (p,): that of a near face whose depth grows along the inward normal.

    Walls of a notch or of a re-entrant corner may belong to no face of the shape; their index is -1.
    """
    # the depth of another face does not grow along the normal, and so misses by about `inside`
    least, number = np.full(len(centroid), 0.9 * inside), np.full(len(centroid), -1)
    if len(centroid):
        for k, face in enumerate(shape.faces):
            here = shape.face_depth(face, centroid)
            there = shape.face_depth(face, centroid - inside * normal)
            with np.errstate(invalid="ignore"):  # the depth below a face of joined shapes may be infinite here
                miss = np.abs(here) + np.abs(there - here - inside)
            nearer = np.where(np.isnan(miss), np.inf, miss) < least
            least, number = np.where(nearer, miss, least), np.where(nearer, k, number)
    return number
