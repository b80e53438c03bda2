"""Shapes bounded by a closed triangulated surface, from a file or from arrays."""

import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from bondem._checks import array, instance, number, place, shown, vector
from bondem._names import warn_user
from bondem._outlets import OUTLETS
from bondem._plausibility import is_long
from bondem._types import ArrayLike, Floats, Ints, Mask, PerElement, PerElement3, Vector
from bondem._units import length_unit
from bondem.errors import InputError, UnitWarning
from bondem.geometry.closed_surface import closed_surface
from bondem.geometry.planes import box_side, depth_below_side
from bondem.geometry.shape import Shape
from bondem.geometry.shape_boundary import BOX_FACES
from bondem.geometry.smooth_patches import Patch, patch, smooth_patches
from bondem.geometry.surface_files.contents import Contents
from bondem.geometry.surface_files.formats import read_surface_file
from bondem.geometry.triangles import Triangles

# Largest size of a part whose file states no unit and is taken to be in metres, with a warning from 1 m on [m].
_PLAUSIBLE = 10.0

# Largest distance of the triangles of a face from that side of the bounding box, over the size of the box; STL files
# keep seven digits.
_FLUSH = 1e-6

# Angle from which an edge separates patches [rad], and cosine of the largest angle of a mean normal to a wanted one.
_SHARP = math.radians(35.0)
_ALONG = math.cos(math.radians(15.0))


@dataclass(frozen=True, eq=False, repr=False)
class Surface(Shape):
    """The solid enclosed by a triangulated surface, for example `Surface("part.stl", unit="mm")`.

    Facets in a side of the bounding box form the faces "x_min" … "z_max"; all other facets form the face "side".
    `bd.Face` also takes the name of any of `patches`: a face between sharp edges, such as "patch:3", or a solid,
    group or object of the file. `plot` shows them.

    Equal corners of several solids of a file, and doubled triangles, are merged. Solids must not touch: unite those
    that overlap as two surfaces, `bd.Surface(…) | bd.Surface(…)`. The triangles of a cavity face inwards.

    Attributes:
        vertices: corners [m], (v, 3).
        triangles: corner indices of each triangle, counter-clockwise seen from outside, (t, 3).
        named: triangles of each named part, as indices into `triangles`.
        sharp: angle between the normals of two triangles from which their edge separates patches [rad].

    Raises:
        InputError: The file does not exist or has another format, its size cannot be in metres, the surface is not
            closed or intersects itself, or solids overlap.

    Warns:
        UnitWarning: The part of a file without a unit is longer than one metre.
    """

    vertices: Floats
    triangles: Ints
    named: Mapping[str, Ints]
    sharp: float

    def __init__(
        self, file: str | Path | Any | None = None, *, unit: str | float | None = None,
        vertices: ArrayLike | None = None, triangles: ArrayLike | None = None,
        named: Mapping[str, ArrayLike] | None = None, sharp: float = _SHARP,
    ) -> None:  # fmt: skip
        """Read a surface from a file, or make it from arrays.

        Args:
            file: STL, OBJ, 3MF, PLY or OFF file, or a `trimesh.Trimesh`.
            unit: unit of length, by name ("mm") or in metres (1e-3). None for the unit that the file states, as 3MF
                does, else for metres, if the size is plausible.
            vertices: corners (v, 3) in `unit`, instead of a file.
            triangles: corner indices (t, 3), together with `vertices`.
            named: names of parts of the surface and the triangles of each, together with `vertices`.
            sharp: angle between the normals of two triangles from which their edge separates patches [rad].
        """
        scale = None if unit is None else length_unit("Surface", unit)
        sharp = number("Surface", "sharp", sharp, unit="rad", above=0.0, advice="an angle between 0 and π")
        name, (x, t, parts, own) = _given(file, vertices, triangles, named)
        x, t, retained = closed_surface(name, x, t)
        size = float(np.ptp(x, axis=0).max())
        scale = own if scale is None else scale
        if file is not None and scale is None and size > _PLAUSIBLE:
            raise InputError(
                f"{name} is {size:.4g} long and has no unit; give unit='mm', or unit='m' if its numbers are metres"
            )
        if file is not None and scale is None and is_long(size):
            warn_user(
                f"{name} is assumed to be {size:.4g} m long; give unit='m' to confirm, or unit='mm' for millimetres",
                UnitWarning,
            )
        x = x * (1.0 if scale is None else scale)
        for key, values in (("vertices", x), ("triangles", t)):
            values.setflags(write=False)
            object.__setattr__(self, key, values)
        object.__setattr__(self, "named", _retained_parts(parts, retained))
        object.__setattr__(self, "sharp", sharp)

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
        bounds = self.bounds
        flush = _FLUSH * float((bounds[1] - bounds[0]).max())
        on_face, rest = {}, np.ones(len(self.triangles), dtype=bool)
        for face in BOX_FACES:
            axis, end = box_side(face)
            flat = (np.abs(self._corner[:, :, axis] - bounds[end][axis]) <= flush).all(axis=1)
            if flat.any():
                on_face[face] = np.flatnonzero(flat)
                rest &= ~flat
        if rest.any():
            on_face["side"] = np.flatnonzero(rest)
        return on_face

    @cached_property
    def patches(self) -> tuple[Patch, ...]:
        """Parts that `bd.Face` takes by name: those that the file names, then "patch:1" … from the largest down.

        Numbered patches end at edges whose angle is `sharp` or more, and where a plane passes into a rounding. Their
        numbers do not depend on the order of the triangles. A part of the file gets the prefix "group:" if its name
        is also that of a face or of a numbered patch.
        """
        found = smooth_patches(self.vertices, self.triangles, self.sharp)
        taken = {*BOX_FACES, "side", *(one.name for one in found)}
        return (*(
            patch(f"group:{name}" if name in taken else name, chosen, self._corner, self._facet)
            for name, chosen in self.named.items()
        ), *found)  # fmt: skip

    @property
    def patch_names(self) -> tuple[str, ...]:
        return tuple(self._of_patch)

    def patch(self, *, near: ArrayLike | None = None, normal: ArrayLike | None = None) -> Patch:
        """Return a numbered patch by its place or direction: `bd.Face(part.patch(normal=(0, 0, 1)).name)`.

        Args:
            near: point [m], (3,), for the patch nearest to it.
            normal: direction of any length, (3,): only patches whose mean normal is within 15° of it count. Without
                `near`, the largest of them is returned.

        Raises:
            InputError: Neither is given, or no patch has this normal.
        """
        if near is None and normal is None:
            raise InputError("Surface.patch: give near=, a point [m], or normal=, a direction, or both")
        found = [one for one in self.patches if one.name not in self._group_names]
        if normal is not None:
            along = np.array(vector("Surface.patch", "normal", normal))
            found = [one for one in found if one.normal @ along > _ALONG * np.linalg.norm(along)]
            if not found:
                raise InputError(
                    f"Surface.patch: no patch has a mean normal within 15° of {shown(normal)}; see Surface.patches"
                )
        if near is None:
            return found[0]
        point = np.array(vector("Surface.patch", "near", near, unit="m"))
        return min(found, key=lambda one: float(self._all.distance_of(one.triangles, point).min()))

    def plot(self, path: str | Path | None = None, *, view: tuple[float, float] = (28.0, 24.0)) -> Any:
        """Draw the surface from two opposite sides, with the names of its patches.

        Args:
            path: PNG, PDF or SVG to write; nothing is written when None.
            view: azimuth and elevation of the camera [degree].

        Returns:
            A `matplotlib.figure.Figure`, which Jupyter shows; its `show()` opens a window.

        Raises:
            InputError: The view is not two angles, or nothing can be written at `path`.
            RunFileError: The disk is full, or another failure to write.
        """
        return OUTLETS.draw_surface(self, path, view=view)

    @cached_property
    def _of_patch(self) -> dict[str, Patch]:
        return {one.name: one for one in self.patches}

    @cached_property
    def _group_names(self) -> set[str]:
        return {one.name for one in self.patches[: len(self.named)]}

    @cached_property
    def _trees(self) -> dict[str, Triangles]:
        return {}

    def _tree(self, face: str) -> Triangles:
        """Return the triangles of a face with their search tree, built at first use."""
        if face not in self._trees:
            self._trees[face] = Triangles(self.vertices, self.triangles[self.face_triangles(face)])
        return self._trees[face]

    def face_triangles(self, face: str) -> Ints:
        """Return the triangles of a face or patch, as indices into `triangles`, (k,); InputError for another name."""
        self._check_face(face)
        return self._on_face[face] if face in self._on_face else self._of_patch[face].triangles

    def patch_area(self, name: str) -> float:
        return self._of_patch[name].area

    def on_patch(self, name: str, points: PerElement3, normals: PerElement3) -> Mask:
        self._check_face(name)
        triangle, off = self._all.facing(points, normals)
        size = float(np.ptp(self.vertices, axis=0).max())
        return np.isin(triangle, self._of_patch[name].triangles) & (off <= _FLUSH * size)

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        return self.vertices.min(axis=0), self.vertices.max(axis=0)

    def placed_bounds(self, turn: Floats, by: Vector) -> tuple[Vector, Vector]:
        placed = self.vertices @ turn.T + by
        return placed.min(axis=0), placed.max(axis=0)

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
        if face in BOX_FACES:
            return depth_below_side(self.bounds, face, points)
        points = np.atleast_2d(points)
        return np.copysign(self._tree(face).distance(points), self.depth(points))

    def depth(self, points: PerElement3) -> PerElement:
        return self._all.signed_distance(np.atleast_2d(np.asarray(points, dtype=float)))

    def face_centre(self, face: str) -> Vector:
        self._check_face(face)
        chosen = self.face_triangles(face)
        weight = np.linalg.norm(self._facet[chosen], axis=1)
        return weight @ self._corner[chosen].mean(axis=1) / weight.sum()

    def section(self) -> float:
        lower, upper = self.bounds
        return _section(self._corner, 0.5 * float(lower[0] + upper[0]))


def _section(corner: Floats, x: float) -> float:
    """Return the area of the section of a closed surface at x [m²], from the lines in which triangles cross x."""
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


def _given(
    file: Any, vertices: ArrayLike | None, triangles: ArrayLike | None, named: Mapping[str, ArrayLike] | None
) -> tuple[str, Contents]:
    """Return the name of a surface, for messages, and its contents, from a file, a Trimesh or arrays."""
    if (file is None) == (vertices is None and triangles is None and named is None):
        raise InputError("Surface needs either a file, or vertices= and triangles=, which may have named=")
    # if the user passes a mesh of trimesh, that package is already imported
    trimesh = sys.modules.get("trimesh")
    if trimesh is not None and isinstance(file, trimesh.Trimesh):
        unit = None if file.units is None else length_unit("Surface: units of the Trimesh", file.units)
        x, t = np.array(file.vertices, dtype=float), np.array(file.faces, dtype=np.int64)
        return "the Trimesh", Contents(x.reshape(-1, 3), t.reshape(-1, 3), {}, unit)
    if isinstance(file, str | Path):
        found = place("Surface: file", file)
        return str(found), read_surface_file(found)
    if file is not None:
        raise InputError(
            f"Surface: file = {shown(file)}; give a path, a trimesh.Trimesh (scene.to_mesh() of a Scene), or"
            " vertices= and triangles="
        )
    if vertices is None or triangles is None:
        raise InputError("Surface needs both vertices= and triangles=, or a file")
    x = array("Surface", "vertices", vertices, wanted="corners, shape (v, 3)")
    t = np.atleast_1d(_whole("triangles", triangles, "numbers of corners, shape (t, 3)"))  # one number has no length
    parts = {}
    if named is not None:
        instance("Surface", "named", named, Mapping, 'names and triangles, such as {"inlet": [0, 1]}')
        for name, chosen in named.items():
            instance("Surface", "a name of named", name, str, "a text")
            parts[name] = np.unique(_whole(f"named[{name!r}]", chosen, "numbers of triangles, from 0"))
            if parts[name].size and not 0 <= parts[name][0] <= parts[name][-1] < len(t):
                raise InputError(f"Surface: named[{name!r}] has triangles that do not exist; count them from 0")
    return "the surface", Contents(x, t, parts)


def _whole(name: str, values: ArrayLike, wanted: str) -> Ints:
    numbers = array("Surface", name, values, wanted=wanted)
    if not ((np.rint(numbers) == numbers) & (np.abs(numbers) < 2.0**31)).all():
        raise InputError(f"Surface: {name} contains fractional numbers; give {wanted}, from 0")
    return numbers.astype(np.int64)


def _retained_parts(parts: dict[str, Ints], retained: Ints) -> dict[str, Ints]:
    """Renumber triangles of named parts after repair; `retained` are the old numbers of those that remain, (t,)."""
    found = {name: np.flatnonzero(np.isin(retained, chosen)) for name, chosen in parts.items()}
    return {name: chosen for name, chosen in found.items() if chosen.size}
