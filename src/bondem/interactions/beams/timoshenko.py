"""Timoshenko beam bond (Chen et al. 2022)."""

from dataclasses import dataclass, replace
from typing import ClassVar

from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness, Section
from bondem.interactions.beams.free_parameter import RADIUS_RATIO, FreeParameter


@dataclass(frozen=True, kw_only=True)
class Timoshenko(BondLaw):
    """A cylindrical beam with shear deformation (form factor f_s = 10/9 of the circular section).

        kn = E A / L    ks = 12 E I / (L³ (1 + Φ))    kb = E I / L    kt = G J / L    contact point at L/2
        Φ = 12 E I f_s / (G A L²) = 20 r² (1 + ν) / (3 L²)

    The beam is nodally exact for loads at the elements. Tension is positive. Reference: Chen et al. (2022) eqs (21),
    (22), (25).
    """

    title: ClassVar[str] = "Timoshenko"
    # ν decreases further, ever more slowly, for bonds wider than the elements
    free: ClassVar[FreeParameter] = replace(RADIUS_RATIO, curve=(*RADIUS_RATIO.curve, 1.25, 1.5), fitted=(0.6,))

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        section = Section(self.bond_radius(bonds))
        L = bonds.length
        Phi = 20.0 * section.radius**2 * (1.0 + self.nu) / (3.0 * L**2)
        return self._of_beams(bonds, section, 12.0 * (self.E * section.second_moment) / (L**3 * (1.0 + Phi)))
