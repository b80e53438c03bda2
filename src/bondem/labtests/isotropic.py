"""Elastic moduli of a stiffness matrix: its isotropic (Voigt) average, and Young's modulus by direction."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from bondem._drawing import Plotted, columns_of
from bondem._types import Floats

#: Components of a tensor in a matrix of moduli: xx, yy, zz, yz, xz, xy.
VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
# Number of directions over half a turn at which moduli are drawn.
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


class StiffnessResult(Plotted):
    """Elastic result with a stiffness matrix, and the moduli that follow from it."""

    if TYPE_CHECKING:

        @property
        def stiffness(self) -> Floats:
            """Matrix C of σ = C ε [Pa], (6, 6), in the order xx, yy, zz, yz, xz, xy with engineering shear."""
            ...

    @property
    def table(self) -> dict[str, Floats]:
        """Stiffness matrix as columns by name and unit, (6,) each, with a row for each stress."""
        names = ["xyz"[a] + "xyz"[b] for a, b in VOIGT]
        return {"row [-]": np.arange(1.0, 7.0)} | columns_of("stiffness {} [Pa]", names, self.stiffness)

    @property
    def drawn(self) -> dict[str, Floats]:
        """Young's moduli by direction in the three coordinate planes [Pa], (181,) each, over the angle [degree].

        With the compliance S and the direction n, 1 / E = s·S s, where s are the components of the stress n⊗n.
        """
        S, angle = np.linalg.inv(self.stiffness), np.linspace(0.0, np.pi, _DIRECTIONS)
        found = {"angle in the plane [degree]": np.degrees(angle)}
        for a, b in ((0, 1), (1, 2), (2, 0)):
            n = np.zeros((len(angle), 3))
            n[:, a], n[:, b] = np.cos(angle), np.sin(angle)
            s = np.stack([n[:, i] * n[:, j] for i, j in VOIGT], axis=1)
            found[f"E from {'xyz'[a]} to {'xyz'[b]} [Pa]"] = 1.0 / np.einsum("ka,ab,kb->k", s, S, s)
        return found

    @property
    def isotropic(self) -> Isotropic:
        """Isotropic (Voigt) average of the stiffness."""
        return Isotropic.average(self.stiffness)

    @property
    def K(self) -> float:
        """Bulk modulus of the isotropic average [Pa]."""
        return self.isotropic.K

    @property
    def G(self) -> float:
        """Shear modulus of the isotropic average [Pa]."""
        return self.isotropic.G

    @property
    def E(self) -> float:
        """Young's modulus of the isotropic average [Pa]."""
        return self.isotropic.E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the isotropic average [-]."""
        return self.isotropic.nu
