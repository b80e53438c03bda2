"""Figure of a test programme: deviations of E, ν and strengths from their targets and closed forms."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, INK, ORANGE, legend_columns, sheet


def draw_targets(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Draw the deviation of each test from its target and from the closed form of the criterion [%].

    Args:
        path: PNG to write.
        rows: rows of the programme's table, at least one with "off_target" or "off_theory".
    """
    shown = [row for row in rows if row["off_target"] is not None or row["off_theory"] is not None]
    place = np.arange(len(shown))[::-1]
    with sheet(path, 8.2, 0.42 * len(shown) + 1.3) as (figure, ax):
        ax.axvline(0.0, color=INK, linewidth=0.9)
        for key, label, colour, style, up in (
            ("off_target", "against the target", BLUE, "o", 0.12),
            ("off_theory", "against the closed form of the criterion", ORANGE, "D", -0.12),
        ):
            known = [(y + up, row) for y, row in zip(place, shown, strict=True) if row[key] is not None]
            if not known:
                continue
            spread = [100.0 * (row["scatter"] or 0.0) for _, row in known]
            bars = {"xerr": spread, "capsize": 3} if any(spread) else {}
            ax.errorbar([100.0 * row[key] for _, row in known], [y for y, _ in known], fmt=style, color=colour,
                        markersize=6, linewidth=1.0, label=label, **bars)  # fmt: skip
        reach = 1.15 * max(5.0, *(abs(value) for value in ax.get_xlim()))
        ax.set(xlim=(-reach, reach), ylim=(-0.6, len(shown) - 0.4), yticks=place,
               xlabel="measured over target or closed form, less one  [%]")  # fmt: skip
        ax.set_yticklabels([f"{row['specimen']}: {row['label']}" for row in shown])
        ax.grid(axis="y", visible=False)
        figure.legend(loc="outside lower center", ncols=legend_columns(2))
