"""Regions: who is meant. A region selects connected elements of a lattice and is combined by & | -."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._types import Ints, Mask, Vector
from bondem.errors import EmptyRegionError, InputError
from bondem.specimen.geometry import Shape
from bondem.specimen.lattice import Lattice


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
        return lattice.particles.position[self.select(lattice)].mean(axis=0)

    def __and__(self, other: "Region") -> "Region":
        return Intersection(self, other)

    def __or__(self, other: "Region") -> "Region":
        return Union(self, other)

    def __sub__(self, other: "Region") -> "Region":
        return Difference(self, other)


@dataclass(frozen=True)
class Everything(Region):
    """All connected elements."""

    def mask(self, lattice: Lattice) -> Mask:
        return np.ones(len(lattice.particles), dtype=bool)


@dataclass(frozen=True)
class Face(Region):
    """Elements whose surface lies at a named face of the shape.

    Attributes:
        name: "x_min", "x_max", ... or "side".
        depth: how far from the face their surface may lie, in mean radii [-].
    """

    name: str
    depth: float = 0.02

    def mask(self, lattice: Lattice) -> Mask:
        particles = lattice.particles
        distance = particles.envelope.face_depth(self.name, particles.position) - particles.radius
        return distance <= self.depth * particles.mean_radius

    def anchor(self, lattice: Lattice) -> Vector:
        return lattice.particles.envelope.face_centre(self.name)


@dataclass(frozen=True)
class Index(Region):
    """Elements by number, in the user's order.

    Attributes:
        elements: indices.
    """

    elements: tuple[int, ...]

    def __init__(self, elements: object) -> None:
        object.__setattr__(self, "elements", tuple(int(k) for k in np.atleast_1d(np.asarray(elements))))

    def mask(self, lattice: Lattice) -> Mask:
        n = len(lattice.particles)
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

    def mask(self, lattice: Lattice) -> Mask:
        return self.shape.contains(lattice.particles.position)


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
