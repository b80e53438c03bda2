"""Contact bond: a glued point that carries force but no moment."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from bondem.interactions.beams.bond_law import BondGeometry, BondStiffness
from bondem.interactions.beams.free_parameter import FreeParameter
from bondem.interactions.beams.parallel_bond import ParallelBond


@dataclass(frozen=True, kw_only=True)
class ContactBond(ParallelBond):
    """The parallel bond without its moments: the elements may roll on each other.

        kn = E A / L    ks = kn / κ    kb = kt = 0    contact point at (L + Ri - Rj) / 2

    κ is that of `ParallelBond`. Static solutions need lattices so dense that no element rolls freely. Calibration in
    studies therefore excludes this bond. Tension is positive. Reference: Potyondy and Cundall (2004), contact bond.
    """

    title: ClassVar[str] = "contact"
    free: ClassVar[FreeParameter] = replace(ParallelBond.free, curve=(), fitted=(), held_out=())
    moments: ClassVar[bool] = False

    def stiffness(self, bonds: BondGeometry) -> BondStiffness:
        full = super().stiffness(bonds)
        none = np.zeros_like(full.kn)
        return BondStiffness(kn=full.kn, ks=full.ks, kb=none, kt=none.copy(), lever=full.lever, radius=full.radius)
