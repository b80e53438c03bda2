"""What the failure of a body of cells is made of: cracks of facets, and cells that yield."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Slip:
    """How cells yield in shear (`bondem.laws.plasticity`).

    Attributes:
        cohesion: c [Pa].
        friction_angle: φ [rad].
        dilatancy: ψ [rad].
        fracture_energy: G_II, which slip dissipates until the cohesion is gone [J/m²]; inf where it stays.
    """

    cohesion: float
    friction_angle: float
    dilatancy: float
    fracture_energy: float


@dataclass(frozen=True, kw_only=True)
class Softening:
    """How facets crack in tension, and cells yield.

    Attributes:
        tension: f_t, the largest principal stress [Pa].
        fracture_energy: G_f of tension [J/m²]; 0 where facets break at once.
        friction: μ on the faces of cracks that have closed [-].
        slip: how cells yield, or None where they do not.
    """

    tension: float
    fracture_energy: float
    friction: float
    slip: Slip | None
