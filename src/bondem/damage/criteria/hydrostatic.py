"""Hydrostatic criterion: cracks where the mean stress of the material reaches a strength."""

from dataclasses import dataclass

from bondem._plausibility import physical
from bondem.damage.bilinear import Bilinear
from bondem.damage.cohesive_softening import Softening, StressIndex, check_crack
from bondem.damage.criteria.criterion import Criterion


@dataclass(frozen=True, kw_only=True)
class Hydrostatic(Criterion):
    """Cracking of facets of cells where the mean stress reaches the strength.

        (σ1 + σ2 + σ3) / 3 ≥ tension     principal stresses of σ* of `bd.Rankine`, for facets in tension

    A bar breaks at three times this stress. With a fracture energy a crack softens as for `bd.Rankine`, up to the
    opening 2 G_f / f_t with f_t = 3 `tension`; without one it breaks at once. For bodies of cells only.

    Attributes:
        tension: largest mean stress [Pa].
        fracture_energy: G_f of a bar that is torn apart [J/m²]; None for brittle facets.
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
        physical("Hydrostatic", "tension", self.tension)
        check_crack("Hydrostatic", self.fracture_energy, self.friction, self.curve)

    @property
    def softening(self) -> Softening:
        return Softening(
            tension=3.0 * self.tension, fracture_energy=self.fracture_energy or 0.0, friction=self.friction,
            slips=(), surface=StressIndex(function="mean_stress", values=(self.tension,)),
            curve=self.curve,
        )  # fmt: skip
