"""Lac du Bonnet granite: four published strengths from one input."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from validation.cases.lac_du_bonnet import CLAIMS, Granite, bent, toughness
from validation.figures.fracture import envelope
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.request import Request
from validation.frame.study import Row, Stages, Study
from validation.rows.fracture import FractureRun
from validation.rows.granite import GraniteRun

#: Depths W of the notched beams [m]: that which is held against K_Ic, and one in which the crack is small.
DEPTHS = (0.05, 0.2)
_STRENGTHS = ("ucs", "direct_tension", "brazilian")
_TITLES = {"ucs": "Uniaxial compression", "direct_tension": "Direct tension", "brazilian": "Brazilian test"}
_COLOURS = (BLUE, ORANGE, GREEN, PURPLE, GREY)
# By this share a disc that splits bears less at once.
_FALL = 0.2


@dataclass(frozen=True)
class GraniteStudy(Study):
    """Lac du Bonnet granite from one input: UCS, direct tension, Brazilian strength and K_Ic, nothing calibrated.

    What is put in, what is published and what was fixed beforehand stands in `validation/cases/lac_du_bonnet.py`. The
    rows were tried once, with that input, on seed 1 and coarse cells: 500 gave 207.2, 6.89 and 7.14 MPa, a beam of
    249 cells 1.19 MPa√m. Nothing was changed after it. The load at which a disc splits was added when the curves of
    the four discs had been seen, as their halves bear more after it; it has no verdict.

    Attributes:
        tests: of ucs, direct_tension, brazilian and toughness.
        counts: cells of cores and discs: the first with all seeds, the others with the first one.
        seeds: packings.
        finer: how many times smaller cells of the second size of notched beams are.
    """

    limits: ClassVar = {
        "tests": words(CLAIMS), "counts": numbers(least=100), "seeds": numbers(least=0), "finer": numbers(above=0.0),
    }  # fmt: skip

    tests: tuple[str, ...] = tuple(CLAIMS)
    counts: tuple[int, ...] = (2_000, 6_000)
    seeds: tuple[int, ...] = (1, 2, 3)
    finer: float = 1.4

    def stages(self, out: Path) -> Stages:
        granite, first = Granite(), self.seeds[0]
        requests: list[Request] = []
        for test in (one for one in _STRENGTHS if one in self.tests):
            requests += [GraniteRun(granite, test, self.counts[0], seed) for seed in self.seeds]
            requests += [GraniteRun(granite, test, count, first) for count in self.counts[1:]]
        if "toughness" in self.tests:
            usual, large = (bent(granite, depth) for depth in DEPTHS)
            requests += [FractureRun(usual, seed, curve="straight") for seed in self.seeds]
            requests += [FractureRun(usual, first, self.finer, "straight")]
            requests += [FractureRun(large, first, curve="straight")]
        yield "test", requests

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each test and size what was measured, and the verdict."""
        good, granite = [row for row in rows if not row["error"]], Granite()
        put_in = {"ucs": granite.compressive, "direct_tension": granite.tension, "brazilian": granite.tension}
        groups = [
            (test, [row for row in good if row.get("test") == test and row["count"] == count], put_in[test])
            for test in _STRENGTHS for count in self.counts
        ]  # fmt: skip
        cases = [_judged(test, some, value, strengths(test, some)) for test, some, value in groups if some]
        for depth in DEPTHS:
            beams = [row for row in good if row.get("case") == bent(granite, depth).name]
            for finer in sorted({row["finer"] for row in beams}):
                some = [row for row in beams if row["finer"] == finer]
                found = [toughness(row["peak"], depth) for row in some]
                cases.append(_judged("toughness", some, granite.toughness, found) | {"depth": depth})
                if depth != DEPTHS[0]:
                    cases[-1]["verdict"] = "–"
        return {"mohr_coulomb": granite.compressive, "toughness": granite.toughness, "cases": cases}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: curves of all tests."""
        with sheet(out / "figures" / "granite.png", 9.6, 6.8, 2, 2) as (_, boxes):
            for ax, test in zip(boxes.flat, _STRENGTHS, strict=False):
                _draw_strength(ax, test, [row for row in rows if row.get("test") == test])
            _draw_beams(boxes[1, 1], rows)


def _judged(test: str, rows: Sequence[Row], put_in: float, values: list[float]) -> dict[str, Any]:
    claim, mean = CLAIMS[test], mean_and_scatter(values)
    assert mean["mean"] is not None
    return {
        "test": test, "quantity": claim.quantity, "low": claim.low, "high": claim.high, "words": claim.words,
        "values": values, "mean": mean, "over": mean["mean"] / put_in, "verdict": claim.verdict(values),
        "seeds": [row["seed"] for row in rows], "count": rows[0]["count"],
        "later": [row["peak"] for row in rows] if test == "brazilian" else [],
        **{key: [row.get(key) for row in rows] for key in (
            "residual", "asymmetry", "cracked", "broken", "slipped", "events",
        )},
    }  # fmt: skip


def strengths(test: str, rows: Sequence[Row]) -> list[float]:
    """Peaks [Pa]; of discs the load that splits them, as halves that stay between the platens take more later."""
    return [first_peak(row["curve"]["stress"]) if test == "brazilian" else row["peak"] for row in rows]


def first_peak(stress: Sequence[float]) -> float:
    """Largest stress before it first falls by a fifth [Pa]: it splits a disc, whose halves may bear more later."""
    most = np.maximum.accumulate(np.array(stress))
    fallen = np.flatnonzero(np.array(stress) < (1.0 - _FALL) * most)
    return float(most[fallen[0]] if fallen.size else most[-1])


def _draw_strength(ax: Any, test: str, rows: Sequence[Row]) -> None:
    claim = CLAIMS[test]
    ax.axhspan(1e-6 * claim.low, 1e-6 * claim.high, color=GREY, alpha=0.3, linewidth=0.0)
    for row, colour in zip(rows, _COLOURS * len(rows), strict=False):
        ax.plot(1e3 * np.array(row["curve"]["strain"]), 1e-6 * np.array(row["curve"]["stress"]), color=colour,
                linewidth=1.2, label=f"{row['count']} cells, seed {row['seed']}")  # fmt: skip
    along = "approach of the flats over D [‰]" if test == "brazilian" else "strain [‰]"
    ax.set(xlabel=along, ylabel="stress [MPa]", title=_TITLES[test], xlim=(0.0, None), ylim=(0.0, None))
    if rows:
        ax.legend(fontsize=7.0)


def _draw_beams(ax: Any, rows: Sequence[Row]) -> None:
    """K of the load by the formula of a sharp crack, over the opening of the mouth."""
    claim, granite = CLAIMS["toughness"], Granite()
    ax.axhspan(1e-6 * claim.low, 1e-6 * claim.high, color=GREY, alpha=0.3, linewidth=0.0)
    ax.axhline(1e-6 * granite.toughness, color=INK, linewidth=0.8, linestyle=":", label="√(E G_f)")
    colours = iter(_COLOURS * len(rows))
    for depth in DEPTHS:
        for row in (row for row in rows if row.get("case") == bent(granite, depth).name):
            K = 1e-6 * np.array([toughness(load, depth) for load in row["curve"]["load"]])
            at, most = envelope(1e6 * np.array(row["curve"]["CMOD"]), K)
            ax.plot(at, most, color=next(colours), linewidth=1.2,
                    label=f"W = {1e3 * depth:g} mm, {row['count']} cells, seed {row['seed']}")  # fmt: skip
    ax.set(xlabel="opening of the mouth [µm]", ylabel="K of the load [MPa√m]", title="Notched beams",
           xlim=(0.0, 60.0), ylim=(0.0, 2.7))  # fmt: skip
    ax.legend(fontsize=7.0)
