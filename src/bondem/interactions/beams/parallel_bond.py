"""Parallel bond (Potyondy and Cundall 2004, as in PFC3D)."""

from dataclasses import dataclass
from typing import ClassVar

from bondem._checks import number
from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness, Section
from bondem.interactions.beams.free_parameter import FreeParameter


@dataclass(frozen=True, kw_only=True)
class ParallelBond(BondLaw):
    """Springs distributed over a disc at the contact point between the two surfaces.

        kn = E A / L    ks = kn / κ    kb = kn r² / 4    kt = ks r² / 2    contact point at (L + Ri - Rj) / 2

    The law converges to a beam only as bonds become short compared with their radius. Tension is positive. Reference:
    Chen et al. (2022) Tables 1 and 9, eqs (2) and (8).

    Attributes:
        kappa: positive ratio κ of normal to shear stiffness [-], else InputError; 2 (1 + ν) by default.
    """

    title: ClassVar[str] = "parallel"
    free: ClassVar[FreeParameter] = FreeParameter(
        name="kappa", meaning="stiffness ratio", symbol="κ", tex=r"$\kappa$", search=(0.5, 50.0),
        curve=(0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 12.0, 20.0, 30.0, 50.0), fitted=(1.5, 5.0),
        held_out=(4.0,),
    )  # fmt: skip

    moments_at_contact: ClassVar[bool] = True

    kappa: float | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.kappa is not None:
            number("ParallelBond", "kappa", self.kappa, above=0.0, advice="a positive ratio, or None for 2 (1 + ν)")

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        section = Section(self.bond_radius(bonds))
        kappa = self.kappa if self.kappa is not None else 2.0 * (1.0 + self.nu)
        kn = self.E * section.area / bonds.length
        return BondStiffness(
            kn=kn, ks=kn / kappa, kb=0.25 * kn * section.radius**2, kt=0.5 * kn / kappa * section.radius**2,
            lever=0.5 * (bonds.length + bonds.radius_i - bonds.radius_j), radius=section.radius,
        )  # fmt: skip
