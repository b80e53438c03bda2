"""Linear criterion: the sum of the loads of a bond, each over its strength, as in LAMMPS."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from bondem._checks import number
from bondem._types import Floats, PerBond
from bondem.damage.criteria.criterion import BondCriterion, Joint, columns


@dataclass(frozen=True, kw_only=True)
class LinearSum(BondCriterion):
    """Breakage of a bond where the shares of its strengths sum up to one.

        N / force + |Q| / shear + |M| / bending + |T| / twisting ≥ 1

    Tension is positive, and N counts with its sign, so that compression strengthens. M is the larger of the moments
    at both ends for beams, and that at the contact point for parallel and contact bonds.

    Attributes:
        force: largest tensile force alone [N].
        shear: largest shear force alone [N].
        bending: largest bending moment alone [N·m].
        twisting: largest twisting moment alone [N·m].

    Reference: `bond_style bpm/rotational` of LAMMPS, after Wang (2009). Its manual and its source sum the same four
    shares, N with its sign, and cut off the sum at 0. Its moments are k_b times the angle of bending and k_t times
    that of twisting, without the contribution of the shear force towards the ends. They are those at the contact
    point, as here for parallel and contact bonds. Three things differ. LAMMPS weakens bonds by 1 - index⁴ before they
    break (unless `smooth no` is set). Its source reads the limit of twisting before that of bending, while its manual
    lists them the other way round. Its moments grow with the angle, not with its sine.

    Raises:
        InputError: A strength is not positive.
    """

    kind: ClassVar[str] = "linear_sum"

    force: float
    shear: float
    bending: float
    twisting: float

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, unit in (("force", "N"), ("shear", "N"), ("bending", "N·m"), ("twisting", "N·m")):
            number("LinearSum", name, getattr(self, name), unit=unit, above=0.0, advice=f"a positive {unit}")

    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        return columns(*(1.0 / (s * factor) for s in (self.force, self.shear, self.bending, self.twisting)))

    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        s = coefficients.T
        return np.hypot(s[0], s[1]), np.hypot(s[2], s[3])
