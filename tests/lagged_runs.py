"""Small runs of bonds that store something from step to step, for tests of devices.

These are beams of the incremental formulation.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import bondem as bd
from bondem.model.state import State
from tests.core import contact_cases
from tests.device_cases import GAUGES, bar, cell, moving


def storing_bar(law: Any) -> bd.Model:
    """The bar of `tests.device_cases`, of the incremental formulation."""
    model = bar()
    return bd.Model(model.lattice, replace(law, formulation="incremental"), model.density, boundary=model.boundary)


def storing_cell() -> bd.Model:
    """The periodic cell, of the incremental formulation."""
    model = cell()
    law = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6, formulation="incremental")
    return bd.Model(model.lattice, law, 1000.0)


def storing_and_touching() -> bd.Model:
    """The bar with a slit between walls, of the incremental formulation."""
    model = contact_cases.touching_beams(contact_cases.LINEAR)
    law = replace(contact_cases.BEAM, formulation="incremental")
    return bd.Model(
        model.lattice, law, model.density, boundary=model.boundary, contact=model.contact, walls=model.walls
    )


Case = tuple[bd.Model, Callable[[bd.Model], State], int, float, dict[str, Any]]
CASES: dict[str, Callable[[], Case]] = {
    "stored": lambda: (
        storing_bar(bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)), moving, 240, 2e-3,
        {"damping": bd.LocalDamping(0.1), "gauges": GAUGES, "every": 6},
    ),
    "stored, dashpots": lambda: (
        storing_bar(bd.ParallelBond(E=1e7, nu=0.2, radius_ratio=0.6)), moving, 240, 1e-3,
        {"damping": bd.BondDamping(eta=0.1), "every": 7},
    ),
    "stored, periodic": lambda: (storing_cell(), moving, 240, 2e-3, {"every": 6}),
    "stored, contact": lambda: (storing_and_touching(), moving, 300, 1e-3, {"every": 20}),
}  # fmt: skip
