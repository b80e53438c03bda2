"""Bond law with stiffnesses that do not depend on the length, as in `bond_style bpm/rotational` of LAMMPS."""

import dataclasses
from typing import ClassVar

import numpy as np

from bondem.interactions.beams.bond_law import BondGeometry, BondLaw, BondStiffness


@dataclasses.dataclass(frozen=True, kw_only=True)
class Alike(BondLaw):
    """Bonds with the same four stiffnesses at any length, and the contact point in the middle.

    Attributes:
        kn, ks: normal and shear stiffness [N/m].
        kb, kt: bending and twisting stiffness [N·m].
    """

    title: ClassVar[str] = "alike"
    moments_at_contact: ClassVar[bool] = True

    kn: float
    ks: float
    kb: float
    kt: float

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        def all_of(value: float) -> np.ndarray:
            return np.full_like(bonds.length, value)

        return BondStiffness(
            kn=all_of(self.kn), ks=all_of(self.ks), kb=all_of(self.kb), kt=all_of(self.kt),
            lever=0.5 * bonds.length, radius=all_of(self.radius),
        )  # fmt: skip
