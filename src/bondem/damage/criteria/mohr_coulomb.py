"""Mohr–Coulomb criterion: tensile strength, cohesion and friction of bonds, facets or cells."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from bondem._checks import number
from bondem._plausibility import physical
from bondem._types import Floats, PerBond
from bondem.damage.bilinear import Bilinear
from bondem.damage.cohesive_softening import Slip, Softening, check_crack, check_slip
from bondem.damage.criteria.criterion import BondCriterion, Joint, columns
from bondem.errors import InputError

_STRENGTH = "a positive strength in Pa, or 0 for both tension and cohesion of a joint without cohesion"


@dataclass(frozen=True, kw_only=True)
class MohrCoulomb(BondCriterion):
    """Breakage of bonds or facets whose traction reaches the tensile strength, or exceeds cohesion and friction.

        t_n ≥ tension        |t_s| + t_n tan φ ≥ c

    The traction is force over area, for a beam N/A and Q/A; moments do not count. Tension is positive, so that
    compression (t_n < 0) strengthens. If tension > c / tan φ, the cohesion alone limits the traction.

    With a fracture energy, beams that reach this limit soften (`core/laws/beam_softening.hpp`). They absorb G_f times
    their section in tension and G_II times it in shear; G_II is finite and ψ = 0 for them. In bodies of cells the
    criterion is then that of the material. Facets crack where the largest principal stress reaches the tensile
    strength, as for `bd.Rankine`, and cells yield where

        (σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ ≥ r c cos φ

    on their mean stress. The cohesion falls (r from 1 to 0) with the mean slip of the cells half a band width away,
    so that a band dissipates G_II per area. Friction remains. Facets of a cell that has slipped and has no cohesion
    break.

    An entry of `failure=` for a pair of regions describes a plane between them, by the traction of its facets. A
    facet opens from t_n = tension on and slips from |t_s| + t_n tan φ = c on, with G_f and G_II per facet area. A
    joint without cohesion has tension = 0, cohesion = 0 and no energies; every load opens it or lets it slip.

    Bonds of the non-local law break at once where the mean stress of their two elements reaches the criterion in any
    direction, after Celigueta et al. (2020), eq (9):

        σ1 ≥ tension        (σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ ≥ c cos φ

    Their paper has no separate tensile strength: with tension = c / tan φ, the tip of the cone, it has no effect.

    Attributes:
        tension: tensile strength [Pa]; 0, as `cohesion`, for a joint without cohesion.
        cohesion: c [Pa].
        friction_angle: φ [rad], in [0, π/2).
        fracture_energy: G_f of tension [J/m²]; None for bonds or facets that break at once, by their traction.
        fracture_energy_shear: G_II of slip [J/m²], for cells inf for a constant cohesion; 10 G_f by default.
        dilatancy: ψ of cells [rad], in [0, φ]; 0 for a pair of regions, as planes do not dilate.
        band_width: width of shear bands between cells [m], by which G_II becomes a work per volume; None for four
            cells, of the size of each.
        curve: softening curve of cracks between cells; None for a straight line, the only one for beams.

    Raises:
        InputError: A strength, energy or width is not positive, φ is outside [0, π/2) or ψ outside [0, φ]. Or a
            parameter of softening or yielding is given without the fracture energy of tension.
    """

    kind: ClassVar[str] = "mohr_coulomb"
    needs_beams: ClassVar[bool] = False

    tension: float
    cohesion: float
    friction_angle: float
    fracture_energy: float | None = None
    fracture_energy_shear: float | None = None
    dilatancy: float = 0.0
    band_width: float | None = None
    curve: Bilinear | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        strengths = {"tension": self.tension, "cohesion": self.cohesion}
        least = [number("MohrCoulomb", *one, unit="Pa", least=0.0, advice=_STRENGTH) for one in strengths.items()]
        for name, value in strengths.items() if any(least) else ():
            physical("MohrCoulomb", name, value, advice=_STRENGTH)
        number(
            "MohrCoulomb", "friction_angle", self.friction_angle, unit="rad", least=0.0, below=0.5 * math.pi,
            advice="an angle in [0, π/2) rad",
        )  # fmt: skip
        number("MohrCoulomb", "dilatancy", self.dilatancy, unit="rad", least=0.0, advice="an angle in [0, φ] rad")
        number("MohrCoulomb", "friction_angle - dilatancy", self.friction_angle - self.dilatancy, least=0.0)
        if not any(least):
            self._check_joint()
        check_crack("MohrCoulomb", self.fracture_energy, 0.0, self.curve)
        check_slip("MohrCoulomb", self.fracture_energy, self.fracture_energy_shear, self.dilatancy, self.band_width)

    def _check_joint(self) -> None:
        """Raise InputError for options that a joint without strength does not have."""
        options = "on", "fracture_energy", "fracture_energy_shear", "dilatancy", "band_width", "curve"
        given = [name for name in options if getattr(self, name) is not None and getattr(self, name) != 0.0]
        if given:
            raise InputError(f"MohrCoulomb: a joint of tension = 0 and cohesion = 0 has no {given[0]}; leave it out")

    @property
    def principal(self) -> tuple[float, float, float] | None:
        sine, twice = math.sin(self.friction_angle), 2.0 * self.cohesion * math.cos(self.friction_angle)
        return 1.0 / self.tension, (1.0 + sine) / twice, (1.0 - sine) / twice

    @property
    def energies(self) -> tuple[float, float] | None:
        opening, shear = self.fracture_energy, self.fracture_energy_shear
        return None if opening is None else (opening, 10.0 * opening if shear is None else shear)

    @property
    def softening(self) -> Softening | None:
        if self.energies is None or self.fracture_energy is None:
            return None
        slip = Slip(
            cone=False, cohesion=self.cohesion, strength=self.cohesion * math.cos(self.friction_angle),
            slope=math.sin(self.friction_angle), dilation=math.sin(self.dilatancy),
            fracture_energy=self.energies[1], width=self.band_width,
        )  # fmt: skip
        return Softening(
            tension=self.tension, fracture_energy=self.fracture_energy, friction=math.tan(self.friction_angle),
            slips=(slip,), curve=self.curve,
        )  # fmt: skip

    def coefficients(self, joint: Joint, factor: PerBond) -> Floats:
        tension, cohesion = self.tension * factor, self.cohesion * factor
        slope = math.tan(self.friction_angle)
        return columns(1.0 / (joint.area * tension), 1.0 / (joint.area * cohesion), slope)

    def bounds(self, joint: Joint, coefficients: Floats) -> tuple[PerBond, PerBond]:
        s = coefficients.T
        return np.maximum(s[0], s[1] * np.sqrt(1.0 + s[2] ** 2)), np.zeros_like(s[0])

    def pulled(self, joint: Joint, coefficients: Floats) -> PerBond:
        s = coefficients.T
        return 1.0 / np.maximum(s[0], s[1] * s[2])  # at most the tension at the tip of the cone

    def pulled_and_sheared(self, joint: Joint, factor: PerBond, arm: PerBond) -> tuple[PerBond, PerBond]:
        each = self.coefficients(joint, factor)
        return self.pulled(joint, each), 1.0 / each[:, 1]
