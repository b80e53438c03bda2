"""Readable parameters of a failure criterion."""

import math
from dataclasses import fields

from bondem.damage.criteria.criterion import Criterion
from bondem.report.numbers import with_unit

# Fields of criteria that are stresses, and angles.
_STRESSES = ("tension", "compression", "cohesion", "hydrostatic")
_ANGLES = ("friction_angle",)


def parameter_texts(criterion: Criterion) -> list[tuple[str, str]]:
    """Return names and formatted values of the parameters of a criterion, without those that are 0 or None."""
    found: list[tuple[str, str]] = []
    for item in fields(criterion):
        value = getattr(criterion, item.name)
        if value is None or value == 0.0:
            continue
        if not isinstance(value, int | float):
            shown = type(value).__name__
        elif item.name in _STRESSES:
            shown = with_unit(value, "Pa")
        elif item.name.startswith("fracture_energy"):
            shown = with_unit(value, "J/m²")
        elif item.name in _ANGLES:
            shown = f"{math.degrees(value):.4g}°"
        else:
            shown = f"{value:.4g}"
        found.append((item.name.replace("_", " "), shown))
    return found
