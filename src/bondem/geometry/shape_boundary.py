"""Walls of a shape: distances of points from its faces, and the quantities that follow from them."""

from abc import ABC, abstractmethod
from collections.abc import Sequence

import numpy as np

from bondem._checks import array, shown
from bondem._types import Floats, Mask, PerElement, PerElement3, Vector
from bondem.errors import InputError
from bondem.geometry.planes import Planes, box_side

# Largest number of names of patches that a message lists.
_LISTED = 8

BOX_FACES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")


class Walled(ABC):
    """A region of space with named faces.

    `face_depth(name, points)` is the distance of points from a named face, measured inwards [m]. Containment, packing
    walls and face regions follow from it. The gradient of a depth never exceeds 1, also for combined shapes; volumes
    and packing walls rely on this.
    """

    @property
    @abstractmethod
    def bounds(self) -> tuple[Vector, Vector]:
        """Lower and upper corner of a box around the shape [m], each (3,)."""

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        """Return corners of a box around the shape, rotated about the origin by `turn` (3, 3), moved by `by` [m]."""
        lower, upper = self.bounds
        middle, reach = turn @ (0.5 * (lower + upper)) + by, np.abs(turn) @ (0.5 * (upper - lower))
        return middle - reach, middle + reach

    @property
    @abstractmethod
    def volume(self) -> float:
        """Volume of the shape [m³]; of shapes that are combined by `&`, `|`, `-` or `cut` within about 1e-3."""

    @property
    @abstractmethod
    def area(self) -> float:
        """Area of all walls [m²], within about 1e-2 for combined shapes; 0 for a periodic cell."""

    @property
    @abstractmethod
    def faces(self) -> tuple[str, ...]:
        """Names of the faces."""

    @property
    def patch_names(self) -> tuple[str, ...]:
        """Names of parts of surfaces (`Surface.patches`), each of which lies on one or several of the faces."""
        return ()

    def on_patch(self, name: str, points: PerElement3, normals: PerElement3) -> Mask:
        """Return a mask (n,) of the points (n, 3) [m], on walls with outward normals (n, 3), that lie on a patch."""
        raise InputError(f"{type(self).__name__} has no patch {shown(name)}")

    def patch_area(self, name: str) -> float:
        """Return the area of a patch [m²]; nan where walls of another shape may have cut it."""
        return float("nan")

    def has_face(self, face: str) -> bool:
        """Return True if the shape has a face or patch of this name."""
        return face in self.faces or face in self.patch_names

    @abstractmethod
    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        """Return the distance of `points` from a face, positive inside [m], (n,); InputError for an unknown face."""

    @abstractmethod
    def section(self) -> float:
        """Return the area of the cross-section normal to x at mid-length [m²]."""

    @property
    def period(self) -> Vector | None:
        """Edge lengths of the periodic cell [m], (3,); None for other shapes."""
        return None

    @property
    def extent(self) -> float:
        """Extent of the shape along x [m]."""
        lower, upper = self.bounds
        return float(upper[0] - lower[0])

    def face_centre(self, face: str) -> Vector:
        """Return the point through which a load on a face acts [m], (3,).

        It is the centre of this side of the bounding box, or of the whole box for a face that is no side of a box.

        Raises:
            InputError: The shape has no such face.
        """
        self._check_face(face)
        bounds = self.bounds
        centre = 0.5 * (bounds[0] + bounds[1])
        if face in BOX_FACES:
            axis, end = box_side(face)
            centre[axis] = bounds[end][axis]
        return centre

    @property
    def planes(self) -> Planes:
        """Point [m] and outward normal of each plane face with the whole shape on one side, by face."""
        return {}

    def depth(self, points: PerElement3) -> PerElement:
        """Return the distance to the nearest wall [m], (n,): positive inside, negative outside, inf without walls."""
        return self.depth_of(self.faces, points)

    def depth_of(self, faces: Sequence[str], points: PerElement3) -> PerElement:
        """Return the depth of points (n, 3) [m] below the faces named in `faces` [m], (n,).

        A shape that is not the intersection of its faces uses all its faces.
        """
        points = np.atleast_2d(points)
        if not faces:
            return np.full(len(points), np.inf)
        depths = np.array([self.face_depth(face, points) for face in faces])
        # A point beyond several faces that meet at right angles is nearest to their edge or corner.
        beyond = np.sqrt((np.minimum(depths, 0.0) ** 2).sum(axis=0))
        return np.where(beyond > 0.0, -beyond, depths.min(axis=0))

    def contains(self, points: PerElement3) -> np.ndarray:
        """Return a mask (n,) of points (n, 3) [m] inside the shape or on its wall; InputError for other shapes."""
        at = np.atleast_2d(array("contains", "points", points, wanted="points as an array of shape (n, 3) [m]"))
        if at.shape[1:] != (3,):
            raise InputError(f"contains: points has shape {at.shape}; give points as an array of shape (n, 3) [m]")
        return self.depth(at) >= 0.0

    def _check_face(self, face: str) -> None:
        if not isinstance(face, str) or not self.has_face(face):
            known = ", ".join(self.faces) or "none (it is periodic)"
            if patches := self.patch_names:
                known += f"; and patches: {', '.join(patches[:_LISTED])}"
                known += f" … {patches[-1]}" if len(patches) > _LISTED else ""
            raise InputError(f"{type(self).__name__} has no face {shown(face)}; its faces are: {known}")


def common_bounds(first: Walled, second: Walled) -> tuple[Vector, Vector]:
    """Return lower and upper corner of the intersection of the bounds of two shapes [m], (3,) each."""
    (a, b), (c, d) = first.bounds, second.bounds
    return np.maximum(a, c), np.minimum(b, d)
