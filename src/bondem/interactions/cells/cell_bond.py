"""The cell law: facets between the cells of a body, with the material's own E and ν."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal, overload

from bondem._checks import choice, number
from bondem._plausibility import physical
from bondem.specimen.material import Material, of_material

#: Parts of the relative rotation of two cells that strain the facet between them.
FacetRotation = Literal["bending", "full", "none"]


@of_material
@dataclass(frozen=True, kw_only=True)
class CellBond:
    """Cells of an elastic material, joined at their facets; needs a body from `bd.connect(..., method="laguerre")`.

    A facet of area A lies between cells i and j, whose centres are L apart along its normal. Its two faces open by δ.
    A cell of volume V has the dilatation θ. With G = E / 2(1+ν) and λ = E ν / (1+ν)(1-2ν) the energy is

        U = Σ facets ½ (2 G A / L) |δ|² + Σ facets ½ ρ·H ρ + Σ cells ½ V λ θ²,   V_p θ_p = Σ A w_p m_p·δ

    where ρ is the relative rotation and H the resistance of the facet to it. w_p is the share of the opening on the
    side of cell p. A w_p m_p, near A w_p n, is the balanced share of the facet. Shares sum to zero over each cell and
    give every uniform strain its dilatation. Each uniform stress is therefore exact in every cell. Gradients of θ add
    the energy of bending. Facets on the surface open until they carry no traction. The law needs no calibration: E
    and ν are those of the material, for -1 < ν < ½. Tension is positive.

    `bd.CellBond(granite)` takes E and ν from a `bd.Material`.

    Attributes:
        E: Young's modulus of the material [Pa].
        nu: Poisson's ratio of the material [-].
        facet_rotation: part of a relative rotation that strains a facet: "bending" (about the two axes in its plane),
            "full" (also twist) or "none".

    References: with plain shares A w n and without gradients this elastic law is that of Mka3D (Mariotti 2007;
    Monasse and Mariotti 2012, arXiv 0907.2202), except that facets bend with E I/L and twist with G I_p/L there. At
    ν = 0 each facet is that of the rigid-body-spring lattice of Bolander and Saito (1998), which PFC
    (`springnetwork`, since version 7) extends to other ν by fictitious stresses (Asahina et al. 2015, 2017; Rasmussen
    2021). The page "The cell law" of the documentation compares these and other works.

    Raises:
        InputError: A value is outside its physical range.
    """

    title: ClassVar[str] = "cell law"
    formulation: ClassVar[str] = "total"

    E: float
    nu: float
    facet_rotation: FacetRotation = "bending"

    if TYPE_CHECKING:

        @overload
        def __init__(self, material: Material, *, facet_rotation: FacetRotation = "bending") -> None: ...
        @overload
        def __init__(
            self, *, E: float | Material, nu: float | Material, facet_rotation: FacetRotation = "bending"
        ) -> None: ...

    def __post_init__(self) -> None:
        physical("CellBond", "E", self.E)
        number("CellBond", "nu", self.nu, above=-1.0, below=0.5, advice="a Poisson's ratio in (-1, 0.5)")
        choice("CellBond", "facet_rotation", self.facet_rotation, FacetRotation)

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))

    @property
    def lame(self) -> float:
        """Lamé's λ [Pa]."""
        return self.E * self.nu / ((1.0 + self.nu) * (1.0 - 2.0 * self.nu))
