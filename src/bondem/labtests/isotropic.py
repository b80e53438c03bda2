"""Isotropic material nearest to a stiffness tensor (Voigt's average)."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats


@dataclass(frozen=True)
class Isotropic:
    """Isotropic elastic material.

    Attributes:
        K: bulk modulus [Pa].
        G: shear modulus [Pa].
    """

    K: float
    G: float

    @classmethod
    def average(cls, stiffness: Floats) -> "Isotropic":
        """Average a stiffness matrix (6, 6) [Pa], in the order xx, yy, zz, yz, xz, xy; K and G are linear in it."""
        C = stiffness
        longitudinal, lateral = np.trace(C[:3, :3]), C[0, 1] + C[0, 2] + C[1, 2]
        shear = float(longitudinal - lateral + 3.0 * np.trace(C[3:, 3:])) / 15.0
        return cls(K=float(C[:3, :3].sum()) / 9.0, G=shear)

    @property
    def E(self) -> float:
        """Young's modulus [Pa]."""
        return 9.0 * self.K * self.G / (3.0 * self.K + self.G)

    @property
    def nu(self) -> float:
        """Poisson's ratio [-]."""
        return (3.0 * self.K - 2.0 * self.G) / (2.0 * (3.0 * self.K + self.G))
