"""Three-point bending of notched beams, as cases."""

from dataclasses import dataclass

from bondem.geometry.elementary_shapes import Box
from bondem.geometry.shape import Shape
from validation.cases.case import Line

# A roller is a line; so thin is the box about which cells are fine [m].
_THIN = 1e-6


@dataclass(frozen=True)
class BentBeam:
    """A beam from x = 0 to its length, y = 0 to its depth, on two rollers below, pressed by one above.

    Rollers are forces on rows of cells, each through its line and with nothing that keeps cells from turning.

    Attributes:
        length, depth, width: of the beam [m].
        supports: where the rollers are, x [m].
        loaded: where it is pressed, x [m].
        notch: its middle x, depth and width [m], from below.
        gauge: distance of the knives of the mouth's gauge [m], or None.
    """

    length: float
    depth: float
    width: float
    supports: tuple[float, float]
    loaded: float
    notch: tuple[float, float, float]
    gauge: float | None = None

    @property
    def shape(self) -> Shape:
        """The beam and its notch."""
        at, deep, wide = self.notch
        slot = Box((wide, 2.0 * deep, 3.0 * self.width)).moved((at - 0.5 * wide, -deep, -self.width))
        return Box((self.length, self.depth, self.width)).cut(slot, name="notch")

    def about(self, reach: float, towards: float = 0.0) -> Shape:
        """The ligament within some distance to both sides [m], drawn out `towards` some x, and the three rollers."""
        at, deep, _ = self.notch
        low, high = min(at, at + towards) - reach, max(at, at + towards) + reach
        place: Shape = Box((high - low, self.depth - deep, self.width)).moved((low, deep, 0.0))
        lines = [(x, 0.0) for x in self.supports] + [(self.loaded, self.depth - _THIN)]
        for x, y in lines:
            place = place | Box((_THIN, _THIN, self.width)).moved((x - 0.5 * _THIN, y, 0.0))
        return place

    @property
    def held(self) -> tuple[Line, Line]:
        """The rollers below."""
        return Line(self.supports[0], 0.0), Line(self.supports[1], 0.0)

    @property
    def driven(self) -> tuple[Line, int]:
        """The roller above, which moves down."""
        return Line(self.loaded, self.depth), -1

    def spared(self, below: float, above: float) -> tuple[tuple[Line, float], ...]:
        """About the rollers nothing fails, so far from the two below and the one above [m]."""
        return (*((one, below) for one in self.held), *(((self.driven[0], above),) if above > 0.0 else ()))

    @property
    def mouth(self) -> tuple[Line, Line] | None:
        """Knives of the gauge."""
        if self.gauge is None:
            return None
        at = self.notch[0]
        return Line(at - 0.5 * self.gauge, 0.0), Line(at + 0.5 * self.gauge, 0.0)

    @property
    def ligament(self) -> float:
        """Area that a straight crack above the notch has [m²]."""
        return self.width * (self.depth - self.notch[1])
