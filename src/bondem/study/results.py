"""What a study leaves in `results.json`: SI, finite numbers or null."""

import math
from collections.abc import Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from bondem import __version__
from bondem.calibration.elastic import Calibration
from bondem.laws.bond import BondLaw
from bondem.report.findings import Examined
from bondem.study.study import Study

_COMMON = {item.name for item in fields(BondLaw)}


def collect(
    study: Study, fit: Calibration, specimens: Sequence[Examined], timing: dict[str, float]
) -> dict[str, Any]:
    """All numbers of a study, in the pinned layout, and those of every packing under "packings".

    A scatter over a single packing is null.
    """
    first = specimens[0]
    return _finite({
        "specimen": _specimen(first),
        "micro": {
            "law": type(fit.law).__name__,
            "E_mu": fit.law.E,
            "nu_mu": fit.law.nu,
            "r_mu_ratio": fit.law.radius_ratio,
            "rho_mu": fit.density,
        }
        | {item.name: getattr(fit.law, item.name) for item in fields(fit.law) if item.name not in _COMMON},
        "macro": {
            "E": fit.E,
            "nu": fit.nu,
            "rho": first.rho,
            "E_std": deviation([one.tension.E for one in specimens]),
            "nu_std": deviation([one.tension.nu for one in specimens]),
        },
        "tests": {name: _test(name, specimens) for name in study.tests},
        "timing": timing,
        "version": __version__,
        "seed": study.seed,
        "packings": [_packing(one, k < study.calibrating) for k, one in enumerate(specimens)],
    })  # fmt: skip


def deviation(values: Sequence[float]) -> float | None:
    """Standard deviation of a sample, None for a single value."""
    return float(np.std(values, ddof=1)) if len(values) > 1 else None


def _specimen(one: Examined) -> dict[str, Any]:
    return {
        "elements": len(one.lattice.particles),
        "bonds": len(one.lattice.pairs),
        "volume_fraction": one.quality.volume_fraction,
        "coordination_number": one.quality.coordination_number,
        "isotropy_error": one.quality.isotropy_error,
        "rattlers": one.lattice.rattlers,
    }


def _test(name: str, specimens: Sequence[Examined]) -> dict[str, Any]:
    outcomes = [one.outcomes[name] for one in specimens]
    against = [one.theory_timoshenko for one in outcomes if one.theory_timoshenko is not None]
    errors = [one.error for one in outcomes]
    return {
        "measured": np.mean([one.measured for one in outcomes]),
        "theory": np.mean([one.theory for one in outcomes]),
        "theory_timoshenko": np.mean(against) if against else None,
        "error": np.mean(errors),
        "scatter": deviation(errors),
        "unit": outcomes[0].unit,
    }


def _packing(one: Examined, calibrating: bool) -> dict[str, Any]:
    return {
        "seed": one.seed,
        "calibrating": calibrating,
        **_specimen(one),
        "rms_excess": one.quality.rms_excess,
        "largest_overlap": one.quality.largest_overlap,
        "fabric_reasons": list(one.quality.reasons),
        "E": one.tension.E,
        "nu": one.tension.nu,
        "E_paper": one.tension.E_paper,
        "nu_paper": one.tension.nu_paper,
        "rho": one.rho,
        "tests": {
            name: {
                "measured": outcome.measured,
                "theory": outcome.theory,
                "theory_timoshenko": outcome.theory_timoshenko,
                "theory_refined": outcome.theory_refined,
                "error": outcome.error,
                "error_timoshenko": outcome.error_timoshenko,
                "error_refined": outcome.error_refined,
                "unit": outcome.unit,
                "free_vibration": outcome.curves.get("free_vibration"),
            }
            for name, outcome in one.outcomes.items()
        },
    }


def _finite(value: Any) -> Any:
    match value:
        case dict():
            return {key: _finite(item) for key, item in value.items()}
        case list():
            return [_finite(item) for item in value]
        case bool() | None | str():
            return value
    number = np.asarray(value).item()
    return number if math.isfinite(number) else None
