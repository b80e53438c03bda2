"""Weakest links: mean strength of bars whose strengths scatter after Weibull, over volume, size of cells and m."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREEN, INK, ORANGE, sheet
from validation.figures.axes import plain_ticks
from validation.frame.limits import numbers
from validation.frame.request import Request
from validation.frame.study import Row, Stages, Study
from validation.rows.weibull import Ceramic, WeibullRun, WeibullSpheres

#: How far a mean strength may be off the weakest link's [-].
LIMIT = 0.05
# Cells of the bars [m], volumes in cells of that size, other sizes of cells in the larger one, and G_f [J/m²] of
# bars that soften.
_SIZE, _VOLUMES, _SIZES, _ENERGIES = 3e-3, (250, 1000), (2.4e-3, 3.75e-3), (4e3, 16e3)
# Modulus of bars of which more than volume and modulus varies; spheres, and how far their flaws reach.
_MODULUS, _SPHERES, _REACH = 10.0, (500, 2000), (2.0, 4.0)
_KEYS = ("bonds", "modulus", "energy", "bar", "size", "reach", "count")


@dataclass(frozen=True)
class WeibullStudy(Study):
    """Bars of 6750 and 27 000 mm³ with m = 5, 10 and 20: Γ(1 + 1/m) s₀ (V₀/V)^(1/m) within 5 % on average.

    Fixed before the runs: flaws that set strengths within 6 mm, two cells (`bd.Weibull(correlation=)`); brittle bars
    of cells twice as long as wide, between smooth ends, without inertia; in the larger one also cells of 0.8 and 1.25
    times the size. Beside them, with m = 10: independent strengths; cracks that soften, with process zones
    E G_f / s₀² of 17 and 68 mm, three and eleven times the correlation length; and bonded spheres, whose flaws reach
    two and four bonds. The bars beside take the first half of the seeds. Three packings are taken in turn.

    Attributes:
        moduli: m [-].
        length: correlation length of the strengths [mm].
        seeds: seeds of the strengths.
    """

    limits: ClassVar = {
        "moduli": numbers(above=1.0), "length": numbers(above=0.0), "seeds": numbers(least=0, fewest=2),
    }  # fmt: skip

    moduli: tuple[float, ...] = (5.0, 10.0, 20.0)
    length: float = 6.0
    seeds: tuple[int, ...] = tuple(range(11, 51))

    def stages(self, out: Path) -> Stages:
        reach, one = 1e-3 * self.length, Ceramic(modulus=_MODULUS)
        small, large = (count * _SIZE**3 for count in _VOLUMES)
        bars = [(Ceramic(modulus=m), bar, _SIZE, reach) for m in self.moduli for bar in (small, large)]
        asked: list[Request] = [WeibullRun(*bar, seed) for bar in bars for seed in self.seeds]
        half = self.seeds[: (len(self.seeds) + 1) // 2]
        bars = [(one, large, size, reach) for size in _SIZES]
        bars += [(one, bar, _SIZE, 0.0) for bar in (small, large)]
        bars += [(replace(one, energy=energy), small, _SIZE, reach) for energy in _ENERGIES]
        asked += [WeibullRun(*bar, seed) for bar in bars for seed in half]
        asked += [WeibullSpheres(one, count, far, seed) for far in _REACH for count in _SPHERES for seed in half]
        yield "pull", asked

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: mean strengths of each kind of bar over the weakest link's."""
        kinds: dict[tuple[Any, ...], list[Row]] = {}
        for row in rows:
            if not row["error"]:
                kinds.setdefault(tuple(row[key] for key in _KEYS), []).append(row)
        return {"limit": LIMIT, "bars": [_compared(some) for some in kinds.values() if len(some) > 1]}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: mean strengths of cells over volume, with the weakest link's."""
        cells = [one for one in results["bars"] if one["bonds"] == "cells" and one["energy"] == 0.0]
        with sheet(out / "figures" / "weibull.png", 6.0, 4.2) as (_, ax):
            V = np.geomspace(_VOLUMES[0], _VOLUMES[-1], 50) * _SIZE**3
            for m, colour in zip(sorted({one["modulus"] for one in cells}), (GREEN, BLUE, ORANGE) * 9, strict=False):
                material = Ceramic(modulus=m)
                link = [material.expected(one) for one in V]
                ax.plot(1e9 * V, link, color=colour, label=f"weakest link, m = {m:g}")
                for reach, mark in ((True, "o"), (False, "x")):
                    some = [one for one in cells if one["modulus"] == m and (one["reach"] > 0.0) == reach]
                    ax.errorbar([1e9 * one["bar"] for one in some], [one["mean"] for one in some],
                                [2.0 * one["error"] for one in some], fmt=mark, color=colour if reach else INK,
                                label="" if reach or not some else "independent, m = 10", capsize=2.0)  # fmt: skip
            ax.set(xscale="log", yscale="log", xlabel="volume [mm³]", ylabel="mean strength over s₀")
            for axis, marks in ((ax.xaxis, (7e3, 1e4, 2e4, 3e4)), (ax.yaxis, (0.4, 0.5, 0.6, 0.8, 1.0))):
                plain_ticks(axis, marks)
            ax.legend(frameon=False, fontsize=8.0)


def _compared(rows: Sequence[Row]) -> dict[str, Any]:
    """Mean strength of one kind of bar; what has no weakest link by its nature is shown without a verdict."""
    first = rows[0]
    strength = np.array([row["strength"] for row in rows])
    mean, error = float(strength.mean()), float(strength.std(ddof=1) / np.sqrt(len(strength)))
    asked = Ceramic(modulus=first["modulus"]).expected(first["bar"])
    verdict = "met" if abs(mean / asked - 1.0) <= LIMIT else "missed"
    found = {
        **{key: first[key] for key in _KEYS}, "runs": len(rows), "mean": mean, "error": error,
        "deviation": float(strength.std(ddof=1)), "asked": asked, "ratio": mean / asked, "ratio_error": error / asked,
        "verdict": "shown" if first["energy"] > 0.0 or first["reach"] == 0.0 else verdict,
    }  # fmt: skip
    if first["bonds"] == "cells":
        weakest = np.array([row["weakest"] for row in rows])
        found |= {"weakest": float(weakest.mean()), "over_weakest": float((strength / weakest).mean()),
                  "largest_over_weakest": float((strength / weakest).max())}  # fmt: skip
    return found
