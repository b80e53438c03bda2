"""Published fracture tests with beam bonds in place of cells: the same inputs, calibrated, side by side."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, sheet
from validation.cases.gregoire import GREGOIRE
from validation.cases.l_panel import L_PANEL
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.beam_bonds import SlowBeamsRun, StruckBeamsRun
from validation.rows.kalthoff import Plate
from validation.studies.kalthoff import draw_cracks

#: Slow cases: the way of the driven line at the expected peak, and at the latest end of the run [m].
SLOW = {"l_panel": (L_PANEL, 0.2e-3, 1e-3), "gregoire": (GREGOIRE, 0.03e-3, 0.15e-3)}
#: Angle of the crack of Kalthoff's plate [degrees], within what, and strengths of the material [Pa].
ANGLE, LIMIT, STRENGTHS = 70.0, 5.0, (844e6, 1900e6)
CASES = (*SLOW, "kalthoff")
_COLOURS = (BLUE, ORANGE, GREEN, GREY)


@dataclass(frozen=True)
class BeamBondsStudy(Study):
    """Winkler's L-shaped panel, Grégoire's beam and Kalthoff's plate, of spheres with brittle Euler–Bernoulli bonds.

    E, ν, ρ and f_t are those of the cells' scorecard. E and ν are calibrated and f_t is set by direct tension, both
    on a bar of its own (`validation/cases/beam_bonds.py`). Brittle beams have no fracture energy: what their size
    implies is told beside the published one. Slow tests are explicit and damped, as `bd.solve_quasistatic` takes
    cells only.

    Fixed beforehand: 1000 spheres for the slow cases, about as many as cells had, and 8000 for the plate; rollers and
    loads hold a row of spheres along y; no bond breaks near them, as in the cases; 400 traverses of sound along the
    longest edge until 0.2 mm (panel) and 0.03 mm (beam), seed 1 of each also four times as slow. Seed 1 of the slow
    cases and of the plate of 844 MPa had been run once before, at 100 traverses: 8.79 kN, 1.28 kN, 44°.

    Attributes:
        cases: of l_panel, gregoire and kalthoff.
        seeds: packings.
        count: spheres of the slow cases.
        struck: spheres of the plate.
    """

    limits: ClassVar = {
        "cases": words(CASES), "seeds": numbers(least=0), "count": numbers(least=300), "struck": numbers(least=300),
    }  # fmt: skip

    cases: tuple[str, ...] = CASES
    seeds: tuple[int, ...] = (1, 2, 3)
    count: int = 1000
    struck: int = 8000

    def stages(self, out: Path) -> Stages:
        requests: list[SlowBeamsRun | StruckBeamsRun] = []
        for name in self.cases:
            if name in SLOW:
                case, way, reach = SLOW[name]
                requests += [SlowBeamsRun(case, way, reach, seed, self.count) for seed in self.seeds]
                usual = requests[-1]
                assert isinstance(usual, SlowBeamsRun)
                slower = 4.0 * usual.traverses
                requests.append(SlowBeamsRun(case, way, reach, self.seeds[0], self.count, slower))
            else:
                requests += [
                    StruckBeamsRun(Plate(), strength, seed, self.struck)
                    for strength in STRENGTHS for seed in self.seeds
                ]  # fmt: skip
        yield "break", requests

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each case its claim, what its packings gave, the verdict, and what bonds imply."""
        good = [row for row in rows if not row["error"]]
        cases = [_slow(name, some) for name in self.cases if name in SLOW if (some := _of(good, name))]
        if "kalthoff" in self.cases:
            groups = [[row for row in _of(good, "kalthoff") if row["strength"] == one] for one in STRENGTHS]
            cases += [_struck(some) for some in groups if some]
        return {"cases": cases}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: load curves and broken bonds of the slow cases, cracks of the plates."""
        for name in self.cases:
            some = _of(rows, name)
            if not some:
                continue
            path = out / "figures" / f"beams_{name}.png"
            with sheet(path, 9.6, 4.2, 1, 2) as (_, (left, right)):
                if name in SLOW:
                    _draw_curves(left, name, some)
                    _draw_broken(right, some[0], SLOW[name][0].shape.bounds, "broken bonds, seed 1")
                else:
                    for ax, strength in zip((left, right), STRENGTHS, strict=True):
                        struck = [row for row in some if row["strength"] == strength]
                        draw_cracks(ax, struck, ANGLE, f"f_t = {1e-6 * strength:g} MPa, broken bonds after 90 µs")


def _of(rows: Sequence[Row], name: str) -> list[Row]:
    return [row for row in rows if row["case"] == name]


def _bonds(row: Row) -> dict[str, Any]:
    """What bonds are and imply."""
    kept = ("E_mu", "radius_ratio", "density", "bond_tension", "factor", "tension", "length", "toughness")
    return {key: row[key] for key in kept} | {
        "energy": row["implied_energy"], "given_energy": row["given_energy"],
        "given_toughness": sqrt(row["E"] * row["given_energy"]),
    }  # fmt: skip


def _lists(rows: Sequence[Row]) -> dict[str, Any]:
    return {key: [row[key] for row in rows] for key in ("seed", "count", "broken", "residual")}


def _slow(name: str, rows: Sequence[Row]) -> dict[str, Any]:
    case, least = SLOW[name][0], min(row["traverses"] for row in rows)
    usual, slower = ([row for row in rows if (row["traverses"] == least) is same] for same in (True, False))
    values = [row["peak"] for row in usual]
    claim = case.claim
    return {
        "name": name, "title": case.title, "quantity": "peak", "words": claim.words, "low": claim.low,
        "high": claim.high, "values": values, "mean": mean_and_scatter(values), "verdict": claim.verdict(values),
        "slower": [row["peak"] for row in slower], "runs": _lists(usual), "strength": case.tension,
        **_bonds(usual[0]),
    }  # fmt: skip


def _struck(rows: Sequence[Row]) -> dict[str, Any]:
    angles = [row["angle"] for row in rows]
    known = [one for one in angles if one is not None]
    inside = [one is not None and abs(one - ANGLE) <= LIMIT for one in angles]
    together = len(known) == len(angles) and abs(float(np.mean(known)) - ANGLE) <= LIMIT
    strength = rows[0]["strength"]
    return {
        "name": "kalthoff", "title": f"Kalthoff and Winkler, f_t = {1e-6 * strength:g} MPa", "quantity": "angle",
        "words": f"{ANGLE:g} ± {LIMIT:g}°", "low": ANGLE - LIMIT, "high": ANGLE + LIMIT, "values": angles,
        "mean": mean_and_scatter(known) if known else None,
        "verdict": "met" if all(inside) else "met by the mean" if together else "missed",
        "runs": _lists(rows), "strength": strength, **_bonds(rows[0]),
    }  # fmt: skip


def _draw_curves(ax: Any, name: str, rows: Sequence[Row]) -> None:
    case = SLOW[name][0]
    for row, colour in zip(rows, _COLOURS * len(rows), strict=False):
        said = f"seed {row['seed']}, {row['traverses']:g} traverses"
        ax.plot(1e3 * np.array(row["curve"]["displacement"]), 1e-3 * np.array(row["curve"]["load"]), color=colour,
                linewidth=1.0, label=said)  # fmt: skip
    if case.curve:
        x, y = np.array(case.curve).T
        ax.plot(1e3 * x, 1e-3 * y, "o--", color=INK, markersize=3.5, label="published")
    ax.axhspan(1e-3 * case.claim.low, 1e-3 * case.claim.high, color=GREY, alpha=0.2, linewidth=0.0)
    longest = max(max(row["curve"]["displacement"]) for row in rows)
    ax.set(xlim=(0.0, 1.05e3 * max(longest, 0.5 * case.curve[-1][0] if case.curve else 0.0)),
           xlabel="displacement [mm]", ylabel="load [kN]", title=case.title)  # fmt: skip
    ax.set_ylim(bottom=0.0)
    ax.legend(fontsize=7.5)


def _draw_broken(ax: Any, row: Row, bounds: Any, title: str) -> None:
    lower, upper = (1e3 * np.asarray(one) for one in bounds)
    ax.plot(1e3 * np.array(row["x"]), 1e3 * np.array(row["y"]), ".", color=BLUE, markersize=4.0)
    ax.set(xlim=(lower[0], upper[0]), ylim=(lower[1], upper[1]), aspect="equal", xlabel="x [mm]", ylabel="y [mm]",
           title=title)  # fmt: skip
