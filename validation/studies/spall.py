"""Spalling of a granite bar: where it breaks, and what its free end does."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, sheet
from validation.frame.limits import numbers
from validation.frame.study import Row, Stages, Study
from validation.rows.spall import Bar, SpallRun

#: Published: place of the spall from the free end and how well it is known [m], velocities of the free end [m/s].
PLACE, WITHIN, HIGHEST, PULL_BACK = 57e-3, 10e-3, 7.75, 3.5
_COLOURS = (BLUE, GREEN, PURPLE, GREY, ORANGE)
# Share of a section that is broken where a bar counts as broken.
_MUCH = 0.1


@dataclass(frozen=True)
class Spall(Study):
    """A granite bar, Ø45 × 140 mm, struck at one end, spalls near the other: place, and velocities of that end.

    E = 43.6 GPa, ν = 0.15, ρ = 2660 kg/m³; a pressure on one end that rises to 41.5 MPa in 35 µs and is gone after 55
    µs. Published (a second-hand document, whose section is assumed): a spall 57 ± 10 mm from the free end, whose
    velocity reaches 7.75 m/s and falls by 3.5 m/s; a strength of 8 MPa in static tests, 18.9 MPa at these rates. Both
    are run, and none has a verdict, as G_f is not known and cells know no rate.

    Fixed beforehand: G_f = 50 J/m² (K_Ic = 1.5 MPa√m of other granites), varied to 100 J/m² on the first packing;
    straight softening; smooth ends; 130 µs; the pull-back ends where the end has gained 0.3 m/s again.

    Attributes:
        strengths: f_t [MPa].
        energies: G_f [J/m²]: the first with all packings, the others with the first one.
        seeds: packings.
        sizes: of cells [mm]: the first with all packings, the others with the first one.
    """

    limits: ClassVar = {
        "strengths": numbers(above=0.0), "energies": numbers(above=0.0), "seeds": numbers(least=0),
        "sizes": numbers(above=0.0),
    }  # fmt: skip

    strengths: tuple[float, ...] = (8.0, 18.9)
    energies: tuple[float, ...] = (50.0, 100.0)
    seeds: tuple[int, ...] = (1, 2, 3)
    sizes: tuple[float, ...] = (3.0, 2.0)

    def stages(self, out: Path) -> Stages:
        usual = [(self.energies[0], self.sizes[0], seed) for seed in self.seeds]
        energies = [(energy, self.sizes[0], self.seeds[0]) for energy in self.energies[1:]]
        sizes = [(self.energies[0], size, self.seeds[0]) for size in self.sizes[1:]]
        yield "strike", [
            SpallRun(Bar(), 1e6 * strength, energy, 1e-3 * size, seed)
            for strength in self.strengths for energy, size, seed in (*usual, *energies, *sizes)
        ]  # fmt: skip

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each run velocities and pieces, and what a thin elastic bar would do."""
        bar = Bar()
        runs = [
            {key: row[key] for key in (
                "tension", "fracture_energy", "size", "count", "seed", "highest", "pull_back", "lengths", "first",
                "residual",
            )} | {
                "broken": _broken(row), "thin": bar.thin.place(row["tension"]),
                "thin_pull_back": bar.thin.pull_back(row["tension"]),
            }
            for row in rows if not row["error"]
        ]  # fmt: skip
        return {"place": PLACE, "within": WITHIN, "highest": HIGHEST, "pull_back": PULL_BACK,
                "thin_highest": bar.thin.velocity, "runs": runs}  # fmt: skip

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: velocity of the free end, and how much of each section is broken."""
        bar, strengths = Bar(), list(dict.fromkeys(row["tension"] for row in rows))
        with sheet(out / "figures" / "spall.png", 9.6, 3.2 * len(strengths), len(strengths), 2, squeeze=False) as (
            _, boxes,
        ):  # fmt: skip
            for (left, right), tension in zip(boxes, strengths, strict=True):
                some = [row for row in rows if row["tension"] == tension]
                for row, colour in zip(some, _COLOURS * len(some), strict=False):
                    said = f"G_f {row['fracture_energy']:g} J/m², {row['count']} cells, seed {row['seed']}"
                    time = 1e6 * np.array(row["curve"]["time"])
                    left.plot(time, row["curve"]["velocity"], color=colour, label=said)
                    edges = np.linspace(0.0, 1e3 * bar.length, len(row["profile"]) + 1)
                    right.stairs(row["profile"], edges, color=colour)
                left.axhline(HIGHEST, color=INK, linestyle=":", linewidth=1.0)
                left.axhline(HIGHEST - PULL_BACK, color=INK, linestyle=":", linewidth=1.0)
                left.set(xlim=(30.0, 130.0), xlabel="time [µs]", ylabel="velocity of the free end [m/s]",
                         title=f"f_t = {1e-6 * tension:g} MPa; dotted: published")  # fmt: skip
                left.legend(fontsize=7.0, loc="lower right")
                right.axvspan(1e3 * (PLACE - WITHIN), 1e3 * (PLACE + WITHIN), color=GREY, alpha=0.3, linewidth=0.0)
                right.axvline(1e3 * bar.thin.place(tension), color=INK, linestyle="--", linewidth=1.0)
                right.set(xlim=(0.0, 1e3 * bar.length), xlabel="from the free end [mm]",
                          ylabel="broken area / section, a 3 mm bin [-]",
                          title="band: published, dashed: thin elastic bar")  # fmt: skip


def _broken(row: Row) -> list[float] | None:
    """From where to where more than a tenth of the section is broken in a bin of its profile [m]."""
    bins = np.flatnonzero(np.array(row["profile"]) > _MUCH)
    wide = Bar().length / len(row["profile"])
    return [float(bins[0] * wide), float((bins[-1] + 1) * wide)] if bins.size else None
