"""Gauges: what is read off while a run goes on, as region × quantity × reduction."""

from dataclasses import dataclass

from bondem._checks import choice, count
from bondem.specimen.regions import Region, as_region

QUANTITIES = ("displacement", "velocity", "rotation", "angular_velocity", "force")
WALL_QUANTITIES = ("displacement", "velocity", "force", "growth")
REDUCTIONS = ("mean", "sum", "max_abs")


@dataclass(frozen=True)
class Gauge:
    """Three components over time, sampled inside the compiled loop.

    Attributes:
        region: who.
        quantity: "displacement" [m], "velocity" [m/s], "rotation" [rad], "angular_velocity" [rad/s] or
            "force" [N], that of loads and supports on the region.
        reduction: "mean", "sum" or "max_abs" over the elements, component by component; unless given the sum of a
            force and the mean of all else.
    """

    region: Region
    quantity: str
    reduction: str = ""

    def __post_init__(self) -> None:
        as_region("Gauge", self.region)
        choice("Gauge", "quantity", self.quantity, QUANTITIES)
        usual = "sum" if self.quantity == "force" else "mean"
        asked = choice("Gauge", "reduction", self.reduction, ("", *REDUCTIONS))
        object.__setattr__(self, "reduction", asked or usual)


@dataclass(frozen=True)
class WallGauge:
    """Three components of a wall over time, sampled inside the compiled loop.

    Attributes:
        wall: its number among the walls of the model.
        quantity: "displacement" [m]; "velocity" [m/s], of a driven wall that over the last step; "force" of the
            elements on the wall [N]; or "growth": change of the radius [m], force on it that would change the
            radius [N], sum of the normal forces [N].
    """

    wall: int
    quantity: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "wall", count("WallGauge", "wall", self.wall, advice="the number of a wall, from 0"))
        choice("WallGauge", "quantity", self.quantity, WALL_QUANTITIES)


AnyGauge = Gauge | WallGauge
