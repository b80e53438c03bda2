"""Exact signed distance of points from a closed set of triangles.

Triangles are cut into pieces of even size, which form a tree of boxes. Each point searches the nearer branch first
and skips boxes farther away than the nearest triangle so far. The sign follows from the normal at the nearest point.
At edges and corners it is the mean of the adjacent normals, weighted by angle, which gives the right sign everywhere
(Bærentzen & Aanæs, IEEE Trans. Vis. Comput. Graph. 11, 2005).
"""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.surface_tables import Nearest, TriangleTree
from bondem._threads import current_threads
from bondem._types import Floats, Ints, PerElement, PerElement3, Vector

_PIECES = 10_000  # approximate number; more give tighter boxes but more levels
_FACING = 0.9  # cosine of the largest angle between a normal and a triangle that faces along it


class Triangles:
    """A set of triangles with a search tree for distances."""

    def __init__(self, vertices: Floats, triangles: Ints) -> None:
        """Build the search tree.

        Args:
            vertices: corners [m], (v, 3).
            triangles: three corner indices each, counter-clockwise seen from outside, (t, 3).
        """
        self._corner = vertices[triangles]
        self._side = np.roll(self._corner, -1, axis=1) - self._corner
        normal = np.cross(self._side[:, 0], self._side[:, 1])
        size = np.linalg.norm(normal, axis=1)
        self._normal = normal / np.where(size > 0.0, size, 1.0)[:, None]
        self._length2 = np.maximum((self._side**2).sum(axis=2), 1e-300)
        self._outward = self._outward_normals(triangles, len(vertices))
        piece, owner = _in_order(*_pieces(self._corner, 0.5 * float(size.sum())))
        boxes = boxes_of_tree(piece.min(axis=1), piece.max(axis=1))
        self._tree = TriangleTree(*boxes, owner, self._corner, self._side, self._normal)

    def _outward_normals(self, triangles: Ints, vertices: int) -> Floats:
        """Return the outward normals of the interior, the sides and the corners of each triangle, (t, 7, 3)."""
        before = -np.roll(self._side, 1, axis=1)
        cosine = (before * self._side).sum(axis=2) / np.sqrt(self._length2 * np.roll(self._length2, 1, axis=1))
        angle = np.arccos(np.clip(cosine, -1.0, 1.0))
        corner = np.zeros((vertices, 3))
        np.add.at(corner, triangles, angle[:, :, None] * self._normal[:, None])
        ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
        _, edge = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
        edge = edge.reshape(-1, 3)
        side = np.zeros((edge.max() + 1, 3))
        np.add.at(side, edge, self._normal[:, None])
        return np.concatenate([self._normal[:, None], side[edge], corner[triangles]], axis=1)

    def distance(self, points: PerElement3) -> PerElement:
        """Return the unsigned distance to the nearest triangle [m], (n,)."""
        return self._closest(points, self._nearest(points))[0]

    def signed_distance(self, points: PerElement3) -> PerElement:
        """Return the distance to the nearest triangle [m], positive inside the surface and negative outside, (n,)."""
        triangle = self._nearest(points)
        distance, feature, offset = self._closest(points, triangle)
        outward = self._outward[triangle, feature]
        return np.where((offset * outward).sum(axis=1) > 0.0, -distance, distance)

    def distance_of(self, triangles: Ints, point: Vector) -> PerElement:
        """Return the distance of a point (3,) from each of some triangles [m], (k,)."""
        return self._closest(np.broadcast_to(point, (len(triangles), 3)), triangles)[0]

    def facing(self, points: PerElement3, normals: PerElement3) -> tuple[Ints, PerElement]:
        """Return the nearest triangle that faces along a normal, within 26°, and the distance of its plane [m], (n,).

        The distance is infinite where no triangle faces along the normal.
        """
        triangle = self._nearest(points)
        for k in np.flatnonzero((self._normal[triangle] * normals).sum(axis=1) < _FACING):
            others = np.flatnonzero(self._normal @ normals[k] >= _FACING)
            if others.size:
                triangle[k] = others[self.distance_of(others, points[k]).argmin()]
        off = np.abs(((points - self._corner[triangle, 0]) * self._normal[triangle]).sum(axis=1))
        return triangle, np.where((self._normal[triangle] * normals).sum(axis=1) < _FACING, np.inf, off)

    def _nearest(self, points: PerElement3) -> Ints:
        triangle = np.empty(len(points), dtype=np.int64)
        found = Nearest(np.ascontiguousarray(points, dtype=float), triangle)
        run_pass(calls.find_nearest_triangles(self._tree, found), threads=current_threads())
        return triangle

    def _closest(self, points: PerElement3, triangle: Ints) -> tuple[PerElement, Ints, PerElement3]:
        """Return distance, feature (0 inside, 1–3 sides, 4–6 corners) and offset of points to their triangles."""
        from_corner = points[:, None] - self._corner[triangle]
        side, normal = self._side[triangle], self._normal[triangle]
        along = np.einsum("nij,nij->ni", from_corner, side) / self._length2[triangle]
        clipped = np.clip(along, 0.0, 1.0)
        to_side = from_corner - clipped[:, :, None] * side
        d2 = np.einsum("nij,nij->ni", to_side, to_side)
        each = np.arange(len(points))
        s = d2.argmin(axis=1)
        t = clipped[each, s]
        feature = np.where(t <= 0.0, 4 + s, np.where(t >= 1.0, 4 + (s + 1) % 3, 1 + s))
        height = np.einsum("nj,nj->n", from_corner[:, 0], normal)
        within = (np.einsum("nij,nij->ni", np.cross(normal[:, None], side), from_corner) > 0.0).all(axis=1)
        offset = np.where(within[:, None], height[:, None] * normal, to_side[each, s])
        distance = np.where(within, np.abs(height), np.sqrt(d2[each, s]))
        return distance, np.where(within, 0, feature), offset


def _pieces(corner: Floats, area: float) -> tuple[Floats, Ints]:
    """Halve triangles (t, 3, 3) until no side is long; return the pieces and the triangle of each."""
    longest = 1.5 * (area / _PIECES) ** 0.5
    piece, owner = corner, np.arange(len(corner))
    while True:
        length = np.linalg.norm(np.roll(piece, -1, axis=1) - piece, axis=2)
        long = length.max(axis=1) > longest
        if not long.any():
            return piece, owner
        whole, number = piece[long], owner[long]
        turn = (length[long].argmax(axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(whole, turn[:, :, None], axis=1), 1, 0)
        middle = 0.5 * (a + b)
        halves = [np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)]
        piece = np.concatenate([piece[~long], *halves])
        owner = np.concatenate([owner[~long], number, number])


def _in_order(piece: Floats, owner: Ints) -> tuple[Floats, Ints]:
    """Pad the pieces to a power of two by repetition, and sort them with their owners by `tree_order`."""
    fill = np.resize(np.arange(len(piece)), 1 << (len(piece) - 1).bit_length())
    centre = piece.mean(axis=1)[fill]
    chosen = fill[tree_order(centre, np.arange(len(fill)))]
    return piece[chosen], owner[chosen]


def tree_order(centre: Floats, order: Ints) -> Ints:
    """Sort the leaves of a tree so that each half, quarter, … is a compact part of space.

    Args:
        centre: positions, (k, 3); those of absent leaves are infinite and sorted to the end.
        order: rows of `centre`, one per leaf, (2^d,).
    """
    order = order[None]
    while order.shape[1] > 1:
        there = centre[order]
        known = np.isfinite(there)
        extent = np.where(known, there, -np.inf).max(axis=1) - np.where(known, there, np.inf).min(axis=1)
        along = np.take_along_axis(there, extent.argmax(axis=1)[:, None, None], axis=2)[:, :, 0]
        order = np.take_along_axis(order, np.argsort(along, axis=1, kind="stable"), axis=1)
        order = order.reshape(2 * len(order), -1)
    return order.ravel()


def boxes_of_tree(leaf_lower: Floats, leaf_upper: Floats) -> tuple[Floats, Floats]:
    """Return the corners of all boxes of a tree, level by level after an unused row, from those of its leaves."""
    lower, upper = [leaf_lower], [leaf_upper]
    while len(lower[0]) > 1:
        lower.insert(0, np.minimum(lower[0][::2], lower[0][1::2]))
        upper.insert(0, np.maximum(upper[0][::2], upper[0][1::2]))
    unused = np.zeros((1, 3))
    return np.concatenate([unused, *lower]), np.concatenate([unused, *upper])
