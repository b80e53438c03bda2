"""Shear-flexible beam bond after Obermayr et al. (2013)."""

from dataclasses import dataclass
from typing import ClassVar

from bondem._checks import number
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness, Section
from bondem.interactions.beams.free_parameter import FreeParameter


@dataclass(frozen=True, kw_only=True)
class Obermayr(BondLaw):
    """A Timoshenko element with reduced integration of the shear strain.

        kn = E A / L    ks = α_s G A / L    kb = E I / L    kt = G J / L    contact point at L/2

    The element is not nodally exact: the bending part of the shear flexibility is missing, but refinement adds it.
    Tension is positive. Reference: Chen et al. (2022) §4.3.

    Attributes:
        alpha_s: positive shear correction factor α_s [-], else InputError; 9/10 is the stubby limit of Timoshenko.
    """

    title: ClassVar[str] = "Obermayr"
    free: ClassVar[FreeParameter] = FreeParameter(
        name="alpha_s", meaning="shear factor", symbol="α_s", tex=r"$\alpha_s$", search=(0.05, 2.5),
        curve=(0.02, 0.04, 0.07, 0.1, 0.15, 0.25, 0.4, 0.6, 0.75, 0.9, 1.2, 1.5, 2.5, 5.0), fitted=(0.25,),
    )  # fmt: skip

    alpha_s: float = 0.9

    def __post_init__(self) -> None:
        super().__post_init__()
        number("Obermayr", "alpha_s", self.alpha_s, above=0.0, advice="a positive shear correction factor")

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        section = Section(self.bond_radius(bonds))
        return self._of_beams(bonds, section, self.alpha_s * self.G * section.area / bonds.length)
