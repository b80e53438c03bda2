"""Bodies of cells for ParaView as VTKHDF, an unstructured grid of polyhedra, and fields of any body."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from bondem._types import ArrayLike, Floats, Ints
from bondem.geometry.rotations import turned_vectors
from bondem.io.atomic import require_writable
from bondem.io.hdf5 import put, writing
from bondem.io.vtkhdf_series import begin_group, static_polyhedra
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_stress import stress_fields
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra
from bondem.statics.static import StaticResult

# Corners of a cell that are closer than this coincide [mean radii].
_SAME = 1e-7


def fields_of_motion(state: State | StaticResult | None) -> dict[str, ArrayLike]:
    """Return fields of elements by name: motion, for a static solution also reactions and stresses; {} for None."""
    if state is None:
        return {}
    if isinstance(state, State):
        return {
            "displacement": state.displacement, "orientation": state.orientation, "velocity": state.velocity,
            "angular_velocity": state.angular_velocity,
        }  # fmt: skip
    return {
        "displacement": state.displacement, "rotation": state.rotation, "reaction": state.reaction[:, :3],
        "reaction_moment": state.reaction[:, 3:], "stress": state.stress.reshape(-1, 9),
        "principal_stresses": state.principal_stresses, "von_mises_stress": state.von_mises_stress,
    }  # fmt: skip


def fields_of_bodies(lattice: Lattice) -> dict[str, ArrayLike]:
    """Return the field "body", the number of the body of each element; empty for a single body."""
    return {"body": lattice.body} if len(lattice.names) > 1 else {}


def drawn_bonds(lattice: Lattice) -> Ints:
    """Return the numbers of the bonds that do not cross the border of a periodic cell, (b,)."""
    i, j = lattice.pairs.T
    plain = lattice.particles.position[j] - lattice.particles.position[i]
    return np.flatnonzero(np.abs(plain - lattice.branch).max(axis=1) < 1e-6 * lattice.particles.mean_radius)


def fields_of_cells(body: Lattice, state: State | StaticResult | None) -> dict[str, ArrayLike]:
    """Return fields of cells by name, with motion and stress for a given state or static solution."""
    cells = body.elements.require_cells().cells
    fields: dict[str, ArrayLike] = {"volume": cells.volume, "free_area": cells.free_area}
    fields |= fields_of_bodies(body) | fields_of_motion(state)
    if not isinstance(state, State):
        return fields
    model = state.model
    return fields | stress_fields(model, state) if isinstance(model, Model) else fields


def write_cells(path: Path, body: Lattice, state: State | None, fields: Mapping[str, np.ndarray]) -> None:
    """Write cells as polyhedra, which move and turn with the state.

    Args:
        path: VTKHDF file; InputError if it cannot be written.
        body: lattice of cells.
        state: state of the cells; None for cells at rest.
        fields: fields of the cells by name, (n,) or (n, k).
    """
    corners = Corners(body)
    point = corners.place if state is None else corners.moved(body, state)
    cells = static_polyhedra(corners.cell, corners.number, corners.start, corners.polygon_cell, len(body.particles))
    require_writable(path, "VTK file")
    with writing(path) as file:
        root = begin_group(file, "UnstructuredGrid")
        for name, values in ({"Points": point} | cells).items():
            put(root, name, values)
        for name, values in fields.items():
            put(root, f"CellData/{name}", values)


class Corners:
    """Corners of cells, unique within each cell, sorted by cell.

    Attributes:
        place: positions of the corners [m], (c, 3).
        cell: cell of each corner, (c,).
        number: corner numbers of all polygons in sequence.
        start: offset of each polygon in `number`, (p + 1,).
        polygon_cell: cell of each polygon, (p,).
    """

    def __init__(self, body: Lattice) -> None:
        found = polyhedra(body)
        self.start: Ints = found.start
        self.polygon_cell: Ints = found.cell
        owner = np.repeat(found.cell, np.diff(found.start))
        grid = np.rint(found.vertex / (_SAME * body.particles.mean_radius)).astype(np.int64)
        rows = np.column_stack([owner, grid])
        _, first, number = np.unique(rows, axis=0, return_index=True, return_inverse=True)
        self.number: Ints = number.ravel()
        self.cell: Ints = owner[first]
        self.place: Floats = found.vertex[first]

    def moved(self, body: Lattice, state: State) -> Floats:
        """Compute the positions of the corners in the pose of a state [m], (c, 3)."""
        centre = body.centre[self.cell]
        turned = turned_vectors(state.orientation[self.cell], self.place - centre)
        return centre + state.displacement[self.cell] + turned
