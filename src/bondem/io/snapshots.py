"""Snapshots of a run in its file for ParaView: elements, bonds or cells, and cracks, over time.

    /VTKHDF/elements   points that move: radius, displacement, velocity, angular_velocity, orientation (w, x, y, z);
                       under the cell law and the non-local law the stress (xx, yy, zz, xy, yz, xz); in a scene of
                       several bodies the number of the body
    /VTKHDF/bonds      lines between elements: length, integrity, normal_force (tension positive), shear_force,
                       bending_moment (larger one of both ends), twisting_moment
    /VTKHDF/cells      instead of bonds for a body of cells: polyhedra that move and turn; fields of the elements are
                       stored once, under both names
    /VTKHDF/cracks     polygons of facets and beams that have lost integrity: integrity, area, opening, sliding, facet
    /VTKHDF/walls      polygons of the walls of the model: number of the wall

Snapshots are in SI units and single precision; states for a restart are stored elsewhere, bit for bit.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import h5py
import numpy as np

from bondem._types import Floats, Ints
from bondem.boundary.wall_outlines import WallOutlines, wall_outlines
from bondem.io.vtk_cells import Corners, drawn_bonds, fields_of_bodies
from bondem.io.vtkhdf_series import Piece, begin_collection, static_lines, static_polyhedra
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.bond_forces import bond_forces
from bondem.observables.cell_stress import stress_fields

#: Columns of a 3×3 tensor, and of a row xx, yy, zz, xy, xz, yz of a state, in the order of VTK.
_OF_TENSOR, _OF_ROW = (0, 4, 8, 1, 5, 2), (0, 1, 2, 3, 5, 4)


class Outlined(Protocol):
    """Outlines of cracks: corners (v, 3), offsets of the polygons (p + 1,), and fields of the polygons."""

    @property
    def vertex(self) -> Floats: ...

    @property
    def start(self) -> Ints: ...

    @property
    def fields(self) -> Mapping[str, np.ndarray]: ...


@dataclass(frozen=True, eq=False)
class Snapshots:
    """Group of the snapshots in a file.

    Attributes:
        pieces: parts of each snapshot by name, such as "elements" and "bonds".
        cracks: function of the crack outlines of a state; None for a file without cracks.
        drawn: numbers of the shown bonds, which do not cross the border of a periodic cell.
        corners: corners of the cells if the file stores their motion; else None.
        walls: outlines of all walls of the model, as one item; empty for a file without walls.
    """

    pieces: Mapping[str, Piece]
    cracks: Callable[[State], Outlined] | None
    drawn: np.ndarray
    corners: Corners | None = None
    walls: tuple[WallOutlines, ...] = ()

    @classmethod
    def begin(cls, file: h5py.File, model: Model, cracks: Callable[[State], Outlined] | None) -> "Snapshots":
        """Create the group of snapshots in a file, and write its constant data."""
        root = begin_collection(file)
        lattice, n, drawn, corners = model.lattice, len(model.lattice.particles), drawn_bonds(model.lattice), None
        pieces = {"elements": Piece.begin(root, "elements", "PolyData")}
        vertices = {"NumberOfPoints": np.array([n])} | static_lines(np.arange(n)[:, None])
        of_body = {name: np.asarray(values) for name, values in fields_of_bodies(lattice).items()}
        pieces["elements"].set_static(
            vertices | {"PointData/radius": _single(lattice.particles.radius)}
            | {f"PointData/{name}": values for name, values in of_body.items()}
        )  # fmt: skip
        if lattice.cells is None:
            pieces["bonds"] = Piece.begin(root, "bonds", "PolyData")
            static = {"NumberOfPoints": np.array([n])} | static_lines(lattice.pairs[drawn])
            pieces["bonds"].set_static(static | {"CellData/length": _single(lattice.length[drawn])})
        else:
            pieces["cells"] = Piece.begin(root, "cells", "UnstructuredGrid")
            c = Corners(lattice)
            static = static_polyhedra(c.cell, c.number, c.start, c.polygon_cell, n)
            pieces["cells"].set_static(
                static | {"CellData/volume": _single(lattice.cells.volume)}
                | {f"CellData/{name}": values for name, values in of_body.items()}
            )  # fmt: skip
            corners = c
        if cracks is not None:
            pieces["cracks"] = Piece.begin(root, "cracks", "PolyData")
        if model.walls:
            pieces["walls"] = Piece.begin(root, "walls", "PolyData")
        return cls(pieces, cracks, drawn, corners, _walls(model))

    @classmethod
    def of(cls, file: h5py.File, model: Model, cracks: Callable[[State], Outlined] | None) -> "Snapshots":
        """Open the snapshots stored in a run file."""
        root: Any = file["VTKHDF"]
        pieces = {name: Piece(root[name]) for name in root if name != "Assembly"}
        # older files have cells at rest only, and continue so
        solid = pieces.get("cells")
        moves = solid is not None and (not solid.has_points or solid.has("orientation"))
        return cls(
            pieces, cracks if "cracks" in pieces else None, drawn_bonds(model.lattice),
            Corners(model.lattice) if moves else None, _walls(model) if "walls" in pieces else (),
        )  # fmt: skip

    def take(self, model: Model, state: State) -> None:
        """Append a snapshot, unless one of this or a later time exists."""
        times = self.pieces["elements"].times
        if len(times) and times[-1] >= state.time:
            return
        own: dict[str, Any] = {
            "displacement": state.displacement, "velocity": state.velocity,
            "angular_velocity": state.angular_velocity, "orientation": state.orientation,
        }  # fmt: skip
        stress = _stress(model, state)
        if stress is not None:
            own["stress"] = stress
        place, still = state.position, dict.fromkeys(fields_of_bodies(model.lattice))
        self.pieces["elements"].add_step(
            state.time, points=place, point_data={"radius": None} | still | own, cell_data={}
        )
        if "bonds" in self.pieces:
            fields = {name: values[self.drawn] for name, values in _of_bonds(model, state).items()}
            self.pieces["bonds"].add_step(
                state.time, points=place, point_data={}, cell_data={"length": None} | fields
            )
        if "cells" in self.pieces:
            points = None
            if self.corners is None:
                del own["orientation"], own["angular_velocity"]
            else:
                points = self.corners.moved(model.lattice, state)
            same = {name: self.pieces["elements"].last(name, rows) for name, rows in own.items()}
            self.pieces["cells"].add_step(
                state.time, points=points, point_data={}, cell_data={"volume": None} | still | same
            )
        if self.cracks is not None:
            found = self.cracks(state)
            self.pieces["cracks"].add_step(
                state.time, points=found.vertex, point_data={}, cell_data=found.fields, polygons=found.start
            )
        for walls in self.walls:
            self.pieces["walls"].add_step(
                state.time, points=walls.moved(state.walls), point_data={},
                cell_data={"wall": walls.wall}, polygons=walls.start,
            )  # fmt: skip

    def cut(self, time: float) -> None:
        """Remove the snapshots after a time [s]."""
        for piece in self.pieces.values():
            piece.cut(int((piece.times <= time).sum()))


def _walls(model: Model) -> tuple[WallOutlines, ...]:
    if not model.walls:
        return ()
    position, radius = model.lattice.particles.position, model.lattice.particles.radius[:, None]
    return (wall_outlines(model.walls, (position - radius).min(axis=0), (position + radius).max(axis=0)),)


def _single(values: Any) -> Any:
    return np.asarray(values, dtype=np.float32)


def _stress(model: Model, state: State) -> Floats | None:
    found = stress_fields(model, state)
    if found:
        return found["stress"][:, _OF_TENSOR]
    if state.stress.size:
        return state.stress[model.layout.rank][:, _OF_ROW]
    return None


def _of_bonds(model: Model, state: State) -> dict[str, Floats]:
    found = bond_forces(model, state)
    return {
        "integrity": state.bond_integrity, "normal_force": found.normal, "shear_force": found.shear,
        "bending_moment": found.bending, "twisting_moment": found.twisting,
    }  # fmt: skip
