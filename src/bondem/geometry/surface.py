"""Shapes bounded by a closed triangulated surface, from a file or from arrays."""

import importlib
import os
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from bondem._checks import array, place
from bondem._names import users_line
from bondem._types import ArrayLike, Floats, Ints, PerElement, PerElement3, Vector
from bondem._units import length_unit
from bondem.errors import InputError, UnitWarning
from bondem.geometry.closed_surface import closed_surface
from bondem.geometry.shape import Shape
from bondem.geometry.shape_boundary import BOX_FACES
from bondem.geometry.triangles import Triangles

_SUFFIXES = (".stl", ".ply")

# Longest specimen taken for metres without being told so, with a warning and without [m].
_PLAUSIBLE, _USUAL = 10.0, 1.0

# How far from a side of the bounding box a facet may lie to be part of that face, over the size of the box;
# STL files keep seven digits.
_FLUSH = 1e-6


@dataclass(frozen=True, eq=False, repr=False)
class Surface(Shape):
    """The solid enclosed by a triangulated surface, for example `Surface("part.stl", unit="mm")`.

    Facets in a side of the bounding box form the faces "x_min" … "z_max"; all other facets form the face "side".
    Equal corners of several solids of a file, and doubled triangles, are merged. Solids must not touch: those that
    overlap are joined as two surfaces, `bd.Surface(…) | bd.Surface(…)`. A cavity faces inwards.

    Attributes:
        vertices: corners [m], (v, 3).
        triangles: corner indices of each triangle, counter-clockwise seen from outside, (t, 3).

    Raises:
        InputError: The file does not exist or has another format, its size cannot be in metres, the surface is not
            closed, or solids overlap.

    Warns:
        UnitWarning: The part of a file without a unit is longer than one metre.
    """

    vertices: Floats
    triangles: Ints

    def __init__(
        self,
        file: str | Path | None = None,
        *,
        unit: str | float | None = None,
        vertices: ArrayLike | None = None,
        triangles: ArrayLike | None = None,
    ) -> None:
        """Read a surface from a file, or make it from arrays.

        Args:
            file: STL or PLY file.
            unit: unit of length, by name ("mm") or in metres (1e-3); None for metres, if the size is plausible.
            vertices: corners (v, 3) in `unit`, instead of a file.
            triangles: corner indices (t, 3), together with `vertices`.
        """
        scale = None if unit is None else length_unit("Surface", unit)
        if file is not None:
            name = str(place("Surface: file", file))
            x, t = _read(Path(name))
        elif vertices is not None and triangles is not None:
            name = "the surface"
            x, t = _arrays(vertices, triangles)
        else:
            raise InputError("Surface needs a file, or both vertices= and triangles=")
        x, t = closed_surface(name, x, t)
        size = float(np.ptp(x, axis=0).max())
        if file is not None and scale is None and size > _PLAUSIBLE:
            raise InputError(
                f"{name} is {size:.4g} long and has no unit; give unit='mm', or unit='m' if its numbers are metres"
            )
        if file is not None and scale is None and size > _USUAL:
            warnings.warn(
                f"{name} is assumed to be {size:.4g} m long; give unit='m' to confirm, or unit='mm' for millimetres",
                UnitWarning, stacklevel=users_line(),
            )  # fmt: skip
        x = x * (1.0 if scale is None else scale)
        for key, values in (("vertices", x), ("triangles", t)):
            values.setflags(write=False)
            object.__setattr__(self, key, values)

    def __repr__(self) -> str:
        a, b, c = np.ptp(self.vertices, axis=0)
        return f"Surface({len(self.triangles)} triangles, {a:.4g} x {b:.4g} x {c:.4g} m)"

    @cached_property
    def _corner(self) -> Floats:
        return self.vertices[self.triangles]

    @cached_property
    def _facet(self) -> Floats:
        """Area of each triangle times its outward normal [m²], (t, 3)."""
        a, b, c = np.moveaxis(self._corner, 1, 0)
        return 0.5 * np.cross(b - a, c - a)

    @cached_property
    def _all(self) -> Triangles:
        return Triangles(self.vertices, self.triangles)

    @cached_property
    def _on_face(self) -> dict[str, Ints]:
        """Triangle numbers of each face."""
        lower, upper = self.bounds
        flush = _FLUSH * float((upper - lower).max())
        on_face, rest = {}, np.ones(len(self.triangles), dtype=bool)
        for face in BOX_FACES:
            axis, plane = "xyz".index(face[0]), upper if face.endswith("max") else lower
            flat = (np.abs(self._corner[:, :, axis] - plane[axis]) <= flush).all(axis=1)
            if flat.any():
                on_face[face] = np.flatnonzero(flat)
                rest &= ~flat
        if rest.any():
            on_face["side"] = np.flatnonzero(rest)
        return on_face

    @cached_property
    def _side(self) -> Triangles:
        return Triangles(self.vertices, self.triangles[self._on_face["side"]])

    def face_triangles(self, face: str) -> Ints:
        """Return the triangles of a face, as indices into `triangles`."""
        self._check_face(face)
        return self._on_face[face]

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return self.vertices.min(axis=0), self.vertices.max(axis=0)

    @property
    def volume(self) -> float:
        # Gauss: the flux of x/3 through the surface, about a point near it against cancellation
        middle = self.vertices.mean(axis=0)
        return float(((self._corner.mean(axis=1) - middle) * self._facet).sum() / 3.0)

    @property
    def area(self) -> float:
        return float(np.linalg.norm(self._facet, axis=1).sum())

    @property
    def faces(self) -> tuple[str, ...]:
        return tuple(self._on_face)

    def face_depth(self, face: str, points: PerElement3) -> PerElement:
        self._check_face(face)
        points = np.atleast_2d(points)
        if face == "side":
            depth = self.depth(points)
            return np.copysign(self._side.distance(points), depth)
        lower, upper = self.bounds
        axis = "xyz".index(face[0])
        return upper[axis] - points[:, axis] if face.endswith("max") else points[:, axis] - lower[axis]

    def depth(self, points: PerElement3) -> PerElement:
        return self._all.signed_distance(np.atleast_2d(np.asarray(points, dtype=float)))

    def face_centre(self, face: str) -> Vector:
        self._check_face(face)
        chosen = self._on_face[face]
        weight = np.linalg.norm(self._facet[chosen], axis=1)
        return weight @ self._corner[chosen].mean(axis=1) / weight.sum()

    def section(self) -> float:
        lower, upper = self.bounds
        return _section(self._corner, 0.5 * float(lower[0] + upper[0]))


def _section(corner: Floats, x: float) -> float:
    """Return the area of the section of a closed surface at x [m²], whose outline is where triangles cross it."""
    above = corner[:, :, 0] >= x
    area = 0.0
    for lone in range(3):
        a, b, c = (corner[:, (lone + k) % 3] for k in range(3))
        up = above[:, lone]
        crossed = (up != above[:, lone - 2]) & (up != above[:, lone - 1])
        a, b, c, up = a[crossed], b[crossed], c[crossed], up[crossed]
        p, q = (a + ((x - a[:, :1]) / (e[:, :1] - a[:, :1])) * (e - a) for e in (b, c))
        turn = p[:, 1] * q[:, 2] - p[:, 2] * q[:, 1]
        area += 0.5 * float(np.where(up, turn, -turn).sum())
    return abs(area)


def _arrays(vertices: ArrayLike, triangles: ArrayLike) -> tuple[Floats, Ints]:
    x = array("Surface", "vertices", vertices, wanted="corners, shape (v, 3)")
    numbers = array("Surface", "triangles", triangles, wanted="numbers of corners, shape (t, 3)")
    if not ((np.rint(numbers) == numbers) & (np.abs(numbers) < 2.0**31)).all():
        raise InputError("Surface: triangles contain fractional numbers; give indices of their corners, from 0")
    return x, numbers.astype(np.int64)


def _read(file: Path) -> tuple[Floats, Ints]:
    if file.suffix.lower() not in _SUFFIXES:
        raise InputError(f"{file}: Surface reads STL and PLY files; export the part as one of these")
    if not os.path.isfile(file):
        raise InputError(f"{file}: there is no such file; check the path")
    # loaded on use: a run without surfaces need not wait for it
    trimesh = importlib.import_module("trimesh")
    try:
        mesh = trimesh.load_mesh(file)
        return np.array(mesh.vertices, dtype=float), np.array(mesh.faces, dtype=np.int64)
    except Exception as error:  # whatever a parser trips over
        raise InputError(f"{file} cannot be read as {file.suffix[1:].upper()} ({error}); export it again") from error
