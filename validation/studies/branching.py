"""Branching of a running crack: notched plates of two glasses, pulled by a traction that is held."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.branching import BranchingRun, NotchedPlate

#: The speed of a crack is to stay below this share of Rayleigh's celerity [-].
LIMIT = 0.6
#: Plates by their name.
PLATES = {
    "A": NotchedPlate(E=32e9, nu=0.2, rho=2450.0, tension=3.08e6, fracture_energy=3.0, stress=1e6, duration=80e-6,
                      slot=1e-3),
    "B30": NotchedPlate(E=72e9, nu=0.22, rho=2440.0, tension=30e6, fracture_energy=3.8, stress=2e6, duration=43e-6,
                        slot=0.5e-3),
    "B40": NotchedPlate(E=72e9, nu=0.22, rho=2440.0, tension=40e6, fracture_energy=3.8, stress=2e6, duration=43e-6,
                        slot=0.5e-3),
}  # fmt: skip
# Cells of B over 2 E G / f_t²: their facets span 1.13 of their size.
_SHARE = 0.87
_COLOURS = (BLUE, ORANGE, GREEN, PURPLE, GREY)


@dataclass(frozen=True)
class Branching(Study):
    """A crack starts from a notch, runs and branches: two plates 100 × 40 mm, notched to their middle.

    A, of many phase-field papers (Borden et al. 2012): E = 32 GPa, ν = 0.2, ρ = 2450 kg/m³, G = 3 J/m², 1 MPa held
    on the long sides, 80 µs. B, soda-lime glass (Ha and Bobaru 2010): E = 72 GPa, ρ = 2440 kg/m³, G = 3.8 J/m², 2
    MPa, 43 µs. Held against: A's crack branches, and stays below 0.6 of Rayleigh's celerity, 1275 m/s, in its
    fastest 10 µs (the distance from the notch of the farthest facet that has broken). That limit, A's traction and
    its duration, and B's speed of about 1580 m/s are from memory of these papers, so that B has no verdict.

    Fixed beforehand: f_t = 3.08 MPa for A, which papers that need one take (from memory), 30 and 40 MPa for B, whose
    strength is not known; 2 mm thick; notches 1 mm (A) and 0.5 mm (B) wide; ν = 0.22 for B; a crack has branched
    where three strips of 2 mm in turn have facets of the crack three cells apart. A with 10 000 cells had been run
    before (`examples/cracks.py`: 763 to 781 m/s along x), and seed 1 once with these rows.

    Attributes:
        cases: plates, of A, B30 and B40 (B with f_t = 30 and 40 MPa).
        counts: cells of A: the first with all seeds, the others with the first one.
        seeds: packings.
    """

    limits: ClassVar = {"cases": words(PLATES), "counts": numbers(least=500), "seeds": numbers(least=0)}

    cases: tuple[str, ...] = ("A", "B30")
    counts: tuple[int, ...] = (10_000, 5_000, 20_000)
    seeds: tuple[int, ...] = (1, 2, 3)

    def stages(self, out: Path) -> Stages:
        requests = []
        for case in self.cases:
            plate = PLATES[case]
            if case == "A":
                requests += [BranchingRun(case, plate, self.counts[0], seed) for seed in self.seeds]
                requests += [BranchingRun(case, plate, count, self.seeds[0]) for count in self.counts[1:]]
            else:
                volume = plate.length * plate.height * plate.thickness
                count = round(volume / (_SHARE * plate.longest) ** 3)
                requests += [BranchingRun(case, plate, count, seed) for seed in self.seeds]
        yield "pull", requests

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each run when and where it starts and branches, its speeds and what is said of them."""
        runs = [_judged(row) for row in rows if not row["error"]]
        return {"limit": LIMIT, "runs": runs}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: of each plate the crack of its first packing and the fronts of all."""
        for case in dict.fromkeys(row["case"] for row in rows):
            some, plate = [row for row in rows if row["case"] == case], PLATES[case]
            path = out / "figures" / f"branching_{case}.png"
            with sheet(path, 9.6, 3.4, 1, 2, width_ratios=(1.55, 1.0)) as (_, (left, right)):
                _draw_crack(left, plate, some[0])
                _draw_fronts(right, plate, some)


def _judged(row: Row) -> dict[str, Any]:
    fast = row["fastest"]
    met = row["branched"] is not None and fast is not None and fast < LIMIT * row["rayleigh"]
    return {
        **{key: found for key, found in row.items() if key not in ("x", "y", "front", "error", "unstable")},
        "over": None if fast is None else fast / row["rayleigh"],
        "verdict": "–" if row["case"] != "A" else "met" if met else "missed",
    }  # fmt: skip


def _draw_crack(ax: Any, plate: NotchedPlate, row: Row) -> None:
    x, y = (1e3 * (np.array(row[axis]) + plate.tip[k]) for k, axis in enumerate("xy"))
    ax.plot(x, y, ".", color=BLUE, markersize=2.0)
    ax.plot([0.0, 1e3 * plate.tip[0]], [1e3 * plate.tip[1]] * 2, color=INK, linewidth=2.5)
    ax.set(xlim=(0.0, 1e3 * plate.length), ylim=(0.0, 1e3 * plate.height), aspect="equal", xlabel="x [mm]",
           ylabel="y [mm]", title=f"crack after {1e6 * plate.duration:g} µs, {row['count']} cells")  # fmt: skip


def _draw_fronts(ax: Any, plate: NotchedPlate, rows: Sequence[Row]) -> None:
    for row, colour in zip(rows, _COLOURS * len(rows), strict=False):
        ax.plot(1e6 * np.array(row["front"]["time"]), 1e3 * np.array(row["front"]["length"]), color=colour,
                label=f"{row['count']} cells, seed {row['seed']}")  # fmt: skip
    limit = LIMIT * plate.rayleigh
    start = min((row["onset"] for row in rows if row["onset"] is not None), default=0.0)
    way = np.array([0.0, 0.5 * plate.length])
    ax.plot(1e6 * (start + way / limit), 1e3 * way, "--", color=INK, label=f"{LIMIT:g} c_R = {limit:.0f} m/s")
    ax.set(xlim=(0.0, 1e6 * plate.duration), ylim=(0.0, 500.0 * plate.length), xlabel="time [µs]",
           ylabel="front along x [mm]", title="front of the crack")  # fmt: skip
    ax.legend(fontsize=7.0, loc="upper left")
