"""Small flat patches of the faces of shapes, on which pressures and dashpots act."""

import math
from itertools import pairwise

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Ball, BoundingBox, Box, Cylinder
from bondem.geometry.planes import box_side
from bondem.geometry.shape import Cut, Joined, Overlap, Placed, Shape
from bondem.geometry.surface import Surface

# Distance from a wall, over the size of the shape, at which points on both sides are tested for inside and outside.
_NEAR = 1e-6


def face_patches(shape: Shape, face: str, size: float) -> tuple[Floats, Floats]:
    """Cut a face of a shape into flat patches with edges of about `size` [m].

    Elementary shapes and surfaces are cut directly. For a combined shape the faces of its parts are cut; the patches
    that remain have the combined shape on one side and its outside on the other.

    Returns:
        Centres [m] and areas times outward normals [m²], (k, 3) each.

    Raises:
        InputError: The shape has no such face, or is of a kind that cannot be cut into patches.
    """
    shape.face_depth(face, np.zeros((1, 3)))  # raises InputError for an unknown face
    match shape:
        case Box() | BoundingBox():
            return _plane(*shape.bounds, face, size)
        case Cylinder(radius=radius, length=length):
            return _tube(radius, length, size) if face == "side" else _disc(radius, length, face, size)
        case Ball(radius=radius):
            return _sphere(radius, size)
        case Surface():
            return _facets(shape, face, size)
        case Placed(shape=inner, turn=turn, by=by):
            centre, area = face_patches(inner, face, size)
            rows = np.array(turn)
            return centre @ rows.T + by, area @ rows.T
        case Overlap() | Cut() | Joined():
            return _remaining(shape, face, size)
    raise InputError(f"faces of a {type(shape).__name__} cannot carry pressure or dashpots; use a Load")


def _plane(lower: Floats, upper: Floats, face: str, size: float) -> tuple[Floats, Floats]:
    axis, end = box_side(face)
    others = [k for k in range(3) if k != axis]
    counts = [max(1, math.ceil((upper[k] - lower[k]) / size)) for k in others]
    grid = np.indices(counts).reshape(2, -1).T + 0.5
    edge = (upper - lower)[others] / counts
    centre = np.empty((len(grid), 3))
    centre[:, others] = lower[others] + grid * edge
    centre[:, axis] = (lower, upper)[end][axis]
    area = np.zeros_like(centre)
    area[:, axis] = (2.0 * end - 1.0) * edge.prod()
    return centre, area


def _disc(radius: float, length: float, face: str, size: float) -> tuple[Floats, Floats]:
    rings = max(1, math.ceil(radius / size))
    edges = np.linspace(0.0, radius, rings + 1)
    centres, areas = [], []
    for inner, outer in pairwise(edges):
        count = max(6, math.ceil(2.0 * math.pi * outer / size))
        angle = 2.0 * math.pi * (np.arange(count) + 0.5) / count
        half = math.pi / count
        middle = 2.0 / 3.0 * (outer**3 - inner**3) / (outer**2 - inner**2) * math.sin(half) / half
        centres.append(np.column_stack([0.0 * angle, middle * np.cos(angle), middle * np.sin(angle)]))
        areas.append(np.full(count, (outer**2 - inner**2) * half))
    centre, area = np.concatenate(centres), np.zeros((sum(map(len, areas)), 3))
    top = face == "x_max"
    centre[:, 0] = length if top else 0.0
    area[:, 0] = np.concatenate(areas) * (1.0 if top else -1.0)
    return centre, area


def _tube(radius: float, length: float, size: float) -> tuple[Floats, Floats]:
    around, along = max(8, math.ceil(2.0 * math.pi * radius / size)), max(1, math.ceil(length / size))
    angle, x = np.meshgrid(
        2.0 * math.pi * (np.arange(around) + 0.5) / around, length * (np.arange(along) + 0.5) / along
    )
    normal = np.column_stack([np.zeros(angle.size), np.cos(angle).ravel(), np.sin(angle).ravel()])
    centre = radius * normal
    centre[:, 0] = x.ravel()
    return centre, normal * (2.0 * math.pi * radius * length / angle.size)


def _sphere(radius: float, size: float) -> tuple[Floats, Floats]:
    bands = 2 * max(2, math.ceil(0.5 * math.pi * radius / size))
    edge = np.linspace(0.0, math.pi, bands + 1)
    normals, areas = [], []
    for low, high in pairwise(edge):
        middle = 0.5 * (low + high)
        count = 2 * max(3, math.ceil(math.pi * radius * math.sin(middle) / size))
        angle = 2.0 * math.pi * (np.arange(count) + 0.5) / count
        across = math.sin(middle)
        normals.append(
            np.column_stack([across * np.cos(angle), across * np.sin(angle), np.full(count, math.cos(middle))])
        )
        areas.append(np.full(count, 2.0 * math.pi * radius**2 * (math.cos(low) - math.cos(high)) / count))
    normal = np.concatenate(normals)
    return radius * normal, normal * np.concatenate(areas)[:, None]


def _facets(surface: Surface, face: str, size: float) -> tuple[Floats, Floats]:
    """Divide each triangle of a face into n² equal triangles with sides of at most `size` [m]."""
    corner = surface.vertices[surface.triangles[surface.face_triangles(face)]]
    longest = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max(axis=1)
    cuts = np.maximum(1, np.ceil(longest / size)).astype(int)
    centres, areas = [], []
    for n in np.unique(cuts):
        a, b, c = np.moveaxis(corner[cuts == n], 1, 0)
        u, v = np.indices((n, n)).reshape(2, -1)
        up, down = u + v < n, u + v < n - 1
        shares = np.concatenate([
            np.column_stack([u[up], v[up]]) + 1.0 / 3.0, np.column_stack([u[down], v[down]]) + 2.0 / 3.0,
        ]) / n  # fmt: skip
        centre = a[:, None] + shares[:, :1] * (b - a)[:, None] + shares[:, 1:] * (c - a)[:, None]
        centres.append(centre.reshape(-1, 3))
        areas.append(np.repeat(0.5 * np.cross(b - a, c - a) / n**2, n * n, axis=0))
    return np.concatenate(centres), np.concatenate(areas)


def _remaining(shape: Overlap | Cut | Joined, face: str, size: float) -> tuple[Floats, Floats]:
    lower, upper = shape.bounds
    near = _NEAR * float((upper - lower).max())
    found: tuple[list[Floats], list[Floats]] = ([], [])
    for part in (shape.first, shape.second):
        flip = -1.0 if isinstance(shape, Cut) and part is shape.second else 1.0
        for name in part.faces:
            centre, area = face_patches(part, name, size)
            area = flip * area
            step = near * area / np.linalg.norm(area, axis=1, keepdims=True)
            wall = (shape.depth(centre - step) > 0.0) & (shape.depth(centre + step) < 0.0)
            if part is shape.second:  # a wall of both parts belongs to the first
                wall &= np.abs(shape.first.depth(centre)) > 0.1 * near
            centre, area = centre[wall], area[wall]
            own = np.abs(shape.face_depth(face, centre)) <= near if len(centre) else np.zeros(0, dtype=bool)
            found[0].append(centre[own])
            found[1].append(area[own])
    return np.concatenate(found[0]), np.concatenate(found[1])
