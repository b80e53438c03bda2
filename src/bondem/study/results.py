"""Contents of `results.json` of a study: finite numbers in SI, or null."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import Any

import numpy as np

from bondem.calibration.uncertainty import Sample
from bondem.fracture.lost_area import lost_area
from bondem.interactions.beams.bond_law import BondLaw
from bondem.labtests.outcome import Outcome
from bondem.report.findings import Bonding, Examined
from bondem.specimen.fabric import Fabric
from bondem.study.provenance import provenance
from bondem.study.study_file import Study

_COMMON = {item.name for item in fields(BondLaw)}
# Attributes of the outcome of a test that the results have under equal names.
_NUMBERS = (
    "measured", "theory", "theory_timoshenko", "theory_refined", "error", "error_timoshenko", "error_refined", "unit",
)  # fmt: skip


def collect(
    study: Study, bonds: Bonding | None, specimens: Sequence[Examined], timing: dict[str, float]
) -> dict[str, Any]:
    """Collect the contents of `results.json`: the first specimen, means of tests over all packings, and each packing.

    The scatter over a single packing is None, and so are "micro" and "macro" of a study without a material.
    """
    calibrating = study.calibrating if bonds is not None and bonds.fit is not None else 0
    return _finite({
        "specimen": _specimen(specimens[0]),
        "micro": _micro(bonds) if bonds is not None else None,
        "macro": _macro(bonds, specimens) if bonds is not None else None,
        "unseen": _unseen(specimens[calibrating:]) if bonds is not None and calibrating else None,
        "tests": {name: _test(name, specimens) for name in study.tests},
        "timing": timing,
        **provenance(),
        "seed": study.seed,
        "packings": [_packing(one, k < calibrating) for k, one in enumerate(specimens)],
    })  # fmt: skip


def _micro(bonds: Bonding) -> dict[str, Any]:
    law = bonds.law
    pinned = {
        "law": type(law).__name__,
        "E_mu": law.E,
        "nu_mu": law.nu,
        "r_mu_ratio": law.radius_ratio if isinstance(law, BondLaw) else None,
        "rho_mu": bonds.density,
    }
    return pinned | {item.name: getattr(law, item.name) for item in fields(law) if item.name not in _COMMON}


def _macro(bonds: Bonding, specimens: Sequence[Examined]) -> dict[str, Any]:
    """Collect E and ν with their scatter, and the density; for cells E and ν are measured on the first packing.

    E and ν are None for balls and for specimens with a notch or borings, which have no tension test.
    """
    tensions = [one.tension for one in specimens if one.tension is not None]
    found = bonds.fit if bonds.fit is not None else tensions[0] if tensions else None
    return {
        "E": None if found is None else found.E,
        "nu": None if found is None else found.nu,
        "rho": specimens[0].rho,
        "E_std": deviation([tension.E for tension in tensions]),
        "nu_std": deviation([tension.nu for tension in tensions]),
    }


def deviation(values: Sequence[float]) -> float | None:
    """Return the standard deviation of a sample; None for fewer than two values."""
    return float(np.std(values, ddof=1)) if len(values) > 1 else None


def _interval(values: Sequence[float]) -> list[float] | None:
    """Return the 95 % confidence interval of the mean of a sample; None for a single value, or if one is NaN."""
    several = len(values) > 1 and bool(np.isfinite(values).all())
    return list(Sample(np.array(values)).interval()) if several else None


def _unseen(specimens: Sequence[Examined]) -> dict[str, Any] | None:
    """Collect mean E and ν, with 95 % intervals, of packings that were not used for calibration; None if empty."""
    tensions = [one.tension for one in specimens if one.tension is not None]
    if not tensions:
        return None
    found: dict[str, Any] = {"packings": len(tensions)}
    for name in ("E", "nu"):
        values = [float(getattr(one, name)) for one in tensions]
        found[name] = {"mean": np.mean(values), "confidence_95": _interval(values)}
    return found


def _specimen(one: Examined) -> dict[str, Any]:
    """Collect numbers of a specimen; volume fraction and isotropy error are None for cells, which fill the shape."""
    return _aggregates(one) | {
        "elements": len(one.lattice.particles),
        "bonds": len(one.lattice.pairs),
        "volume_fraction": None if one.quality is None else one.quality.volume_fraction,
        "coordination_number": one.lattice.coordination_number,
        "isotropy_error": None if one.quality is None else one.quality.isotropy_error,
        "rattlers": one.lattice.rattlers,
    }


def _aggregates(one: Examined) -> dict[str, Any]:
    """Collect number, volume fraction, cells, E and ν of the aggregates; empty for a body without aggregates."""
    if one.aggregates is None:
        return {}
    share = one.aggregates.volume / one.lattice.particles.envelope.volume
    inside = int(one.aggregates.mask(one.lattice).sum())
    assert isinstance(one.law, Mapping)
    _, own = one.law.values()
    return {"aggregates": {
        "count": len(one.aggregates), "fraction": share, "cells": inside, "E": own.E, "nu": own.nu,
    }}  # fmt: skip


def _test(name: str, specimens: Sequence[Examined]) -> dict[str, Any]:
    outcomes = [one.outcomes[name] for one in specimens]
    against = [one.theory_timoshenko for one in outcomes if one.theory_timoshenko is not None]
    measured = np.array([one.measured for one in outcomes])
    errors = [one.error for one in outcomes]
    spread = errors if np.isfinite(errors).all() else (measured / measured.mean() - 1.0).tolist()
    return {
        "measured": measured.mean(),
        "theory": np.mean([one.theory for one in outcomes]),
        "theory_timoshenko": np.mean(against) if against else None,
        "error": np.mean(errors),
        "scatter": deviation(spread),
        "error_95": _interval(errors),
        "unit": outcomes[0].unit,
    }


def _packing(one: Examined, calibrating: bool) -> dict[str, Any]:
    return {
        "seed": one.seed,
        "calibrating": calibrating,
        **_specimen(one),
        **(_fabric(one.quality) if one.quality is not None else {}),
        "fabric_reasons": [] if one.quality is None else list(one.quality.reasons),
        **{name: getattr(one.tension, name, None) for name in ("E", "nu", "E_paper", "nu_paper")},
        "rho": one.rho,
        "tests": {
            name: {
                **{number: getattr(outcome, number) for number in _NUMBERS},
                "free_vibration": outcome.curves.get("free_vibration"),
                **({"told": dict(outcome.told)} if outcome.told else {}),
                "failure": _failure(one, outcome),
            }
            for name, outcome in one.outcomes.items()
        },
    }


def _fabric(quality: Fabric) -> dict[str, Any]:
    """Collect the measures of a packing of spheres that `Fabric` has in addition to those of `_specimen`."""
    same = (
        "core_volume_fraction", "loose", "backbone_coordination_number", "fineness", "smallest_extent", "rms_excess",
        "core_rms_excess", "core_stretch", "largest_overlap",
    )  # fmt: skip
    strata = {item.name: getattr(quality.strata, item.name).tolist() for item in fields(quality.strata)}
    return {name: getattr(quality, name) for name in same} | {
        "eigenvalues": quality.eigenvalues.tolist(), "strata": strata
    }  # fmt: skip


def _failure(one: Examined, outcome: Outcome) -> dict[str, Any] | None:
    """Collect cracks, pieces and final energy balance of a test to failure; None for other tests."""
    if outcome.cracking is None:
        return None
    found = outcome.cracking.numbers()
    if one.aggregates is not None:
        found["lost_area"] = lost_area(one.lattice, outcome.cracking.state, one.aggregates)
    if not outcome.energy:
        return found
    return found | {
        "energy": {name: energy[-1] for name, energy in outcome.energy.items()},
        "largest_imbalance": np.abs(outcome.energy["balance"]).max(),
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
