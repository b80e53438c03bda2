"""Expanding rings: mean size of fragments over the rate of strain."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.report.style import BLUE, INK, sheet
from validation.figures.axes import plain_ticks
from validation.frame.files import mean_and_scatter
from validation.frame.limits import numbers
from validation.frame.study import Row, Stages, Study
from validation.rows.ring import Ring, RingRun

#: How far the mean size of the pieces of all packings may be off the formula [-].
LIMIT = 0.1


@dataclass(frozen=True)
class RingStudy(Study):
    """Expanding rings after Zhou, Molinari and Ramesh (2006): the size of fragments falls with the rate of strain.

    Circumference 50 mm, section 0.3 × 0.3 mm, E = 275 GPa, ν = 0.3, ρ = 2750 kg/m³, σ_c = 300 MPa, G = 100 J/m²; held
    against s/s₀ = 4.5 / (1 + 4.5 (ε̇/ε̇₀)^(2/3)), within a tenth. The formula is of a ring without width, so that this
    was fixed: velocities are radial and proportional to the radius; pieces of fewer than four cells are no fragments;
    rates lie between that whose kinetic energy can break the ring (1400 /s) and that whose fragments are as short as
    the section is wide. Two rates had been tried before the limit was set (3000 and 10 000 /s, all pieces counted).

    Attributes:
        rates: of strain [1/s].
        seeds: packings of each.
        size: of cells [m].
        side: of the section [m].
    """

    limits: ClassVar = {
        "rates": numbers(above=0.0), "seeds": numbers(least=0),
        "side": numbers(above=0.0, below=2e-3, advice="a width of up to 2 mm"),
    }  # fmt: skip

    rates: tuple[float, ...] = (2e3, 4e3, 8e3, 16e3)
    seeds: tuple[int, ...] = (1, 2, 3)
    size: float = 0.12e-3
    side: float = Ring.side

    def __post_init__(self) -> None:
        super().__post_init__()
        numbers(above=0.0, below=0.503 * self.side, advice="at most half the section")(self.name, "size", self.size)

    def stages(self, out: Path) -> Stages:
        ring = Ring(side=self.side)
        yield "fly", [RingRun(ring, rate, self.size, seed) for rate in self.rates for seed in self.seeds]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: of each rate the pieces of its packings and their mean size, over the formula's."""
        good = [row for row in rows if not row["error"]]
        groups = [[row for row in good if row["rate"] == rate] for rate in self.rates]
        rates = [_judged(some) for some in groups if some]
        return {"limit": LIMIT, "rates": rates}

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: sizes over rates beside the formula."""
        ring = Ring(side=self.side)
        with sheet(out / "figures" / "ring.png", 6.0, 4.2) as (_, ax):
            rates = np.geomspace(0.03, 1.0, 100) * ring.rate
            ax.plot(rates / ring.rate, [ring.size(rate) / ring.length for rate in rates], color=INK, label="formula")
            ax.plot([row["rate"] / ring.rate for row in rows], [row["over"] for row in rows], "o", color=BLUE,
                    label="packings of cells", alpha=0.7)  # fmt: skip
            ax.axhline(ring.side / ring.length, color=INK, linewidth=0.8, linestyle=":", label="width of the section")
            ax.set(xscale="log", yscale="log", xlabel="rate of strain over ε̇₀", ylabel="mean size of pieces over s₀")
            for axis, marks in ((ax.xaxis, (0.05, 0.1, 0.2, 0.5, 1.0)), (ax.yaxis, (1.0, 1.5, 2.0, 3.0))):
                plain_ticks(axis, marks)
            ax.legend(frameon=False)


def _judged(rows: Sequence[Row]) -> dict[str, Any]:
    over, formula = mean_and_scatter([row["over"] for row in rows]), rows[0]["formula"]
    assert over["mean"] is not None
    ratio, slowed = over["mean"] / formula, float(np.mean([row["slowed"] for row in rows]))
    return {
        "rate": rows[0]["rate"], "over": over, "formula": formula, "ratio": ratio,
        "verdict": "met" if abs(ratio - 1.0) <= LIMIT else "missed",
        "slowed": slowed, "slowed_thin": rows[0]["slowed_thin"],
        "ratio_slowed": over["mean"] * Ring().length / Ring().size(slowed),
        "dissipated": float(np.mean([row["dissipated"] for row in rows])),
        **{key: [row[key] for row in rows] for key in ("seed", "pieces", "count", "residual")},
    }  # fmt: skip
