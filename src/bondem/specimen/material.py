"""Continuum materials, described by their elastic constants and density."""

from dataclasses import dataclass
from typing import Any

from bondem._checks import instance, number, shown
from bondem._plausibility import question_material

_RANGES: dict[str, dict[str, Any]] = {
    "E": {"above": 0.0, "unit": "Pa", "advice": "a positive Young's modulus in Pa"},
    "nu": {"above": -1.0, "below": 0.5, "advice": "a Poisson's ratio in (-1, 0.5)"},
    "rho": {"above": 0.0, "unit": "kg/m³", "advice": "a positive density"},
}


@dataclass(frozen=True)
class Material:
    """An isotropic, linear elastic material.

    Attributes:
        name: name used in reports and messages.
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-], strictly between -1 and 0.5.
        rho: density [kg/m³].
        source: origin of the values, as text.

    Raises:
        InputError: A value is not finite or is outside its physical range.

    Warns:
        UnitWarning: E or rho differs by a factor of 10³ from that of the named material, or no solid has such a
            value.
    """

    name: str
    E: float
    nu: float
    rho: float
    source: str = ""

    def __post_init__(self) -> None:
        instance("Material", "name", self.name, str, "the name used in reports, as text")
        instance("Material", "source", self.source, str, "the origin of the values, as text")
        for name, options in _RANGES.items():
            value = number(f"material {shown(self.name)}", name, getattr(self, name), **options)
            object.__setattr__(self, name, value)
        question_material(" ".join(self.name.split()), self.E, self.rho)

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))
