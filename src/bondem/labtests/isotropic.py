"""Isotropic material nearest to a stiffness tensor (Voigt's average)."""

from dataclasses import dataclass

import numpy as np

from bondem._drawing import columns_of
from bondem._types import Floats

# Components of a tensor in a matrix of moduli.
_VOIGT = ("xx", "yy", "zz", "yz", "xz", "xy")
# Steps of a turn in which moduli by direction are drawn.
_DIRECTIONS = 181


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


def matrix_table(stiffness: Floats) -> dict[str, Floats]:
    """Return the rows of a stiffness matrix (6, 6) [Pa] by name and unit, (6,) each."""
    return {"row [-]": np.arange(1.0, 7.0)} | columns_of("stiffness {} [Pa]", _VOIGT, stiffness)


def directional_moduli(stiffness: Floats) -> dict[str, Floats]:
    """Return Young's moduli by direction in the three planes of coordinates, by name and unit.

    With the compliance S and the direction n, 1 / E = s·S s, where s holds the components of n⊗n.

    Args:
        stiffness: matrix in the order xx, yy, zz, yz, xz, xy with engineering shear strains [Pa], (6, 6).
    """
    S, angle = np.linalg.inv(stiffness), np.linspace(0.0, np.pi, _DIRECTIONS)
    found = {"angle in the plane [degree]": np.degrees(angle)}
    for a, b in ((0, 1), (1, 2), (2, 0)):
        n = np.zeros((len(angle), 3))
        n[:, a], n[:, b] = np.cos(angle), np.sin(angle)
        x, y, z = n.T
        s = np.stack([x * x, y * y, z * z, y * z, x * z, x * y], axis=1)
        found[f"E from {'xyz'[a]} to {'xyz'[b]} [Pa]"] = 1.0 / np.einsum("ka,ab,kb->k", s, S, s)
    return found
