"""Figure of cubes pulled beside a pressure or a tension along the crack, with the rule of cracks now and before."""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from bondem.report.style import BLUE, GREY, ORANGE, sheet
from validation.frame.record import RESULTS

_HELD = "pressure {} f_t held by platens: "
_PRESSURES = (0, 1, 3, 6, 10)
_LINES: Mapping[str, dict[str, Any]] = {
    "loading_paths": {"label": "now", "color": BLUE, "marker": "o"},
    "loading_paths_before": {"label": "before", "color": ORANGE, "marker": "s", "fillstyle": "none"},
}


def points(record: str, quantity: str) -> Iterator[tuple[int, float]]:
    """Pressure over f_t, and what was measured, of each packing of 400 cells."""
    cases = json.loads((RESULTS / f"{record}.json").read_text(encoding="utf-8"))["cases"]
    for pressure in _PRESSURES:
        name = _HELD.format(pressure) + quantity
        for row in (row for case in cases for row in case["rows"] if row["name"] == name):
            if row["count"] == 400:
                yield pressure, row["measured"] / (row["expected"] or 1.0)


def draw_beside(path: Path) -> None:
    """Draw peak, energy, and the pressure that is left."""
    panels = (("peak", "peak over f_t [-]"), ("G_f", "energy over G_f and section [-]"),
              ("pressure at the end over f_t", "share of the pressure left [-]"))  # fmt: skip
    with sheet(path, 9.0, 3.2, 1, 3) as (figure, axes):
        for axis, (quantity, label) in zip(axes, panels, strict=True):
            for record, line in _LINES.items():
                found = list(points(record, quantity))
                axis.plot(*zip(*found, strict=True), lw=0.0, ms=5, **line)
            axis.axhline(1.0, color=GREY, lw=0.8)
            axis.set_xlabel("pressure along the crack over f_t [-]")
            axis.set_ylabel(label)
        axes[0].set_ylim(0.9, 1.1)
        axes[1].set_yscale("log")
        axes[1].set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
        axes[1].set_yticks([], minor=True)
        axes[2].set_ylim(0.0, 1.1)
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
