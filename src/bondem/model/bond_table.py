"""Constants of the bonds in the kernels' order and form."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._types import Floats, PerBond
from bondem.laws.bond import BondStiffness
from bondem.model.layout import Layout
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class BondTable:
    """What the bond pass reads, internal order.

    Attributes:
        constants: rows X0 (3), L [m], kn [N/m], A, B, C, kt [N·m], shape (9, m).
        shear: ks [N/m], shape (m,).
        bending: kb [N·m], shape (m,).
        lever: distance of the contact point from the internal element i [m], shape (m,).
        radius: bond radius [m], shape (m,).
    """

    constants: Floats
    shear: PerBond
    bending: PerBond
    lever: PerBond
    radius: PerBond

    @classmethod
    def of(cls, lattice: Lattice, layout: Layout, stiffness: BondStiffness) -> "BondTable":
        """Reorder a law's stiffnesses and form the constants of the energy."""
        order, flipped = layout.bond_order, layout.flipped
        L = lattice.length[order]
        direction = lattice.branch[order] / L[:, None] * np.where(flipped, -1.0, 1.0)[:, None]
        ks, kb, kt = stiffness.ks[order], stiffness.kb[order], stiffness.kt[order]
        a = np.where(flipped, L - stiffness.lever[order], stiffness.lever[order])
        b = L - a
        k = kb - kt
        constants = np.empty((9, len(L)))
        constants[:3] = direction.T
        constants[3] = L
        constants[4] = stiffness.kn[order]
        constants[5] = ks * a * a + k
        constants[6] = ks * a * b - k
        constants[7] = ks * b * b + k
        constants[8] = kt
        return cls(constants, ks.copy(), kb.copy(), a, stiffness.radius[order])

    def stretched(self, strain: PerBond) -> "BondTable":
        """The same bonds with rest lengths L (1 + ε*); the moments' constants stay as they are.

        Args:
            strain: ε* [-], shape (m,), or (0,) for none.
        """
        if strain.size == 0:
            return self
        stretch = 1.0 + strain
        constants = self.constants.copy()
        constants[3] *= stretch
        return replace(self, constants=constants, shear=self.shear / stretch**2, lever=self.lever * stretch)


# Rounding that products of constants and length may differ by.
_ROUNDING = 1e-14


def alike(constants: Floats) -> tuple[float, float, float, float] | None:
    """kn L, A L = C L, B L and kt L [N, N·m²] where all bonds share them, else None.

    So it is for Euler–Bernoulli bonds of one material and radius: their stiffnesses go as 1 / L.
    """
    if constants.shape[1] == 0:
        return None
    products = constants[4:] * constants[3]
    largest = np.abs(products).max(axis=1)
    spread = np.append(np.ptp(products, axis=1), abs(products[1] - products[3]).max())
    if (spread > _ROUNDING * np.append(largest, largest[1])).any():
        return None
    kn, A, B, _, kt = products.mean(axis=1).tolist()
    return kn, A, B, kt
