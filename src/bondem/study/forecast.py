"""Forecast of the computations of a study."""

import math

from bondem.report.numbers import with_unit
from bondem.study.specimen_step import ImportPlan
from bondem.study.study_file import Study

# Neighbours of an element: spheres that touch (z = 6.2), and cells with a facet in common.
_BONDS, _FACETS = 3.1, 7.0
# Peak memory of an element, of cells as measured at a million (docs/validation/cost.md), and of the program [bytes].
_SPHERE, _CELL, _PROGRAM = 4e3, 9e3, 4e8
# Share of the volume that spheres fill.
_FILLED = 0.63
# Critical step over size over celerity, of cells and of bonded spheres alike to a third.
_STEP = 0.25


def forecast(study: Study) -> list[tuple[str, str]]:
    """List the planned computations of a study as pairs of a name and a text.

    Args:
        study: the study.
    """
    plan, cells = study.specimen, study.bond.cells is not None
    lines: list[tuple[str, str]] = []
    if isinstance(plan, ImportPlan):
        lines.append(("specimen", f"particles of {plan.file}"))
        return lines + _work(study)
    shape, count = plan.shape, plan.count
    volume = shape.volume
    own = volume / count
    size = own ** (1.0 / 3.0) if cells else (6.0 * _FILLED * own / math.pi) ** (1.0 / 3.0)
    what = "cells" if cells else "spheres"
    lines += [
        ("specimen", f"{type(shape).__name__}, {volume * 1e9:.4g} mm³, packed by the method \"{plan.method}\""),
        ("elements", f"{count} {what} of about {with_unit(size, 'm')},"
                     f" about {round((_FACETS if cells else _BONDS) * count)} {'facets' if cells else 'bonds'}"),
        ("memory", f"about {(_PROGRAM + count * (_CELL if cells else _SPHERE)) / 1e9:.1f} GB"),
    ]  # fmt: skip
    if study.aggregates is not None:
        grains = study.aggregates
        small, large = (with_unit(grains.sieve.diameters[k], "m") for k in (0, -1))
        lines.append(("aggregates", f"{grains.fraction:g} of the volume, balls of {small} to {large}"))
    if study.material is not None:
        E = max(study.material.E, study.aggregates.E if study.aggregates is not None else 0.0)
        celerity = math.sqrt(E / study.material.rho)
        lines.append(("time step", f"about {_STEP * size / celerity:.1g} s in explicit tests"))
    return lines + _work(study)


def _work(study: Study) -> list[tuple[str, str]]:
    packings = f"{study.packings}, seeds {study.seed} to {study.seed + study.packings - 1}"
    lines = [("packings", packings if study.packings > 1 else f"1, seed {study.seed}")]
    if study.material is None:
        return [*lines, ("tests", "none: packed and checked only")]
    m = study.material
    lines.append(("material", f"{m.name}, E = {with_unit(m.E, 'Pa')}, ν = {m.nu:g}, ρ = {with_unit(m.rho, 'kg/m³')}"))
    if study.bond.cells is not None:
        lines.append(("law", f"{study.bond.cells.__name__}, nothing to calibrate"))
    else:
        law = study.bond.law.__name__ if study.bond.law is not None else "recommended for ν"
        lines.append(("law", f"{law}, calibrated on {study.calibrating} packing{'s' * (study.calibrating > 1)}"))
    if study.failure is not None:
        lines.append(("failure", type(study.failure).__name__))
    return [*lines, ("tests", ", ".join(study.tests) or "none")]
