"""Bodies of cells that yield, that crack along material planes or under strains that change, for devices."""

from collections.abc import Callable
from typing import Any

import bondem as bd
from tests.device_cases import Case
from tests.device_cracks import GAUGES, LAW, RANKINE, STEP, body, free, thrown

COULOMB = bd.MohrCoulomb(
    tension=4e6, cohesion=6e6, friction_angle=0.6, fracture_energy=50.0, fracture_energy_shear=500.0
)  # fmt: skip
CONE = bd.DruckerPrager(tension=3e6, compression=12e6, fracture_energy=50.0, fracture_energy_shear=500.0)
WEAK = bd.MohrCoulomb(
    tension=1e6, cohesion=1.5e6, friction_angle=0.4, fracture_energy=10.0, fracture_energy_shear=30.0
)  # fmt: skip


def halves(plane: Any, whole: Any = RANKINE) -> dict[Any, Any]:
    """Criteria of the bar, and of the material plane across its middle."""
    left = bd.Within(bd.Box((16e-3, 16e-3, 16e-3)))
    return {bd.Everything(): whole, (left, bd.Everything() - left): plane}


def warming(failure: Any, share: float = 1.0) -> bd.Model:
    """The bar between two walls, one of which moves, which grows and shrinks by two strains."""
    heat = [
        bd.Eigenstrain(-4e-4 * share, schedule=bd.Ramp(0.0, 1.0, 1e-5)),
        bd.Eigenstrain(6e-4 * share, bd.Index(range(40)), schedule=bd.Ramp(0.0, 1.0, 1.6e-5)),
    ]
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2.0 * share, 5e-6))]
    return bd.Model(body(), LAW, 2500.0, failure=failure, boundary=[*ends, *heat])


def pressed(failure: Any, length: int = 8) -> bd.Model:
    """The bar, pressed by a wall against another one and by a pressure that grows."""
    return bd.Model(body(length), LAW, 2500.0, failure=failure, boundary=[
        bd.Fix(bd.Face("x_min")),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, -6.0, 4e-6)),
        bd.Pressure(bd.Face("y_max"), 4e6, schedule=bd.Ramp(0.0, 1.0, 1e-5)),
        bd.Load(bd.Face("z_max"), force=(100.0, 0.0, -600.0), schedule=bd.Ramp(0.0, 1.0, 2e-5)),
    ])  # fmt: skip


CASES: dict[str, Callable[[], Case]] = {
    "crushed": lambda: (free(COULOMB), thrown((-4.0, 0.5, 0.8)), 240, STEP, {"every": 20}),
    "crushed by a cone": lambda: (
        free(CONE), thrown((-4.0, 0.5, 0.8)), 240, STEP, {"every": 20, "damping": bd.LocalDamping(0.05)}
    ),
    "crushed between walls": lambda: (
        pressed(COULOMB), thrown((-1.0, 0.0, 0.0)), 240, STEP, {"every": 20, "gauges": GAUGES}
    ),
    "crushed and touching": lambda: (
        free(COULOMB, contact=bd.LinearContact(E=40e9, friction=0.4)), thrown((-40.0, -12.0, -12.0), 10.0), 400,
        0.25 * STEP, {"every": 100},
    ),
    "planes": lambda: (free(halves(WEAK)), thrown((1.0, 0.8, 0.6), 0.3), 240, STEP, {"every": 20}),
    "planes that shear": lambda: (
        free(halves(WEAK, COULOMB)), thrown((-1.5, 0.8, 0.6), 0.3), 240, STEP,
        {"every": 20, "damping": bd.BondDamping(eta=0.1)},
    ),
    "warming and cracking": lambda: (
        warming(RANKINE), thrown((0.5, 0.0, 0.0)), 240, STEP, {"every": 20, "gauges": GAUGES}
    ),
    "warming and crushed": lambda: (
        warming(COULOMB, -6.0), thrown((-1.0, 0.0, 0.0)), 240, STEP, {"every": 20, "gauges": GAUGES}
    ),
}  # fmt: skip
