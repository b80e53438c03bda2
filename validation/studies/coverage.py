"""Whether intervals keep their word: calibrate on some packings, test on others."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.calibration.elastic import Calibration, calibrate
from bondem.calibration.uncertainty import Sample, half_width
from bondem.interactions.beams.bond_law import BondLaw
from bondem.packing.sizes import SPREAD
from bondem.specimen.materials import fused_silica
from validation.figures.coverage import draw_coverage
from validation.frame.failures import complain
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.rows.elastic import ElasticRequest, cells_and_bars
from validation.rows.packings import PackingRequest, kept_lattice

#: Probability of the intervals [-].
LEVEL = 0.95

# Random calibrations, drawn from all packings, of each number of packings.
_DRAWS = 4000
_SIZES = (2, 3, 4, 6, 8, 12, 16)


@dataclass(frozen=True)
class Coverage(Study):
    """Whether the intervals of a calibration hold unseen packings as often as they say.

    Attributes:
        count: elements of a packing.
        calibrating: packings that calibrate, seeds 1 … calibrating.
        held_out: unseen packings, the next seeds.
        shape: "cylinder", the paper's 10 x 40 mm, or "cell", periodic.
    """

    limits: ClassVar = {
        "calibrating": numbers(least=2), "held_out": numbers(least=1), "shape": words(("cylinder", "cell")),
    }  # fmt: skip

    count: int = 10_000
    calibrating: int = 8
    held_out: int = 40
    shape: str = "cylinder"

    @property
    def bodies(self) -> list[PackingRequest]:
        """All packings, those that calibrate first."""
        number = self.calibrating + self.held_out
        cells, bars = (number, 0) if self.shape == "cell" else (0, number)
        return cells_and_bars(self.count, SPREAD, cells=cells, bars=bars)

    def stages(self, out: Path) -> Stages:
        """See `Study`; the bonds are calibrated between the two."""
        complain((yield "pack", self.bodies), out)
        law = _calibrated(tuple(self.bodies[: self.calibrating]), out).law
        complain((yield "test", [ElasticRequest(one, law, slopes=True) for one in self.bodies]), out, what="tests")

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        return _results(self, _calibrated(tuple(self.bodies[: self.calibrating]), out), rows)

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Packings in and out of the intervals, and how often over random calibrations."""
        draw_coverage(out / "figures" / "coverage.png", dict(results))


@lru_cache(maxsize=1)
def _calibrated(packings: tuple[PackingRequest, ...], out: Path) -> Calibration:
    return calibrate([kept_lattice(one, out) for one in packings], fused_silica)


def _results(study: Coverage, fit: Calibration, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    quantities: dict[str, Any] = {}
    for name in ("E", "nu"):
        values = np.array([row[name] for row in rows])
        known, unseen = values[: study.calibrating], values[study.calibrating :]
        low, high = Sample(known).interval(kind="prediction", level=LEVEL)
        quantities[name] = {
            "values": values,
            "prediction": (low, high),
            "confidence": Sample(known).interval(level=LEVEL),
            "covered": int(((low <= unseen) & (unseen <= high)).sum()),
            "coverage": _coverage(study, name, rows, fit.law),
        }
    return {
        "level": LEVEL,
        "E_mu": fit.law.E,
        "value": fit.value,
        "quantities": quantities,
    }


def _coverage(study: Coverage, name: str, rows: Sequence[dict[str, Any]], law: BondLaw) -> dict[str, Any]:
    """Mean share of unseen packings in the interval, over calibrations on random packings of all.

    A calibration on other packings has other bonds. What each packing does with them follows to first order from
    its slopes; the shift is a hundredth of r̃, so that the second order does not count.
    """
    E, nu = (np.array([row[key] for row in rows]) for key in ("E", "nu"))
    assert law.radius_ratio is not None
    log_slope, nu_slope = (np.array([row[key] for row in rows]) for key in ("exponent", "nu_slope"))
    log_slope = log_slope / law.radius_ratio
    rng = np.random.default_rng(0)
    found = {}
    for size in _SIZES:
        if len(rows) - size < 2:
            continue
        order = rng.permuted(np.tile(np.arange(len(rows)), (_DRAWS, 1)), axis=1)
        known = order[:, :size]
        shift = (fused_silica.nu - nu[known].mean(axis=1)) / nu_slope[known].mean(axis=1)
        if name == "nu":
            values = nu[order] + nu_slope[order] * shift[:, None]
        else:
            values = E[order] * np.exp(log_slope[order] * shift[:, None])
        half = half_width(size, kind="prediction", level=LEVEL) * values[:, :size].std(axis=1, ddof=1)
        off = np.abs(values[:, size:] - values[:, :size].mean(axis=1, keepdims=True))
        share = (off <= half[:, None]).mean(axis=1)
        found[str(size)] = {"mean": float(share.mean()), "worst_tenth": float(np.quantile(share, 0.1))}
    return found
