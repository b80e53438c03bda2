"""Pictures of run files by VTK, imported on use only, as pyvista is an optional extra."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pyvista
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkIOHDF import vtkHDFReader

from bondem._extras import install
from bondem.errors import InputError
from bondem.fracture.fragments import fragments
from bondem.io.run_contents import read_contents
from bondem.io.runfile import read_run
from bondem.report.style import GREY, INK, ORANGE, SEQUENTIAL

_MOVIES = (".mp4", ".gif")
_BACKGROUND = "white"
_LIGHT: dict[str, Any] = {"ambient": 0.35, "diffuse": 0.7}
_UNITS = {
    "displacement": "m", "velocity": "m/s", "angular_velocity": "rad/s", "stress": "Pa", "normal_force": "N",
    "shear_force": "N", "bending_moment": "N·m", "twisting_moment": "N·m",
    "radius": "m", "length": "m", "volume": "m³", "opening": "m", "sliding": "m", "area": "m²",
}  # fmt: skip
# Sides of the spheres that stand for elements, in a picture of few and of many of them.
_FINE, _COARSE, _MANY = 24, 10, 20_000


def render_run(
    run_file: Path, out: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1,
    section: str | None = None, warp: float = 1.0, size: Sequence[int] = (1200, 800),
) -> Path:  # fmt: skip
    """Draw snapshots of a run file into a PNG, or all of them into an MP4 or GIF.

    Args:
        run_file: run file with snapshots.
        out: picture or film to write.
        field: field of the elements, or "fragment" (of the last state only); None for the displacement.
        show: objects to draw: "auto", "elements", "cells", "cracks" or "bonds".
        snapshot: index of the snapshot; -1 is the last.
        section: axis "x", "y" or "z" of a section; the half in front of the middle plane is removed.
        warp: magnification of displacements [-].
        size: width and height of the picture [pixels].

    Raises:
        InputError: no such field or snapshot, or an unknown suffix.
        RunFileError: the file is not a run file.
    """
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # of a screen that is not there nobody need hear
    film = out.suffix.lower() in _MOVIES
    if not film and out.suffix.lower() != ".png":
        raise InputError(
            f"out = '{out}': unknown suffix; give a name that ends in .png, or in .mp4 or .gif for a film"
        )
    scene = _Scene(run_file, field, show, section, warp)
    plotter: Any = pyvista.Plotter(off_screen=True, window_size=list(size))
    plotter.set_background(_BACKGROUND)
    if not film:
        scene.draw(plotter, scene.number(snapshot))
        plotter.screenshot(out)
    else:
        try:
            plotter.open_gif(str(out)) if out.suffix.lower() == ".gif" else plotter.open_movie(str(out))
        except (ImportError, ValueError) as error:
            told = " ".join(str(error).split())
            raise InputError(f"films need imageio ({told}); {install('view')}") from None
        for number in range(scene.count):
            plotter.clear_actors()
            scene.draw(plotter, number)
            plotter.write_frame()
    plotter.close()
    return out


def view_run(
    run_file: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1, warp: float = 1.0
) -> None:
    """Open a window with a slider for the snapshots."""
    scene = _Scene(run_file, field, show, None, warp)
    plotter: Any = pyvista.Plotter()
    plotter.set_background(_BACKGROUND)
    chosen = scene.number(snapshot)

    def go(value: float) -> None:
        plotter.clear_actors()
        scene.draw(plotter, round(value))

    if scene.count > 1:
        plotter.add_slider_widget(go, (0, scene.count - 1), value=chosen, title="snapshot", fmt="%.0f")
    scene.draw(plotter, chosen)
    plotter.show()


def _titled(name: str | None) -> str:
    plain = (name or "").strip("|")
    return f"{name} [{_UNITS[plain]}]" if plain in _UNITS else str(name or "")


@dataclass
class _Scene:
    """Objects to draw of a run file."""

    run_file: Path
    field: str | None
    show: str
    section: str | None
    warp: float

    def __post_init__(self) -> None:
        if not read_contents(self.run_file).snapshots:
            raise InputError(f"'{self.run_file}' has no snapshots; run again with snapshot_every=")
        self._reader = vtkHDFReader()
        self._reader.SetFileName(str(self.run_file))
        self._reader.UpdateInformation()
        self.count = int(self._reader.GetNumberOfSteps())
        with h5py.File(self.run_file, "r") as file:
            steps: Any = file["VTKHDF/elements/Steps/Values"]
            self._times = np.asarray(steps[()])
        self._fragment = self._labels() if self.field == "fragment" else None

    def number(self, snapshot: int) -> int:
        """Index of a snapshot, counted from either end.

        Raises:
            InputError: there is no such snapshot.
        """
        if not -self.count <= snapshot < self.count:
            raise InputError(
                f"snapshot = {snapshot}: '{self.run_file}' has {self.count} snapshots; give a number from 0 to"
                f" {self.count - 1}"
            )
        return snapshot % self.count

    def draw(self, plotter: Any, number: int) -> None:
        """Draw one snapshot."""
        pieces = self._pieces(number)
        body = self._body(pieces)
        if body is not None:
            name = self._coloured(body)
            bar = {"color": "black", "title": _titled(name), "n_labels": 3, "fmt": "%.3g"}
            plotter.add_mesh(
                body, scalars=name, cmap="tab20" if name == "fragment" else SEQUENTIAL, smooth_shading=False,
                show_scalar_bar=name not in ("fragment", None), scalar_bar_args=bar, color=GREY, name="body",
                **_LIGHT,
            )  # fmt: skip
        cracks = pieces.get("cracks")
        if cracks is not None and cracks.n_cells and (self.show == "cracks" or self.section):
            if self.section is not None:
                cracks = cracks.clip(normal=f"-{self.section}", origin=self._middle)
            plotter.add_mesh(
                cracks, color=ORANGE, show_edges=self.show == "cracks", edge_color=INK, name="cracks", **_LIGHT
            )
        plotter.add_text(f"t = {self._times[number]:.4g} s", font_size=10, color="black", name="time")
        if number in (0, self.count - 1) or plotter.camera_position is None:
            plotter.view_isometric()

    def _body(self, pieces: dict[str, Any]) -> Any:
        show = self.show
        if show == "auto":
            show = "cells" if "cells" in pieces else "elements"
        if show == "cracks":
            return pieces["elements"].outline() if "elements" in pieces else None
        if show not in pieces:
            raise InputError(f"show = {show}: '{self.run_file}' has none; choose from {', '.join(pieces)}")
        mesh = pieces[show]
        if show == "cells":
            own = mesh.cell_data
            moved = self.warp * own["displacement"]
            cell = np.repeat(np.arange(mesh.n_cells), [mesh.get_cell(k).n_points for k in range(mesh.n_cells)])
            mesh.points = mesh.points + moved[cell]
        else:
            mesh.points = mesh.points + (self.warp - 1.0) * pieces["elements"].point_data["displacement"]
        self._middle = mesh.center
        if self._fragment is not None and show in ("cells", "elements"):
            (mesh.cell_data if show == "cells" else mesh.point_data)["fragment"] = self._fragment
        if self.section is not None:
            mesh = mesh.clip(normal=f"-{self.section}", origin=self._middle, crinkle=show == "cells")
        if show == "elements":
            sides = _COARSE if mesh.n_points > _MANY else _FINE
            ball = pyvista.Sphere(radius=1.0, theta_resolution=sides, phi_resolution=sides)
            mesh = mesh.glyph(scale="radius", geom=ball, orient=False)
        return mesh

    def _coloured(self, mesh: Any) -> str | None:
        """Array that colours a mesh; vectors are coloured by their magnitude.

        Raises:
            InputError: there is no such field.
        """
        known = {*mesh.point_data.keys(), *mesh.cell_data.keys()}
        name = self.field or ("displacement" if "displacement" in known else "integrity")
        if name not in known:
            if self.field is None:
                return None
            raise InputError(f"field = '{name}': no such field; choose from {', '.join(sorted(known))}, and fragment")
        data = mesh.cell_data if name in mesh.cell_data else mesh.point_data
        if data[name].ndim > 1:
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

    def _labels(self) -> np.ndarray:
        """Fragment of each element at the last checkpoint; the largest is 0, and all beyond the nineteen largest are
        one.
        """
        kept = read_run(self.run_file)
        return np.minimum(fragments(kept.model.lattice, kept.state).label, 19)
