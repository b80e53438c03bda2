"""Elliptic criterion: breakage by elongation and bending angle of a beam together."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from bondem._checks import number
from bondem._types import Floats, PerBond
from bondem.damage.criteria.criterion import BondCriterion, Joint, columns

# Share of the bound of forces from which on deformations are evaluated: strongly rotated beams are softer than the
# linear ones for which the bound holds.
_MARGIN = 0.5


@dataclass(frozen=True, kw_only=True)
class Elliptic(BondCriterion):
    """Breakage of a beam where elongation and bending together reach their limits.

        (ε⁺ / elongation)² + max(|θ_i|, |θ_j|) / rotation ≥ 1

    with ε = (ℓ - L) / L, only where positive. θ_i and θ_j are the angles between the axis of the beam and two axes
    that are fixed to its ends and agree with it at rest. In ε and θ the limit is a parabola; the name is that of the
    literature. Bonds without bending stiffness are evaluated in every step, because no force indicates their angles.

    Attributes:
        elongation: ε at which a straight beam breaks [-].
        rotation: θ at which a beam of constant length breaks [rad].

    Reference: Carmona, Wittel, Kun and Herrmann (2008), eq. (5) of the preprint arXiv:0711.2993. There ε² also counts
    in compression, and each of the two limits scatters by a Weibull distribution of its own. Here compression breaks
    nothing, and both limits of a bond share one factor.

    Raises:
        InputError: A limit is not positive.
    """

    kind: ClassVar[str] = "elliptic"

    elongation: float
    rotation: float

    def __post_init__(self) -> None:
        super().__post_init__()
        number("Elliptic", "elongation", self.elongation, above=0.0)
        number("Elliptic", "rotation", self.rotation, unit="rad", above=0.0)

    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        return columns(1.0 / (self.elongation * factor), 1.0 / (self.rotation * factor))

    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        k, L, s = joint.beam, joint.length, coefficients.T
        near, far = k.lever, L - k.lever
        # moments at the centres over the angles of the ends; the softer of the two ways to bend
        a, b, c = k.ks * near**2 + k.kb, k.ks * near * far - k.kb, k.ks * far**2 + k.kb
        with np.errstate(divide="ignore", invalid="ignore"):
            soft = 0.5 * (a + c) - np.sqrt((0.5 * (a - c)) ** 2 + b**2)
            soft = np.where(soft > 1e-9 * (a + c), soft, 0.0)
            # (ε / ε_c)² + … ≥ 1 only where ε / ε_c + … ≥ 1
            return s[0] / (k.kn * L * _MARGIN), s[1] / (soft * _MARGIN)

    def pulled(self, joint: Joint, coefficients: Floats) -> PerBond:
        return joint.beam.kn * joint.length / coefficients[:, 0]
