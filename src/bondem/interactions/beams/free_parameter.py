"""Parameter of a bond law that controls Poisson's ratio: its notation and usual values."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class FreeParameter:
    """Dimensionless parameter of a bond law that calibration varies, because ν depends most on it.

    Attributes:
        name: keyword of the law.
        meaning: meaning in words.
        symbol: symbol as plain text; text after an underscore is a subscript.
        tex: symbol for figures.
        search: range in which calibration searches [-].
        curve: values of the calibration curve of the law, ascending [-]; empty for a law without one.
        fitted: values at which the surface correction is fitted to the law [-].
        held_out: values at which the correction is tested on the law, at r̃ = 0.7 [-].
    """

    name: str
    meaning: str
    symbol: str
    tex: str
    search: tuple[float, float]
    curve: tuple[float, ...] = ()
    fitted: tuple[float, ...] = ()
    held_out: tuple[float, ...] = ()

    @property
    def is_radius(self) -> bool:
        """True if the free parameter is the radius of the bonds."""
        return self.name == RADIUS_RATIO.name

    @property
    def label(self) -> str:
        """Label of the axis of this parameter in figures."""
        return f"{self.meaning} {self.tex} [-]"

    @property
    def scale(self) -> str:
        """Scale of the axis of this parameter: "log" if the search spans more than a decade, else "linear"."""
        return "log" if self.search[1] > 10.0 * self.search[0] else "linear"


#: r̃ of beams: slender beams bend more, compared with their elongation, than stubby ones.
RADIUS_RATIO = FreeParameter(
    name="radius_ratio", meaning="radius ratio", symbol="r̃", tex=r"$\tilde{r}$", search=(0.1, 0.9),
    # stubbier bonds than 1 are no longer inside the elements
    curve=(0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.75, 0.8, 0.9, 1.0),
)  # fmt: skip
