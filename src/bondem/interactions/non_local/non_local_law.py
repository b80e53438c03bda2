"""The non-local law of Celigueta et al. (2020): the force of a bond follows from the mean stress of its two elements.

A bond of area A and normal n between centres L apart has the gap δ at its contact point, with the normal part δ_n
and the tangential part δ_t. The mean stress σ of its two elements follows from the forces of the step (or iteration)
before, and δ_t⁻ is δ_t at that step. With kn = A E / L and kt = A G / L, tension positive, the force is

    F = kn δ_n n + kt δ_t + e                                             eqs (2), (3), (6)
    e = A ν (tr σ - n·σ n) n + t - kt δ_t⁻,      t = A (σ n - (n·σ n) n)

The tangential part of F is thus t + kt (δ_t - δ_t⁻). The spring kt δ_t represents only half of the engineering shear
strain, and t adds the other half. The stress of an element of volume V is the symmetric part of

    σ = (1/V) Σ l ⊗ F,     l from its centre to the contact point         eq (1)

If `NonLocal.limited` is set, t - kt δ_t⁻ is shortened to the length of t where it is longer. The paper does not
mention this limit. Without the limit only the lag of the law restrains the rotation of an element.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal, overload

from bondem._checks import choice, instance, number
from bondem._plausibility import physical
from bondem.specimen.material import Material, of_material

#: Points of action of the force of a bond, and of l in eq (1): the centroid of the facet, or the line of centres.
Lever = Literal["facet", "contact"]
#: Definitions of A: areas of the facets of a body, or the authors' own weights on a lattice of spheres.
Areas = Literal["facet", "weighted"]
#: Definitions of V in eq (1): volume of the cell, or of the sphere, as printed.
Volume = Literal["cell", "sphere"]
# Number that avoids 0 / 0 and changes no other result [N²].
_NOTHING = 1e-200


@of_material
@dataclass(frozen=True, kw_only=True)
class NonLocal:
    """Bonds whose force follows from the mean stress σ of their two elements, with E and ν of the material.

        kn = E A / L    kt = G A / L    F = kn δ_n n + kt δ_t + e

    The docstring of the module `bondem.interactions.non_local.non_local_law` defines these symbols. e follows from σ
    and δ_t of the step before. The law has no potential, so that the work of e is a separate entry of the energy
    balance. There is no symmetric stiffness matrix, and there are no natural modes. The only moments are those of F.

    `bd.NonLocal(granite)` takes E and ν from a `bd.Material`.

    Attributes:
        E: Young's modulus of the material [Pa].
        nu: Poisson's ratio of the material [-], from 0 to below 0.5.
        lever: point of action of the force. "facet" is the centroid of the facet, with which every cell has the exact
            stress of a uniform strain. "contact" is a point on the line of centres, as in the paper. A lattice of
            spheres has this point in either case.
        areas: areas A. "facet" requires a body from `bd.connect(..., method="laguerre")`, and "weighted" a lattice of
            spheres (`bondem.interactions.non_local.contact_areas`).
        volume: V of eq (1): "cell" (estimated as Σ A l / 3 for spheres), or "sphere" as in the paper, with which
            stresses are too large and amplify themselves.
        limited: True to limit the tangential part of e, as the docstring of the module defines.

    Reference: Celigueta, Latorre, Arrufat and Oñate, non-local bonded DEM with fracture (2020), eqs (1) to (6).

    Raises:
        InputError: A value is outside its range.
    """

    title: ClassVar[str] = "non-local law"
    formulation: ClassVar[str] = "incremental"

    E: float
    nu: float
    lever: Lever = "facet"
    areas: Areas = "facet"
    volume: Volume = "cell"
    limited: bool = True

    if TYPE_CHECKING:

        @overload
        def __init__(
            self, material: Material, *, lever: Lever = "facet", areas: Areas = "facet", volume: Volume = "cell",
            limited: bool = True,
        ) -> None: ...  # fmt: skip
        @overload
        def __init__(
            self, *, E: float | Material, nu: float | Material, lever: Lever = "facet", areas: Areas = "facet",
            volume: Volume = "cell", limited: bool = True,
        ) -> None: ...  # fmt: skip

    def __post_init__(self) -> None:
        physical("NonLocal", "E", self.E)
        number("NonLocal", "nu", self.nu, least=0.0, below=0.5, advice="a Poisson's ratio in [0, 0.5)")
        choice("NonLocal", "lever", self.lever, Lever)
        choice("NonLocal", "areas", self.areas, Areas)
        choice("NonLocal", "volume", self.volume, Volume)
        instance("NonLocal", "limited", self.limited, bool, "True or False")

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))
