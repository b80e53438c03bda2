"""Gauges: what is read off while a run goes on, as region × quantity × reduction."""

from dataclasses import dataclass

from bondem.errors import InputError
from bondem.specimen.regions import Region

QUANTITIES = ("displacement", "velocity", "rotation", "angular_velocity", "force")
WALL_QUANTITIES = ("displacement", "force", "growth")
REDUCTIONS = ("mean", "sum", "max_abs")


@dataclass(frozen=True)
class Gauge:
    """Three components over time, sampled inside the compiled loop.

    Attributes:
        region: who.
        quantity: "displacement" [m], "velocity" [m/s], "rotation" [rad], "angular_velocity" [rad/s] or
            "force" [N], that of loads and supports on the region.
        reduction: "mean", "sum" or "max_abs" over the elements, component by component.
    """

    region: Region
    quantity: str
    reduction: str = "mean"

    def __post_init__(self) -> None:
        if self.quantity not in QUANTITIES:
            raise InputError(f"Gauge: unknown quantity '{self.quantity}'; choose from {', '.join(QUANTITIES)}")
        if self.reduction not in REDUCTIONS:
            raise InputError(f"Gauge: unknown reduction '{self.reduction}'; choose from {', '.join(REDUCTIONS)}")


@dataclass(frozen=True)
class WallGauge:
    """Three components of a wall over time, sampled inside the compiled loop.

    Attributes:
        wall: its number among the walls of the model.
        quantity: "displacement" [m]; "force" of the elements on the wall [N]; or "growth": change of a cylinder's
            radius [m], force on it that would change the radius [N], sum of the normal forces [N].
    """

    wall: int
    quantity: str

    def __post_init__(self) -> None:
        if self.quantity not in WALL_QUANTITIES:
            raise InputError(
                f"WallGauge: unknown quantity '{self.quantity}'; choose from {', '.join(WALL_QUANTITIES)}"
            )


AnyGauge = Gauge | WallGauge
