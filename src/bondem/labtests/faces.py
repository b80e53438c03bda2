"""How the end faces of a specimen move, and where they are: elements of spheres, facets of a body of cells."""

import numpy as np

from bondem._types import Floats
from bondem.labtests.gauge_length import rigid_motion
from bondem.model.model import Model
from bondem.observe.facet_loads import loads_on_facets
from bondem.observe.surface import surface_displacement
from bondem.solve.static import StaticResult
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


def face_motion(model: Model, solution: StaticResult, name: str, depth: float) -> Floats:
    """Rigid motion of a face [m, rad], (6,): the one closest to its elements or, of a body of cells, to its facets.

    Spheres are loaded and held at their centres. A body is at its walls, so that its surface is what moves: see
    `bondem.observe.surface`.
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
    """Where the faces across x are held and loaded [m]: mean centres of their elements, or the walls of a body."""
    if lattice.cells is not None:
        lower, upper = (float(lattice.particles.envelope.face_centre(name)[0]) for name in ("x_min", "x_max"))
        return lower, upper
    x = lattice.particles.position[:, 0]
    lower, upper = (float(np.mean(x[Face(name, depth).select(lattice)])) for name in ("x_min", "x_max"))
    return lower, upper
