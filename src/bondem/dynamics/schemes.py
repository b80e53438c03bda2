"""Time integration schemes, as three coefficients of one update.

Every scheme closes a step by v += finish · a and opens the next by v += begin · a, x += dt v + extra · a. Angular
velocities follow the same update (ω̇ = τ/I for a sphere), and orientations follow it through the exponential map.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

from bondem._checks import number


class Scheme(ABC):
    """An explicit scheme for second-order motion."""

    @property
    @abstractmethod
    def critical(self) -> float:
        """Largest stable ω_max dt [-]."""

    @property
    @abstractmethod
    def conserves(self) -> bool:
        """True if the energy balance closes, to second order in the step."""

    @abstractmethod
    def coefficients(self, dt: float) -> tuple[float, float, float]:
        """Return the factors of the acceleration in a step of the duration dt [s].

        Returns:
            Factors finish, begin [s] and extra [s²]. The acceleration a at the end of a step adds finish · a to the
            velocity v; the next step begins with v += begin · a and moves x by dt v + extra · a.
        """


@dataclass(frozen=True)
class VelocityVerlet(Scheme):
    """The velocity Verlet scheme: second order, symplectic, no dissipation; stable for ω dt < 2.

    Reference: André et al. (2012) eqs (5), (6), with all positions advanced before any force.
    """

    @property
    def critical(self) -> float:
        return 2.0

    @property
    def conserves(self) -> bool:
        return True

    def coefficients(self, dt: float) -> tuple[float, float, float]:
        return 0.5 * dt, 0.5 * dt, 0.0


@dataclass(frozen=True)
class TchamwaWielgosz(Scheme):
    """The Tchamwa–Wielgosz scheme: first order, dissipates high frequencies.

    A step is x⁺ = x + dt v + φ dt² a, v⁺ = v + dt a. It is stable for ω dt < 2 / √(2φ - 1). It is the scheme of the
    reference (Mahéo et al. 2009) cited by André et al. (2012). The decentred scheme in their eqs (17), (18) is
    another one, and unstable for φ > 1.

    Attributes:
        phi: dissipation φ >= 1 [-]; 1 dissipates nothing, and a smaller value raises InputError.
    """

    phi: float = 1.3

    def __post_init__(self) -> None:
        number("TchamwaWielgosz", "phi", self.phi, least=1.0, advice="a dissipation of at least 1")

    @property
    def critical(self) -> float:
        return 2.0 / math.sqrt(2.0 * self.phi - 1.0)

    @property
    def conserves(self) -> bool:
        return False

    def coefficients(self, dt: float) -> tuple[float, float, float]:
        return 0.0, dt, (self.phi - 1.0) * dt * dt
