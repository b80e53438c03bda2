"""Shapes a specimen can have.

A shape knows its walls: `face_depth(name, points)` is the distance of points from a named face, measured
inwards [m], and everything else (containment, packing walls, face regions) follows from it.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerElement, PerElement3, Vector
from bondem.errors import InputError

_BOX_FACES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")


class Shape(ABC):
    """A region of space with named faces."""

    @property
    @abstractmethod
    def bounds(self) -> tuple[Vector, Vector]:
        """Lower and upper corner of the bounding box [m], each (3,)."""

    @property
    @abstractmethod
    def volume(self) -> float:
        """Volume [m³]."""

    @property
    @abstractmethod
    def area(self) -> float:
        """Area of all walls [m²]; 0 for a periodic cell."""

    @property
    @abstractmethod
    def faces(self) -> tuple[str, ...]:
        """Names of the faces."""

    @abstractmethod
    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        """Distance of `points` (n, 3) from a face, positive inside [m], shape (n,)."""

    @abstractmethod
    def section(self) -> float:
        """Area of the cross-section normal to x [m²] (at mid-length)."""

    @property
    def period(self) -> Vector | None:
        """Edge lengths of the periodic cell [m], (3,), or None."""
        return None

    @property
    def extent(self) -> float:
        """Extent along x [m]."""
        lower, upper = self.bounds
        return float(upper[0] - lower[0])

    def face_centre(self, face: str) -> Vector:
        """Centroid of a face [m], (3,): the point through which a load on the face acts."""
        lower, upper = self.bounds
        centre = 0.5 * (lower + upper)
        if face in _BOX_FACES:
            axis = "xyz".index(face[0])
            centre[axis] = upper[axis] if face.endswith("max") else lower[axis]
        return centre

    def depth(self, points: PerElement3) -> PerElement:
        """Distance to the nearest wall [m], positive inside, shape (n,); infinite without walls."""
        points = np.atleast_2d(points)
        if not self.faces:
            return np.full(len(points), np.inf)
        return np.min([self.face_depth(face, points) for face in self.faces], axis=0)

    def contains(self, points: PerElement3) -> np.ndarray:
        """Whether points lie inside or on the wall, shape (n,)."""
        return self.depth(points) >= 0.0

    def _check_face(self, face: str) -> None:
        if face not in self.faces:
            known = ", ".join(self.faces) or "none (it is periodic)"
            raise InputError(f"{type(self).__name__} has no face '{face}'; its faces are: {known}")


def _positive(owner: str, **lengths: float) -> None:
    for name, value in lengths.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(f"{owner}: {name} = {value} m; give a positive length in metres")


def _axis_depth(lower: Floats, upper: Floats, face: str, points: PerElement3) -> PerElement:
    axis = "xyz".index(face[0])
    x = np.atleast_2d(points)[:, axis]
    return upper[axis] - x if face.endswith("max") else x - lower[axis]


@dataclass(frozen=True)
class Cylinder(Shape):
    """A circular cylinder with axis y = z = 0 and x in [0, length].

    Attributes:
        radius: radius [m].
        length: length along x [m].
    """

    radius: float
    length: float

    def __post_init__(self) -> None:
        _positive("Cylinder", radius=self.radius, length=self.length)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        r = self.radius
        return np.array([0.0, -r, -r]), np.array([self.length, r, r])

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
        return _axis_depth(*self.bounds, face, points)

    def section(self) -> float:
        return math.pi * self.radius**2


@dataclass(frozen=True)
class Box(Shape):
    """A box from (0, 0, 0) to `size`.

    Attributes:
        size: edge lengths [m], (3,).
    """

    size: tuple[float, float, float]

    def __post_init__(self) -> None:
        if len(self.size) != 3:
            raise InputError(f"{type(self).__name__}: size = {self.size}; give three edge lengths in metres")
        object.__setattr__(self, "size", tuple(float(edge) for edge in self.size))
        _positive(type(self).__name__, **dict(zip(("size[0]", "size[1]", "size[2]"), self.size, strict=True)))

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.zeros(3), np.array(self.size)

    @property
    def volume(self) -> float:
        return math.prod(self.size)

    @property
    def area(self) -> float:
        a, b, c = self.size
        return 2.0 * (a * b + b * c + c * a)

    @property
    def faces(self) -> tuple[str, ...]:
        return _BOX_FACES

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        return _axis_depth(*self.bounds, face, points)

    def section(self) -> float:
        return self.size[1] * self.size[2]


@dataclass(frozen=True)
class Cell(Shape):
    """A periodic cell from (0, 0, 0) to `size`: no walls, no faces, the reference for bulk moduli.

    Attributes:
        size: edge lengths [m], (3,).
    """

    size: tuple[float, float, float]

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", Box(self.size).size)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.zeros(3), np.array(self.size)

    @property
    def volume(self) -> float:
        return math.prod(self.size)

    @property
    def area(self) -> float:
        return 0.0

    @property
    def faces(self) -> tuple[str, ...]:
        return ()

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        raise AssertionError("unreachable: a cell has no faces")

    def section(self) -> float:
        return self.size[1] * self.size[2]

    @property
    def period(self) -> Vector:
        return np.array(self.size)


@dataclass(frozen=True)
class Ball(Shape):
    """A ball about the origin.

    Attributes:
        radius: radius [m].
    """

    radius: float

    def __post_init__(self) -> None:
        _positive("Ball", radius=self.radius)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.full(3, -self.radius), np.full(3, self.radius)

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
class BoundingBox(Shape):
    """The axis-parallel box around spheres that came without a shape.

    Attributes:
        lower: lower corner [m], (3,).
        upper: upper corner [m], (3,).
    """

    lower: tuple[float, float, float]
    upper: tuple[float, float, float]

    @classmethod
    def of(cls, position: PerElement3, radius: PerElement) -> "BoundingBox":
        """The smallest box around spheres at `position` (n, 3) with `radius` (n,) [m]."""
        lower = (position - radius[:, None]).min(axis=0)
        upper = (position + radius[:, None]).max(axis=0)
        a, b, c = map(float, lower)
        d, e, f = map(float, upper)
        return cls((a, b, c), (d, e, f))

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return np.array(self.lower), np.array(self.upper)

    @property
    def _size(self) -> Floats:
        return np.subtract(self.upper, self.lower)

    @property
    def volume(self) -> float:
        return float(np.prod(self._size))

    @property
    def area(self) -> float:
        a, b, c = self._size
        return float(2.0 * (a * b + b * c + c * a))

    @property
    def faces(self) -> tuple[str, ...]:
        return _BOX_FACES

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        return _axis_depth(*self.bounds, face, points)

    def section(self) -> float:
        return float(self._size[1] * self._size[2])
