"""Scene of a run file: the body, its cracks, walls and coordinates, with one camera for all snapshots."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pyvista
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

from bondem._types import Floats
from bondem.errors import InputError
from bondem.fracture.fragments import fragments
from bondem.geometry.rotations import turned_vectors
from bondem.io.hdf5 import array_at
from bondem.io.raw_spheres import snapshot_number
from bondem.io.run_contents import read_contents
from bondem.io.runfile import read_run, reading_run
from bondem.observables.principal_stresses import principal_stresses, von_mises_stress
from bondem.report.piece_colours import piece_palette
from bondem.report.style import GREY, INK, ORANGE, SEQUENTIAL

_LIGHT: dict[str, Any] = {"ambient": 0.35, "diffuse": 0.7}
_BAR: dict[str, Any] = {
    "n_labels": 3, "fmt": "%.3g", "vertical": True, "position_x": 0.87, "position_y": 0.25, "height": 0.5,
    "title_font_size": 18, "label_font_size": 16,
}  # fmt: skip
_WALL: dict[str, Any] = {"color": "#9fb3c8", "opacity": 0.35, "ambient": 0.6, "diffuse": 0.4}
_UNITS = {
    "displacement": "m", "velocity": "m/s", "angular_velocity": "rad/s", "normal_force": "N",
    "shear_force": "N", "bending_moment": "N·m", "twisting_moment": "N·m",
    "radius": "m", "length": "m", "volume": "m³", "opening": "m", "sliding": "m", "area": "m²",
    "von Mises stress": "Pa", "stress s1": "Pa",
}  # fmt: skip
# Scalars of the stress by name of the field, with title and function of tensors; places of components in a tensor.
_STRESSES = {
    "stress": ("von Mises stress", von_mises_stress), "von_mises_stress": ("von Mises stress", von_mises_stress),
    "s1": ("stress s1", lambda stress: principal_stresses(stress)[:, 0]),
}  # fmt: skip
_TENSOR = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
# Units of coordinates, the finest first.
_LENGTHS = ((1e6, "µm"), (1e3, "mm"), (1.0, "m"))
# Sides of drawn spheres for few and for many elements, and the largest number of few elements.
_FINE, _COARSE, _MANY = 24, 10, 20_000
# Share of the longest side of a body below which a side has numbers at its ends only.
_SHORT = 0.25
# Azimuth and elevation of named cameras [degree].
_CAMERAS = {
    "iso": (45.0, 30.0), "x": (0.0, 0.0), "-x": (180.0, 0.0), "y": (90.0, 0.0), "-y": (-90.0, 0.0),
    "z": (-90.0, 90.0),
    "-z": (-90.0, -90.0),
}  # fmt: skip


class Scene:
    """Pictures of the snapshots of a run file, with one camera.

    Args:
        run_file: run file with snapshots.
        field, show, section, warp, camera, walls, axes: options of `bondem.report.scenes.render_run`.

    Raises:
        InputError: no snapshots, or no such camera.
        RunFileError: the file is not a run file.
    """

    def __init__(
        self, run_file: Path, *, field: str | None, show: str, section: str | None, warp: float, camera: str,
        walls: bool, axes: bool,
    ) -> None:  # fmt: skip
        self._file, self._field, self._show = run_file, field, show
        self._warp, self._walls, self._axes = warp, walls, axes
        self._toward, self._up = _direction(camera)
        # the normal of the section, towards the camera: pyvista removes the half to which it points
        front = section is None or self._toward["xyz".index(section)] >= 0.0
        self._section = section if front else f"-{section}"
        if not read_contents(run_file).snapshots:
            raise InputError(f"'{run_file}' has no snapshots; run again with snapshot_every=")
        self._reader = vtkHDFReader()
        self._reader.SetFileName(str(run_file))
        self._reader.UpdateInformation()
        self.count = int(self._reader.GetNumberOfSteps())
        with reading_run(Path(run_file)) as file:
            self._times = array_at(file, "VTKHDF/elements/Steps/Values")
        self._colour = self._by_piece() if field == "fragment" else None
        self._placed = False

    def number(self, snapshot: int) -> int:
        """Convert the number of a snapshot, negative from the end, to an index from 0.

        Raises:
            InputError: there is no such snapshot.
        """
        return snapshot_number(self._file, snapshot, self.count, argument="snapshot")

    def draw(self, plotter: Any, number: int) -> None:
        """Draw the snapshot of index `number`, from 0, in a pyvista plotter; unknown fields raise InputError."""
        pieces = self._pieces(number)
        body = self._body(pieces)
        if body is not None:
            name = self._coloured(body)
            bar = {"color": "black", "title": _titled(name), **_BAR}
            plain = name in ("fragment", None)
            plotter.add_mesh(
                body, scalars=name, rgb=name == "fragment", cmap=SEQUENTIAL, smooth_shading=False,
                show_scalar_bar=not plain, scalar_bar_args=bar, color=GREY, name="body", **_LIGHT,
            )  # fmt: skip
        cracks = pieces.get("cracks")
        if cracks is not None and cracks.n_cells and (self._show == "cracks" or self._section):
            if self._section is not None:
                cracks = cracks.clip(normal=self._section, origin=self._middle)
            plotter.add_mesh(
                cracks, color=ORANGE, show_edges=self._show == "cracks", edge_color=INK, name="cracks", **_LIGHT
            )
        if self._walls and "walls" in pieces:
            plotter.add_mesh(pieces["walls"], name="walls", **_WALL)
        plotter.add_text(f"t = {self._times[number]:.4g} s", font_size=10, color="black", name="time")
        self._place(plotter, pieces, number)
        if self._axes:
            plotter.add_axes(line_width=3, color="black")
            if body is not None:
                self._measured(plotter, body)

    def _measured(self, plotter: Any, body: Any) -> None:
        """Draw the box about the body with its coordinates, in the unit that suits its size."""
        factor, unit = next((one for one in _LENGTHS if body.length * one[0] < 1000.0), _LENGTHS[-1])
        sides = np.diff(np.reshape(body.bounds, (3, 2)))[:, 0]
        x, y, z = (3 if side > _SHORT * sides.max() else 2 for side in sides)  # numbers of short sides would overlap
        plotter.show_bounds(
            mesh=body, axes_ranges=[factor * end for end in body.bounds], fmt="%.3g", n_xlabels=x, n_ylabels=y,
            n_zlabels=z, xtitle=f"x [{unit}]", ytitle=f"y [{unit}]", ztitle=f"z [{unit}]", font_size=10,
            color="#5b6875", location="outer",
        )  # fmt: skip

    def _place(self, plotter: Any, pieces: dict[str, Any], number: int) -> None:
        """Set the camera, at the first call only, so that the first, the last and this snapshot are visible."""
        if self._placed:
            return
        self._placed = True
        seen = [np.array(pieces["elements"].bounds).reshape(3, 2)]
        seen += [np.array(self._pieces(k)["elements"].bounds).reshape(3, 2) for k in {0, self.count - 1} - {number}]
        low, high = np.min(seen, axis=0)[:, 0], np.max(seen, axis=0)[:, 1]
        margin = 0.05 * float(np.linalg.norm(high - low))
        middle = 0.5 * (low + high)
        plotter.camera_position = [middle + self._toward, middle, self._up]
        if max(abs(self._toward)) > 0.999:  # along an axis without perspective
            plotter.enable_parallel_projection()
        plotter.reset_camera(bounds=np.column_stack([low - margin, high + margin]).ravel().tolist())

    def _body(self, pieces: dict[str, Any]) -> Any:
        show = self._show
        if show == "auto":
            show = "cells" if "cells" in pieces else "elements"
        if show == "cracks":
            return pieces["elements"].outline() if "elements" in pieces else None
        if show not in pieces:
            raise InputError(f"show = {show}: '{self._file}' has none; choose from {', '.join(pieces)}")
        mesh = pieces[show]
        if show == "cells":
            mesh.points = self._corners(mesh, pieces["elements"])
        else:
            mesh.points = mesh.points + (self._warp - 1.0) * pieces["elements"].point_data["displacement"]
        self._middle = mesh.center
        if self._colour is not None and show in ("cells", "elements"):
            (mesh.cell_data if show == "cells" else mesh.point_data)["fragment"] = self._colour
        if self._section is not None:
            mesh = mesh.clip(normal=self._section, origin=self._middle, crinkle=show == "cells")
        if show == "elements":
            sides = _COARSE if mesh.n_points > _MANY else _FINE
            ball = pyvista.Sphere(radius=1.0, theta_resolution=sides, phi_resolution=sides)
            mesh = mesh.glyph(scale="radius", geom=ball, orient=False)
        return mesh

    def _corners(self, mesh: Any, elements: Any) -> Floats:
        """Return the corners of rotated cells with magnified displacements [m], (c, 3)."""
        moved = mesh.cell_data["displacement"]
        start = vtk_to_numpy(mesh.GetCells().GetOffsetsArray())
        cell = np.repeat(np.arange(mesh.n_cells), np.diff(start))
        if "orientation" in mesh.cell_data:
            return mesh.points + (self._warp - 1.0) * moved[cell]
        centre = (elements.points - elements.point_data["displacement"])[cell].astype(float)  # older files
        turn = elements.point_data["orientation"][cell].astype(float)
        return centre + turned_vectors(turn, mesh.points - centre) + self._warp * moved[cell]

    def _coloured(self, mesh: Any) -> str | None:
        """Return the name of the array that colours a mesh; vectors are replaced by their magnitude.

        Raises:
            InputError: there is no such field.
        """
        known = {*mesh.point_data.keys(), *mesh.cell_data.keys()}
        name = self._field or ("displacement" if "displacement" in known else "integrity")
        if name in _STRESSES and "stress" in known:
            data = mesh.cell_data if "stress" in mesh.cell_data else mesh.point_data
            title, measure = _STRESSES[name]
            data[title] = measure(np.asarray(data["stress"])[:, _TENSOR])
            return title
        if name not in known:
            if self._field is None:
                return None
            known |= {*_STRESSES, "fragment"} if "stress" in known else {"fragment"}
            raise InputError(f"field = '{name}': no such field; choose from {', '.join(sorted(known))}")
        data = mesh.cell_data if name in mesh.cell_data else mesh.point_data
        if data[name].ndim > 1 and name != "fragment":
            data[f"|{name}|"] = np.linalg.norm(data[name], axis=1)
            return f"|{name}|"
        return name

    def _pieces(self, number: int) -> dict[str, Any]:
        self._reader.SetStep(number)
        self._reader.Update()
        found: Any = self._reader.GetOutputDataObject(0)
        assembly, pieces = found.GetDataAssembly(), {}
        for node in assembly.GetChildNodes(assembly.GetRootNode()):
            for index in assembly.GetDataSetIndices(node):
                part = found.GetPartitionedDataSet(index)
                if part.GetNumberOfPartitions():
                    pieces[assembly.GetNodeName(node)] = pyvista.wrap(part.GetPartition(0))
        return pieces

    def _by_piece(self) -> np.ndarray:
        """Return red, green and blue of each element by its fragment at the last checkpoint, in 0 … 255, (n, 3)."""
        checkpoint = read_run(self._file)
        pieces = fragments(checkpoint.model.lattice, checkpoint.state)
        return np.rint(255.0 * piece_palette(len(pieces))).astype(np.uint8)[pieces.label]


def _direction(camera: str) -> tuple[Floats, Floats]:
    """Return unit vectors from the body to the camera and upwards, (3,) each.

    Raises:
        InputError: no such camera.
    """
    angles: Any = _CAMERAS.get(camera)
    if angles is None:
        try:
            azimuth, elevation = (float(part) for part in camera.split(","))
        except ValueError:
            azimuth = elevation = math.nan
        if not (math.isfinite(azimuth) and abs(elevation) <= 90.0):
            raise InputError(
                f"camera = '{camera}' is unknown; give one of {', '.join(_CAMERAS)}, or AZIMUTH,ELEVATION in degrees"
            )
        angles = azimuth, elevation
    a, e = (math.radians(angle) for angle in angles)
    toward = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    up = np.array([0.0, 1.0, 0.0]) if abs(toward[2]) > 0.999 else np.array([0.0, 0.0, 1.0])
    return toward, up


def _titled(name: str | None) -> str:
    plain = (name or "").strip("|")
    return f"{name} [{_UNITS[plain]}]" if plain in _UNITS else str(name or "")
