"""Moments of a shape: volume, centre and second moments, from which mass and inertia follow."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Vector
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import Ball, BoundingBox, Box, Cylinder
from bondem.geometry.quadrature import cell_levels
from bondem.geometry.shape import Cut, Joined, Overlap, Placed, Shape
from bondem.geometry.shape_boundary import common_bounds
from bondem.geometry.surface import Surface


@dataclass(frozen=True, eq=False)
class Moments:
    """Integrals over a body.

    Attributes:
        volume: ∫ dV [m³].
        centre: ∫ x dV / V [m], (3,).
        second: ∫ (x - c) (x - c)ᵀ dV about the centre c [m⁵], (3, 3).
    """

    volume: float
    centre: Vector
    second: Floats

    @property
    def inertia(self) -> Floats:
        """Inertia tensor about the centre at density 1, ∫ (r² 1 - r rᵀ) dV [m⁵], (3, 3)."""
        return np.trace(self.second) * np.eye(3) - self.second

    def __add__(self, other: "Moments") -> "Moments":
        return _combined(self, other, 1.0)

    def __sub__(self, other: "Moments") -> "Moments":
        return _combined(self, other, -1.0)


def moments(shape: Shape) -> Moments:
    """Compute volume, centre and second moments of a shape.

    The moments are exact for cylinder, box, ball and triangulated surface, also if moved or rotated. Intersections of
    shapes, which cuts and unions subtract, are measured by refinement, to about 1e-3.

    Args:
        shape: any shape but a periodic cell.

    Raises:
        InputError: The shape is a periodic cell, which has no centre.
    """
    if shape.period is not None:
        raise InputError("a periodic cell has no centre and no moments of inertia; use a Box of the same size")
    match shape:
        case Box() | BoundingBox():
            lower, upper = shape.bounds
            return Moments(shape.volume, 0.5 * (lower + upper), np.diag(shape.volume / 12.0 * (upper - lower) ** 2))
        case Cylinder(radius=radius, length=length):
            across, along = 0.25 * radius**2, length**2 / 12.0
            spread = shape.volume * np.array([along, across, across])
            return Moments(shape.volume, np.array([0.5 * length, 0.0, 0.0]), np.diag(spread))
        case Ball(radius=radius):
            return Moments(shape.volume, np.zeros(3), 0.2 * shape.volume * radius**2 * np.eye(3))
        case Surface():
            return _enclosed(shape)
        case Placed(shape=inner, turn=rows, by=by):
            own, turn = moments(inner), np.array(rows)
            return Moments(own.volume, turn @ own.centre + by, turn @ own.second @ turn.T)
        case Cut(first=first, second=second):
            return moments(first) - _measured(Overlap(first, second)) if _meet(first, second) else moments(first)
        case Joined(first=first, second=second):
            both = moments(first) + moments(second)
            return both - _measured(Overlap(first, second)) if _meet(first, second) else both
    return _measured(shape)


def _combined(a: Moments, b: Moments, sign: float) -> Moments:
    volume = a.volume + sign * b.volume
    centre = (a.volume * a.centre + sign * b.volume * b.centre) / volume
    second = np.zeros((3, 3))
    for part, factor in ((a, 1.0), (b, sign)):
        arm = part.centre - centre
        second += factor * (part.second + part.volume * np.outer(arm, arm))
    return Moments(volume, centre, second)


def _meet(first: Shape, second: Shape) -> bool:
    lower, upper = common_bounds(first, second)
    return bool((lower < upper).all())


def _enclosed(surface: Surface) -> Moments:
    """Sum moments of the tetrahedra from a point to the triangles; triangles that face the point count negative."""
    origin = surface.vertices.mean(axis=0)
    corner = surface.vertices[surface.triangles] - origin
    volume = np.linalg.det(corner) / 6.0
    whole = float(volume.sum())
    total = corner.sum(axis=1)
    centre = volume @ total / (4.0 * whole)
    # ∫ x xᵀ over a tetrahedron with one corner at 0: V/20 (Σ p pᵀ + Σp Σpᵀ)
    second = np.einsum("t,tki,tkj->ij", volume, corner, corner) + np.einsum("t,ti,tj->ij", volume, total, total)
    return Moments(whole, origin + centre, second / 20.0 - whole * np.outer(centre, centre))


def _measured(shape: Shape) -> Moments:
    lower, upper = shape.bounds
    middle = 0.5 * (lower + upper)
    volume, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
    for cells in cell_levels(shape.depth, lower, upper):
        arm, weight = cells.centre - middle, cells.size * cells.share
        volume += float(weight.sum())
        first += weight @ arm
        second += (weight[:, None] * arm).T @ arm + weight.sum() * np.diag(cells.edge**2) / 12.0
    if not volume > 0.0:
        return Moments(0.0, middle, second)
    centre = first / volume
    return Moments(volume, middle + centre, second - volume * np.outer(centre, centre))
