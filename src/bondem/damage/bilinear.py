"""Softening curve of two lines, with a long tail at low stress, as in concrete."""

from dataclasses import dataclass

from bondem._checks import number
from bondem.errors import InputError


@dataclass(frozen=True, kw_only=True)
class Bilinear:
    """Softening curve of a crack: two lines that meet at the stress `stress` f_t and the opening `opening` G_f / f_t.

    The first begins at f_t. The second ends at the opening (2 - `opening`) / `stress` G_f / f_t, so that the area
    under the curve is G_f. The default is Petersson's curve for concrete: a third of the strength at 0.8 G_f / f_t,
    zero at 3.6 G_f / f_t.

    Attributes:
        stress: stress at the kink, over f_t [-], in (0, 1).
        opening: opening at the kink, over G_f / f_t [-], above 0, at most 2 - 2 `stress`, where both lines are one.

    Raises:
        InputError: The kink is above the straight line, or a value is out of range.

    Reference: Petersson (1981), "Crack growth and development of fracture zones in plain concrete and similar
    materials", report TVBM-1006, Lund.
    """

    stress: float = 1.0 / 3.0
    opening: float = 0.8

    def __post_init__(self) -> None:
        number("Bilinear", "stress", self.stress, above=0.0, below=1.0, advice="a share of the strength in (0, 1)")
        number("Bilinear", "opening", self.opening, above=0.0, advice="a positive opening in G_f / f_t")
        if self.opening > 2.0 - 2.0 * self.stress:
            raise InputError(
                f"Bilinear: opening = {self.opening:g} at stress = {self.stress:g} is above the straight line; give"
                f" at most 2 - 2 stress = {2.0 - 2.0 * self.stress:.4g}"
            )

    @property
    def last(self) -> float:
        """Opening at zero stress, over G_f / f_t [-]."""
        return (2.0 - self.opening) / self.stress

    @property
    def steep(self) -> float:
        """Opening where the first line would reach zero, over `last` [-]."""
        return self.opening / ((1.0 - self.stress) * self.last)
