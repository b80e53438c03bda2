"""The non-local law of Celigueta, Oñate et al.: a bond follows the mean stress of its two elements.

A bond of area A between centres L apart has the gap δ at its contact point, with the normal part δ_n and the
tangential part δ_t; σ is the mean stress of its two elements, found with the forces of the step (or iteration)
before. With kn = A E / L and kt = A G / L, tension positive,

    F = kn δ_n n + kt δ_t + e                                             eqs (2), (3), (6)
    e = A ν (tr σ - n·σ n) n + t - kt δ_t⁻,      t = A (σ n - (n·σ n) n)

where δ_t⁻ is the tangential gap when σ was found, so that in one step F_t changes by kt (δ_t - δ_t⁻) from A τ. The
spring kt δ_t represents only half of the engineering shear strain; A τ supplies the other half. The stress of an
element of volume V is the symmetric part of

    σ = (1/V) Σ l ⊗ F,     l from its centre to the contact point         eq (1)

The limiter keeps the length of t - kt δ_t⁻ at most |t|, and so each of its components at most |A τ|, for any
axes. The paper does not print it; without it, only the lag of the law itself restrains the rotation of an element.
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
    """Bonds that follow the mean stress of their two elements, with the material's own E and ν.

        kn = E A / L    kt = G A / L    F = kn δ_n n + kt δ_t + e(σ, δ_t of the step before)

    The law has no potential. The work of its extra force e is therefore a separate entry of the energy balance, and
    there is no symmetric stiffness and no mode. Stress lags one step or one iteration behind. The only moments are
    those of forces. The page "The non-local law" of the documentation defines e and the stresses.

    `bd.NonLocal(granite)` takes E and ν from a `bd.Material`.

    Attributes:
        E: Young's modulus of the material [Pa].
        nu: Poisson's ratio of the material [-], at least 0.
        lever: point of action. "facet" is the centroid of the facet, where a uniform strain has its exact stress in
            every cell. "contact" is the line of centres, as printed; a lattice of spheres has no other.
        areas: "facet" (needs a body from `bd.connect(..., method="laguerre")`) or "weighted" (a lattice of spheres,
            see `bondem.interactions.non_local.contact_areas`).
        volume: V of eq (1): "cell", or "sphere" as printed, which gives too large stresses that amplify themselves.
        limited: True to limit the extra shear force.

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
