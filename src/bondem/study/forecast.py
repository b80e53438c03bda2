"""Forecast of the computations of a study."""

import math

from bondem.report.numbers import with_unit
from bondem.study.specimen_step import ImportPlan
from bondem.study.study_file import Study

# Peak memory of the program [bytes].
_PROGRAM = 4e8
# Critical time step times wave speed over element size, within a third for cells and for bonded spheres.
_STEP = 0.25


def forecast(study: Study) -> list[tuple[str, str]]:
    """List the planned computations of a study, with estimates of memory and time step, as pairs of name and text."""
    plan, bond = study.specimen, study.bond
    lines: list[tuple[str, str]] = []
    if isinstance(plan, ImportPlan):
        lines.append(("specimen", f"particles of {plan.file}"))
        return lines + _work(study)
    shape, count = plan.shape, plan.count
    volume = shape.volume
    size, (what, joined) = bond.size(volume / count), bond.words
    lines += [
        ("specimen", f"{type(shape).__name__}, {volume * 1e9:.4g} mm³, packed by the method \"{plan.method}\""),
        ("elements", f"{count} {what} of about {with_unit(size, 'm')},"
                     f" about {round(bond.neighbours * count)} {joined}"),
        ("memory", f"about {(_PROGRAM + count * bond.memory) / 1e9:.1f} GB"),
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
    lines.append(("law", study.bond.described(study.calibrating)))
    if study.failure is not None:
        lines.append(("failure", type(study.failure).__name__))
    return [*lines, ("tests", ", ".join(study.tests) or "none")]
