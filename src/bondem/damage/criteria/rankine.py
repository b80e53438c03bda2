"""Rankine criterion: cracks where the largest principal stress of the material reaches a strength."""

from dataclasses import dataclass

from bondem._plausibility import physical
from bondem.damage.bilinear import Bilinear
from bondem.damage.cohesive_softening import Softening, check_crack
from bondem.damage.criteria.criterion import Criterion


@dataclass(frozen=True, kw_only=True)
class Rankine(Criterion):
    """Cracking of facets of cells in tension, where the largest principal stress reaches the strength.

        σ1(σ*) ≥ tension,     σ* = σ̄ + Δ⊗n + n⊗Δ - (Δ·n) n⊗n,     Δ = t - σ̄ n

    with σ̄ the mean stress of the two cells and t the traction of the facet: σ* is the mean tensor modified to agree
    with that traction. A facet in compression must also reach the strength by its traction alone: t_s² ≥ tension
    (tension - t_n).

    From then on the facet softens by its traction along the three present principal directions e_a of that stress.
    t·e_a follows a straight line from f_t |n·e_a| to the opening 2 G_f / f_t. With a `bd.Bilinear` it follows two
    lines, as for concrete. A crack therefore dissipates G_f per area of the crack however its facets zigzag. Each
    direction softens separately, so that a load along another one meets the strength of that direction
    (`core/laws/softening.hpp`). Without a fracture energy the facet breaks at once.

    For an entry of `failure=` for a pair of regions, the traction of a facet between them decides alone: t_n ≥
    tension, and G_f per facet area. Bonds of the non-local law break at once where σ1 of the mean stress σ̄ itself
    reaches the strength; the friction of their faces is that of the contact law. The criterion does not apply to
    beams.

    Attributes:
        tension: f_t [Pa].
        fracture_energy: G_f [J/m²]; None for brittle facets.
        friction: μ on the faces of closed cracks [-].
        curve: softening curve of cracks; None for a straight line.

    Raises:
        InputError: A strength or energy is not positive, the friction is negative, or a curve lacks an energy.
    """

    tension: float
    fracture_energy: float | None = None
    friction: float = 0.0
    curve: Bilinear | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        physical("Rankine", "tension", self.tension)
        check_crack("Rankine", self.fracture_energy, self.friction, self.curve)

    @property
    def principal(self) -> tuple[float, float, float] | None:
        return 1.0 / self.tension, 0.0, 0.0

    @property
    def softening(self) -> Softening:
        return Softening(
            tension=self.tension, fracture_energy=self.fracture_energy or 0.0, friction=self.friction, slips=(),
            curve=self.curve,
        )  # fmt: skip
