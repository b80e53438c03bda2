"""Positions and motions of the end faces of a specimen, from elements of spheres or facets of cells."""

import numpy as np

from bondem._types import Floats
from bondem.labtests.gauge_length import rigid_motion
from bondem.model.model import Model
from bondem.observables.facet_loads import loads_on_facets
from bondem.observables.surface_displacement import surface_displacement
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face
from bondem.statics.static import StaticResult


def face_motion(model: Model, solution: StaticResult, name: str, depth: float) -> Floats:
    """Rigid motion of a face closest to its elements or, for cells, to its facets [m, rad], (6,).

    Spheres are loaded and held at their centres, cells at the walls of the body. The motion of a body of cells is
    therefore that of its surface; see `bondem.observables.surface_displacement`.
    """
    lattice = model.lattice
    if lattice.cells is None:
        chosen = Face(name, depth).select(lattice)
        return rigid_motion(lattice.centre[chosen], solution.displacement[chosen])
    free, found = lattice.cells.free, lattice.on_face(name)
    return rigid_motion(free.centroid[found], surface(model, solution)[found], free.area[found])


def surface(model: Model, solution: StaticResult) -> Floats:
    """Displacements of the free facets of a body under the loads of the model [m], in the order of `cells.free`."""
    assert model.lattice.cells is not None
    traction = loads_on_facets(model) / model.lattice.cells.free.area[:, None]
    return surface_displacement(model, solution.displacement, solution.rotation, traction=traction)


def ends(lattice: Lattice, depth: float) -> tuple[float, float]:
    """Positions x of the held and the loaded face [m]: mean centres of elements, or walls of a body of cells."""
    if lattice.cells is not None:
        lower, upper = (float(lattice.particles.envelope.face_centre(name)[0]) for name in ("x_min", "x_max"))
        return lower, upper
    x = lattice.particles.position[:, 0]
    lower, upper = (float(np.mean(x[Face(name, depth).select(lattice)])) for name in ("x_min", "x_max"))
    return lower, upper
