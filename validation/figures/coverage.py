"""Intervals of a calibration and the packings they were to hold."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, ORANGE, sheet

_SYMBOLS = {"E": ("E", BLUE, "o"), "nu": ("ν", GREEN, "s")}


def draw_coverage(path: Path, results: Mapping[str, Any]) -> None:
    """Every packing against the intervals, and the coverage over the number of calibrating packings.

    Args:
        path: PNG to write.
        results: of `python -m validation coverage`.
    """
    n = results["calibrating"]
    with sheet(path, 10.2, 3.8, 1, 3) as (_, (*boxes, right)):
        for ax, (name, (symbol, colour, marker)) in zip(boxes, _SYMBOLS.items(), strict=True):
            one = results["quantities"][name]
            values = np.array(one["values"])
            mean = values[:n].mean()
            low, high = (100.0 * (end / mean - 1.0) for end in one["prediction"])
            ax.axhspan(low, high, color=colour, alpha=0.12, linewidth=0.0, label="one new packing, 95 %")
            low, high = (100.0 * (end / mean - 1.0) for end in one["confidence"])
            ax.axhspan(low, high, color=colour, alpha=0.3, linewidth=0.0, label="mean of all, 95 %")
            off = 100.0 * (values / mean - 1.0)
            seed = np.arange(1, len(off) + 1)
            ax.plot(seed[:n], off[:n], marker, color=ORANGE, markersize=4.5, label="calibrating")
            ax.plot(seed[n:], off[n:], marker, color=colour, markersize=4.0, label="unseen")
            top = 1.9 * np.abs([*off, *ax.get_ylim()]).max()
            ax.set(xlabel="seed", ylabel=f"{symbol} against the calibration [%]", ylim=(-0.6 * top, top),
                   title=f"{symbol}: {one['covered']} of {results['held_out']} inside")  # fmt: skip
            ax.legend(loc="upper center", fontsize=8.0, ncols=2)
        for name, (symbol, colour, marker) in _SYMBOLS.items():
            found = results["quantities"][name]["coverage"]
            size = np.array([int(key) for key in found])
            right.plot(size, [100.0 * one["mean"] for one in found.values()], marker=marker, color=colour,
                       label=f"{symbol}, mean")  # fmt: skip
            worst = [100.0 * one["worst_tenth"] for one in found.values()]
            right.plot(size, worst, marker=marker, color=colour, linestyle=(0, (3, 2)), linewidth=1.0, markersize=3.5,
                       label=f"{symbol}, worst tenth")  # fmt: skip
        right.axhline(100.0 * results["level"], color=GREY, linewidth=1.0)
        right.set(xlabel="calibrating packings", ylabel="unseen packings inside [%]", ylim=(60.0, 101.0),
                  title="over random calibrations")  # fmt: skip
        right.legend(loc="lower right", fontsize=8.0)
