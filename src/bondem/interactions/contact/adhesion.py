"""Adhesion of spheres that touch or are close to each other, as a potential well."""

import math
from dataclasses import dataclass

from bondem._checks import number
from bondem._types import Floats


@dataclass(frozen=True)
class Adhesion:
    """Attraction of spheres that touch, and of spheres up to a gap, for `adhesion=` of a contact law.

        F = F_c (g < 0),   F_c (1 - g / D) (0 <= g < D),   F_c = strength A

    with g the gap, D the reach and A = π min(Ri, Rj)² (at a wall π R²). The force adds to the spring and the
    dashpots of the contact, and depends on the gap alone. Its potential is a well of depth F_c D / 2 at the gap 0.
    Spheres without other forces rest at the overlap where the spring balances F_c, and F_c pulls them apart.
    Friction and rolling resistance have the force of the spring as their normal force. Pairs that a bond joins or
    has joined do not adhere, because broken surfaces do not heal, unless the contact law has `parallel=True`.

    This is the adhesion of PFC's adhesive rolling resistance linear model, with the force `adh_f0` = strength A and
    the range `adh_d0` = reach. Yade's `normalCohesion` is strength π.

    Attributes:
        strength: pull-off force over the area A [Pa].
        reach: gap up to which the force acts, at most the radius of the smallest element [m].

    Raises:
        InputError: A value is not positive.
    """

    strength: float
    reach: float

    def __post_init__(self) -> None:
        number("Adhesion", "strength", self.strength, unit="Pa", above=0.0, advice="a positive stress")
        number("Adhesion", "reach", self.reach, unit="m", above=0.0, advice="a positive gap")

    def pull_off(self, radius: Floats) -> Floats:
        """Return the largest attraction [N], (n,), of two spheres of each radius [m], or of a sphere and a wall."""
        return self.strength * math.pi * radius**2


def numbers_of(adhesion: Adhesion | None) -> tuple[float, float]:
    """Return strength [Pa] and reach [m], zeros without adhesion."""
    return (0.0, 0.0) if adhesion is None else (adhesion.strength, adhesion.reach)
