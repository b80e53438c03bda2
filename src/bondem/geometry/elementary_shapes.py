"""Elementary shapes of specimens: cylinder, box, periodic cell and ball."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._checks import array, number, shown
from bondem._plausibility import question_size
from bondem._types import Floats, PerElement, PerElement3, Triple, Vector
from bondem.errors import InputError
from bondem.geometry.planes import Planes, box_planes, depth_below_side
from bondem.geometry.shape import Shape
from bondem.geometry.shape_boundary import BOX_FACES

__all__ = ["Ball", "BoundingBox", "Box", "Cell", "Cylinder", "Shape"]


# Limits of lengths [m], beyond which volumes and moments of inertia overflow or vanish.
_SMALLEST, _LARGEST = 1e-30, 1e30


def _length(owner: str, name: str, value: object) -> float:
    length = number(owner, name, value, unit="m", above=0.0, advice="a positive length in metres")
    if not _SMALLEST <= length <= _LARGEST:
        raise InputError(f"{owner}: {name} = {length:g} m is not a plausible length; check its unit (metres)")
    return length


def _edges(owner: str, size: object) -> tuple[float, float, float]:
    given = array(owner, "size", size, wanted="three edge lengths in metres")
    if given.shape != (3,):
        raise InputError(f"{owner}: size = {shown(size)}; give three edge lengths in metres")
    a, b, c = (_length(owner, f"size[{k}]", value) for k, value in enumerate(given.tolist()))
    return a, b, c


@dataclass(frozen=True)
class Cylinder(Shape):
    """A circular cylinder with axis y = z = 0 and x in [0, length]; lengths that are not positive raise InputError.

    Attributes:
        radius: radius [m].
        length: length along x [m].
    """

    radius: float
    length: float

    def __post_init__(self) -> None:
        for name in ("radius", "length"):
            object.__setattr__(self, name, _length("Cylinder", name, getattr(self, name)))
        question_size("Cylinder", max(self.length, 2.0 * self.radius))

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        r = self.radius
        return np.array([0.0, -r, -r]), np.array([self.length, r, r])

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        half = 0.5 * self.length * turn[:, 0]
        reach = np.abs(half) + self.radius * np.hypot(turn[:, 1], turn[:, 2])
        return half + by - reach, half + by + reach

    @property
    def volume(self) -> float:
        return math.pi * self.radius**2 * self.length

    @property
    def area(self) -> float:
        return 2.0 * math.pi * self.radius * (self.radius + self.length)

    @property
    def faces(self) -> tuple[str, ...]:
        return ("x_min", "x_max", "side")

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        points = np.atleast_2d(points)
        if face == "side":
            return self.radius - np.hypot(points[:, 1], points[:, 2])
        return depth_below_side(self.bounds, face, points)

    @property
    def planes(self) -> Planes:
        return box_planes(self.bounds, ("x_min", "x_max"))

    def section(self) -> float:
        return math.pi * self.radius**2


class _Cuboid(Shape):
    """A box with edges along x, y and z, whose corners are its bounds."""

    @property
    def _edge(self) -> tuple[float, float, float]:
        a, b, c = np.subtract(*self.bounds[::-1]).tolist()
        return a, b, c

    @property
    def volume(self) -> float:
        return math.prod(self._edge)

    @property
    def area(self) -> float:
        a, b, c = self._edge
        return 2.0 * (a * b + b * c + c * a)

    @property
    def faces(self) -> tuple[str, ...]:
        return BOX_FACES

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        return depth_below_side(self.bounds, face, points)

    def section(self) -> float:
        return self._edge[1] * self._edge[2]


@dataclass(frozen=True)
class _Sized(_Cuboid):
    """A box with one corner at the origin."""

    size: Triple

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", _edges(type(self).__name__, self.size))
        question_size(type(self).__name__, max(self.size))

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.zeros(3), np.array(self.size)


@dataclass(frozen=True)
class Box(_Sized):
    """A box with one corner at the origin and the opposite corner at `size`.

    Attributes:
        size: edge lengths [m], (3,); values that are not positive raise InputError.
    """

    size: Triple

    @property
    def planes(self) -> Planes:
        return box_planes(self.bounds, BOX_FACES)


@dataclass(frozen=True)
class Cell(_Sized):
    """A periodic box from the origin to `size`, without walls and faces, for properties of the bulk.

    Attributes:
        size: edge lengths [m], (3,); values that are not positive raise InputError.
    """

    size: Triple

    @property
    def area(self) -> float:
        return 0.0

    @property
    def faces(self) -> tuple[str, ...]:
        return ()

    @property
    def period(self) -> Vector:
        return np.array(self.size)


@dataclass(frozen=True)
class Ball(Shape):
    """A ball centred at the origin.

    Attributes:
        radius: radius [m]; a value that is not positive raises InputError.
    """

    radius: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "radius", _length("Ball", "radius", self.radius))
        question_size("Ball", 2.0 * self.radius)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.full(3, -self.radius), np.full(3, self.radius)

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        return by - self.radius, by + self.radius

    @property
    def volume(self) -> float:
        return 4.0 / 3.0 * math.pi * self.radius**3

    @property
    def area(self) -> float:
        return 4.0 * math.pi * self.radius**2

    @property
    def faces(self) -> tuple[str, ...]:
        return ("side",)

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        return self.radius - np.linalg.norm(np.atleast_2d(points), axis=1)

    def section(self) -> float:
        return math.pi * self.radius**2


@dataclass(frozen=True)
class BoundingBox(_Cuboid):
    """The axis-parallel box around particles that have no shape.

    Attributes:
        lower: lower corner [m], (3,).
        upper: upper corner [m], (3,).
    """

    lower: tuple[float, float, float]
    upper: tuple[float, float, float]

    @classmethod
    def of(cls, position: PerElement3, radius: PerElement) -> "BoundingBox":
        """Return the smallest box around spheres at `position` (n, 3) with `radius` (n,) [m]."""
        a, b, c = (position - radius[:, None]).min(axis=0).tolist()
        d, e, f = (position + radius[:, None]).max(axis=0).tolist()
        return cls((a, b, c), (d, e, f))

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.array(self.lower), np.array(self.upper)
