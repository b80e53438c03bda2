"""Small runs in which beams soften, for tests of devices: models, their states, steps, time steps and options."""

from collections.abc import Callable
from typing import Any

import bondem as bd
from bondem.model.state import State
from tests.device_cases import GAUGES, Case, bar, cell, moving

SOFT: dict[str, Any] = {"fracture_energy": 1.5e3, "fracture_energy_shear": 3e3}
CRITERIA: dict[str, Any] = {
    "peripheral": bd.PeripheralStress(
        tension=1.5e5, shear=1e5, scatter=bd.Weibull(modulus=6.0, volume=0.3, seed=2), **SOFT
    ),
    "mohr coulomb": bd.MohrCoulomb(tension=6e4, cohesion=5e4, friction_angle=0.5, **SOFT),
}
DAMPED = bd.LocalDamping(0.1)


def softening_bar(criterion: Any) -> bd.Model:
    """The bar of `tests.device_cases`, whose bonds soften."""
    model = bar()
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=criterion)


def softening_cell(failure: Any) -> bd.Model:
    """The periodic cell, whose bonds are alike but for their length."""
    model = cell()
    return bd.Model(model.lattice, model.bond, model.density, failure=failure)


def fast(model: bd.Model) -> State:
    """A state in fast motion."""
    return moving(model, speed=3.0)


CASES: dict[str, Callable[[], Case]] = {
    **{
        f"softening, {name}": lambda criterion=criterion: (
            softening_bar(criterion), fast, 60, 2.5e-3, {"damping": DAMPED, "gauges": GAUGES, "every": 6}
        )
        for name, criterion in CRITERIA.items()
    },
    "softening, alike": lambda: (
        softening_cell(bd.PeripheralStress(tension=3e5, shear=2e5, fracture_energy=8e3)),
        lambda model: moving(model, speed=5.0), 60, 2.5e-3, {"every": 6},
    ),
    "softening, alike, mohr coulomb": lambda: (
        softening_cell(bd.MohrCoulomb(tension=3e5, cohesion=2e5, friction_angle=0.5, fracture_energy=8e3)),
        lambda model: moving(model, speed=5.0), 60, 2.5e-3, {"every": 6},
    ),
    "softening, dashpots": lambda: (
        softening_bar(CRITERIA["peripheral"]), fast, 60, 1e-3, {"damping": bd.BondDamping(eta=0.1), "every": 7}
    ),
}  # fmt: skip
