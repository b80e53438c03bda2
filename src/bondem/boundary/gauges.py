"""Gauges: quantities that a run records of regions (`Gauge`) or walls (`WallGauge`), or strains (`StrainGauge`)."""

from dataclasses import dataclass
from typing import Literal

from bondem._checks import choice, count
from bondem.specimen.regions import Region, as_region

Quantity = Literal["displacement", "velocity", "rotation", "angular_velocity", "force"]
WallQuantity = Literal[
    "displacement", "velocity", "force", "growth", "rotation", "angular_velocity", "torque", "power"
]
Reduction = Literal["", "mean", "sum", "max_abs"]
# SI unit of each quantity but "growth", whose components have different ones.
_UNITS = {
    "displacement": "m", "velocity": "m/s", "rotation": "rad", "angular_velocity": "rad/s", "force": "N",
    "torque": "N·m", "power": "W",
}  # fmt: skip


@dataclass(frozen=True)
class Gauge:
    """Three components of a quantity of a region, recorded over the time of a run.

    Attributes:
        region: elements to observe.
        quantity: "displacement" [m], "velocity" [m/s], "rotation" [rad], "angular_velocity" [rad/s] or
            "force" [N], that of loads and supports on the region; a run raises InputError if it has none. On a face
            of cells it is that on the facets of the face; a run stops at each record to find it where other facets
            of its cells are loaded or held.
        reduction: "mean", "sum" or "max_abs" over the elements, component by component. The default is the sum for
            forces and the mean for all other quantities. Unknown names raise InputError.
    """

    region: Region
    quantity: Quantity
    reduction: Reduction = ""

    def __post_init__(self) -> None:
        as_region("Gauge", self.region)
        choice("Gauge", "quantity", self.quantity, Quantity)
        usual = "sum" if self.quantity == "force" else "mean"
        asked = choice("Gauge", "reduction", self.reduction, Reduction)
        object.__setattr__(self, "reduction", asked or usual)


@dataclass(frozen=True)
class WallGauge:
    """Three components of a quantity of a wall, recorded over the time of a run.

    Attributes:
        wall: index of the wall among the walls of the model; a run raises InputError if there is none.
        quantity: "displacement" [m]; "velocity" [m/s], for a driven wall that of the last step; "force" of the
            elements on the wall [N]; "growth", whose components are the change of the radius [m], the force that
            would change it [N], and the sum of the normal forces [N]; "rotation", a vector of at most π [rad];
            "angular_velocity" [rad/s]; "torque" of the elements about the point about which the wall turns [N·m]; or
            "power" of the wall on the elements [W], whose components are the power of its velocity and growth, that
            of its turn, and their sum.
    """

    wall: int
    quantity: WallQuantity

    def __post_init__(self) -> None:
        object.__setattr__(self, "wall", count("WallGauge", "wall", self.wall, advice="the number of a wall, from 0"))
        choice("WallGauge", "quantity", self.quantity, WallQuantity)


@dataclass(frozen=True)
class StrainGauge:
    """Normal strains along x, y and z over time [-], of the affine field closest to the displacements of a region.

    They are relative changes of length of lines of material, which were along x, y and z in the reference and turn
    with the region: a rotation, however large, gives no strain. A run with such a gauge stops at each record to
    evaluate it.

    Attributes:
        region: elements whose centres the field fits, four or more not in a plane; others raise InputError in a run.
    """

    region: Region

    def __post_init__(self) -> None:
        as_region("StrainGauge", self.region)


AnyGauge = Gauge | WallGauge | StrainGauge


def units_of(gauge: AnyGauge) -> tuple[str, str, str]:
    """Return the SI units of the three components of a gauge."""
    quantity = "" if isinstance(gauge, StrainGauge) else gauge.quantity
    one = _UNITS.get(quantity, "-")
    return ("m", "N", "N") if quantity == "growth" else (one, one, one)
