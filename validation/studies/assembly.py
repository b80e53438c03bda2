"""E and ν over the number of elements, law and specimen fixed (André et al. 2012, §5.4)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.interactions.law_catalogue import DEFAULT
from bondem.packing.sizes import SPREAD
from validation.figures.assembly import draw_assembly, draw_fineness, draw_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.frame.tables import summary
from validation.measures.limit import Limit, limit
from validation.rows.elastic import MEASURED, ElasticRequest
from validation.rows.packings import TARGETS, PackingRequest, kept_lattice

#: 12 sizes in equal ratios.
COUNTS = (500, 700, 1000, 1400, 2000, 2800, 4000, 5600, 8000, 11_000, 15_000, 20_000)

#: The paper's fused silica, Table 2.
LAW = DEFAULT(E=265e9, nu=0.3, radius_ratio=0.71)

#: What is in print of the scatter of E and ν: of the paper's beams over 7500 elements, and what it quotes of Hentz
#: for the springs of Liao and for his own criterion.
IN_PRINT = {"beams, the paper": (0.07, 0.05), "springs, Hentz": (0.12, 0.10), "springs, Liao": (0.28, 0.16)}

# "For a number of discrete element over 7 500".
_LARGE = 7500

# Below, walls and edges are no longer apart.
_ASYMPTOTIC = 1000

_CELL_COUNT = 10_000

#: The affine fit, and the paper's eqs (14) and (15).
QUANTITIES = ("E", "nu", "E_paper", "nu_paper")


@dataclass(frozen=True)
class Assembly(Study):
    """E and ν over the number of elements: figures 17 and 18 of André et al. (2012).

    Attributes:
        counts: numbers of elements.
        packings: of each, seeds 1 … packings.
        cells: periodic cells of up to 10 000 elements, seeds 1 … cells, to hold the limits against.
        targets: of `PackingRequest`: "contacts", "jamming" or both.
        spread: κ [-].
    """

    limits: ClassVar = {
        "counts": numbers(least=300), "packings": numbers(least=2, advice="at least 2: one has no scatter"),
        "cells": numbers(least=0), "targets": words(TARGETS),
    }  # fmt: skip

    counts: tuple[int, ...] = COUNTS
    packings: int = 4
    cells: int = 3
    targets: tuple[str, ...] = ("contacts",)
    spread: float = SPREAD

    def stages(self, out: Path) -> Stages:
        large = min(_CELL_COUNT, max(self.counts))
        packings = [
            PackingRequest(count, self.spread, "quench", target, seed, form == "cube", form)
            for target in self.targets
            for form, counts, last in (("bar", sorted(self.counts), self.packings), ("cube", [large], self.cells))
            for count in counts
            for seed in range(1, last + 1)
        ]
        yield "pack", packings
        yield "solve", [ElasticRequest(one, LAW) for one in packings]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: means, scatter and limits at each target."""
        good = [row for row in rows if not row["error"]]
        return {
            "law": {"name": DEFAULT.__name__, "E_mu": LAW.E, "nu_mu": LAW.nu, "radius_ratio": LAW.radius_ratio},
            "in_print": {name: {"E": E, "nu": nu} for name, (E, nu) in IN_PRINT.items()},
            "targets": {target: _found(_of_bars(good, target)) for target in self.targets},
            "summary": summary(rows, ("target", "periodic", "count"), MEASURED),
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 17 and 18, and the scatter."""
        figures = out / "figures"
        limits = {target: _limits(_of_bars(rows, target)) for target in self.targets}
        draw_assembly(figures / "assembly.png", rows, limits)
        first = self.targets[0]
        scatter = {target: found["scatter"] for target, found in results["targets"].items()}
        draw_scatter(figures / "scatter.png", _of_bars(rows, first), scatter, IN_PRINT)
        # The first packing of four sizes, as far apart as there are.
        there = sorted({row["count"] for row in rows if not row["periodic"]})
        shown = sorted({there[round(k * (len(there) - 1) / 3)] for k in range(4)})
        requests = [PackingRequest(n, self.spread, "quench", first, 1, False, "bar") for n in shown]
        lattices = [kept_lattice(one, out) for one in requests if one.whole(out)]
        draw_fineness(figures / "fineness.png", lattices)


def _of_bars(rows: Sequence[Row], target: str) -> list[Row]:
    return [row for row in rows if row["target"] == target and not row["periodic"]]


def _found(bars: Sequence[Row]) -> dict[str, Any]:
    fits = _limits(bars)
    return {
        "scatter": {name: _scatter(bars, name) for name in QUANTITIES},
        "limits": {name: fit and fit.as_dict() for name, fit in fits.items()},
    }


def _limits(bars: Sequence[Row]) -> dict[str, Limit | None]:
    used = [row for row in bars if row["count"] >= _ASYMPTOTIC]
    count = np.array([row["count"] for row in used], dtype=float)
    return {name: limit(count, np.array([row[name] for row in used], dtype=float)) for name in QUANTITIES}


def _scatter(bars: Sequence[Row], name: str) -> dict[str, float | None]:
    """How much packings of one size differ, and all of more than 7500 elements, relative to their mean [-].

    Returns:
        "c", "c_error": of sd = c / √N, from packings of the same size, at all sizes; "exponent", "exponent_error": of
        N in sd, which should be -1/2; "large": how many packings have more than 7500 elements; "std" and
        "peak_to_peak" of these, whatever their size; "within": sd of those about the mean of their size.
    """
    sizes = sorted({row["count"] for row in bars})
    groups = [np.array([row[name] for row in bars if row["count"] == size], dtype=float) for size in sizes]
    pairs = [(size, group) for size, group in zip(sizes, groups, strict=True) if len(group) > 1]
    found: dict[str, float | None] = dict.fromkeys(
        ("c", "c_error", "exponent", "exponent_error", "large", "std", "peak_to_peak", "within")
    )
    if not pairs:
        return found
    N = np.array([size for size, _ in pairs], dtype=float)
    dof = np.array([len(group) - 1 for _, group in pairs], dtype=float)
    sd = np.array([group.std(ddof=1) / abs(group.mean()) for _, group in pairs])
    c = float(np.sqrt((dof * N * sd**2).sum() / dof.sum()))
    found |= {"c": c, "c_error": c / float(np.sqrt(2.0 * dof.sum()))}
    if len(pairs) > 2:
        # ln s of a normal sample has variance 1 / (2 dof), nearly.
        (slope, _), covariance = np.polyfit(np.log(N), np.log(sd), 1, w=np.sqrt(2.0 * dof), cov="unscaled")
        found |= {"exponent": float(slope), "exponent_error": float(np.sqrt(covariance[0, 0]))}
    large = [(size, group) for size, group in pairs if size > _LARGE]
    if large:
        values = np.concatenate([group for _, group in large])
        own = np.concatenate([group / group.mean() - 1.0 for _, group in large])
        found |= {
            "large": len(values),
            "std": float(values.std(ddof=1) / abs(values.mean())),
            "peak_to_peak": float(np.ptp(values) / abs(values.mean())),
            "within": float(np.sqrt((own**2).sum() / (len(own) - len(large)))),
        }
    return found
