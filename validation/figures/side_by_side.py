"""Broken cylinders of all laws, side by side: slices through the middle, coloured by damage."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.collections import PatchCollection

from bondem.errors import InputError
from bondem.report.style import INK, sheet
from validation.figures.axes import draw_slice

#: Tests in rows: seen across the load, or along the axis in splitting.
ROWS = (("ucs", "compression"), ("tension", "direct tension"), ("brazilian", "splitting"))
_FARTHEST = 5e-4


def draw_broken(path: Path, kept: Path, names: Sequence[tuple[str, str]], count: int, radius: float) -> None:
    """Draw packing 1 at the end of each test.

    Args:
        path: PNG to write.
        kept: folder of what the tests left.
        names: of the laws, and their words.
        count: elements.
        radius: of the cylinder [m].
    """
    there = [one for one in names if (kept / f"{one[0]}-{count}-seed1-brazilian.npz").exists()]
    path.parent.mkdir(parents=True, exist_ok=True)
    if not there:
        raise InputError(f"{kept} has no curves of {count} elements; measure them first")
    ratios = [4.4, 4.4, 2.4]
    with sheet(path, 1.2 * len(there), 5.8, 3, len(there), squeeze=False, height_ratios=ratios) as (figure, boxes):
        found = None
        for (test, title), line in zip(ROWS, boxes, strict=True):
            for ax, (name, words) in zip(line, there, strict=True):
                with np.load(kept / f"{name}-{count}-seed1-{test}.npz") as one:
                    found = _slice(ax, one, test)
                height = (-1.2 * radius, 1.2 * radius) if test == "brazilian" else (-0.2 * radius, 4.2 * radius)
                ax.set(xlim=(-1.3 * radius, 1.3 * radius), ylim=height, aspect="equal")
                ax.set_axis_off()
                if test == "ucs":
                    ax.set_title(words.replace(", ", ",\n"), fontsize=6.5, loc="center", color=INK)
            line[0].text(-0.12, 0.5, title, transform=line[0].transAxes, rotation=90, va="center", ha="center",
                         color=INK)  # fmt: skip
        assert found is not None
        bar = figure.colorbar(found, ax=boxes, orientation="horizontal", shrink=0.4, aspect=40, pad=0.01)
        bar.set_label("share of the bonds or facets of an element that is broken [-]")


def _slice(ax: Any, one: Mapping[str, np.ndarray], test: str) -> PatchCollection:
    # what breaks off flies away: all motions beyond half a millimetre are drawn alike
    moved = np.clip(one["displacement"], -_FARTHEST, _FARTHEST)
    views = (0, 2, 1) if test == "brazilian" else (2, 1, 0)
    moved = moved - np.median(moved, axis=0)
    return draw_slice(ax, one, views, moved, one["damage"], cmap="YlOrRd", limits=(0.0, 1.0))
