"""A continuum material, as the user knows it."""

import math
from dataclasses import dataclass

from bondem.errors import InputError


@dataclass(frozen=True)
class Material:
    """An isotropic linear elastic material.

    Attributes:
        name: what the reports call it.
        E: Young's modulus [Pa].
        nu: Poisson's ratio [-], strictly between -1 and 0.5.
        rho: density [kg/m³].
        source: where the values are from, in words.

    Raises:
        InputError: a value is not finite or outside its physical range.
    """

    name: str
    E: float
    nu: float
    rho: float
    source: str = ""

    def __post_init__(self) -> None:
        if not (math.isfinite(self.E) and self.E > 0.0):
            raise InputError(f"material '{self.name}': E = {self.E} Pa; give a positive Young's modulus in Pa")
        if not -1.0 < self.nu < 0.5:
            raise InputError(f"material '{self.name}': nu = {self.nu}; give a Poisson's ratio in (-1, 0.5)")
        if not (math.isfinite(self.rho) and self.rho > 0.0):
            raise InputError(f"material '{self.name}': rho = {self.rho} kg/m³; give a positive density")

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))
