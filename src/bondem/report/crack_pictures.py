"""Pictures of fracture: fragments as their cells, and crack surfaces."""

from collections.abc import Callable
from functools import partial

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize

from bondem._types import Floats, Mask
from bondem.fracture.cracks import Cracks
from bondem.fracture.fragments import Fragments
from bondem.geometry.rotations import turned_vectors
from bondem.model.state import State
from bondem.report.cell_pictures import draw_cells
from bondem.report.overlays import box_edges, seen_from
from bondem.report.piece_colours import piece_palette
from bondem.report.sphere_pictures import draw_spheres
from bondem.report.spheres import View
from bondem.report.style import GREY, SEQUENTIAL, fit_axes
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import Polyhedra, polyhedra

# Brightness of a surface seen edge-on [-].
_AMBIENT = 0.55
# Largest magnified rotation of a cell [rad].
_SMALL = 0.7


def corners_moved(
    solid: Polyhedra, body: Lattice, displacement: Floats, orientation: Floats, reach: float = 1.0
) -> Floats:
    """Return the displacements of the corners of cells whose motion is magnified by `reach` [m], (v, 3).

    Rotations that remain small are magnified too, so that intact parts show no gaps. Other rotations, such as those
    of detached cells, are drawn unmagnified.
    """
    owner = np.repeat(solid.cell, np.diff(solid.start))
    arm = solid.vertex - body.centre[owner]
    angle = 2.0 * np.arccos(np.clip(np.abs(orientation[:, 0]), 0.0, 1.0))
    times = np.where(reach * angle <= _SMALL, reach, 1.0)[owner, None]
    return reach * displacement[owner] + times * (turned_vectors(orientation[owner], arm) - arm)


def draw_fragments(
    ax: Axes, body: Lattice, state: State, pieces: Fragments, *, view: View, reach: float = 1.0
) -> None:
    """Draw the cells or spheres at their positions, each fragment in its own colour.

    Args:
        ax: axes to draw on, in mm.
        body: lattice of cells or of bonded spheres.
        state: state of the body.
        pieces: fragments of this state, from `bd.fragments`.
        view: direction of view.
        reach: magnification of displacements [-].
    """
    motion = state.displacement, state.orientation
    draw_magnified(ax, body, piece_colours(pieces), motion, view=view, reach=reach, piece=pieces.label)


def draw_elements(
    ax: Axes, body: Lattice, colour: Floats, moved: Floats, corners: Callable[[Polyhedra], Floats], *,
    view: View, shown: Mask | None = None, piece: np.ndarray | None = None, scale: float = 1e3,
) -> None:  # fmt: skip
    """Draw cells as polyhedra, or elements as spheres, on axes with `scale` units per metre.

    Colours and drawn displacements of the centres [m] have shape (n, 3), the mask `shown` and the fragment `piece` of
    each element (n,). `corners` returns the drawn displacements of the corners of the polygons of cells [m], (v, 3).
    """
    if body.cells is None:
        draw_spheres(ax, body, colour, view=view, moved=moved, shown=shown, scale=scale)
        return
    solid = polyhedra(body)
    draw_cells(ax, solid, colour, view=view, moved=corners(solid), shown=shown, piece=piece, scale=scale)


def draw_magnified(
    ax: Axes, body: Lattice, colour: Floats, motion: tuple[Floats, Floats], *, view: View, reach: float,
    shown: Mask | None = None, piece: np.ndarray | None = None,
) -> None:  # fmt: skip
    """Draw elements whose displacements [m], (n, 3), and orientations, (n, 4), are magnified by `reach`."""
    corners = partial(corners_moved, body=body, displacement=motion[0], orientation=motion[1], reach=reach)
    draw_elements(ax, body, colour, reach * motion[0], corners, view=view, shown=shown, piece=piece)


def piece_colours(pieces: Fragments) -> Floats:
    """Return red, green and blue of each element by its fragment, in 0 … 1, (n, 3)."""
    return piece_palette(len(pieces))[pieces.label]


def draw_cracks(
    ax: Axes, body: Lattice, found: Cracks, *, view: View, top: float | None = None
) -> ScalarMappable:
    """Draw crack surfaces, coloured by their opening [µm], within the edges of the specimen's bounding box.

    Args:
        ax: axes to draw on, in mm.
        body: lattice of the cracks.
        found: cracks from `bd.cracks`.
        view: direction of view.
        top: upper end of the colour scale [m]; None for the largest.

    Returns:
        The colour scale, for a colour bar.
    """
    if top is None:
        top = float(found.opening.max()) if len(found) else 1e-6
    norm = Normalize(0.0, 1e6 * max(top, 1e-9))
    outline, size = found.polygons, np.diff(found.polygons.start)
    placed = 1e3 * outline.vertex @ view.axes.T
    facing = np.abs(found.normal[outline.facet] @ view.axes[2])
    tint = np.asarray(colormaps[SEQUENTIAL](norm(1e6 * found.opening[outline.facet])))
    tint[:, :3] *= (_AMBIENT + (1.0 - _AMBIENT) * facing)[:, None]
    if len(size):
        depth = np.add.reduceat(placed[:, 2], outline.start[:-1]) / size
        order = np.argsort(depth)
        shapes = [placed[outline.start[k] : outline.start[k + 1], :2] for k in order]
        ax.add_collection(PolyCollection(shapes, facecolors=tint[order], edgecolors=tint[order], linewidths=0.2))
    corner, pairs = box_edges(*body.particles.envelope.bounds)
    flat = seen_from(corner, view)[:, :2]
    ax.add_collection(LineCollection(list(flat[pairs]), colors=GREY, linewidths=0.7, zorder=0))
    fit_axes(ax, flat)
    ax.axis("off")
    return ScalarMappable(norm, SEQUENTIAL)
