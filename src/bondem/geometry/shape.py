"""The algebra of shapes: moved, rotated, joined and cut shapes."""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bondem._checks import choice, instance, number, shown, vector
from bondem._types import Axis, Floats, Mask, PerElement, PerElement3, Triple, Vector
from bondem.errors import InputError
from bondem.geometry.planes import Planes, box_side, placed, shared, turn_about
from bondem.geometry.quadrature import Content, cell_levels, content
from bondem.geometry.shape_boundary import BOX_FACES, Walled, common_bounds

_Rows = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]


class Shape(Walled):
    """A region of space with named faces.

    Combine shapes with operators: `a & b` is the intersection, `a | b` the union, and `a - b` the first shape without
    the second. Place them with `moved` and `rotated`.
    """

    def moved(self, by: Triple) -> "Shape":
        """Return the shape moved by the vector `by` [m], (3,).

        Raises:
            InputError: `by` is not three finite components.
        """
        return place_shape(self, np.eye(3), np.array(vector(type(self).__name__, "by", by, unit="m")))

    def rotated(self, axis: Axis, angle: float) -> "Shape":
        """Return the shape rotated right-handed by `angle` [rad] about "x", "y" or "z" through the origin.

        Raises:
            InputError: The axis is none of these, or the angle is no finite number.
        """
        choice(f"{type(self).__name__}.rotated", "axis", axis, Axis)
        angle = number(f"{type(self).__name__}.rotated", "angle", angle, unit="rad")
        return place_shape(self, turn_about(axis, angle), np.zeros(3))

    def cut(self, tool: "Shape", *, name: str = "cut") -> "Shape":
        """Return the shape without `tool`, such as a notch, whose walls become the face `name`.

        Raises:
            InputError: The shapes do not intersect, one of them is a periodic `Cell`, or the name is not a text.
        """
        return Cut(self, tool, name)

    def section(self) -> float:
        lower, upper = self.bounds
        lower[0] = upper[0] = 0.5 * (lower[0] + upper[0])
        return content(self.depth, lower, upper).volume

    def __bool__(self) -> bool:
        raise InputError("a shape has no truth value; join two by &, | and -, or compare with None by 'is'")

    def __and__(self, other: "Shape") -> "Shape":
        return Overlap(self, other)

    def __or__(self, other: "Shape") -> "Shape":
        return Joined(self, other)

    def __sub__(self, other: "Shape") -> "Shape":
        return Cut(self, other)


def place_shape(shape: Shape, turn: Floats, by: Vector) -> "Placed":
    """Return a shape rotated by a matrix (3, 3) about the origin and then moved by (3,) [m]."""
    if isinstance(shape, Placed):
        shape, turn, by = shape.shape, turn @ np.array(shape.turn), turn @ np.array(shape.by) + by
    first, second, third = turn
    return Placed(shape, (_three(first), _three(second), _three(third)), _three(by))


def _three(vector: Vector) -> tuple[float, float, float]:
    x, y, z = vector
    return float(x), float(y), float(z)


def _refuse_periodic(*shapes: Shape) -> None:
    for shape in shapes:
        instance("", "the other operand of a shape", shape, Shape, "a shape such as bd.Box(...)")
        if shape.period is not None:
            raise InputError(f"{shown(shape)} is periodic, without walls to move or cut; take a Box of the same size")


@dataclass(frozen=True)
class Placed(Shape):
    """A shape rotated about the origin and then moved; its faces keep their names.

    Attributes:
        shape: shape to place.
        turn: rotation matrix, by rows [-].
        by: displacement [m], (3,).
    """

    shape: Shape
    turn: _Rows
    by: tuple[float, float, float]

    def __post_init__(self) -> None:
        _refuse_periodic(self.shape)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return self.shape.placed_bounds(np.array(self.turn), np.array(self.by))

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        return self.shape.placed_bounds(turn @ np.array(self.turn), turn @ np.array(self.by) + by)

    @property
    def volume(self) -> float:
        return self.shape.volume

    @property
    def area(self) -> float:
        return self.shape.area

    @property
    def faces(self) -> tuple[str, ...]:
        return self.shape.faces

    @property
    def patch_names(self) -> tuple[str, ...]:
        return self.shape.patch_names

    def patch_area(self, name: str) -> float:
        return self.shape.patch_area(name)

    def on_patch(self, name: str, points: PerElement3, normals: PerElement3) -> Mask:
        return self.shape.on_patch(name, self._back(points), normals @ np.array(self.turn))

    def place(self, points: PerElement3) -> PerElement3:
        """Return points (n, 3) of `shape`, rotated and moved with it [m]."""
        return points @ np.array(self.turn).T + self.by

    def _back(self, points: PerElement3) -> PerElement3:
        return (np.atleast_2d(points) - self.by) @ np.array(self.turn)

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        return self.shape.face_depth(face, self._back(points))

    @property
    def planes(self) -> Planes:
        return placed(self.shape.planes, np.array(self.turn), np.array(self.by))

    def depth(self, points: PerElement3) -> PerElement:
        return self.shape.depth(self._back(points))

    def depth_of(self, faces: Sequence[str], points: PerElement3) -> PerElement:
        return self.shape.depth_of(faces, self._back(points))

    def face_centre(self, face: str) -> Vector:
        return np.array(self.turn) @ self.shape.face_centre(face) + self.by

    def section(self) -> float:
        return self.shape.section() if self.turn[0] == (1.0, 0.0, 0.0) else super().section()


@dataclass(frozen=True)
class _Pair(Shape):
    """Two combined shapes. Refinement finds volumes without a closed form to about 1e-3, and areas to 1e-2."""

    first: Shape
    second: Shape

    @property
    def patch_names(self) -> tuple[str, ...]:
        return self.first.patch_names

    def on_patch(self, name: str, points: PerElement3, normals: PerElement3) -> Mask:
        return self.first.on_patch(name, points, normals)

    def depth_of(self, faces: Sequence[str], points: PerElement3) -> PerElement:
        return self.depth(points)

    @cached_property
    def _common(self) -> Content:
        lower, upper = common_bounds(self.first, self.second)
        if (lower >= upper).any():
            return Content(0.0, 0.0)
        return content(self._both, lower, upper)

    def _both(self, points: PerElement3) -> PerElement:
        return np.minimum(self.first.depth(points), self.second.depth(points))

    @cached_property
    def _measured(self) -> Content:
        lower, upper = self.bounds
        margin = 0.02 * (upper - lower).max()  # a wall is measured from both sides
        return content(self.depth, lower - margin, upper + margin)

    @property
    def area(self) -> float:
        return self._measured.area


@dataclass(frozen=True)
class _Walls(_Pair):
    """A shape with the walls of a second one, all of one name; faces of the first shape keep their names."""

    name: str = "cut"

    def __post_init__(self) -> None:
        _refuse_periodic(self.first, self.second)
        instance(type(self).__name__, "name", self.name, str, "a text")
        lower, upper = common_bounds(self.first, self.second)
        flat = (upper - lower < 1e-9 * np.subtract(*self.first.bounds[::-1]).max()).any()
        if flat or not any((level.share > 0.0).any() for level in cell_levels(self._both, lower, upper)):
            raise InputError(f"{shown(self.first)} and {shown(self.second)} do not intersect; check places (metres)")

    @abstractmethod
    def beside(self, points: PerElement3) -> PerElement:
        """Return the distance of points (n, 3) from the walls of the second shape, positive inside [m], (n,)."""

    @property
    def faces(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.first.faces, self.name)))

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        walls = [self.beside(points)] if face == self.name else []
        if self.first.has_face(face):
            walls.append(self.first.face_depth(face, points))
        return np.min(walls, axis=0)

    def depth(self, points: PerElement3) -> PerElement:
        return np.minimum(self.first.depth(points), self.beside(points))


@dataclass(frozen=True)
class Overlap(_Walls):
    """The intersection of two shapes. Faces of the first shape keep their names; those of the second become `name`.

    Attributes:
        first: first shape.
        second: second shape; shapes that do not intersect raise InputError.
        name: name of the walls of the second shape; they join a face of the first shape that has this name.
    """

    first: Shape
    second: Shape
    name: str = "cut"

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return common_bounds(self.first, self.second)

    @property
    def volume(self) -> float:
        return self._common.volume

    def beside(self, points: PerElement3) -> PerElement:
        return self.second.depth(points)

    def face_centre(self, face: str) -> Vector:
        return self.first.face_centre(face) if self.first.has_face(face) else super().face_centre(face)


@dataclass(frozen=True)
class Cut(_Walls):
    """A shape without another one, for example a specimen with a notch. Faces of the first shape keep their names.

    Attributes:
        first: shape to cut.
        second: shape to remove; shapes that do not intersect raise InputError.
        name: name of the new walls; they join a face of the first shape that has this name.
    """

    first: Shape
    second: Shape
    name: str = "cut"

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return self.first.bounds

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        return self.first.placed_bounds(turn, by)

    @property
    def volume(self) -> float:
        return self.first.volume - self._common.volume

    @property
    def planes(self) -> Planes:
        return self.first.planes

    @cached_property
    def _new(self) -> tuple[str, ...]:
        """Faces of the second shape that become walls; faces in a plane of the first shape cut nothing."""
        tiny = 1e-9 * float(np.subtract(*self.first.bounds[::-1]).max())
        same = shared(self.second.planes, self.first.planes, tiny)
        return tuple(face for face in self.second.faces if face not in same) or self.second.faces

    def beside(self, points: PerElement3) -> PerElement:
        """Return the distance of points (n, 3) from the removed shape, positive outside of it [m], (n,)."""
        return -self.second.depth_of(self._new, points)

    def face_centre(self, face: str) -> Vector:
        if self.first.has_face(face):
            return self.first.face_centre(face)
        self._check_face(face)
        lower, upper = common_bounds(self.first, self.second)
        return 0.5 * (lower + upper)


@dataclass(frozen=True)
class Joined(_Pair):
    """The union of two shapes.

    The parts should overlap by two element diameters, as depths are approximate where the parts meet. Faces named
    "x_min" … "z_max" are only those in a side of the box around both parts. All other faces keep their names, and
    faces of both parts with the same name form one face.

    Attributes:
        first: first part.
        second: second part.
    """

    first: Shape
    second: Shape

    def __post_init__(self) -> None:
        _refuse_periodic(self.first, self.second)

    @cached_property
    def _bounds(self) -> tuple[Vector, Vector]:
        (a, b), (c, d) = self.first.bounds, self.second.bounds
        return np.minimum(a, c), np.maximum(b, d)

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        (a, b), (c, d) = self.first.placed_bounds(turn, by), self.second.placed_bounds(turn, by)
        return np.minimum(a, c), np.maximum(b, d)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        lower, upper = self._bounds
        return lower.copy(), upper.copy()

    @property
    def volume(self) -> float:
        return self.first.volume + self.second.volume - self._common.volume

    @cached_property
    def _parts(self) -> dict[str, list[Shape]]:
        """Parts that contribute to each face."""
        carried: dict[str, list[Shape]] = {}
        tiny = 1e-9 * float(np.subtract(*self._bounds[::-1]).max())
        for part in (self.first, self.second):
            for face in part.faces:
                if face in BOX_FACES:
                    axis, end = box_side(face)
                    if abs(part.bounds[end][axis] - self._bounds[end][axis]) > tiny:
                        continue
                carried.setdefault(face, []).append(part)
        return carried

    @property
    def faces(self) -> tuple[str, ...]:
        return tuple(self._parts)

    @property
    def patch_names(self) -> tuple[str, ...]:
        """Names of the patches of both parts, except names that both parts use, such as "patch:1"."""
        first, second = self.first.patch_names, self.second.patch_names
        return tuple(name for name in (*first, *second) if (name in first) != (name in second))

    def on_patch(self, name: str, points: PerElement3, normals: PerElement3) -> Mask:
        self._check_face(name)
        return self._carriers(name)[0].on_patch(name, points, normals)

    def _carriers(self, face: str) -> list[Shape]:
        """Return the parts that contribute to a face, or the part that has a patch of this name."""
        self._check_face(face)
        if face in self._parts:
            return self._parts[face]
        return [self.first if face in self.first.patch_names else self.second]

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        depth, deepest = np.full(len(np.atleast_2d(points)), np.inf), self.depth(points)
        for part in self._carriers(face):
            # A wall of one part that lies within the other is no wall.
            own = part.depth(points) >= deepest
            depth = np.where(own, np.minimum(depth, part.face_depth(face, points)), depth)
        return depth

    def depth(self, points: PerElement3) -> PerElement:
        """Return the distance to the nearest wall [m], (n,).

        The result is the larger depth of both parts, a lower bound of the distance where the parts meet.
        """
        return np.maximum(self.first.depth(points), self.second.depth(points))

    def face_centre(self, face: str) -> Vector:
        return np.mean([part.face_centre(face) for part in self._carriers(face)], axis=0)
