"""Bodies of cells that crack, for devices: with each kind of what begins, ends and dissipates."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

import bondem as bd
from bondem.model.state import State
from tests.device_cases import Case
from tests.specimens import cubes

LAW = bd.CellBond(E=40e9, nu=0.2)
RANKINE = bd.Rankine(tension=4e6, fracture_energy=50.0)
GAUGES = {"end": bd.Gauge(bd.Face("x_max"), "displacement"), "wall": bd.Gauge(bd.Face("x_min"), "force", "sum")}
#: Stable time step of the bodies, about [s].
STEP = 1e-7


@cache
def body(length: int = 8) -> bd.Lattice:
    """A bar of 128 cells, or of other lengths."""
    rng = np.random.default_rng(1)
    counts = (length, 4, 4)
    grid = 4e-3 * (np.indices(counts).reshape(3, -1).T + 0.5)
    centre, radius = grid + rng.uniform(-7e-4, 7e-4, grid.shape), rng.uniform(1e-3, 1.2e-3, len(grid))
    return bd.connect(bd.Particles(centre, radius, shape=bd.Box((length * 4e-3, 16e-3, 16e-3))), method="laguerre")


def thrown(along: tuple[float, float, float], noise: float = 0.05) -> Callable[[bd.Model], State]:
    """Velocities in proportion to the place, by axis at the ends [m/s], and some of no order."""

    def start(model: bd.Model) -> State:
        centre = model.lattice.centre
        x = (centre - centre.mean(axis=0)) / (0.5 * np.ptp(centre[:, 0]))
        state = model.state()
        rng = np.random.default_rng(0)
        state.set_motion(velocity=x * np.array(along) + noise * rng.standard_normal(x.shape))
        return state

    return start


def free(failure: Any, length: int = 8, **more: Any) -> bd.Model:
    """The bar, free of anything else."""
    return bd.Model(body(length), LAW, 2500.0, failure=failure, **more)


def held() -> bd.Model:
    """The bar, held at one end, pulled at the other and pressed from one side."""
    return bd.Model(body(), LAW, 2500.0, failure=RANKINE, boundary=[
        bd.Fix(bd.Face("x_min")),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 4.0, 5e-6)),
        bd.Pressure(bd.Face("y_max"), 1e6, schedule=bd.Ramp(0.0, 1.0, 1e-5)),
        bd.BodyForce((0.0, 0.0, -30.0)),
    ])  # fmt: skip


def sliding(length: int = 8) -> bd.Model:
    """A bar of 128 cubes, or more, whose upper half slides on a weak joint that presses."""
    box = (length * 4e-3, 16e-3, 8e-3)
    low, up = bd.Within(bd.Box(box)), bd.Within(bd.Box(box).moved((0.0, 0.0, 8e-3)))
    weak = bd.MohrCoulomb(
        tension=1e4, cohesion=1e4, friction_angle=0.4, fracture_energy=0.3, fracture_energy_shear=0.3
    )
    failure = {bd.Everything(): bd.Rankine(tension=20e6, fracture_energy=300.0), (low, up): weak}
    return bd.Model(
        cubes((length, 4, 4), 4e-3), LAW, 2500.0, failure=failure, contact=bd.LinearContact(E=40e9, friction=0.4),
        boundary=[bd.Fix(bd.Face("z_min")), bd.Pressure(bd.Face("z_max"), 5e6)],
    )  # fmt: skip


def pushed(model: bd.Model) -> State:
    """The upper half slides at 80 m/s."""
    state = model.state()
    upper = model.lattice.centre[:, 2] > 8e-3
    state.set_motion(velocity=np.where(upper[:, None], [80.0, 5.0, 0.0], 0.0))
    return state


CASES: dict[str, Callable[[], Case]] = {
    "torn apart": lambda: (free(RANKINE), thrown((2.0, -0.4, 0.6)), 240, STEP, {"every": 20}),
    "brittle": lambda: (
        free(bd.Rankine(tension=4e6)), thrown((2.0, -0.4, 0.6)), 200, STEP,
        {"every": 20, "damping": bd.LocalDamping(0.05)}
    ),
    "bilinear": lambda: (
        free(bd.Rankine(tension=4e6, fracture_energy=50.0, curve=bd.Bilinear())), thrown((2.0, -0.4, 0.6)), 200, STEP,
        {"every": 20, "damping": bd.BondDamping(eta=0.1)},
    ),
    "held and pulled": lambda: (held(), thrown((0.5, 0.0, 0.0)), 240, STEP, {"every": 20, "gauges": GAUGES}),
    "driven together and touching": lambda: (
        free(RANKINE, contact=bd.LinearContact(E=40e9, friction=0.4)), thrown((-40.0, -12.0, -12.0), 10.0), 500,
        0.25 * STEP, {"every": 100},
    ),
    "sliding on a joint": lambda: (sliding(), pushed, 450, 0.8 * STEP, {"every": 100}),
}  # fmt: skip
