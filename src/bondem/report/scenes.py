"""Pictures of run files by VTK: loaded only where it is asked for, as pyvista is an optional extra."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyvista
from vtkmodules.vtkCommonCore import vtkLogger

from bondem.errors import InputError
from bondem.report.scene import Scene

_MOVIES = (".mp4", ".gif")
_BACKGROUND = "white"


def render_run(
    run_file: Path, out: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1,
    section: str | None = None, warp: float = 1.0, size: Sequence[int] = (1200, 800), camera: str = "iso",
    walls: bool = True, axes: bool = True,
) -> Path:  # fmt: skip
    """Draw snapshots of a run file into a PNG, or all of them into an MP4 or GIF.

    Args:
        run_file: with snapshots.
        out: picture or film.
        field: of the elements, or "fragment" (of the last state only); displacement unless given.
        show: "auto", "elements", "cells", "cracks" or "bonds".
        snapshot: which one; -1 is the last.
        section: "x", "y" or "z": what lies before the middle is cut away.
        warp: by how much displacements are enlarged.
        size: of the picture in pixels.
        camera: where one looks from: "iso", "x", "-x", "y", "-y", "z", "-z", or "AZIMUTH,ELEVATION" [degree].
        walls: whether walls are drawn.
        axes: whether coordinates are drawn.

    Raises:
        InputError: no such field, snapshot or camera, or an ending that is not known.
        RunFileError: no run file.
    """
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # of a screen that is not there nobody need hear
    film = out.suffix.lower() in _MOVIES
    if not film and out.suffix.lower() != ".png":
        raise InputError(f"'{out}': give a name that ends in .png, or in .mp4 or .gif for a film")
    scene = Scene(run_file, field=field, show=show, section=section, warp=warp, camera=camera, walls=walls, axes=axes)
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
            raise InputError(f'films need imageio ({told}): pip install "bondem[view]"') from None
        for number in range(scene.count):
            plotter.clear_actors()
            scene.draw(plotter, number)
            plotter.write_frame()
    plotter.close()
    return out


def view_run(
    run_file: Path, *, field: str | None = None, show: str = "auto", snapshot: int = -1, warp: float = 1.0,
    camera: str = "iso",
) -> None:  # fmt: skip
    """Open a window with a slider through the snapshots.

    Raises:
        InputError: there is no display, or no such field, snapshot or camera.
        RunFileError: no run file.
    """
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # what is wrong with the display the error says
    scene = Scene(run_file, field=field, show=show, section=None, warp=warp, camera=camera, walls=True, axes=True)
    chosen = scene.number(snapshot)
    _require_display(run_file)
    plotter: Any = pyvista.Plotter()
    plotter.set_background(_BACKGROUND)
    if "OSOpenGL" in plotter.render_window.GetClassName() or "EGL" in plotter.render_window.GetClassName():
        plotter.close()
        raise _no_display(run_file)  # the display that was named does not answer

    def go(value: float) -> None:
        plotter.clear_actors()
        scene.draw(plotter, round(value))

    if scene.count > 1:
        plotter.add_slider_widget(go, (0, scene.count - 1), value=chosen, title="snapshot", fmt="%.0f")
    scene.draw(plotter, chosen)
    plotter.show()


def _require_display(run_file: Path) -> None:
    """Make sure that a window can be opened.

    Raises:
        InputError: it cannot.
    """
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        raise _no_display(run_file)


def _no_display(run_file: Path) -> InputError:
    return InputError(f"view: no display is available to open a window; write a picture: bondem render {run_file}")
