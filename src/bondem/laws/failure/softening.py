"""What the failure of a body of cells is made of: cracks of facets, and cells that yield."""

import math
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Slip:
    """How cells yield in shear (`bondem.laws.plasticity`): by Mohr–Coulomb, or on Drucker–Prager's cone.

    Attributes:
        cone: whether on the cone.
        cohesion: c, or k of the cone [Pa]; it falls with slip.
        strength: c cos φ, or k [Pa].
        slope: sin φ, or α [-].
        dilation: sin ψ, or β [-].
        fracture_energy: G_II, which slip dissipates until the cohesion is gone [J/m²]; inf where it stays.
    """

    cone: bool
    cohesion: float
    strength: float
    slope: float
    dilation: float
    fracture_energy: float

    def compressive(self, pressure: float = 0.0) -> float:
        """What a continuum bears along one axis under a pressure on its sides [Pa].

        (2 c cos φ + p (1 + sin φ)) / (1 - sin φ), or (k + p (1/√3 + 2 α)) / (1/√3 - α).
        """
        if self.cone:
            third = 1.0 / math.sqrt(3.0)
            return (self.strength + pressure * (third + 2.0 * self.slope)) / (third - self.slope)
        return (2.0 * self.strength + pressure * (1.0 + self.slope)) / (1.0 - self.slope)


@dataclass(frozen=True, kw_only=True)
class Surface:
    """A criterion that is a function of the stress tensor: reached where its index is 1.

    Attributes:
        function: of the stress (3, 3) [Pa], tension positive, and of the values; it returns the index.
        values: its parameters, in order.
    """

    function: Callable[..., float]
    values: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class Softening:
    """How facets crack in tension, and cells yield.

    Attributes:
        tension: f_t, the strength in uniaxial tension [Pa].
        fracture_energy: G_f of tension [J/m²]; 0 where facets break at once.
        friction: μ on the faces of cracks that have closed [-].
        slip: how cells yield, or None where they do not.
        surface: when facets begin to crack; None where the largest principal stress reaches `tension`.
    """

    tension: float
    fracture_energy: float
    friction: float
    slip: Slip | None
    surface: Surface | None = None
