"""Load curves of a fracture test beside what was measured, and the path of its crack."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Patch

from bondem._types import Floats
from bondem.geometry.shape import Shape
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, sheet
from validation.cases.case import Case

_COLOURS = (BLUE, ORANGE, GREEN, PURPLE, INK)
# Of the figure, and of a set of curves in it [inch].
_HEIGHT, _WIDTH = 4.2, 4.6
# Integrity below which a facet is drawn as torn: that of one whose opening is most of the way to its end.
_GONE = 0.02
# Points of the grid on which the outline of a shape is found, along its longer side.
_GRID = 600


def draw_case(path: Path, case: Case, rows: Sequence[dict[str, Any]]) -> None:
    """Load over displacement, and over the crack mouth's opening where there is a gauge; the crack of the first row.

    Args:
        path: PNG to write.
        case: what was tested.
        rows: of `validation.rows.fracture.FractureRun`, one a packing.
    """
    drawn = ["displacement"] + ["CMOD"] * (case.mouth is not None)
    low_x, high_x, low_y, high_y = case.path
    wide = _HEIGHT * min(max((high_x - low_x) / (high_y - low_y), 0.6), 1.6)
    widths = [_WIDTH] * len(drawn) + [wide]
    with sheet(path, sum(widths), _HEIGHT, 1, len(widths), gridspec_kw={"width_ratios": widths}) as (_, boxes):
        for ax, name in zip(boxes, drawn, strict=False):
            _curves(ax, case, rows, name)
        crack_path(boxes[-1], case.shape, case.path, rows[0])


def _curves(ax: Axes, case: Case, rows: Sequence[dict[str, Any]], name: str) -> None:
    for row, colour in zip(rows, _COLOURS * len(rows), strict=False):
        x, load = (np.array([0.0, *row["curve"][key]]) for key in (name, "load"))
        ax.plot(1e3 * x, 1e-3 * load, color=colour, linewidth=0.5, alpha=0.35)
        ax.plot(*envelope(1e3 * x, 1e-3 * load), color=colour, label=f"seed {row['seed']}, {row['count']} cells")
    claim = case.claim
    if claim.quantity == "peak":
        ax.axhspan(1e-3 * claim.low, 1e-3 * claim.high, color=GREY, alpha=0.25, linewidth=0.0, label=claim.words)
    if case.curve and name == "displacement":
        known = np.array(case.curve)
        ax.plot(1e3 * known[:, 0], 1e-3 * known[:, 1], "o--", color=INK, markersize=4.0, linewidth=0.9,
                label="published")  # fmt: skip
    title = "load over displacement" if name == "displacement" else "load over crack mouth opening"
    ax.margins(x=0.02, y=0.18)  # room for what is said of the lines
    ax.set(xlabel="displacement of the load [mm]" if name == "displacement" else "CMOD [mm]", ylabel="load [kN]",
           title=title, xlim=(0.0, None), ylim=(0.0, None))  # fmt: skip
    handles, _ = ax.get_legend_handles_labels()
    if claim.quantity == "work":
        handles += [
            Patch(color="none", label=f"work, seed {row['seed']}: {row['work'] + row['tail']:.3f} J") for row in rows
        ] + [Patch(color="none", label=claim.words)]  # fmt: skip
    ax.legend(handles=handles, loc="upper right", fontsize=8.0)


def envelope(x: Floats, load: Floats, bins: int = 120) -> tuple[Floats, Floats]:
    """Largest loads of events in equal parts of the way, (k,) each: single events come at less than those about them.

    Where the path turns back it is the upper branch that is seen.
    """
    edge = np.linspace(0.0, float(x.max()), bins + 1)
    part = np.clip(np.searchsorted(edge, x, side="right") - 1, 0, bins - 1)
    most = np.full(bins, -np.inf)
    np.maximum.at(most, part, load)
    first = int(np.argmax(load))
    where = [int(np.flatnonzero((part == k) & (load == most[k]))[0]) for k in np.unique(part)]
    chosen = np.unique([0, *where, first])
    chosen = chosen[np.argsort(x[chosen], kind="stable")]
    return x[chosen], load[chosen]


def crack_path(ax: Axes, shape: Shape, window: tuple[float, float, float, float], row: dict[str, Any]) -> None:
    """Facets of the crack, seen along the thickness: short lines along them, orange where hardly anything is left."""
    crack = {name: np.array(values) for name, values in row["crack"].items()}
    along = np.column_stack([-crack["normal_y"], crack["normal_x"]])
    half = 0.5 * np.sqrt(crack["area"])[:, None] * along
    middle = np.column_stack([crack["x"], crack["y"]])
    order = np.argsort(-crack["integrity"])
    lines = 1e3 * np.stack([middle - half, middle + half], axis=1)[order]
    low_x, high_x, low_y, high_y = window
    _outline(ax, shape, window)
    gone = crack["integrity"][order] < _GONE
    for chosen, colour, width in ((~gone, GREY, 0.6), (gone, ORANGE, 1.3)):
        ax.add_collection(LineCollection(list(lines[chosen]), colors=colour, linewidths=width, alpha=0.7))
    ax.set(xlim=(1e3 * low_x, 1e3 * high_x), ylim=(1e3 * low_y, 1e3 * high_y), aspect="equal", xlabel="x [mm]",
           ylabel="y [mm]", title=f"crack, seed {row['seed']}")  # fmt: skip
    ax.grid(False)


def _outline(ax: Axes, shape: Shape, window: tuple[float, float, float, float]) -> None:
    """The part of the body that is shown, in grey."""
    low_x, high_x, low_y, high_y = window
    step = max(high_x - low_x, high_y - low_y) / _GRID
    x, y = np.arange(low_x - step, high_x + step, step), np.arange(low_y - step, high_y + step, step)
    lower, upper = shape.bounds
    grid = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    middle = np.full((len(grid), 1), 0.5 * (lower[2] + upper[2]))
    depth = shape.depth(np.hstack([grid, middle])).reshape(len(y), len(x))
    ax.contourf(1e3 * x, 1e3 * y, depth, levels=[0.0, np.inf], colors=[PALE])
    ax.contour(1e3 * x, 1e3 * y, depth, levels=[0.0], colors=[GREY], linewidths=0.8)
