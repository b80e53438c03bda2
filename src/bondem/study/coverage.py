"""Whether intervals keep their word: calibrate on some packings, test on others: `bondem study coverage`."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from bondem.calibration.elastic import Calibration, calibrate
from bondem.calibration.uncertainty import Sample, half_width
from bondem.errors import InputError
from bondem.laws.bond import BondLaw
from bondem.packing.sizes import SPREAD
from bondem.report.coverage_figure import draw_coverage
from bondem.report.study_page import write_study_page
from bondem.specimen.materials import fused_silica
from bondem.study.elastic_rows import ElasticRequest, cells_and_bars
from bondem.study.packing_rows import PackingRequest, kept_lattice
from bondem.study.packing_runs import complain, gather
from bondem.study.study_files import keep_study, study_folder, table

#: Probability of the intervals [-].
LEVEL = 0.95

# Random calibrations, drawn from all packings, of each number of packings.
_DRAWS = 4000
_SIZES = (2, 3, 4, 6, 8, 12, 16)

_SYMBOLS = {"E": "E", "nu": "ν"}
_CAPTION = (
    "Left and middle: calibrating and unseen packings, and the intervals of the calibration. Right: share of unseen"
    " packings in the interval, over random calibrations from the same packings."
)


@dataclass(frozen=True)
class Coverage:
    """What to calibrate on and to test.

    Attributes:
        count: elements of a packing.
        calibrating: packings that calibrate, seeds 1 … calibrating.
        held_out: unseen packings, the next seeds.
        shape: "cylinder", the paper's 10 x 40 mm, or "cell", periodic.
    """

    count: int = 10_000
    calibrating: int = 8
    held_out: int = 40
    shape: str = "cylinder"

    def __post_init__(self) -> None:
        if self.calibrating < 2 or self.held_out < 1:
            raise InputError(
                f"{self.calibrating} calibrating and {self.held_out} unseen packings; give at least 2 and 1"
            )
        if self.shape not in ("cylinder", "cell"):
            raise InputError(f"shape = '{self.shape}'; choose from cylinder, cell")

    @property
    def packings(self) -> list[PackingRequest]:
        """All packings, those that calibrate first."""
        number = self.calibrating + self.held_out
        cells, bars = (number, 0) if self.shape == "cell" else (0, number)
        return cells_and_bars(self.count, SPREAD, cells=cells, bars=bars)


def run_coverage(
    study: Coverage,
    out: str | Path,
    *,
    processes: int | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> dict[str, Any]:
    """Pack, calibrate on the first packings, test on the others, and count; leaves results, a table and a figure.

    Args:
        study: what to do.
        out: folder for the results, of an earlier run or new.
        processes: how many work at once; one a core unless given.
        progress: told the stage and the share of it that is done.

    Returns:
        What `results.json` holds.

    Raises:
        InputError: the folder cannot be written to.
        PackingError: a packing or a test failed.
    """
    out = study_folder(out)
    tell = progress or (lambda stage, share: None)
    packings = study.packings
    complain(gather(packings, out, processes=processes, progress=lambda share: tell("pack", share)), out)
    tell("calibrate", 0.0)
    fit = calibrate([kept_lattice(one, out) for one in packings[: study.calibrating]], fused_silica)
    tell("calibrate", 1.0)
    requests = [ElasticRequest(one, fit.law, slopes=True) for one in packings]
    rows = gather(requests, out, processes=processes, progress=lambda share: tell("test", share))
    complain(rows, out)
    results = _results(study, fit, rows)
    results = keep_study(out, results, _table(results))
    draw_coverage(out / "figures" / "coverage.png", results)
    write_study_page(
        out,
        title="Do the intervals keep their word?",
        about=f"{study.calibrating} calibrating and {study.held_out} unseen packings of {study.count} elements,"
        f" {study.shape}, fused silica, {results['law']} bonds",
        verdict=" ".join(_verdict(study, symbol, results["quantities"][name]) for name, symbol in _SYMBOLS.items()),
        captions={"coverage": _CAPTION},
    )
    return results


def _results(study: Coverage, fit: Calibration, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    quantities: dict[str, Any] = {}
    for name in ("E", "nu"):
        values = np.array([row[name] for row in rows])
        known, unseen = values[: study.calibrating], values[study.calibrating :]
        low, high = Sample(known).interval(kind="prediction", level=LEVEL)
        mean_low, mean_high = Sample(known).interval(level=LEVEL)
        quantities[name] = {
            "values": values,
            "prediction": (low, high),
            "confidence": (mean_low, mean_high),
            "covered": int(((low <= unseen) & (unseen <= high)).sum()),
            "mean_covered": bool(mean_low <= unseen.mean() <= mean_high),
            "scatter": float(np.std(values, ddof=1) / values.mean()),
            "coverage": _coverage(study, name, rows, fit.law),
        }
    return {
        "study": "coverage",
        "count": study.count,
        "shape": study.shape,
        "calibrating": study.calibrating,
        "held_out": study.held_out,
        "level": LEVEL,
        "law": type(fit.law).__name__,
        "E_mu": fit.law.E,
        "value": fit.value,
        "quantities": quantities,
    }


def _verdict(study: Coverage, symbol: str, found: dict[str, Any]) -> str:
    often = found["coverage"].get(str(study.calibrating))
    over = "" if often is None else f"; over random calibrations on as many packings, {often['mean']:.1%}"
    inside = f"{found['covered']} of {study.held_out} unseen packings lie in the {LEVEL:.0%} prediction interval"
    return f"{symbol}: {inside}{over}."


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


def _table(results: dict[str, Any]) -> str:
    quantities = results["quantities"]
    first = table(
        f"Calibrated on {results['calibrating']} packings of {results['count']} elements, tested on"
        f" {results['held_out']}",
        ["quantity", "scatter of all", "prediction interval", "unseen packings in it", "mean of the unseen in the"
         " confidence interval"],
        [
            [symbol, f"{one['scatter']:.2%}", " … ".join(f"{end / scale:.5g}" for end in one["prediction"]),
             f"{one['covered']} of {results['held_out']}", "yes" if one["mean_covered"] else "no"]
            for symbol, one, scale in (("E [GPa]", quantities["E"], 1e9), ("ν", quantities["nu"], 1.0))
        ],
    )  # fmt: skip
    second = table(
        f"Share of unseen packings in the {results['level']:.0%} interval, over random calibrations",
        ["packings", "E, mean", "E, worst tenth", "ν, mean", "ν, worst tenth"],
        [
            [size] + [f"{quantities[name]['coverage'][size][key]:.1%}" for name in ("E", "nu")
                      for key in ("mean", "worst_tenth")]
            for size in quantities["E"]["coverage"]
        ],
    )  # fmt: skip
    return f"{first}\n{second}"
