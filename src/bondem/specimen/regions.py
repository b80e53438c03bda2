"""Regions: who is meant. A region selects connected elements of a lattice and is combined by & | -."""

import warnings
from abc import ABC, abstractmethod
from dataclasses import dataclass, field

import numpy as np

from bondem._checks import count, instance, number, shown, vector
from bondem._names import users_line
from bondem._types import ArrayLike, Floats, Ints, Mask, PerElement3, Vector
from bondem.errors import EmptyRegionError, FaceWarning, InputError
from bondem.specimen.geometry import Shape
from bondem.specimen.lattice import Lattice

# Without a shape a face is the plane of the outermost sphere. It is warned of where it has less than this share
# of the elements within one mean radius of it, and those are at least so many.
_SPARSE, _LAYER = 0.25, 10


class Region(ABC):
    """A rule that selects elements."""

    @abstractmethod
    def mask(self, lattice: Lattice) -> Mask:
        """Which elements match, rattlers not excluded, shape (n,)."""

    def select(self, lattice: Lattice) -> Ints:
        """Indices of the connected elements of the region, ascending, in the user's order; all where none is bonded.

        Raises:
            EmptyRegionError: no connected element matches.
        """
        # grains without any bond are no rattlers of a specimen: they are what is simulated
        chosen = np.flatnonzero(self.mask(lattice) & lattice.connected if len(lattice.pairs) else self.mask(lattice))
        if chosen.size == 0:
            raise EmptyRegionError(
                f"{self} selects no connected element; check its name, units (metres) and depth"
            )
        return chosen

    def anchor(self, lattice: Lattice) -> Vector:
        """The point a load on the region acts through: the centroid of its elements [m], (3,)."""
        return lattice.centre[self.select(lattice)].mean(axis=0)

    def __and__(self, other: "Region") -> "Region":
        return Intersection(self, as_region("&", other))

    def __or__(self, other: "Region") -> "Region":
        return Union(self, as_region("|", other))

    def __sub__(self, other: "Region") -> "Region":
        return Difference(self, as_region("-", other))


@dataclass(frozen=True)
class Everything(Region):
    """All connected elements."""

    def mask(self, lattice: Lattice) -> Mask:
        return np.ones(len(lattice.particles), dtype=bool)


@dataclass(frozen=True)
class Face(Region):
    """Elements whose surface lies at a named face of the shape; cells of a body that have a facet on it.

    Without a shape the face is that of the bounding box of the spheres, which in a loose or cut packing few of them
    reach: a layer is then what `depth=1.0` selects, and a face of far fewer is warned of (`FaceWarning`).

    Attributes:
        name: "x_min", "x_max", ... or "side".
        depth: how far from the face their surface may lie, in mean radii [-]; of no account for cells.
    """

    name: str
    depth: float = 0.02

    def __post_init__(self) -> None:
        instance("Face", "name", self.name, str, 'the name of a face, such as "x_min" or "side"')
        depth = number("Face", "depth", self.depth, advice="a finite depth, in mean radii [-]")
        object.__setattr__(self, "depth", depth)

    def mask(self, lattice: Lattice) -> Mask:
        if lattice.cells is not None:
            chosen = np.zeros(len(lattice.particles), dtype=bool)
            chosen[lattice.cells.free.cell[lattice.on_face(self.name)]] = True
            return chosen
        particles = lattice.particles
        gap = particles.envelope.face_depth(self.name, particles.position) - particles.radius
        chosen = gap <= self.depth * particles.mean_radius
        layer = int((gap <= particles.mean_radius).sum())
        if particles.shape is None and layer >= _LAYER and chosen.sum() < _SPARSE * layer:
            warnings.warn(
                f"{self} is {chosen.sum()} of the {layer} elements within a mean radius of the bounding box, as the"
                " particles have no shape; give bd.Particles shape=, or the face depth=1.0",
                FaceWarning,
                stacklevel=users_line(),
            )
        return chosen

    def anchor(self, lattice: Lattice) -> Vector:
        """The centroid of the face [m], (3,): on a body of cells, that of the facets on it."""
        if lattice.cells is None:
            return lattice.particles.envelope.face_centre(self.name)
        free, on = lattice.cells.free, lattice.on_face(self.name)
        return np.average(free.centroid[on], axis=0, weights=free.area[on])


@dataclass(frozen=True)
class Index(Region):
    """Elements by number, or by a mask, in the user's order.

    Attributes:
        elements: indices.
        size: number of elements where a mask was given, else None.

    Args:
        elements: one index, indices (k,), or truth values (n,).
        size: number of elements that there must be; None for any.
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
            raise InputError(f"Index names element {found.min()}, but element indices start at 0")
        object.__setattr__(self, "elements", tuple(found.tolist()))
        object.__setattr__(self, "size", size)

    def __repr__(self) -> str:
        return f"Index(elements={shown(list(self.elements))})"

    def mask(self, lattice: Lattice) -> Mask:
        n = len(lattice.particles)
        if self.size is not None and self.size != n:
            raise InputError(f"Index was given a mask of {self.size} elements, but there are {n}")
        wrong = [k for k in self.elements if not 0 <= k < n]
        if wrong:
            raise InputError(f"Index names element {wrong[0]}, but element indices run from 0 to {n - 1}")
        chosen = np.zeros(n, dtype=bool)
        chosen[list(self.elements)] = True
        return chosen


@dataclass(frozen=True)
class Within(Region):
    """Elements whose centre lies inside a shape.

    Attributes:
        shape: any shape, in the coordinates of the specimen.
    """

    shape: Shape

    def __post_init__(self) -> None:
        instance("Within", "shape", self.shape, Shape, "a shape such as bd.Ball(...)")

    def mask(self, lattice: Lattice) -> Mask:
        return self.shape.contains(lattice.particles.position)


@dataclass(frozen=True, kw_only=True)
class Plane(Region):
    """Elements on the side of a plane that its normal points to: one of two layers.

    `bd.pack(..., around=plane)` makes cells end on the plane.

    Attributes:
        point: any point of the plane [m], (3,).
        normal: to the side that is meant, of any length, (3,).

    Raises:
        InputError: values that are not finite, or a normal of no length.
    """

    point: tuple[float, float, float]
    normal: tuple[float, float, float]

    def __post_init__(self) -> None:
        object.__setattr__(self, "point", vector("Plane", "point", self.point, unit="m"))
        normal = vector("Plane", "normal", self.normal)
        length = float(np.linalg.norm(normal))
        if not length > 0.0:
            raise InputError(f"Plane: normal = {shown(self.normal)} has no length; give a vector across the plane")
        object.__setattr__(self, "normal", tuple(float(v) / length for v in normal))

    def depth(self, points: PerElement3) -> Floats:
        """Distance of points (n, 3) [m] from the plane, positive on the side of the normal [m], (n,)."""
        return (np.atleast_2d(points) - self.point) @ np.array(self.normal)

    def mask(self, lattice: Lattice) -> Mask:
        return self.depth(lattice.particles.position) > 0.0


@dataclass(frozen=True)
class Intersection(Region):
    """Elements of both regions."""

    first: Region
    second: Region

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) & self.second.mask(lattice)


@dataclass(frozen=True)
class Union(Region):
    """Elements of either region."""

    first: Region
    second: Region

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) | self.second.mask(lattice)


@dataclass(frozen=True)
class Difference(Region):
    """Elements of the first region that are not in the second."""

    first: Region
    second: Region

    def mask(self, lattice: Lattice) -> Mask:
        return self.first.mask(lattice) & ~self.second.mask(lattice)


def as_region(owner: str, value: object) -> Region:
    """A region, as it is.

    Raises:
        InputError: something else, such as the name of a face.
    """
    if isinstance(value, Region):
        return value
    meant = f"bd.Face({value!r})" if isinstance(value, str) else 'bd.Face("x_min"), bd.Index(...) or bd.Within(...)'
    raise InputError(f"{owner}: {shown(value)} is no region; give {meant}")


def _indices(elements: ArrayLike) -> np.ndarray:
    """Whole numbers or truth values, (k,)."""
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
