"""Figure of a broken specimen: its fragments, its cracks, their growth and the acoustic emission."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from bondem.fracture.crack_growth import CrackGrowth
from bondem.fracture.cracks import Cracks
from bondem.fracture.emission import AcousticEmission
from bondem.fracture.fragments import Fragments
from bondem.fracture.magnitudes import BValue
from bondem.model.state import State
from bondem.report.crack_pictures import draw_cracks, draw_fragments
from bondem.report.numbers import many
from bondem.report.spheres import View
from bondem.report.style import BLUE, GREY, INK, ORANGE, colour_bar, sheet
from bondem.specimen.lattice import Lattice


def draw_fracture(
    path: Path, body: Lattice, state: State, *, pieces: Fragments, cracks: Cracks, growth: CrackGrowth,
    emission: AcousticEmission, b_value: BValue | None = None, view: View | None = None, reach: float = 1.0,
) -> None:  # fmt: skip
    """Draw four panels: fragments, cracks, growth and acoustic emission.

    Args:
        path: PNG to write.
        body: lattice of cells.
        state: final state.
        pieces, cracks, growth, emission: results for this state and its events.
        b_value: b-value of the emission, or None.
        view: direction of view; None for the default of `View`.
        reach: magnification of displacements of the fragments [-].
    """
    view = View() if view is None else view
    with sheet(path, 10.0, 6.4, 2, 2, height_ratios=(1.25, 1.0)) as (figure, axes):
        (left, right), (below, corner) = axes
        draw_fragments(left, body, state, pieces, view=view, reach=reach)
        crumbs = int((pieces.size < 10).sum())
        left.set_title(f"{many(len(pieces.size) - crumbs, 'piece')}, {many(crumbs, 'crumb')},"
                       f" motion × {reach:g}")  # fmt: skip
        scale = draw_cracks(right, body, cracks, view=view)
        right.set_title(f"cracks, {1e6 * cracks.area:.0f} mm² in {many(len(cracks.surfaces), 'surface')}")
        inset = right.inset_axes((0.03, 0.06, 0.34, 0.03))
        colour_bar(figure, scale, "opening [µm]", cax=inset, orientation="horizontal")
        _draw_growth(below, growth)
        _draw_magnitudes(corner, emission, b_value)


def _draw_growth(ax: Axes, growth: CrackGrowth) -> None:
    """Draw the crack front over time, and the line of its speed."""
    t, x = 1e6 * growth.time, 1e3 * growth.length
    ax.plot(t, x, drawstyle="steps-post", color=BLUE, label="farthest broken facet")
    line = 1e-3 * growth.speed * t
    line += np.median(x - line)
    low, high = growth.interval
    ax.plot(t, line, color=ORANGE, linestyle=(0, (4, 3)),
            label=f"{growth.speed:.0f} m/s ({low:.0f} to {high:.0f})")  # fmt: skip
    ax.set(xlabel="time [µs]", ylabel="length of the crack [mm]", title="growth")
    ax.legend(loc="upper left")


def _draw_magnitudes(ax: Axes, emission: AcousticEmission, b_value: BValue | None) -> None:
    """Draw the number of emissions above each magnitude."""
    size = np.sort(emission.magnitude[np.isfinite(emission.magnitude)])
    ax.step(size, np.arange(len(size), 0, -1), where="pre", color=BLUE, label=f"{len(emission)} emissions")
    if b_value is not None:
        m = np.array([b_value.completeness, size[-1]])
        ax.plot(m, b_value.count * 10.0 ** (-b_value.b * (m - m[0])), color=ORANGE, linestyle=(0, (4, 3)),
                label=f"b = {b_value.b:.2f} ({b_value.interval[0]:.2f} to {b_value.interval[1]:.2f})")  # fmt: skip
        ax.axvline(m[0], color=GREY, linewidth=0.8)
        ax.text(m[0], 1.0, " M$_c$", color=INK, va="bottom")
    ax.set(xlabel="magnitude M", ylabel="emissions of M or more", title="acoustic emission", yscale="log")
    ax.set_ylim(bottom=0.8)
    ax.legend(loc="lower left")
