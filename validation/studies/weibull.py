"""The size effect of brittle bars: strength over volume, with strengths after Weibull."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import gamma
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.errors import InputError
from bondem.report.style import BLUE, INK, ORANGE, sheet
from validation.figures.axes import plain_ticks
from validation.frame.files import table
from validation.frame.study import Row, Stages, Study
from validation.rows.weibull import Ceramic, WeibullRun

#: How far the ratio of two mean strengths may be off the weakest link's [-].
LIMIT = 0.05
# Cells of the bars of the size effect [m], volumes in cells of that size, and sizes of cells in the middle one.
_SIZE, _VOLUMES, _SIZES = 3e-3, (250, 1000, 4000), (2.4e-3, 3.75e-3)
_HEAD = ("strengths", "volume [mm³]", "cells", "cell [mm]", "strength [MPa]", "over the first", "asked", "verdict")
_KINDS = {True: "a field", False: "independent"}


@dataclass(frozen=True)
class WeibullStudy(Study):
    """Bars of 6750, 27 000 and 108 000 mm³, m = 10: mean strength falls as V^(-1/m), whatever the size of cells.

    Strengths of facets are s₀ (V/V₀)^(-1/m) (-ln u)^(1/m), brittle: independent of each other with V their own volume
    A L, or a field of correlation length 6 mm, two cells, with V the volume of its correlation (`bd.Weibull`). Held
    against V^(-1/m) within 5 %, and against the same strength with cells of 0.8 and 1.25 times the size. Lengths of
    two and of three cells had been tried before with seeds 1 to 10; two was kept, and these seeds are others.

    Attributes:
        modulus: m [-].
        length: of correlation of the field of strengths [mm].
        seeds: of the strengths.
    """

    name: ClassVar[str] = "weibull"
    title: ClassVar[str] = "Strength over volume"
    template: ClassVar[str] = "plain.html"

    modulus: float = Ceramic.modulus
    length: float = 1e3 * Ceramic.correlation
    seeds: tuple[int, ...] = tuple(range(11, 51))

    def __post_init__(self) -> None:
        if not (self.modulus > 1.0 and self.length > 0.0):
            raise InputError("weibull: modulus must exceed 1 and length 0 mm, such as --modulus 10 --length 6")
        if len(self.seeds) < 2 or min(self.seeds) < 0:
            raise InputError("weibull: give two seeds or more, from 0 up, such as --seeds 11,12,13")

    @property
    def ceramic(self) -> Ceramic:
        """What the bars are of."""
        return Ceramic(modulus=self.modulus, correlation=1e-3 * self.length)

    def stages(self, out: Path) -> Stages:
        """See `Study`."""
        bars = [(count, _SIZE) for count in _VOLUMES] + [(_VOLUMES[1], size) for size in _SIZES]
        yield "pull", [
            WeibullRun(self.ceramic, count * _SIZE**3, size, correlated, seed)
            for correlated in _KINDS for count, size in bars for seed in self.seeds
        ]  # fmt: skip

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: mean strengths, and their ratios to that of the smallest bar or of the usual cells."""
        good = [row for row in rows if not row["error"]]
        bars = []
        for correlated in _KINDS:
            own = [row for row in good if row["correlated"] == correlated]
            for first, others in ((_bar(own, 0), (1, 2)), (_bar(own, 1), (3, 4))):
                if first is None:
                    continue
                bars += [_compared(first, first, self.modulus)] * (others[0] == 1)
                bars += [_compared(bar, first, self.modulus) for bar in (_bar(own, k) for k in others) if bar]
        return {"limit": LIMIT, "seeds": list(self.seeds), "bars": bars}

    def table(self, results: Mapping[str, Any]) -> str:
        """See `Study`."""
        lines = [
            [_KINDS[one["correlated"]], f"{1e9 * one['bar']:.0f}", str(one["count"]), f"{1e3 * one['size']:g}",
             f"{1e-6 * one['mean']:.1f} ± {1e-6 * one['error']:.1f}",
             f"{one['ratio']:.3f} ± {one['ratio_error']:.3f}", f"{one['asked']:.3f}", one["verdict"]]
            for one in results["bars"]
        ]  # fmt: skip
        return table("Mean strengths ± error of the mean", _HEAD, lines) if lines else "no run\n"

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: mean strengths over volume."""
        ceramic = self.ceramic
        with sheet(out / "figures" / "weibull.png", 6.0, 4.2) as (_, ax):
            V = np.geomspace(_VOLUMES[0], _VOLUMES[-1], 50) * _SIZE**3
            link = 1e-6 * ceramic.tension * gamma(1.0 + 1.0 / ceramic.modulus)
            ax.plot(1e9 * V, link * (V / ceramic.volume) ** (-1.0 / ceramic.modulus), color=INK, label="weakest link")
            for correlated, colour in ((True, BLUE), (False, ORANGE)):
                for usual, mark in ((True, "o"), (False, "x")):
                    some = [one for one in results["bars"]
                            if one["correlated"] == correlated and (one["size"] == _SIZE) == usual]  # fmt: skip
                    label = f"{_KINDS[correlated]}, cells of {'3' if usual else '2.4 and 3.75'} mm"
                    ax.errorbar([1e9 * one["bar"] for one in some], [1e-6 * one["mean"] for one in some],
                                [2e-6 * one["error"] for one in some], fmt=mark, color=colour, label=label,
                                capsize=2.0)  # fmt: skip
            ax.set(xscale="log", yscale="log", xlabel="volume [mm³]", ylabel="mean strength [MPa]")
            for axis, marks in ((ax.xaxis, (5e3, 1e4, 2e4, 5e4, 1e5)), (ax.yaxis, (150, 200, 250, 300, 350))):
                plain_ticks(axis, marks)
            ax.legend(frameon=False, fontsize=8.0)

    def page(self, results: Mapping[str, Any]) -> Mapping[str, Any]:
        """See `Study`."""
        judged = [one["verdict"] for one in results["bars"] if one["verdict"] != "–"]
        return {
            "about": f"Brittle bars of cells by load factors, {len(self.seeds)} fields of strengths each.",
            "verdict": f"{sum(one != 'missed' for one in judged)} of {len(judged)} ratios are within {LIMIT:.0%}.",
            "captions": {"weibull": "Mean strength over volume; bars are two errors of the mean."},
            "note": "",
        }


def _bar(rows: Sequence[Row], k: int) -> list[Row] | None:
    """Rows of one kind of bar."""
    bars = [(count, _SIZE) for count in _VOLUMES] + [(_VOLUMES[1], size) for size in _SIZES]
    count, size = bars[k]
    found = [row for row in rows if row["size"] == size and abs(row["bar"] / (count * _SIZE**3) - 1.0) < 1e-9]
    return found if len(found) > 1 else None


def _compared(rows: Sequence[Row] | None, first: Sequence[Row], modulus: float) -> dict[str, Any]:
    assert rows is not None
    strength, usual = (np.array([row["strength"] for row in some]) for some in (rows, first))
    mean, about = float(strength.mean()), float(usual.mean())
    error, other = (float(some.std(ddof=1) / np.sqrt(len(some))) for some in (strength, usual))
    asked, ratio = (rows[0]["bar"] / first[0]["bar"]) ** (-1.0 / modulus), mean / about
    within = abs(ratio / asked - 1.0) <= LIMIT
    return {
        **{key: rows[0][key] for key in ("correlated", "bar", "size", "count")}, "runs": len(rows), "mean": mean,
        "error": error, "deviation": float(strength.std(ddof=1)), "ratio": ratio, "asked": asked,
        "ratio_error": ratio * float(np.hypot(error / mean, other / about)) if rows is not first else 0.0,
        "verdict": "–" if rows is first else "met" if within else "missed",
    }  # fmt: skip
