"""Pictures of run files by VTK, imported on use only, as pyvista is an optional extra."""

import os
import sys
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

import pyvista
from vtkmodules.vtkCommonCore import vtkLogger

from bondem._extras import install
from bondem.errors import InputError
from bondem.io.atomic import replacing, require_writable
from bondem.report.scene import Scene

_MOVIES = (".mp4", ".gif")
_BACKGROUND = "white"


def render_run(
    run_file: Path, out: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1,
    section: str | None = None, warp: float = 1.0, size: Sequence[int] = (1200, 800), camera: str = "iso",
    walls: bool = True, axes: bool = True,
) -> Path:  # fmt: skip
    """Draw one snapshot of a run file into a PNG, or all snapshots into an MP4 or GIF, and return the path.

    Args:
        run_file: run file with snapshots.
        out: picture or film to write.
        field: field of the elements ("stress" is that of von Mises), "s1" for the largest principal stress, or
            "fragment" (of the last state only); None for displacement or integrity.
        show: objects to draw: "auto", "elements", "cells", "cracks" or "bonds".
        snapshot: index of the snapshot; -1 is the last.
        section: axis "x", "y" or "z" of a section; the half in front of the middle plane is removed.
        warp: magnification of displacements [-].
        size: width and height of the picture [pixels].
        camera: direction of view: "iso", "x", "-x", "y", "-y", "z", "-z", or "AZIMUTH,ELEVATION" [degree].
        walls: True to draw walls.
        axes: True to draw coordinate axes.

    Raises:
        InputError: the field, object, snapshot, camera or suffix is unknown, the file cannot be written, or a film
            lacks imageio.
        RunFileError: the file is not a run file.
    """
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # no messages about a missing screen
    film = out.suffix.lower() in _MOVIES
    if not film and out.suffix.lower() != ".png":
        raise InputError(
            f"out = '{out}': unknown suffix; give a name that ends in .png, or in .mp4 or .gif for a film"
        )
    require_writable(out, "picture")
    scene = Scene(run_file, field=field, show=show, section=section, warp=warp, camera=camera, walls=walls, axes=axes)
    plotter: Any = pyvista.Plotter(off_screen=True, window_size=list(size))
    plotter.set_background(_BACKGROUND)
    with closing(plotter), replacing(out) as aside:
        if film:
            _film(scene, plotter, aside)
        else:
            scene.draw(plotter, scene.number(snapshot))
            plotter.screenshot(aside)
        plotter.close()  # completes a film
    return out


def _film(scene: Scene, plotter: Any, out: Path) -> None:
    try:
        plotter.open_gif(str(out)) if out.suffix.lower() == ".gif" else plotter.open_movie(str(out))
    except (ImportError, ValueError) as error:
        reason = " ".join(str(error).split())
        raise InputError(f"films need imageio ({reason}); {install('view')}") from None
    for number in range(scene.count):
        plotter.clear_actors()
        scene.draw(plotter, number)
        plotter.write_frame()


def view_run(
    run_file: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1, warp: float = 1.0,
    camera: str = "iso",
) -> None:  # fmt: skip
    """Open a window with a slider for the snapshots; arguments are those of `render_run`.

    Raises:
        InputError: no display, or no such field, snapshot or camera.
        RunFileError: the file is not a run file.
    """
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # the error states what is wrong with the display
    scene = Scene(run_file, field=field, show=show, section=None, warp=warp, camera=camera, walls=True, axes=True)
    chosen = scene.number(snapshot)
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        raise _no_display(run_file)
    plotter: Any = pyvista.Plotter()
    plotter.set_background(_BACKGROUND)
    if "OSOpenGL" in plotter.render_window.GetClassName() or "EGL" in plotter.render_window.GetClassName():
        plotter.close()
        raise _no_display(run_file)  # the display of the environment does not respond

    def go(value: float) -> None:
        plotter.clear_actors()
        scene.draw(plotter, round(value))

    if scene.count > 1:
        plotter.add_slider_widget(go, (0, scene.count - 1), value=chosen, title="snapshot", fmt="%.0f")
    scene.draw(plotter, chosen)
    plotter.show()


def _no_display(run_file: Path) -> InputError:
    return InputError(f"view: no display is available to open a window; write a picture: bondem render {run_file}")
