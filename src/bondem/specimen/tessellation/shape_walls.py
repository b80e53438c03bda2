"""Walls of a shape as triangles; curved walls become fine polyhedra of the same volume."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from bondem._checks import shown
from bondem._tables.tessellation_tables import WallTree
from bondem._types import Floats, PerElement, PerElement3, Vector
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Ball, BoundingBox, Box, Cylinder
from bondem.geometry.planes import depth_below_side
from bondem.geometry.shape import Cut, Joined, Overlap, Placed, Shape
from bondem.geometry.surface import Surface
from bondem.geometry.triangles import boxes_of_tree, tree_order

# Least number of sides of a cylinder, and of divisions of the triangles of an icosahedron into four for a ball.
_SIDES, _QUARTERED = 64, 3
_GOLDEN = 0.5 * (1.0 + math.sqrt(5.0))

# Two triangles per side of a box, counter-clockwise from outside; corner k is at (k // 4, k // 2 % 2, k % 2).
_BOX = np.array([
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
])  # fmt: skip


def faceted(shape: Shape, size: float) -> Shape:
    """Return a shape with flat walls in place of curved ones.

    Args:
        shape: any shape.
        size: usual width of the flat pieces of curved walls [m].

    Returns:
        A shape of the same structure, with prisms for cylinders and geodesic polyhedra for balls, each of the same
        volume.
    """
    if isinstance(shape, Cylinder):
        return _prism(shape, size)
    if isinstance(shape, Ball):
        return _geodesic(shape, max(_QUARTERED, round(math.log2(max(shape.radius / size, 1.0)))))
    if isinstance(shape, Placed):
        return replace(shape, shape=faceted(shape.shape, size))
    if isinstance(shape, Overlap | Cut | Joined):
        return replace(shape, first=faceted(shape.first, size), second=faceted(shape.second, size))
    return shape


def wall_triangles(shape: Shape) -> Floats:
    """Return corners of triangles that together cover all walls of a shape with flat walls, (t, 3, 3) [m].

    Triangles of one part of a combined shape that are no walls are included. Other shapes raise InputError.
    """
    if isinstance(shape, Surface):
        return shape.vertices[shape.triangles]
    if isinstance(shape, Prism):
        return shape.triangles()
    if isinstance(shape, Box | BoundingBox):
        lower, upper = shape.bounds
        k = np.arange(8)
        corner = lower + (upper - lower) * np.column_stack([k // 4, k // 2 % 2, k % 2])
        return corner[_BOX]
    if isinstance(shape, Placed):
        return wall_triangles(shape.shape) @ np.array(shape.turn).T + shape.by
    if isinstance(shape, Overlap | Cut | Joined):
        return np.concatenate([wall_triangles(shape.first), wall_triangles(shape.second)])
    raise InputError(f"{shown(shape)} cannot be cut into cells; use bd.Surface(vertices=, triangles=) of it")


@dataclass(frozen=True)
class Prism(Shape):
    """A regular prism with axis y = z = 0 and x in [0, length].

    Attributes:
        radius: distance from the axis to the edges that are parallel to it [m].
        length: length along x [m].
        sides: number of sides.
    """

    radius: float
    length: float
    sides: int

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        ring = self.ring
        return np.array([0.0, *ring.min(axis=0)]), np.array([self.length, *ring.max(axis=0)])

    @property
    def volume(self) -> float:
        return self.section() * self.length

    @property
    def area(self) -> float:
        edge = 2.0 * self.radius * math.sin(math.pi / self.sides)
        return 2.0 * self.section() + self.sides * edge * self.length

    @property
    def faces(self) -> tuple[str, ...]:
        return ("x_min", "x_max", "side")

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        if face != "side":
            return depth_below_side(self.bounds, face, points)
        _, y, z = np.atleast_2d(points).T
        step = 2.0 * math.pi / self.sides
        angle = np.arctan2(z, y)
        off = angle - (np.floor(angle / step) + 0.5) * step
        return self.radius * math.cos(0.5 * step) - np.hypot(y, z) * np.cos(off)

    def section(self) -> float:
        return 0.5 * self.sides * self.radius**2 * math.sin(2.0 * math.pi / self.sides)

    @property
    def ring(self) -> Floats:
        """Coordinates y and z of the edges [m], shape (sides, 2)."""
        around = np.arange(self.sides) * (2.0 * math.pi / self.sides)
        return self.radius * np.column_stack([np.cos(around), np.sin(around)])

    def triangles(self) -> Floats:
        """Return the triangles of the walls [m], shape (t, 3, 3)."""
        a = np.column_stack([np.zeros(self.sides), self.ring])
        b, up = np.roll(a, -1, axis=0), np.array([self.length, 0.0, 0.0])
        first, second = np.zeros_like(a), np.zeros_like(a) + up
        parts = [(a, b, b + up), (a, b + up, a + up), (first, b, a), (second, a + up, b + up)]
        return np.concatenate([np.stack(part, axis=1) for part in parts])


def _prism(shape: Cylinder, size: float) -> Prism:
    sides = max(_SIDES, math.ceil(2.0 * math.pi * shape.radius / size))
    angle = 2.0 * math.pi / sides
    return Prism(shape.radius * math.sqrt(angle / math.sin(angle)), shape.length, sides)


@lru_cache(maxsize=4)
def _geodesic(shape: Ball, quartered: int) -> Surface:
    p = _GOLDEN
    vertices = np.array([
        [-1, p, 0], [1, p, 0], [-1, -p, 0], [1, -p, 0], [0, -1, p], [0, 1, p], [0, -1, -p], [0, 1, -p],
        [p, 0, -1], [p, 0, 1], [-p, 0, -1], [-p, 0, 1],
    ])  # fmt: skip
    triangles = np.array([
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
        [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
        [8, 6, 7], [9, 8, 1],
    ])  # fmt: skip
    vertices = vertices / math.hypot(1.0, p)
    for _ in range(quartered):
        ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
        edge, which = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
        middle = vertices[edge].sum(axis=1)
        m = which.reshape(-1, 3) + len(vertices)
        vertices = np.concatenate([vertices, middle / np.linalg.norm(middle, axis=1, keepdims=True)])
        a, b, c = triangles.T
        p, q, r = m.T
        triangles = np.concatenate([np.column_stack(t) for t in ((a, p, r), (b, q, p), (c, r, q), (p, q, r))])
    inscribed = Surface(vertices=vertices, triangles=triangles)
    scale = shape.radius * (4.0 / 3.0 * math.pi / inscribed.volume) ** (1.0 / 3.0)
    return Surface(vertices=scale * vertices, triangles=triangles)


def wall_tree(corner: Floats) -> WallTree:
    """Build the search tree of wall triangles (t, 3, 3) [m], without those that have no area."""
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    size = np.linalg.norm(normal, axis=1)
    longest = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max(axis=1)
    sound = size > 1e-12 * longest**2
    corner, normal = corner[sound], normal[sound] / size[sound, None]
    plane = np.column_stack([normal, (normal * corner.mean(axis=1)).sum(axis=1)])
    count = len(corner)
    leaves = 1 << max(count - 1, 1).bit_length()
    order = np.append(np.arange(count), np.full(leaves - count, -1))
    middle = np.concatenate([corner.mean(axis=1), np.full((1, 3), np.inf)])  # row -1 for leaves without a triangle
    owner = tree_order(middle, order)
    none = owner[:, None] < 0
    lower = np.where(none, np.inf, corner.min(axis=1)[owner])
    upper = np.where(none, -np.inf, corner.max(axis=1)[owner])
    return WallTree(corner, plane, *boxes_of_tree(lower, upper), owner)
