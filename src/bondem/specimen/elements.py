"""Shape of the elements of a lattice: spheres, or cells that fill the bodies.

Their differences are methods here, so that no other module asks which shape a lattice has.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, TypedDict

import numpy as np
from scipy.spatial import KDTree

from bondem._indices import components
from bondem._names import warn_user
from bondem._types import Floats, Ints, Mask, Pairs, PerBond, PerBond3, PerElement, PerElement3, Vector
from bondem.errors import FaceWarning, InputError
from bondem.geometry.elementary_shapes import BoundingBox
from bondem.geometry.face_patches import face_patches
from bondem.specimen.bodies import Bodies, Which
from bondem.specimen.particles import Particles, freeze
from bondem.specimen.tessellation.cutting import tessellate
from bondem.specimen.tessellation.facets import Cells, Facets, FreeFacets

# Difference of the areas of a patch and of its facets, over that of the patch, above which a warning is given.
_COVERED = 0.02
# Without a shape a face is the plane at the outermost sphere. A warning is given if a region has less than this share
# of the elements within one mean radius of the face, of which there are at least so many.
_SPARSE, _LAYER = 0.25, 10
# Size of the patches of a face, over the mean radius.
_PATCH = 0.25


class CellTables(TypedDict, total=False):
    """Tables of cells for the constructor of a lattice; empty for spheres."""

    facets: Facets
    cells: Cells


@dataclass(frozen=True, eq=False)
class Elements:
    """Elements of a lattice: spheres with bonds between their centres, or cells with facets (`CellElements`).

    Attributes:
        particles: centres and radii.
        pairs: elements i, j of each bond, shape (m, 2).
        bodies: labels, names and shapes of the bodies.
        name, bond_name: words for the elements and their bonds.
        shape_name: word for the shape of the elements.
    """

    particles: Particles
    pairs: Pairs
    bodies: Bodies

    name: ClassVar[str] = "elements"
    bond_name: ClassVar[str] = "bonds"
    shape_name: ClassVar[str] = "spheres"

    @property
    def centre(self) -> PerElement3:
        """Centres of mass [m], shape (n, 3)."""
        return self.particles.position

    @property
    def volume(self) -> PerElement:
        """Volumes of the elements [m³], shape (n,)."""
        return self.particles.volume

    @property
    def tributary_volume(self) -> PerElement:
        """Share of each element in the volume of the shape of its body [m³], shape (n,)."""
        spheres, bodies = self.particles.volume, self.bodies
        shares = np.empty(len(spheres))
        for k in range(len(bodies.names)):
            own = bodies.label == k
            whole = bodies.shape_of("envelope", k, self.particles)[1].volume
            shares[own] = spheres[own] * (whole / spheres[own].sum())
        return shares

    @property
    def whole_volume(self) -> float:
        """Volume of the shapes of the bodies, or of their cells [m³], voids between spheres included."""
        shapes = (self.bodies.shape_of("envelope", k, self.particles)[1] for k in range(len(self.bodies.names)))
        return sum(shape.volume for shape in shapes)

    @property
    def mean_radii(self) -> PerElement:
        """Mean radius R̄ of the particles in the body of each element [m], (n,); bodies that bonds join count as one.

        Lengths in R̄, such as bond radii, are therefore the same for a body in a scene as for the body alone.
        """
        radius, label, count = self.particles.radius, self.bodies.label, len(self.bodies.names)
        if count == 1:
            return np.full(len(radius), self.particles.mean_radius)
        joined = components(label[self.pairs], count)[label]
        found = np.empty(len(radius))
        order = np.argsort(joined, kind="stable")
        for own in np.split(order, np.cumsum(np.bincount(joined))[:-1]):
            found[own] = radius[own].mean()
        return found

    @property
    def relative_size(self) -> PerElement:
        """Size of each element over the mean size [-], shape (n,)."""
        return self.particles.radius / self.particles.mean_radius

    @property
    def size(self) -> float:
        """Mean diameter of the spheres, or edge of a cube of the mean volume of the cells [m]."""
        return 2.0 * self.particles.mean_radius

    @property
    def inner_radius(self) -> PerElement:
        """Radius of the largest sphere inside each element about the centre of its particle [m], shape (n,)."""
        return self.particles.radius

    @property
    def equal_radius(self) -> PerElement:
        """Radius of the sphere of the volume of each element [m], shape (n,)."""
        return self.particles.radius

    def inertia(self, density: PerElement) -> PerElement:
        """Return 2/5 m R², or a third of the trace of a cell's inertia tensor [kg·m²], (n,), at densities [kg/m³]."""
        return 0.4 * (density * self.volume) * self.particles.radius**2

    @property
    def size_column(self) -> tuple[str, PerElement]:
        """Name and values of the sizes in exported files: "radius" [m] or "volume" [m³], shape (n,)."""
        return "radius", self.particles.radius

    @property
    def tables(self) -> Mapping[str, Facets | Cells | FreeFacets]:
        """Tables of the cells by their place in a run file; empty for spheres."""
        return {}

    @property
    def surface(self) -> Ints:
        """Element to which each facet on the surface belongs, shape (k,); empty for spheres."""
        return np.zeros(0, dtype=np.int64)

    @property
    def branch(self) -> PerBond3:
        """Vectors from centre i to centre j [m], shape (m, 3)."""
        i, j = self.pairs.T
        return freeze(self.particles.nearest(self.centre[j] - self.centre[i]))

    @property
    def length(self) -> PerBond:
        """Distance between the bonded centres [m], shape (m,)."""
        return freeze(np.linalg.norm(self.branch, axis=1))

    @property
    def bond_normal(self) -> PerBond3:
        """Directions of the bonds, or normals of the facets, from i to j [-], shape (m, 3)."""
        return self.branch / self.length[:, None]

    @property
    def bond_middle(self) -> PerBond3:
        """Middles of the bonds, or centroids of the facets, in the image next to centre i [m], shape (m, 3)."""
        return self.centre[self.pairs[:, 0]] + 0.5 * self.branch

    def bond_area(self, radius: PerBond) -> PerBond:
        """Return the areas of circular sections of bonds of these radii, or of the facets [m²], shape (m,)."""
        return np.pi * radius**2

    def bond_arm(self, lever: PerBond, chosen: Ints) -> Floats:
        """Return the arms from centre i to a point on each of k `chosen` bonds, or to their facets [m], (k, 3).

        `lever` is the distance of the point from centre i, for all bonds [m], (m,).
        """
        return lever[chosen, None] * self.bond_normal[chosen]

    def mean_spread(self, weight: Floats, chosen: Ints | Mask) -> Vector:
        """Return the mean square distance along x, y, z of chosen elements' volumes from their centres [m²], (3,).

        The mean has a weight per chosen element, shape (k,), of sum 1.
        """
        return np.full(3, 0.2 * weight @ self.particles.radius[chosen] ** 2)

    def require_cells(self, refusal: str = "") -> "CellElements":
        """Return the elements if they are cells.

        Args:
            refusal: text of the error; empty for advice on how to make cells.

        Raises:
            InputError: The elements are spheres.
        """
        usual = "the lattice is not cut into cells; connect its particles with method='laguerre'"
        raise InputError(refusal or usual)

    def refuse_cells(self, refusal: str) -> None:
        """Raise InputError with the text `refusal` if the elements are cells."""

    def face_mask(self, name: str, body: Which | None, depth: float, region: str) -> Mask:
        """Return a mask of the elements on a face, shape (n,).

        Args:
            name: name of the face.
            body: body with this face; None if there is only one.
            depth: largest distance of the surface of a sphere from the face, over the mean radius [-].
            region: the region in words, for a warning.
        """
        _, shape = self.bodies.shape_of("envelope", body, self.particles)
        gap = shape.face_depth(name, self.particles.position) - self.particles.radius
        if body is not None:
            gap[~self.bodies.mask("Face", body)] = np.inf
        mean = self.mean_radii
        chosen = gap <= depth * mean
        layer = int((gap <= mean).sum())
        if isinstance(shape, BoundingBox) and layer >= _LAYER and chosen.sum() < _SPARSE * layer:
            warn_user(
                f"{region} selects {chosen.sum()} of the {layer} elements within R̄ of the bounding box, as the"
                " particles have no shape; give bd.Particles shape=, or the face depth=1.0",
                FaceWarning,
            )
        return chosen

    def face_patches(self, name: str, body: Which | None, whole: Ints, part: Ints) -> tuple[Ints, Floats, Floats]:
        """Return the patches of a face that are nearest to some of its elements.

        Args:
            name: name of the face.
            body: body with this face; None if there is only one.
            whole: elements of the face.
            part: elements of the returned patches, some of the whole, ascending, shape (k,).

        Returns:
            Index in `part` of the element of each patch, (p,); centroids [m]; areas times normal [m²], (p, 3) each.
        """
        shape, position = self.bodies.shape_of("envelope", body, self.particles)[1], self.particles.position
        centre, area = face_patches(shape, name, _PATCH * self.mean_radii[part[0]])
        nearest = whole[KDTree(position[whole]).query(centre)[1]]
        mine = np.isin(nearest, part)
        return np.searchsorted(part, nearest[mine]), centre[mine], area[mine]

    def face_centre(self, name: str, body: Which | None) -> Vector:
        """Return the centroid of a face, or of the facets on it [m], (3,)."""
        return self.bodies.shape_of("envelope", body, self.particles)[1].face_centre(name)

    def placed(self, turn: Floats, by: Floats) -> CellTables:
        """Return the tables of cells rotated by a matrix (3, 3) about the origin, then moved by (3,) [m]."""
        return {}

    def joined(self, others: Sequence["Elements"]) -> CellTables:
        """Return the tables of these and of other elements of the same shape, one body after the other."""
        return {}

    def carved(self, part: Particles, pairs: Pairs) -> tuple[Pairs, CellTables]:
        """Return bonds and tables of cells of a part; `pairs` are old bonds, as elements of the part, (k, 2)."""
        return pairs, {}


@dataclass(frozen=True, eq=False)
class CellElements(Elements):
    """Cells: polyhedra that fill the bodies, with a facet per bond.

    Attributes:
        facets: facets between cells, in the order of the bonds.
        cells: cells, with their facets on the walls.
    """

    facets: Facets
    cells: Cells

    name: ClassVar[str] = "cells"
    bond_name: ClassVar[str] = "facets"
    shape_name: ClassVar[str] = "cells"

    @property
    def centre(self) -> PerElement3:
        return self.cells.centroid

    @property
    def volume(self) -> PerElement:
        return self.cells.volume

    @property
    def tributary_volume(self) -> PerElement:
        return self.cells.volume

    @property
    def whole_volume(self) -> float:
        return float(self.cells.volume.sum())

    @property
    def relative_size(self) -> PerElement:
        return np.cbrt(self.cells.volume / self.cells.volume.mean())

    @property
    def size(self) -> float:
        return float(np.mean(self.cells.volume)) ** (1.0 / 3.0)

    @property
    def inner_radius(self) -> PerElement:
        radius, facets, free = np.full(len(self.particles), np.inf), self.facets, self.cells.free
        for cell, depth in zip(self.pairs.T, (facets.depth_i, facets.depth_j), strict=True):
            np.minimum.at(radius, cell, depth)
        np.minimum.at(radius, free.cell, free.depth)
        return radius

    @property
    def equal_radius(self) -> PerElement:
        return np.cbrt(0.75 / np.pi * self.cells.volume)

    def inertia(self, density: PerElement) -> PerElement:
        return density * np.einsum("nii->n", self.cells.inertia) / 3.0

    @property
    def size_column(self) -> tuple[str, PerElement]:
        return "volume", self.cells.volume

    @property
    def tables(self) -> Mapping[str, Facets | Cells | FreeFacets]:
        return {"facets": self.facets, "cells": self.cells, "cells/free": self.cells.free}

    @property
    def surface(self) -> Ints:
        return self.cells.free.cell

    @property
    def bond_normal(self) -> PerBond3:
        return self.facets.normal

    @property
    def bond_middle(self) -> PerBond3:
        return self.facets.centroid

    def bond_area(self, radius: PerBond) -> PerBond:
        return self.facets.area

    def bond_arm(self, lever: PerBond, chosen: Ints) -> Floats:
        return self.facets.centroid[chosen] - self.centre[self.pairs[chosen, 0]]

    def mean_spread(self, weight: Floats, chosen: Ints | Mask) -> Vector:
        return weight @ self.cells.spread[chosen]

    def require_cells(self, refusal: str = "") -> "CellElements":
        return self

    def refuse_cells(self, refusal: str) -> None:
        raise InputError(refusal)

    def on_face(self, name: str, body: Which | None = None) -> Ints:
        """Return the free facets on a face or patch, as ascending indices into `cells.free`, (k,).

        See `Lattice.on_face`.
        """
        number_of, envelope = self.bodies.shape_of(f"face {name!r}", body, self.particles)
        envelope.face_centre(name)  # raises for an unknown name
        free = self.cells.free
        own = self.bodies.label[free.cell] == number_of
        if name in envelope.faces:
            return np.flatnonzero(own & (free.face == envelope.faces.index(name)))
        found = np.flatnonzero(own & envelope.on_patch(name, free.centroid, free.normal))
        covered, whole = float(free.area[found].sum()), envelope.patch_area(name)
        if abs(covered - whole) > _COVERED * whole:
            warn_user(
                f"the facets on {name!r} cover {covered:.4g} m² of its {whole:.4g} m², as it ends within a plane,"
                " where cells do not end; smaller cells follow its border more closely",
                FaceWarning,
            )
        return found

    def face_mask(self, name: str, body: Which | None, depth: float, region: str) -> Mask:
        chosen = np.zeros(len(self.particles), dtype=bool)
        chosen[self.cells.free.cell[self.on_face(name, body)]] = True
        return chosen

    def face_centre(self, name: str, body: Which | None) -> Vector:
        free, on = self.cells.free, self.on_face(name, body)
        return np.average(free.centroid[on], axis=0, weights=free.area[on])

    def placed(self, turn: Floats, by: Floats) -> CellTables:
        return {"facets": self.facets.placed(turn, by), "cells": self.cells.placed(turn, by)}

    def joined(self, others: Sequence[Elements]) -> CellTables:
        every = [self, *(one.require_cells() for one in others)]
        facets, cells = [one.facets for one in every], [one.cells for one in every]
        return {"facets": Facets.of_all(facets), "cells": Cells.of_all(cells)}

    def carved(self, part: Particles, pairs: Pairs) -> tuple[Pairs, CellTables]:
        cut, facets, cells = tessellate(part)
        return cut, {"facets": facets, "cells": cells}
