"""Euler–Bernoulli beam bond (André et al. 2012)."""

from dataclasses import dataclass, replace
from typing import ClassVar

from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness, Section
from bondem.interactions.beams.free_parameter import RADIUS_RATIO, FreeParameter


@dataclass(frozen=True, kw_only=True)
class EulerBernoulli(BondLaw):
    """A cylindrical beam without shear deformation, clamped in both elements.

        kn = E A / L    ks = 12 E I / L³    kb = E I / L    kt = G J / L    contact point at L/2

    The beam is nodally exact for loads at the elements. Tension is positive. Reference: André et al. (2012) §2, signs
    of eqs (1), (3), (4) corrected; Chen et al. (2022) eq (26).
    """

    title: ClassVar[str] = "Euler–Bernoulli"
    free: ClassVar[FreeParameter] = replace(RADIUS_RATIO, fitted=(0.3, 0.5, 0.8), held_out=(0.7,))

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        section = Section(self.bond_radius(bonds))
        return self._of_beams(bonds, section, 12.0 * (self.E * section.second_moment) / bonds.length**3)
