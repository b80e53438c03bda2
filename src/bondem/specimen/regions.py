"""Regions: rules that select elements of a lattice, combined by `&`, `|` and `-`."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field

import numpy as np

from bondem._checks import count, instance, number, shown, vector
from bondem._types import ArrayLike, Floats, Ints, Mask, PerElement3, Triple, Vector
from bondem.errors import EmptyRegionError, InputError
from bondem.geometry.elementary_shapes import Shape
from bondem.specimen.bodies import Which
from bondem.specimen.lattice import Lattice


class Region(ABC):
    """A rule that selects elements of any lattice; `&`, `|` and `-` combine two regions."""

    @abstractmethod
    def mask(self, lattice: Lattice) -> Mask:
        """Return a mask of the matching elements, shape (n,). Rattlers are not excluded."""

    def select(self, lattice: Lattice) -> Ints:
        """Return the indices of the connected elements of the region, ascending and in the user's order, (k,).

        If the lattice has no bonds, all elements of the region are selected.

        Raises:
            EmptyRegionError: No connected element matches.
        """
        # without any bond, loose grains are not rattlers but the specimen itself
        chosen = self.mask(lattice) & lattice.connected if len(lattice.pairs) else self.mask(lattice)
        return np.flatnonzero(self._some(chosen, "connected element"))

    def with_rattlers(self, lattice: Lattice) -> Mask:
        """Return a mask of all elements of the region, rattlers included, (n,); loads and supports use `select`.

        Raises:
            EmptyRegionError: No element matches.
        """
        return self._some(self.mask(lattice), "element")

    def _some(self, chosen: Mask, kind: str) -> Mask:
        if not chosen.any():
            raise EmptyRegionError(f"{shown(self)} selects no {kind}; check its name, units (metres) and depth")
        return chosen

    def anchor(self, lattice: Lattice) -> Vector:
        """Return the point through which a load on the region acts [m], (3,).

        It is the mean of the centres of the connected elements of the region, not weighted by volume.

        Raises:
            EmptyRegionError: No connected element matches.
        """
        return lattice.centre[self.select(lattice)].mean(axis=0)

    def __bool__(self) -> bool:
        raise InputError("a region has no truth value; join two by &, | and -, or compare with None by 'is'")

    def __and__(self, other: "Region") -> "Region":
        return Intersection(self, as_region("&", other))

    def __or__(self, other: "Region") -> "Region":
        return Union(self, as_region("|", other))

    def __sub__(self, other: "Region") -> "Region":
        return Difference(self, as_region("-", other))


@dataclass(frozen=True)
class Everything(Region):
    """All elements, of which loads and supports act on the connected ones."""

    def mask(self, lattice: Lattice) -> Mask:
        return np.ones(len(lattice.particles), dtype=bool)


@dataclass(frozen=True)
class Face(Region):
    """Elements whose surface lies at a named face of the shape; for a body of cells, those with a facet on the face.

    Without a shape the face is a side of the bounding box of the spheres. In a loose or cut packing few spheres reach
    it; `depth=1.0` then selects a layer. A `FaceWarning` is given if far fewer elements are selected than lie near.

    Attributes:
        name: name of the face, such as "x_min", "x_max" or "side"; a shape without this face raises InputError.
        depth: largest distance of the surface of an element from the face, in mean radii [-]; ignored for cells.
        body: name or number of the body in a scene of several bodies; None if there is only one.
    """

    name: str
    depth: float = 0.02
    body: Which | None = None

    def __post_init__(self) -> None:
        instance("Face", "name", self.name, str, 'the name of a face, such as "x_min" or "side"')
        depth = number("Face", "depth", self.depth, advice="a finite depth, in mean radii [-]")
        object.__setattr__(self, "depth", depth)

    def mask(self, lattice: Lattice) -> Mask:
        return lattice.elements.face_mask(self.name, self.body, self.depth, shown(self))

    def anchor(self, lattice: Lattice) -> Vector:
        """Return the centroid of the face [m], (3,); on a body of cells, the centroid of the facets on the face."""
        return lattice.elements.face_centre(self.name, self.body)


@dataclass(frozen=True)
class Body(Region):
    """Elements of a body of a scene, or of a group of bodies; a scene without such a body raises InputError.

    Attributes:
        which: number of the body, its name, or the name of a group: "grains" selects "grains/0", "grains/1", …
    """

    which: Which

    def __post_init__(self) -> None:
        if isinstance(self.which, bool) or not isinstance(self.which, str | int | np.integer):
            raise InputError(f"Body: which = {shown(self.which)}; give the name or the number of a body")

    def mask(self, lattice: Lattice) -> Mask:
        return lattice.bodies.mask("Body", self.which)


@dataclass(frozen=True)
class Index(Region):
    """Elements given by their indices or by a mask, in the user's order.

    Args:
        elements: one index, indices (k,), or truth values (n,); stored as indices.
        size: number of elements that the lattice must have; None for any number, or for the length of a mask.

    Raises:
        InputError: The elements are neither indices from 0 nor truth values.
    """

    elements: tuple[int, ...]
    size: int | None = field(default=None, compare=False)

    def __init__(self, elements: ArrayLike, size: int | None = None) -> None:
        found = _indices(elements)
        if size is not None:
            size = count("Index", "size", size, advice="how many elements there must be, or None")
        if found.dtype == bool:
            size, found = len(found), np.flatnonzero(found)
        if found.size and found.min() < 0:
            raise InputError(f"Index: element {found.min()} does not exist; give element indices from 0")
        object.__setattr__(self, "elements", tuple(found.tolist()))
        object.__setattr__(self, "size", size)

    def __repr__(self) -> str:
        return f"Index(elements={shown(list(self.elements))})"

    def mask(self, lattice: Lattice) -> Mask:
        n = len(lattice.particles)
        if self.size is not None and self.size != n:
            raise InputError(f"Index: the mask has {self.size} elements, but the lattice has {n}; give a mask of {n}")
        wrong = [k for k in self.elements if not 0 <= k < n]
        if wrong:
            raise InputError(f"Index: element {wrong[0]} does not exist; give element indices from 0 to {n - 1}")
        chosen = np.zeros(n, dtype=bool)
        chosen[list(self.elements)] = True
        return chosen


@dataclass(frozen=True)
class Within(Region):
    """Elements whose particle has its centre inside a shape.

    Attributes:
        shape: any shape, in the coordinates of the specimen; other objects raise InputError.
    """

    shape: Shape

    def __post_init__(self) -> None:
        instance("Within", "shape", self.shape, Shape, "a shape such as bd.Ball(...)")

    def mask(self, lattice: Lattice) -> Mask:
        return self.shape.contains(lattice.particles.position)


@dataclass(frozen=True, kw_only=True)
class Plane(Region):
    """Elements whose particle has its centre on the side of a plane to which its normal points.

    `bd.pack(..., around=plane)` makes cells end on the plane.

    Attributes:
        point: any point of the plane [m], (3,).
        normal: vector of any length that points to the selected side, (3,).

    Raises:
        InputError: A value is not finite, or the normal has zero length.
    """

    point: Triple
    normal: Triple

    def __post_init__(self) -> None:
        object.__setattr__(self, "point", vector("Plane", "point", self.point, unit="m"))
        normal = vector("Plane", "normal", self.normal)
        length = float(np.linalg.norm(normal))
        if not length > 0.0:
            raise InputError(f"Plane: normal = {shown(self.normal)} has no length; give a vector across the plane")
        object.__setattr__(self, "normal", tuple(float(v) / length for v in normal))

    def depth(self, points: PerElement3) -> Floats:
        """Return the distance of points (n, 3) [m] from the plane, positive on the side of the normal [m], (n,)."""
        return (np.atleast_2d(points) - self.point) @ np.array(self.normal)

    def mask(self, lattice: Lattice) -> Mask:
        return self.depth(lattice.particles.position) > 0.0


@dataclass(frozen=True)
class _Pair(Region):
    """A combination of two regions."""

    first: Region
    second: Region


class Intersection(_Pair):
    """Elements that belong to both regions."""

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) & self.second.mask(lattice)


class Union(_Pair):
    """Elements that belong to at least one of two regions."""

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) | self.second.mask(lattice)


class Difference(_Pair):
    """Elements that belong to the first region but not to the second."""

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) & ~self.second.mask(lattice)


# Names by which users may mean the whole body, which is no face.
_WHOLE = ("all", "body", "everything", "default", "matrix", "rest")


def as_region(owner: str, value: object) -> Region:
    """Return a region unchanged and reject anything else.

    Raises:
        InputError: The value is not a region, for example the name of a face.
    """
    if isinstance(value, Region):
        return value
    meant = 'bd.Face("x_min"), bd.Index(...) or bd.Within(...)'
    if isinstance(value, str):
        meant = "bd.Everything()" if value.lower() in _WHOLE else f"bd.Face({value!r})"
    raise InputError(f"{owner}: {shown(value)} is not a region; give {meant}")


def _indices(elements: ArrayLike) -> np.ndarray:
    """Return whole numbers or truth values, (k,); raise InputError for anything else."""
    try:
        found = np.atleast_1d(np.asarray(elements))
    except (TypeError, ValueError, OverflowError):
        found = np.zeros(1, dtype=object)
    if found.size == 0 and found.ndim == 1:
        return np.zeros(0, dtype=np.int64)
    mixed = found.dtype != bool and isinstance(elements, list | tuple) and any(isinstance(k, bool) for k in elements)
    if found.ndim != 1 or found.dtype.kind not in "biu" or mixed:
        raise InputError(
            f"Index: elements = {shown(elements)}; give whole numbers, shape (k,), or truth values, shape (n,)"
        )
    return found
