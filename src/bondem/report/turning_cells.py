"""Data of a rotatable picture of cells in the page of a report: outer polygons, and those between fragments."""

from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps

from bondem._types import Floats, Ints
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.cell_pictures import outlined
from bondem.report.crack_pictures import corners_moved, piece_colours
from bondem.report.findings import Examined
from bondem.report.numbers import pieces_and_crumbs
from bondem.report.spheres import View
from bondem.report.strength_figures import magnified, reach_of
from bondem.report.style import SEQUENTIAL
from bondem.report.turning import in_base64
from bondem.specimen.tessellation.polyhedra import Polyhedra, polyhedra

# Usual view [rad].
_AZIMUTH, _ELEVATION = np.radians(28.0), np.radians(24.0)


@dataclass(frozen=True)
class TurningCells:
    """Data of the rotatable picture of cells.

    Attributes:
        corner: coordinates of the corners from -1 to 1, times 32 000, as 16-bit integers, three per corner, base64.
        size: number of corners of each polygon as bytes, base64.
        edge: 1 for each corner that begins a drawn edge, else 0, as bytes, base64.
        colour: red, green and blue of each polygon as bytes, base64.
        axes: initial directions to the right, upwards and to the viewer, (3, 3).
        caption: caption of the figure.
    """

    corner: str
    size: str
    edge: str
    colour: str
    axes: list[list[float]]
    caption: str


def turning_cells_of(one: Examined) -> TurningCells:
    """Return data of cells at rest, coloured by size, or displaced by the first test to failure, by fragment."""
    body, solid = one.lattice, polyhedra(one.lattice)
    broken = [name for name in FAILURE_TESTS if name in one.outcomes and one.outcomes[name].cracking is not None]
    if broken:
        cracking = one.outcomes[broken[0]].cracking
        assert cracking is not None
        state, pieces = cracking.state, cracking.fragments
        reach = reach_of(body, state.displacement)
        place = solid.vertex + corners_moved(solid, body, state.displacement, state.orientation, reach)
        label, colour = pieces.label, piece_colours(pieces)
        title = FAILURE_TESTS[broken[0]].figure.title
        caption = f"{title}: the broken specimen, {magnified(reach)}, {pieces_and_crumbs(cracking)} in a colour each"
    else:
        size = body.elements.relative_size
        share = (size - size.min()) / max(float(np.ptp(size)), 1e-12)
        place, label, colour = solid.vertex, np.zeros(len(size), dtype=int), colormaps[SEQUENTIAL](share)[:, :3]
        caption = f"The cells, coloured by size, V^(1/3) from {size.min():.2f} to {size.max():.2f} of the mean"
    seen = _seen(solid, label)
    rows, count = _rows(solid.start, seen)
    corner = place[rows]
    lower, upper = corner.min(axis=0), corner.max(axis=0)
    corner = (corner - 0.5 * (lower + upper)) / (0.5 * float((upper - lower).max()))
    return TurningCells(
        corner=in_base64(np.rint(32_000.0 * np.clip(corner, -1.0, 1.0)).astype("<i2")),
        size=in_base64(count.astype(np.uint8)),
        edge=in_base64(outlined(solid)[rows].astype(np.uint8)),
        colour=in_base64(np.rint(255.0 * colour[solid.cell[seen]]).astype(np.uint8)),
        axes=np.round(_clearest(place, solid, seen, label).axes, 4).tolist(),
        caption=f"{caption}. Drag to turn it, pinch or scroll with Ctrl to zoom.",
    )


def _clearest(place: Floats, solid: Polyhedra, seen: Ints, label: Ints) -> View:
    """Return the best of eight views: that in which fragments other than the two heaviest have the largest area."""
    start = solid.start[seen]
    a, b, c = (place[start + k] for k in range(3))
    area = np.cross(b - a, c - a)  # of the first triangle of each polygon
    small = label[solid.cell[seen]] > 1
    views = [View(azimuth=_AZIMUTH + k * 0.25 * np.pi, elevation=_ELEVATION) for k in range(8)]
    return max(views, key=lambda view: float(np.clip(area[small] @ view.axes[2], 0.0, None).sum()))


def _seen(solid: Polyhedra, label: Ints) -> Ints:
    """Return the numbers of the polygons on the boundary and between two fragments, (p,)."""
    other = np.maximum(solid.neighbour, 0)
    return np.flatnonzero((solid.neighbour < 0) | (label[solid.cell] != label[other]))


def _rows(start: Ints, chosen: Ints) -> tuple[Ints, Ints]:
    """Return the rows of the corners of chosen polygons, (v,), and the number of corners of each, (p,)."""
    count = np.diff(start)[chosen]
    first = np.repeat(start[chosen] - np.append(0, np.cumsum(count))[:-1], count)
    return first + np.arange(int(count.sum())), count
