"""Figures of a body of cells: the specimen cut open, and its bending."""

import math
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from bondem.report.cell_pictures import draw_cells, draw_section, section_through
from bondem.report.findings import Examined
from bondem.report.spheres import View
from bondem.report.style import DIVERGING, SEQUENTIAL, colour_bar, sheet
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra

_VIEW = View(azimuth=math.radians(28.0), elevation=math.radians(24.0))
# Largest displacement drawn, over the length.
_EXAGGERATED = 0.15


def draw_body(path: Path, body: Lattice) -> None:
    """Draw the cells of a body coloured by size, one half whole and the other cut open along the axis, into a PNG."""
    size = body.elements.relative_size
    norm = Normalize(float(size.min()), float(size.max()))
    lower, upper = body.particles.envelope.bounds
    middle = 0.5 * (lower + upper)
    x, y, _ = body.centre.T
    cut = (x > middle[0]) & (y < middle[1])
    with sheet(path, 8.2, 4.7) as (figure, ax):
        draw_cells(ax, polyhedra(body), _coloured(SEQUENTIAL, norm, size), view=_VIEW, shown=~cut)
        colour_bar(figure, ScalarMappable(norm, SEQUENTIAL), "size of the cell over the mean,  (V / V̄)$^{1/3}$  [-]",
                   ax=ax, orientation="horizontal", shrink=0.35)  # fmt: skip


def draw_bent(path: Path, specimen: Examined) -> None:
    """Draw the exaggerated body of `static_bending` and its axial section, coloured by axial stress, into a PNG."""
    body, curves = specimen.lattice, specimen.outcomes["static_bending"].curves
    solid = polyhedra(body)
    stress, moved = curves["axial_stress"] / 1e6, curves["displacement"]
    top = float(np.abs(stress).max())
    norm = Normalize(-top, top)
    colour = _coloured(DIVERGING, norm, stress)
    reach = _EXAGGERATED * float(np.ptp(body.centre[:, 0])) / float(np.abs(moved).max())
    owner = np.repeat(solid.cell, np.diff(solid.start))
    pushed = moved[owner] + np.cross(curves["rotation"][owner], solid.vertex - body.centre[owner])
    lower, upper = body.particles.envelope.bounds
    view = View(azimuth=math.radians(14.0), elevation=math.radians(58.0))
    with sheet(path, 8.2, 5.6, 2, 1, height_ratios=(1.5, 1.0)) as (figure, (above, below)):
        draw_cells(above, solid, colour, view=view, moved=reach * pushed)
        above.set_title(f"bent along y, {reach:.0f} times exaggerated")
        draw_section(below, section_through(solid, 2, 0.5 * float(lower[2] + upper[2])), colour)
        below.set(title="section through the axis", xlabel="x [mm]", ylabel="y [mm]")
        colour_bar(figure, ScalarMappable(norm, DIVERGING), "mean axial stress of the cell,  σ$_{xx}$  [MPa]",
                   ax=[above, below], shrink=0.6)  # fmt: skip


def _coloured(scale: str, norm: Normalize, values: np.ndarray) -> np.ndarray:
    return np.asarray(colormaps[scale](norm(values)))[:, :3]
