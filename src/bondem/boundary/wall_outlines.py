"""Polygons that represent walls in pictures and files; infinite walls end a little beyond the specimen."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints
from bondem.boundary.wall_rows import wall_rows
from bondem.boundary.walls import CylinderWall, PlaneWall, SphereWall, Wall, pivot
from bondem.geometry.rotations import turned_vectors

# Sides of circles and cylinders, and rows of a sphere from pole to pole.
_SIDES, _ROWS = 48, 16
# Distance by which infinite walls end beyond the specimen, over its diagonal.
_BEYOND = 0.08


@dataclass(frozen=True, eq=False)
class WallOutlines:
    """Polygons of w walls in the reference, q of them.

    Attributes:
        vertex: corners, polygon by polygon [m], shape (v, 3).
        start: corners of polygon k are start[k] … start[k + 1] - 1, shape (q + 1,).
        wall: number of the wall of each polygon, shape (q,).
        outward: motion of each corner per growth of the radius of its wall [-], shape (v, 3).
        about: point about which each wall turns [m], shape (w, 3).
    """

    vertex: Floats
    start: Ints
    wall: Ints
    outward: Floats
    about: Floats

    def moved(self, walls: Floats) -> Floats:
        """Return the corners [m], (v, 3), moved, turned and grown with the walls of `State.walls`, (w, 27)."""
        row = wall_rows(walls)[np.repeat(self.wall, np.diff(self.start))]
        about = self.about[np.repeat(self.wall, np.diff(self.start))]
        arm = self.vertex + row["growth"][:, None] * self.outward - about
        return about + row["displacement"] + turned_vectors(row["orientation"], arm)


def wall_outlines(walls: Sequence[Wall], lower: Floats, upper: Floats) -> WallOutlines:
    """Return the polygons of walls about a specimen.

    Args:
        walls: walls of the model.
        lower, upper: corners of the box about the specimen [m], shape (3,).
    """
    corner = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    box = lower + corner * (upper - lower)
    parts = [_polygons(wall, box) for wall in walls]
    size = [len(loop) for loops, _ in parts for loop in loops]
    empty = np.zeros((0, 3))
    return WallOutlines(
        vertex=np.concatenate([empty, *(loop for loops, _ in parts for loop in loops)]),
        start=np.append(0, np.cumsum(size)).astype(np.int64),
        wall=np.repeat(np.arange(len(walls)), [len(loops) for loops, _ in parts]),
        outward=np.concatenate([empty, *(loop for _, loops in parts for loop in loops)]),
        about=np.array([pivot(wall) for wall in walls]).reshape(-1, 3),
    )


def _polygons(wall: Wall, box: Floats) -> tuple[list[Floats], list[Floats]]:
    """Return the corners of each polygon of a wall [m], and their motions per growth of its radius [-]."""
    margin = _BEYOND * float(np.linalg.norm(box[-1] - box[0]))
    match wall:
        case PlaneWall(outer=None, inner=0.0):
            loops = _rectangle(np.array(wall.point), np.array(wall.normal), box, margin)
        case PlaneWall():
            reach = float(np.linalg.norm(box - np.array(wall.point), axis=1).max()) + margin
            loops = _ring(wall, reach if wall.outer is None else wall.outer)
        case CylinderWall():
            return _tube(wall, box, margin)
        case SphereWall():
            return _globe(wall)
    return loops, [np.zeros_like(loop) for loop in loops]


def _across(axis: Floats) -> tuple[Floats, Floats]:
    """Return two unit vectors that form a right-handed frame with an axis."""
    u = np.cross(axis, np.eye(3)[np.abs(axis).argmin()]).astype(float)
    u /= np.linalg.norm(u)
    return u, np.cross(axis, u).astype(float)


def _rectangle(point: Floats, normal: Floats, box: Floats, margin: float) -> list[Floats]:
    u, v = _across(normal)
    a, b = (box - point) @ u, (box - point) @ v
    low, high = np.array([a.min(), b.min()]) - margin, np.array([a.max(), b.max()]) + margin
    around = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    return [point + around @ np.stack([u, v])]


def _circle(axis: Floats) -> Floats:
    """Return unit vectors around an axis, the first one again at the end, (s + 1, 3)."""
    u, v = _across(axis)
    angle = np.linspace(0.0, 2.0 * np.pi, _SIDES + 1)[:, None]
    return np.cos(angle) * u + np.sin(angle) * v


def _ring(wall: PlaneWall, outer: float) -> list[Floats]:
    point, around = np.array(wall.point), _circle(np.array(wall.normal))
    if not wall.inner:
        return [point + outer * around[:-1]]
    out, within = point + outer * around, point + wall.inner * around
    return [np.array([out[k], out[k + 1], within[k + 1], within[k]]) for k in range(_SIDES)]


def _tube(wall: CylinderWall, box: Floats, margin: float) -> tuple[list[Floats], list[Floats]]:
    point, axis = np.array(wall.point), np.array(wall.axis)
    along, around = (box - point) @ axis, _circle(np.array(wall.axis))
    ends = point + (along.min() - margin) * axis, point + (along.max() + margin) * axis
    out = [np.array([around[k], around[k + 1], around[k + 1], around[k]]) for k in range(_SIDES)]
    base = np.array([ends[0], ends[0], ends[1], ends[1]])
    return [base + wall.radius * one for one in out], out


def _globe(wall: SphereWall) -> tuple[list[Floats], list[Floats]]:
    around, axis = _circle(np.array([0.0, 0.0, 1.0])), np.array([0.0, 0.0, 1.0])
    angle = np.linspace(0.0, np.pi, _ROWS + 1)
    rows = [np.sin(one) * around + np.cos(one) * axis for one in angle]
    out = [
        np.array([rows[k][s], rows[k + 1][s], rows[k + 1][s + 1], rows[k][s + 1]])
        for k in range(_ROWS) for s in range(_SIDES)
    ]  # fmt: skip
    return [np.array(wall.centre) + wall.radius * one for one in out], out
