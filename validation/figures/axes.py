"""What several figures draw: few numbers at chosen places of an axis, means with their scatter, and bars of them."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle
from matplotlib.ticker import FixedLocator, FormatStrFormatter, NullLocator

from bondem._types import Floats
from bondem.report.style import INK


def plain_ticks(axis: Axis, places: Sequence[float]) -> None:
    """Numbers at these places of a logarithmic axis and nowhere else, written as they are."""
    axis.set_major_locator(FixedLocator(list(places)))
    axis.set_major_formatter(FormatStrFormatter("%g"))
    axis.set_minor_locator(NullLocator())


def draw_means(ax: Axes, x: Floats, y: Floats, colour: str, marker: str, label: str, *, joined: bool = True) -> None:
    """Every packing, small, and their mean with its scatter."""
    level, mean = mean_by(x, y)
    ax.plot(x, y, ".", color=colour, markersize=3.5, alpha=0.5)
    groups = [y[(x == one) & np.isfinite(y)] for one in level]
    spread = np.array([group.std(ddof=1) if len(group) > 1 else 0.0 for group in groups])
    ax.errorbar(level, mean, yerr=spread, color=colour, marker=marker, markersize=4.5, capsize=2.5, elinewidth=1.0,
                linestyle="-" if joined else "none", linewidth=1.3, label=label)  # fmt: skip


def mean_by(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Values of x, and the mean of y at each."""
    level = np.unique(x)
    known = [y[(x == one) & np.isfinite(y)] for one in level]
    return level, np.array([group.mean() if len(group) else np.nan for group in known])


def draw_slice(
    ax: Axes, kept: Mapping[str, Any], views: tuple[int, int, int], moved: Floats, colours: Floats, *, cmap: str,
    limits: tuple[float, float],
) -> PatchCollection:  # fmt: skip
    """Spheres of a slice through the middle, one mean radius to both sides, whose motion is magnified twenty times.

    Args:
        ax: where to draw.
        kept: "position" (n, 3) and "radius" (n,) of the spheres [m].
        views: axes along which one looks, across and up.
        moved: displacements [m], (n, 3).
        colours: of each sphere, in `cmap` between `limits`, (n,).
        cmap, limits: of the colours.
    """
    (middle, across, up), position, radius = views, kept["position"], kept["radius"]
    level = 0.5 * (position[:, middle].min() + position[:, middle].max())
    inside = np.flatnonzero(np.abs(position[:, middle] - level) < radius.mean())
    place = position[inside] + 20.0 * moved[inside]
    circles = [Circle((x, y), r) for x, y, r in zip(place[:, across], place[:, up], radius[inside], strict=True)]
    found = PatchCollection(circles, cmap=cmap, edgecolor="black", linewidth=0.2)
    found.set_array(colours[inside])
    found.set_clim(*limits)
    ax.add_collection(found)
    return found


def draw_bars(
    ax: Axes, place: Floats, values: Sequence[Mapping[str, float | None]], width: float, colour: str,
    label: str | None,
) -> None:  # fmt: skip
    """Bars of means with their scatter, in percent."""
    mean, scatter = ([100.0 * (one[part] or 0.0) for one in values] for part in ("mean", "std"))
    ax.bar(place, mean, width, color=colour, label=label)
    ax.errorbar(place, mean, scatter, fmt="none", ecolor=INK, elinewidth=1.0, capsize=2.0)
