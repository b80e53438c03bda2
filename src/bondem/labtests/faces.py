"""Faces of a specimen as laboratory tests load and observe them: layers of spheres, or facets of cells.

Spheres are loaded and constrained at their centres, cells at the walls of the body. The motion of a body of cells is
therefore that of its surface; see `bondem.observables.surface_displacement`.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from bondem._types import Floats, Ints
from bondem.geometry.face_patches import face_patches
from bondem.labtests.gauge_length import rigid_motion
from bondem.model.model import Model
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.surface_displacement import surface_displacement
from bondem.specimen.elements import CellElements
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face
from bondem.statics.static import StaticResult

# Size of the patches of the surface, over the mean radius.
_PATCH = 0.5


@dataclass(frozen=True, eq=False)
class SpecimenFaces:
    """Faces of a specimen of spheres: layers of elements, `depth` mean radii deep; for cells see `WalledFaces`."""

    lattice: Lattice
    depth: float

    @property
    def ends(self) -> tuple[float, float]:
        """Positions x of the faces x_min and x_max [m]: mean centres of elements, or walls of a body of cells."""
        x = self.lattice.particles.position[:, 0]
        lower, upper = (float(np.mean(x[self._select(name)])) for name in ("x_min", "x_max"))
        return lower, upper

    @property
    def paper_length(self) -> float:
        """Length of the specimen [m]; for spheres L_M = 2 R̄ + ⟨x⟩ at x_max - ⟨x⟩ at x_min, with mean radius R̄.

        This is eq (12) of André et al. (2012) with corrected sign.
        """
        first, last = self.ends
        return last - first + 2.0 * self.lattice.particles.mean_radius

    @property
    def paper_radius(self) -> float:
        """Radius of the specimen [m]; for spheres R_M = R̄ + mean distance of the elements at "side" from the axis.

        This is eq (13) of André et al. (2012). For cells it is the radius of a circle of equal area.
        """
        particles, side = self.lattice.particles, self._select("side")
        return float(particles.mean_radius + np.hypot(*particles.position[side, 1:].T).mean())

    def side_distance(self, distance: Floats, share: Floats) -> float:
        """Return the distance from the axis at which the motion of "side" is measured [m].

        For spheres this is R_M. For cells it is the mean `distance`: a cylinder of cells is a prism, whose facets are
        nearer to the axis than the radius of its section.

        Args:
            distance: distances of the elements or facets at "side" from the axis [m], (k,).
            share: weights of these elements or facets, with the sum 1 [-], (k,).
        """
        return self.paper_radius

    def motion(self, model: Model, solution: StaticResult, name: str) -> Floats:
        """Fit a rigid motion [m, rad], (6,), to the elements of the named face or, for cells, to its facets."""
        chosen = self._select(name)
        return rigid_motion(self.lattice.centre[chosen], solution.displacement[chosen])

    def outside(self, model: Model, solution: StaticResult) -> tuple[Floats, Floats, dict[str, tuple[Ints, Floats]]]:
        """Return positions and displacements of elements or facets [m], (k, 3), and indices and weights by face."""
        sets = {name: self._select(name) for name in self._names}
        even = {name: (found, np.full(len(found), 1.0 / len(found))) for name, found in sets.items()}
        return self.lattice.centre, solution.displacement, even

    @property
    def patches(self) -> tuple[Ints, Floats, Floats]:
        """Patches of the surface: indices of their elements, (p,), centres [m] and areas · normals [m²], (p, 3)."""
        particles = self.lattice.particles
        owners, centres, areas = [], [], []
        for name in particles.envelope.faces:
            centre, area = face_patches(particles.envelope, name, _PATCH * particles.mean_radius)
            chosen = self._select(name)
            owners.append(chosen[KDTree(particles.position[chosen]).query(centre)[1]])
            centres.append(centre)
            areas.append(area)
        return np.concatenate(owners), np.concatenate(centres), np.concatenate(areas)

    @property
    def _names(self) -> list[str]:
        return [name for name in ("x_min", "x_max", "side") if name in self.lattice.particles.envelope.faces]

    def _select(self, name: str) -> Ints:
        return Face(name, self.depth).select(self.lattice)


@dataclass(frozen=True, eq=False)
class WalledFaces(SpecimenFaces):
    """Faces of a body of cells, which are the free facets of its `elements`."""

    elements: CellElements

    @property
    def ends(self) -> tuple[float, float]:
        envelope = self.lattice.particles.envelope
        lower, upper = (float(envelope.face_centre(name)[0]) for name in ("x_min", "x_max"))
        return lower, upper

    @property
    def paper_length(self) -> float:
        first, last = self.ends
        return last - first

    @property
    def paper_radius(self) -> float:
        return math.sqrt(self.lattice.particles.envelope.section() / math.pi)

    def side_distance(self, distance: Floats, share: Floats) -> float:
        return float(share @ distance)

    def motion(self, model: Model, solution: StaticResult, name: str) -> Floats:
        free, found = self.elements.cells.free, self.elements.on_face(name)
        return rigid_motion(free.centroid[found], self._surface(model, solution)[found], free.area[found])

    def outside(self, model: Model, solution: StaticResult) -> tuple[Floats, Floats, dict[str, tuple[Ints, Floats]]]:
        free = self.elements.cells.free
        sets = {name: self.elements.on_face(name) for name in self._names}
        by_area = {name: (found, free.area[found] / free.area[found].sum()) for name, found in sets.items()}
        return free.centroid, self._surface(model, solution), by_area

    @property
    def patches(self) -> tuple[Ints, Floats, Floats]:
        free = self.elements.cells.free
        return free.cell, free.centroid, free.area[:, None] * free.normal

    def _surface(self, model: Model, solution: StaticResult) -> Floats:
        """Compute the displacements of free facets under the loads of the model [m], (k, 3), as in `cells.free`."""
        traction = loads_on_facets(model) / self.elements.cells.free.area[:, None]
        return surface_displacement(model, solution.displacement, solution.rotation, traction=traction)


def means_on_face(body: Lattice, face: str, measure: Callable[[Floats], Floats]) -> tuple[Ints, Floats]:
    """Average a function of facet centroids [m], (k, 3), over the facets of each cell on a face, weighted by area.

    Returns:
        Indices of the cells with facets on the face, (c,), and their averages, (c,).
    """
    free, on = body.elements.require_cells().cells.free, body.on_face(face)
    cell, area = free.cell[on], free.area[on]
    total, summed = (np.bincount(cell, weights=one) for one in (area, area * measure(free.centroid[on])))
    cells = np.flatnonzero(total > 0.0)
    return cells, summed[cells] / total[cells]


def specimen_faces(lattice: Lattice, depth: float = 0.02) -> SpecimenFaces:
    """Create the faces of a specimen, with layers of spheres `depth` mean radii deep [-], or the facets of cells."""
    if isinstance(lattice.elements, CellElements):
        return WalledFaces(lattice, depth, lattice.elements)
    return SpecimenFaces(lattice, depth)
