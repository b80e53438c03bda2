"""Errors of the seven tests by the paper's protocol, beside what it prints."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, INK, ORANGE, sheet


def draw_protocol(
    path: Path,
    summary: Mapping[str, Mapping[str, Any]],
    methods: Mapping[str, str],
    tests: Mapping[str, tuple[str, float]],
) -> None:
    """Bars of every test, one a kind of packing.

    Args:
        path: PNG to write.
        summary: by kind, "errors" of every test as {"mean", "std"} [-].
        methods: names of the kinds.
        tests: name and printed error [-] of every test.
    """
    place = np.arange(len(tests))[::-1]
    height = 0.8 / len(summary)
    with sheet(path, 8.2, 4.6) as (_, ax):
        for k, (kind, colour) in enumerate(zip(summary, (BLUE, GREEN), strict=False)):
            at = place + (0.5 * (len(summary) - 1) - k) * height
            errors = [summary[kind]["errors"][name] for name in tests]
            mean, scatter = ([100.0 * (one[part] or 0.0) for one in errors] for part in ("mean", "std"))
            ax.barh(at, mean, 0.9 * height, color=colour, label=methods[kind])
            ax.errorbar(mean, at, xerr=scatter, fmt="none", ecolor=INK, elinewidth=1.0, capsize=2.0)
        for k, (_, printed) in enumerate(tests.values()):
            for sign in (-1.0, 1.0):
                ax.plot([sign * 100.0 * printed] * 2, [place[k] - 0.45, place[k] + 0.45], color=ORANGE, linewidth=2.0,
                        label="the paper, unsigned" if k == 0 and sign > 0.0 else None)  # fmt: skip
        ax.axvline(0.0, color=INK, linewidth=0.8)
        ax.set_yticks(place, [words for words, _ in tests.values()], fontsize=8.5)
        ax.set(xlabel="measured / theory − 1 [%]")
        ax.grid(axis="y", visible=False)
        ax.legend(loc="lower center", bbox_to_anchor=(0.4, 1.0), ncols=3, fontsize=8.5)
