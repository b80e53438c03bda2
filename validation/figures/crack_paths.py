"""Cracks that choose their path: the crack of each case and its load curve."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, ORANGE, PURPLE, sheet
from validation.cases.path_case import PathCase
from validation.figures.fracture import crack_path

_COLOURS = (BLUE, ORANGE, GREEN, PURPLE)
# Of a crack and of a load curve [inch].
_HEIGHT, _WIDTH = 3.8, 4.4


def draw_path(path: Path, case: PathCase, rows: Sequence[dict[str, Any]]) -> None:
    """Load over displacement of all packings, and the crack of the first.

    Args:
        path: PNG to write.
        case: what was tested.
        rows: of `validation.rows.crack_paths.PathRun`, one a packing.
    """
    low_x, high_x, low_y, high_y = case.window
    wide = _HEIGHT * min(max((high_x - low_x) / (high_y - low_y), 0.6), 1.6)
    with sheet(path, _WIDTH + wide, _HEIGHT, 1, 2, gridspec_kw={"width_ratios": [_WIDTH, wide]}) as (_, boxes):
        for row, colour in zip(rows, _COLOURS * len(rows), strict=False):
            x, load = (np.array(row["curve"][key]) for key in ("displacement", "load"))
            label = f"seed {row['seed']}, {row['count']} cells"
            boxes[0].plot(1e3 * x, 1e-3 * load, color=colour, linewidth=0.8, label=label)
        boxes[0].set(xlabel="displacement [mm]", ylabel="load [kN]", title=case.title)
        boxes[0].legend(fontsize=8.0)
        crack_path(boxes[1], case.shape, case.window, rows[0])
