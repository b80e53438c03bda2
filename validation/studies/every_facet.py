"""Are facets missed that would crack? Runs that look at some facets in each step, beside runs that judge every one.

Facets are looked at whose cells have cracks, or a stress of the size √(σ:σ) = 0.7 f_t and more. Plates that branch
or are torn, bars, balls on a wall, Rankine and Mohr-Coulomb, softening and brittle, with and without scatter: the
cracks of both runs are compared to the bit.
"""

from collections.abc import Callable
from functools import partial
from unittest.mock import patch

import numpy as np

import bondem as bd
import bondem.damage.softening_table as table
from validation.frame.record import Record

EVERY = -1e6  # of the strength: below any stress


def plate(failure: bd.Criterion, boundary: list[bd.BoundaryCondition], duration: float) -> bd.ExplicitResult:
    slot = bd.Box((100e-3, 1e-3, 6e-3)).moved((-50e-3, 19.5e-3, -2e-3))
    shape = bd.Box((100e-3, 40e-3, 2e-3)).cut(slot, name="notch")
    body = bd.connect(bd.pack(shape, count=3000, method="even", seed=1), method="laguerre")
    model = bd.Model(body, bd.CellBond(E=32e9, nu=0.2), 2450.0, failure=failure, boundary=boundary)
    return bd.solve_explicit(model, duration=duration, every=50)


def ball(failure: bd.Criterion, speed: float) -> bd.ExplicitResult:
    body = bd.connect(bd.pack(bd.Ball(radius=0.05), count=1000, method="even", seed=1), method="laguerre")
    wall = bd.PlaneWall((-0.05, 0.0, 0.0), (1.0, 0.0, 0.0))
    model = bd.Model(
        body, bd.CellBond(E=30e9, nu=0.2), 2400.0, failure=failure, contact=bd.LinearContact(E=30e9, friction=0.4),
        walls=[wall],
    )  # fmt: skip
    state = model.state()
    state.set_motion(velocity=np.tile([-speed, 0.0, 0.0], (1000, 1)))
    return bd.solve_explicit(model, duration=2e-4, every=50, state=state)


def bar(failure: bd.Criterion) -> bd.ExplicitResult:
    shape = bd.Box(size=(16e-3, 8e-3, 8e-3))
    body = bd.connect(bd.pack(shape, count=1000, method="even", seed=1), method="laguerre")
    torn = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=0.3)]
    model = bd.Model(body, bd.CellBond(E=40e9, nu=0.2), 2500.0, failure=failure, boundary=torn)
    return bd.solve_explicit(model, duration=3e-4, every=50)


PULLED: list[bd.BoundaryCondition] = [bd.Pressure(bd.Face(name), -1e6) for name in ("y_min", "y_max")]
TORN: list[bd.BoundaryCondition] = [bd.Fix(bd.Face("y_min")), bd.Drive(bd.Face("y_max"), vy=1.0)]
SOFT, BRITTLE = bd.Rankine(tension=4e6, fracture_energy=50.0), bd.Rankine(tension=4e6)
CRUSHED = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=100.0)
UNEVEN = bd.Rankine(tension=4e6, fracture_energy=50.0, scatter=bd.Weibull(modulus=6.0, volume=1e-9))
CASES: dict[str, Callable[[], bd.ExplicitResult]] = {
    "plate that branches": lambda: plate(bd.Rankine(tension=3.08e6, fracture_energy=3.0), PULLED, 90e-6),
    "plate torn": lambda: plate(bd.Rankine(tension=20e6, fracture_energy=14.0), TORN, 2e-4),
    "ball, 50 m/s": lambda: ball(bd.Rankine(tension=4e6, fracture_energy=50.0, friction=0.5), 50.0),
    "ball, 5 m/s": lambda: ball(SOFT, 5.0),
    "ball that yields, 20 m/s": lambda: ball(CRUSHED, 20.0),
    "ball, brittle, 10 m/s": lambda: ball(BRITTLE, 10.0),
    "bar": lambda: bar(SOFT),
    "bar, brittle": lambda: bar(BRITTLE),
    "bar, Weibull": lambda: bar(UNEVEN),
}


def measure(record: Record) -> None:
    """Carry out each case twice."""
    for name, run in CASES.items():
        record.add(partial(compared, run), case=name)


def compared(run: Callable[[], bd.ExplicitResult]) -> dict[str, int | bool]:
    """Cracks of both runs of a case."""
    some = run().state.cracks
    with patch.object(table, "_MARGIN", EVERY):
        every = run().state.cracks
    same = bool(np.array_equal(some, every))
    return {"cracks": len(some), "cracks_of_every_facet": len(every), "same_bits": same}
