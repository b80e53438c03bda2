"""Criterion on the stress of the outermost fibre of a beam."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from bondem._checks import number
from bondem._plausibility import physical
from bondem._types import Floats, PerBond
from bondem.damage.cohesive_softening import check_energies
from bondem.damage.criteria.criterion import BondCriterion, Joint, columns


@dataclass(frozen=True, kw_only=True)
class PeripheralStress(BondCriterion):
    """Breakage of a beam whose outermost fibre reaches the tensile strength, or whose section the shear strength.

        σ = N / A + β |M| r / I ≥ tension        τ = |Q| / A + |T| r / J ≥ shear

    with A = πr², I = πr⁴/4, J = 2I. M is the larger of the moments at both ends for beams, and that at the contact
    point for parallel and contact bonds. Tension is positive. Compression alone breaks nothing.

    With a fracture energy a bond that reaches its strength softens (`core/laws/beam_softening.hpp`). It absorbs G_f
    times its section in tension, and G_II times it in shear.

    Attributes:
        tension: tensile strength [Pa].
        shear: shear strength [Pa].
        beta: share of the bending moment that counts, β [-] in [0, 1].
        fracture_energy: G_f of opening [J/m²]; None for brittle bonds.
        fracture_energy_shear: G_II of slip and twist [J/m²]; 10 G_f by default.

    Reference: Potyondy and Cundall (2004) eq. (19); β is the moment-contribution factor of Potyondy (2011).

    Raises:
        InputError: A strength or energy is not positive, β is outside [0, 1], or only the energy of shear is given.
    """

    kind: ClassVar[str] = "peripheral_stress"

    tension: float
    shear: float
    beta: float = 1.0
    fracture_energy: float | None = None
    fracture_energy_shear: float | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        physical("PeripheralStress", "tension", self.tension)
        physical("PeripheralStress", "shear", self.shear)
        number("PeripheralStress", "beta", self.beta, least=0.0, advice="a share of the moment in [0, 1]")
        number("PeripheralStress", "1 - beta", 1.0 - self.beta, least=0.0, advice="beta in [0, 1]")
        check_energies("PeripheralStress", self.fracture_energy, self.fracture_energy_shear)

    @property
    def energies(self) -> tuple[float, float] | None:
        opening, shear = self.fracture_energy, self.fracture_energy_shear
        return None if opening is None else (opening, 10.0 * opening if shear is None else shear)

    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        section = joint.section
        tension, shear = self.tension * factor, self.shear * factor
        return columns(
            1.0 / (section.area * tension), self.beta * section.radius / (section.second_moment * tension),
            1.0 / (section.area * shear), section.radius / (section.polar_moment * shear),
        )  # fmt: skip

    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        s = coefficients.T
        return np.maximum(s[0], s[2]), np.maximum(s[1], s[3])

    def pulled_and_sheared(self, joint: Joint, factor: PerBond, arm: PerBond) -> tuple[PerBond, PerBond]:
        s = self.coefficients(joint, factor).T
        return 1.0 / s[0], 1.0 / np.maximum(s[2], s[1] * arm)
