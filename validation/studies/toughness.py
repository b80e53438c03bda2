"""Fracture toughness: plates with a crack break at K_Ic = √(E' G_f) where they are large against the process zone."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet
from validation.cases.case import Claim
from validation.cases.toughness import PLATES
from validation.figures.axes import plain_ticks
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.toughness import ToughnessRun

#: How far K at the peak may be from K_Ic [-].
LIMIT = 0.1
_COLOURS = dict(zip(PLATES, (BLUE, ORANGE), strict=True))


@dataclass(frozen=True)
class Toughness(Study):
    """Centre cracks and compact specimens (ASTM E399), three widths each: K of the largest load against √(E' G_f).

    Attributes:
        plates: which kinds.
        seeds: packings of each.
        cells: size of cells at the tip, over l = E' G_f / f_t².
    """

    limits: ClassVar = {"plates": words(PLATES), "seeds": numbers(least=0), "cells": numbers(least=0.02, most=0.4)}

    plates: tuple[str, ...] = tuple(PLATES)
    seeds: tuple[int, ...] = (1, 2)
    cells: float = 0.2

    def stages(self, out: Path) -> Stages:
        yield "pull", [
            ToughnessRun(kind, over, self.cells, seed)
            for kind in self.plates for over in PLATES[kind][1] for seed in self.seeds
        ]  # fmt: skip

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each plate K over K_Ic, and whether that is within 10 %."""
        good = [row for row in rows if not row["error"]]
        wanted = [(kind, over) for kind in self.plates for over in PLATES[kind][1]]
        groups = [[row for row in good if (row["kind"], row["over"]) == one] for one in wanted]
        return {"limit": LIMIT, "size": self.cells, "plates": [_judged(some) for some in groups if some]}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: K over K_Ic against the width, and as plates break."""
        with sheet(out / "figures" / "toughness.png", 10.0, 4.2, 1, 2) as (_, (left, right)):
            left.axhspan(1.0 - LIMIT, 1.0 + LIMIT, color=GREY, alpha=0.2, linewidth=0.0, label="K_Ic ± 10 %")
            for kind in self.plates:
                some, colour = [one for one in results["plates"] if one["kind"] == kind], _COLOURS[kind]
                if not some:
                    continue
                over = np.geomspace(some[0]["over"], some[-1]["over"], 50)
                expected = [PLATES[kind][0](width).expected for width in over]
                left.plot(over, expected, color=colour, linewidth=0.9, label=f"{kind}: crack longer by 0.419 l")
                points = np.array([(one["over"], value) for one in some for value in one["values"]])
                left.plot(*points.T, "o", color=colour, label=f"{kind}: cells")
            for row in [row for row in rows if not row["error"] and row["seed"] == self.seeds[0]]:
                wide = 0.5 + 0.5 * PLATES[row["kind"]][1].index(row["over"])
                share = np.linspace(0.0, 1.0, len(row["curve"]))
                right.plot(share, row["curve"], color=_COLOURS[row["kind"]], linewidth=wide,
                           label=f"{row['kind']}, W = {row['over']:g} l")  # fmt: skip
            right.axhline(1.0, color=INK, linewidth=0.8)
            left.set(xscale="log", xlabel="W / l", ylabel="K / K_Ic at the peak", ylim=(0.8, 1.2))
            ticks = sorted({over for kind in self.plates for over in PLATES[kind][1]})
            plain_ticks(left.xaxis, ticks)
            right.set(xlabel="share of the events", ylabel="K of the notch / K_Ic", ylim=(0.0, 1.4), xlim=(0.0, 1.0))
            left.legend(frameon=False, fontsize=7.5, loc="lower right")
            right.legend(frameon=False, fontsize=7.5, loc="lower center", ncols=2)


def _judged(rows: Sequence[Row]) -> dict[str, Any]:
    values = [row["over_toughness"] for row in rows]
    claim = Claim("toughness", 1.0 - LIMIT, 1.0 + LIMIT, "")
    return {
        **{key: rows[0][key] for key in ("kind", "over", "size", "expected")},
        "values": values, "mean": mean_and_scatter(values),
        **{key: [row[key] for row in rows] for key in ("seed", "count", "events", "end")},
        "verdict": claim.verdict(values),
    }  # fmt: skip
