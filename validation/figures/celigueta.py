"""Curves of the tests of Celigueta et al., and what is left of the specimens."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREY, ORANGE, sheet
from validation.figures.axes import draw_slice

_COLOURS = {"weighted": ORANGE, "facet": BLUE}
_MOST = 5e-5  # displacement from which on colours are those of the end [m]


def draw_curves(path: Path, test: str, measured: float | None, rows: Sequence[Mapping[str, Any]]) -> None:
    """Stress over strain, or over time in splitting; a box for each criterion."""
    failures = list(dict.fromkeys(row["failure"] for row in rows))
    with sheet(path, 4.6 * len(failures), 3.8, 1, len(failures), squeeze=False) as (_, boxes):
        for ax, failure in zip(boxes[0], failures, strict=True):
            seen: set[str] = set()
            for row in rows:
                if row["failure"] != failure:
                    continue
                along, unit = ("time", 1e3) if test == "splitting" else ("strain", 1e2)
                x, y = unit * np.array(row["curve"][along]), 1e-6 * np.array(row["curve"]["stress"])
                label = "" if row["areas"] in seen else f"{row['areas']} areas"
                seen.add(row["areas"])
                ax.plot(x, y, color=_COLOURS[row["areas"]], linewidth=0.9, alpha=0.8, label=label)
            if measured:
                ax.axhline(1e-6 * measured, color=GREY, linestyle="--", linewidth=1.0, label="measured")
            name = "time [ms]" if test == "splitting" else "strain between the plates [%]"
            ax.set(title=f"{test}, {failure}", xlabel=name, ylabel="stress [MPa]", xlim=(0.0, None), ylim=(0.0, None))
            ax.legend(frameon=False)


def draw_broken(path: Path, runs: Sequence[tuple[Mapping[str, Any], Mapping[str, Any]]]) -> None:
    """Slices through the middle, coloured by the displacement across the load; positions magnified twenty times."""
    rows = min(len(runs), 2)
    columns = (len(runs) + 1) // 2
    with sheet(path, (4.4 if rows == 1 else 2.9) * columns, 3.2 * rows, rows, columns, squeeze=False) as (_, boxes):
        for ax in boxes.flat:
            ax.set_axis_off()
        for ax, (run, kept) in zip(boxes.T.flat, runs, strict=False):
            # seen along the axis in splitting, across it in the other tests
            views, moved = (0, 1, 2) if run["test"] == "splitting" else (1, 2, 0), kept["displacement"]
            shown = np.clip(moved[:, views[1]], -_MOST, _MOST)
            draw_slice(ax, kept, views, np.clip(moved, -5e-4, 5e-4), shown, cmap="coolwarm", limits=(-_MOST, _MOST))
            ax.autoscale_view()
            ax.set_aspect("equal")
            ax.set_title(f"{run['test']},\n{run['failure']}, {run['areas']}", fontsize=8)
