"""Figure of a body with aggregates: broken, cut open, and its curve."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb

from bondem._types import Floats
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.model.state import State
from bondem.report.cell_pictures import draw_cells, draw_section, section_through
from bondem.report.crack_pictures import corners_moved
from bondem.report.findings import Examined
from bondem.report.spheres import View
from bondem.report.strength_figures import broken_in, panels
from bondem.report.style import BLUE, sheet
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import Polyhedra, polyhedra

_STONE, _MORTAR, _CRACK = "#8a8f98", "#e3ddd0", "#c1272d"
_VIEW = View(azimuth=0.5, elevation=0.42)
# Largest opening drawn, over the length of the specimen.
_EXAGGERATED = 0.06


def draw_mesoscale(path: Path, body: Lattice, state: State, stones: Aggregates, curve: Floats) -> None:
    """Draw three panels: the broken body, a section and the curve.

    Args:
        path: PNG to write.
        body: lattice of cells.
        state: final state.
        stones: aggregates of the body.
        curve: elongation [m] and stress [Pa], (k, 2).
    """
    solid, colour = polyhedra(body), _coloured(body, stones)
    with sheet(path, 11.0, 3.5, 1, 3, width_ratios=(1.25, 1.1, 1.0)) as (_, (left, middle, right)):
        still = state.displacement, state.orientation
        moved = corners_moved(solid, body, *still)
        reach = max(1.0, _EXAGGERATED * float(np.ptp(body.centre[:, 0])) / max(float(np.ptp(moved[:, 0])), 1e-12))
        draw_cells(left, solid, colour, view=_VIEW, moved=corners_moved(solid, body, *still, reach))
        left.set_title(f"broken, motion × {reach:.0f}")
        _draw_cut_open(middle, solid, body, state, colour, 2)
        middle.set_title("section, cracks in red")
        right.plot(1e6 * curve[:, 0], 1e-6 * curve[:, 1], color=BLUE)
        right.set(xlabel="elongation [µm]", ylabel="stress [MPa]", title="direct tension", xlim=(0.0, None),
                  ylim=(0.0, None))  # fmt: skip


def draw_cut_open(path: Path, specimen: Examined) -> None:
    """Draw a section of a body of cells with aggregates, with its cracks after each test to failure, into a PNG."""
    assert specimen.aggregates is not None
    body, names = specimen.lattice, broken_in(specimen)
    solid, colour = polyhedra(body), _coloured(body, specimen.aggregates)
    with panels(path, len(names), (4.1, 3.6)) as (_, axes):
        for ax, name in zip(axes, names, strict=True):
            state = specimen.outcomes[name].state
            assert state is not None
            _draw_cut_open(ax, solid, body, state, colour, 0 if name == "brazilian" else 2)
            ax.set_title(FAILURE_TESTS[name].figure.title)


def _coloured(body: Lattice, stones: Aggregates) -> Floats:
    return np.where(stones.mask(body)[:, None], to_rgb(_STONE), to_rgb(_MORTAR))


def _draw_cut_open(ax: Axes, solid: Polyhedra, body: Lattice, state: State, colour: Floats, axis: int) -> None:
    """Draw the section through the middle, normal to an axis, with the cells in their initial positions."""
    at = float(np.mean(body.particles.envelope.bounds, axis=0)[axis])
    draw_section(ax, section_through(solid, axis, at), colour)
    _draw_cuts(ax, solid, body, state, axis, at)
    along, up = "xyz".replace("xyz"[axis], "")
    ax.set(xlabel=f"{along} [mm]", ylabel=f"{up} [mm]")


def _draw_cuts(ax: Axes, solid: Polyhedra, body: Lattice, state: State, axis: int, at: float) -> None:
    """Draw the lines in which a plane cuts softened facets; line width increases with damage."""
    lost = {frozenset(pair): loss for pair, loss in zip(
        body.pairs.tolist(), (1.0 - state.bond_integrity).tolist(), strict=True) if loss > 0.0}  # fmt: skip
    lines, widths = [], []
    for k in np.flatnonzero(solid.neighbour > solid.cell):
        loss = lost.get(frozenset((int(solid.cell[k]), int(solid.neighbour[k]))), 0.0)
        corner = solid.vertex[solid.start[k] : solid.start[k + 1]]
        above = corner[:, axis] - at
        other, beyond = np.roll(corner, -1, axis=0), np.roll(above, -1)
        crossed = np.flatnonzero((above > 0.0) != (beyond > 0.0))
        if loss == 0.0 or len(crossed) != 2:
            continue
        share = (above[crossed] / (above[crossed] - beyond[crossed]))[:, None]
        lines.append(1e3 * np.delete((1.0 - share) * corner[crossed] + share * other[crossed], axis, axis=1))
        widths.append(2.2 * loss)
    ax.add_collection(LineCollection(lines, colors=_CRACK, linewidths=widths))
