"""The size effect of notched beams: peaks of Grégoire's half-notched beams over their depth."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem._types import Floats
from bondem.report.style import BLUE, GREY, INK, ORANGE, sheet
from validation.cases.case import CURVES
from validation.cases.gregoire import GREGOIRE, beam, scaled
from validation.figures.axes import plain_ticks
from validation.frame.limits import numbers
from validation.frame.study import Row, Stages, Study
from validation.measures.cohesive_crack import cohesive_crack
from validation.measures.size_effect import SizeEffect
from validation.rows.fracture import FractureRun

# Depths of the continuum's beams [m].
_DEPTHS = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6)


@dataclass(frozen=True)
class SizeEffectStudy(Study):
    """Peaks of Grégoire's half-notched beams of several depths, beside a continuum and Bažant's law.

    Cracks soften along Petersson's two lines, in cells and in the continuum with one cohesive crack. The law is
    fitted to the peaks of the cells.

    Attributes:
        depths: of beams [mm].
        seeds: packings of each.
        finer: how many times smaller cells are than the case has them, 0.046 D.
    """

    limits: ClassVar = {
        "depths": numbers(least=10.0, most=2000.0, fewest=2), "seeds": numbers(least=0),
        "finer": numbers(above=0.0, most=10.0),
    }  # fmt: skip

    depths: tuple[float, ...] = (50.0, 100.0, 200.0)
    seeds: tuple[int, ...] = (1,)
    finer: float = 1.0

    def stages(self, out: Path) -> Stages:
        yield "break", [FractureRun(scaled(1e-3 * depth), seed, self.finer)
                        for depth in self.depths for seed in self.seeds]  # fmt: skip

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: peaks, those of the continuum, and the law."""
        good = [row for row in rows if not row["error"]]
        depth = np.array([1e-3 * float(row["case"].rpartition("_")[2]) for row in good])
        peak = np.array([row["peak"] for row in good])
        continuum = {each: _continuum(each) for each in sorted({*_DEPTHS, *depth.tolist()})}
        found: dict[str, Any] = {
            "continuum": {"depth": list(continuum), "peak": list(continuum.values())},
            "beams": [
                {"depth": one, "seed": row["seed"], "count": row["count"], "peak": row["peak"],
                 "over_continuum": row["peak"] / continuum[one]}
                for one, row in zip(depth.tolist(), good, strict=True)
            ],
            "law": None,
        }  # fmt: skip
        if len(set(depth.tolist())) > 1:
            law = SizeEffect.fitted(depth, _nominal(depth, peak))
            over = _nominal(depth, peak) / law.nominal(depth)
            found["law"] = {"strength": law.strength, "transition": law.transition, "over": over.tolist()}
        return found

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`: nominal strength over depth."""
        depth, peak = (np.array(results["continuum"][key]) for key in ("depth", "peak"))
        fine = np.geomspace(depth[0], depth[-1], 60)
        with sheet(out / "figures" / "size_effect.png", 6.0, 4.4) as (_, ax):
            ax.plot(1e3 * depth, 1e-6 * _nominal(depth, peak), "-", color=INK, label="continuum, cohesive crack")
            beams = np.array([[one["depth"], one["peak"]] for one in results["beams"]]).reshape(-1, 2).T
            ax.plot(1e3 * beams[0], 1e-6 * _nominal(*beams), "o", color=BLUE, label="cells, load factors")
            if law := results["law"]:
                line = SizeEffect(law["strength"], law["transition"]).nominal(fine)
                ax.plot(1e3 * fine, 1e-6 * line, "--", color=ORANGE, label="Bažant's law, fitted to the cells")
            known = 1e-6 * _nominal(np.full(2, 0.05), np.array([GREGOIRE.claim.low, GREGOIRE.claim.high]))
            ax.errorbar([50.0], [known.mean()], [0.5 * np.ptp(known)], color=GREY, fmt="s", capsize=3.0,
                        label="measured, D = 50 mm")  # fmt: skip
            ax.set(xscale="log", yscale="log", xlabel="depth D [mm]", ylabel="nominal strength 3 P S / 2 b D² [MPa]")
            plain_ticks(ax.xaxis, (1e3 * depth).tolist())
            plain_ticks(ax.yaxis, (0.6, 0.8, 1.0, 1.5, 2.0))
            ax.legend(frameon=False, fontsize=8.0)


def _continuum(depth: float) -> float:
    """Peak of a continuum with a cohesive crack [N]."""
    return cohesive_crack(scaled(depth), beam(depth), CURVES["bilinear"]).peak


def _nominal(depth: Floats, peak: Floats) -> Floats:
    """3 P S / 2 b D² [Pa], with S = 2.5 D."""
    return 1.5 * peak * 2.5 / (0.05 * depth)
