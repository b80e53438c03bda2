"""Cohesion and friction on the traction of a bond or facet, with a tensile strength."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from bondem._checks import number
from bondem._compile import device
from bondem._types import Floats, PerBond
from bondem.laws.failure.criterion import SHEAR, TENSION, Criterion, Joint, columns


@dataclass(frozen=True, kw_only=True)
class MohrCoulomb(Criterion):
    """A bond or facet breaks where its traction reaches the tensile strength or slips against cohesion and friction.

        t_n ≥ tension        |t_s| + t_n tan φ ≥ c

    The traction is force over area, of a beam N/A and Q/A; moments do not count. Tension positive, so that pressure
    (t_n < 0) strengthens. Where tension > c / tan φ, the cohesion alone limits the traction.

    Attributes:
        tension: tensile strength [Pa].
        cohesion: c [Pa].
        friction_angle: φ [rad], in [0, π/2).

    Raises:
        InputError: a strength that is not positive, or an angle outside [0, π/2).
    """

    kind: ClassVar[int] = 1
    needs_beams: ClassVar[bool] = False

    tension: float
    cohesion: float
    friction_angle: float

    def __post_init__(self) -> None:
        super().__post_init__()
        number("MohrCoulomb", "tension", self.tension, unit="Pa", above=0.0, advice="a positive strength in Pa")
        number("MohrCoulomb", "cohesion", self.cohesion, unit="Pa", above=0.0, advice="a positive strength in Pa")
        number(
            "MohrCoulomb", "friction_angle", self.friction_angle, unit="rad", least=0.0, below=0.5 * math.pi,
            advice="an angle in [0, π/2) rad",
        )  # fmt: skip

    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        tension, cohesion = self.tension * factor, self.cohesion * factor
        slope = math.tan(self.friction_angle)
        return columns(1.0 / (joint.area * tension), 1.0 / (joint.area * cohesion), slope)

    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        s = coefficients.T
        return np.maximum(s[0], s[1] * np.sqrt(1.0 + s[2] ** 2)), np.zeros_like(s[0])


@device
def mohr_coulomb_index(load, s):
    """Index and mode of a bond or facet that bears N, Q."""
    along, across = load[0] * s[0], (load[1] + load[0] * s[2]) * s[1]
    return (along, TENSION) if along >= across else (across, SHEAR)
