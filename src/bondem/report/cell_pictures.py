"""Pictures of cells in parallel projection, and of plane sections, by the painter's algorithm."""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from bondem._types import Floats, Mask
from bondem.report.spheres import View
from bondem.report.style import fit_axes
from bondem.specimen.tessellation.polyhedra import Polyhedra

_LIGHT = np.array([-0.45, 0.60, 0.66]) / np.linalg.norm([-0.45, 0.60, 0.66])
# Shares of ambient and of directed light.
_AMBIENT, _LAMP = 0.62, 0.45


@dataclass(frozen=True, eq=False)
class CellSection:
    """Polygons of the intersection of a plane with cells.

    Attributes:
        outline: corners in the plane [m], one array (k, 2) per cell.
        cell: cell of each polygon.
    """

    outline: list[Floats]
    cell: np.ndarray


def draw_cells(
    ax: Axes, solid: Polyhedra, colour: Floats, *, view: View, moved: Floats | None = None, shown: Mask | None = None,
    piece: np.ndarray | None = None, scale: float = 1e3,
) -> None:  # fmt: skip
    """Draw the visible outer polygons of cells, including those next to cells that are not drawn.

    Args:
        ax: axes to draw on.
        solid: polygons of the cells.
        colour: red, green and blue of each cell in 0 … 1, (n, 3).
        view: direction of view.
        moved: displacements of the corners of the polygons as drawn [m], (v, 3); None for zero.
        shown: mask of the cells to draw, (n,); None for all.
        piece: fragment of each cell, (n,), so that faces between fragments are drawn; None for one fragment.
        scale: units of the axes per metre.
    """
    here = np.ones(len(colour), dtype=bool) if shown is None else shown
    behind = (solid.neighbour >= 0) & here[np.maximum(solid.neighbour, 0)]
    if piece is not None:
        behind &= piece[solid.cell] == piece[np.maximum(solid.neighbour, 0)]
    size = np.diff(solid.start)
    place = solid.vertex if moved is None else solid.vertex + moved
    placed = scale * place @ view.axes.T
    following = _following(solid.start)
    normal = np.add.reduceat(np.cross(placed, placed[following]), solid.start[:-1], axis=0)  # twice the area
    seen = np.flatnonzero(here[solid.cell] & ~behind & (normal[:, 2] > 0.0))
    depth = np.add.reduceat(placed[:, 2], solid.start[:-1]) / size
    seen = seen[np.argsort(depth[seen])]
    unit = normal[seen] / np.linalg.norm(normal[seen], axis=1, keepdims=True)
    face = np.clip(colour[solid.cell[seen]] * light_on(unit)[:, None], 0.0, 1.0)
    edge = outlined(solid)
    paths: list[Floats] = []
    fills: list[Floats] = []
    for k, tint in zip(seen, face, strict=True):
        corners = np.arange(int(solid.start[k]), int(solid.start[k + 1]))
        paths.append(placed[np.append(corners, corners[0]), :2])
        fills.append(np.append(tint, 1.0))
        for a in corners[edge[corners]]:  # drawn with their polygon, so that nearer ones hide both
            paths.append(placed[[a, following[a]], :2])
            fills.append(np.append(0.7 * tint, 1.0))
    ax.add_collection(PolyCollection(paths, closed=False, facecolors=fills, edgecolors=fills, linewidths=0.35))
    flat = placed[np.repeat(here[solid.cell], size)]
    fit_axes(ax, flat[:, :2])
    ax.axis("off")


def light_on(normal: Floats) -> Floats:
    """Return the brightness of faces, (k,), from their unit normals in the picture, (k, 3)."""
    return _AMBIENT + _LAMP * np.clip(normal @ _LIGHT, 0.0, None)


def _following(start: np.ndarray) -> np.ndarray:
    """Return the next corner of the same polygon for each corner, (v,)."""
    following = np.arange(1, start[-1] + 1)
    following[start[1:] - 1] = start[:-1]
    return following


def outlined(solid: Polyhedra) -> Mask:
    """Return a mask of the corners that begin an edge, (v,), and not a line between strips of a curved surface."""
    following, size = _following(solid.start), np.diff(solid.start)
    owner, wall = np.repeat(solid.cell, size), np.repeat(solid.neighbour < 0, size)
    grid = np.rint((solid.vertex + solid.vertex[following]) / (1e-6 * np.ptp(solid.vertex, axis=0).max()))
    rows = np.column_stack([owner, grid.astype(np.int64)])[wall]
    _, same, count = np.unique(rows, axis=0, return_inverse=True, return_counts=True)
    true = np.ones(len(owner), dtype=bool)
    true[wall] = count[same.ravel()] == 1
    return true


def section_through(solid: Polyhedra, axis: int, at: float) -> CellSection:
    """Cut convex cells by the plane normal to an axis, 0 to 2, at the coordinate `at` [m]."""
    following = _following(solid.start)
    owner = np.repeat(solid.cell, np.diff(solid.start))
    a, b = solid.vertex[:, axis] - at, solid.vertex[following, axis] - at
    crossed = np.flatnonzero((a > 0.0) != (b > 0.0))
    share = (a[crossed] / (a[crossed] - b[crossed]))[:, None]
    point = (1.0 - share) * solid.vertex[crossed] + share * solid.vertex[following[crossed]]
    flat = np.delete(point, axis, axis=1)
    order = np.argsort(owner[crossed], kind="stable")
    flat, cell = flat[order], owner[crossed][order]
    begin = np.flatnonzero(np.diff(cell, prepend=-1))
    outline: list[Floats] = []
    for part in np.split(flat, begin[1:]):
        spread = part - part.mean(axis=0)
        outline.append(part[np.argsort(np.arctan2(spread[:, 1], spread[:, 0]))])
    return CellSection(outline, cell[begin])


def draw_section(ax: Axes, section: CellSection, colour: Floats, *, scale: float = 1e3) -> None:
    """Draw a section in the colours of all cells, (n, 3), on axes with `scale` units per metre."""
    face = colour[section.cell]
    ax.add_collection(
        PolyCollection([scale * one for one in section.outline], facecolors=face, edgecolors="white", linewidths=0.35)
    )
    fit_axes(ax, scale * np.concatenate(section.outline))
    ax.grid(visible=False)
