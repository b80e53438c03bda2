"""Small runs of bonds that store something from step to step, for tests of devices.

These are beams of the incremental formulation, and bonds of the non-local law.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

import bondem as bd
from bondem.model.highest_frequency import highest_frequency
from tests.core import contact_cases
from tests.device_cases import CELL_GAUGES, GAUGES, Case, bar, body, cell, moving

SHEARED = bd.MohrCoulomb(tension=6e5, cohesion=3e5, friction_angle=0.6)
PULLED = bd.Rankine(tension=5e4)
WEAK = bd.MohrCoulomb(tension=1e5, cohesion=4e4, friction_angle=0.6)


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


def non_local_bar(failure: bd.Criterion | None = None) -> bd.Model:
    """A bar of Laguerre cells of the non-local law, held by one face, driven by another, and loaded."""
    boundary = [
        bd.Fix(bd.Face("x_min")),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 3.0, 0.02)),
        bd.Load(bd.Face("y_max"), force=(2e5, -1e5, 1e5), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.BodyForce((0.0, 0.0, -30.0)),
    ]
    law = bd.NonLocal(E=1e7, nu=0.2)
    return bd.Model(body(4, 3, 3), law, density=np.linspace(900.0, 1100.0, 36), boundary=boundary, failure=failure)


def non_local_spheres(failure: bd.Criterion | None = None) -> bd.Model:
    """The bar of spheres of the non-local law, with weighted areas."""
    model, law = bar(), bd.NonLocal(E=1e7, nu=0.25, areas="weighted")
    return bd.Model(model.lattice, law, model.density, boundary=model.boundary, failure=failure)


def non_local_cell() -> bd.Model:
    """A periodic cell of Laguerre cells of the non-local law, whose extra shear force is not limited."""
    law = bd.NonLocal(E=1e7, nu=0.2, limited=False, lever="contact")
    return bd.Model(body(3, 3, 3, periodic=True), law, density=1000.0)


def touching_spheres(own: bd.Particles, failure: bd.Criterion | None, *, weight: float, damping: float) -> bd.Model:
    """Bonded spheres of the non-local law on a plane and below a cylinder, and loose spheres that fall onto them."""
    loose = np.array([[0.5, 0.5, 2.6], [2.5, 1.5, 2.6], [1.5, 2.5, 2.6]])
    radius = np.concatenate([own.radius, np.full(3, 0.3)])
    lattice = bd.connect(bd.Particles(np.concatenate([own.position, loose]), radius), reach=2.0)
    i, j = lattice.pairs.T
    lattice = bd.Lattice(lattice.particles, lattice.pairs[np.maximum(i, j) < len(own.radius)])
    return bd.Model(
        lattice, bd.NonLocal(E=1e7, nu=0.2, areas="weighted"), density=1e3,
        contact=bd.LinearContact(E=1e7, friction=0.4, damping=damping),
        boundary=[bd.BodyForce(acceleration=(5.0, 0.0, -weight))], failure=failure,
        walls=[bd.PlaneWall((0, 0, -0.35), (0, 0, 1)), bd.CylinderWall(0.5, (2, 1, 3.2), (0, 1, 0), outside=True)],
    )  # fmt: skip


def touching_bar(failure: bd.Criterion | None, weight: float) -> bd.Model:
    """The spheres of the bar between walls, with loose ones above."""
    return touching_spheres(bar().lattice.particles, failure, weight=weight, damping=0.1)


def _lagged(make: Callable[[], bd.Model], steps: int, damping: Any, **options: Any) -> "Callable[[], Case]":
    """A case of the non-local law in motion, at a share of the critical step of its springs."""

    def case() -> Case:
        model = make()
        dt = 0.6 / highest_frequency(model)
        speed = 1e-3 * model.lattice.particles.mean_radius / dt
        return model, lambda model: moving(model, speed), steps, dt, {"damping": damping, "every": 20, **options}

    return case


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
    "non-local": _lagged(non_local_bar, 240, bd.BondDamping(eta=0.1), gauges=CELL_GAUGES),
    "non-local, spheres": _lagged(non_local_spheres, 120, bd.LocalDamping(0.2), gauges=GAUGES),
    "non-local, periodic": _lagged(non_local_cell, 60, bd.LocalDamping(0.05)),
    "non-local, contact": _lagged(lambda: touching_bar(None, 400.0), 240, bd.BondDamping(eta=0.1)),
    "non-local, bonds break": _lagged(lambda: non_local_bar(SHEARED), 120, bd.BondDamping(eta=0.1)),
    "non-local, spheres that break": _lagged(lambda: non_local_spheres(PULLED), 240, bd.LocalDamping(0.1)),
    "non-local, bonds break, contact": _lagged(lambda: touching_bar(WEAK, 800.0), 240, bd.BondDamping(eta=0.1)),
}  # fmt: skip
