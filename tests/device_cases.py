"""Small models for devices: bodies of beams and of cells, with all that acts on them, and moving states of them."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.model.state import State

#: A model, how its state begins, number of steps, time step [s], and options of the plan.
Case = tuple[bd.Model, Callable[[bd.Model], State], int, float, dict[str, Any]]

GAUGES = {
    "end": bd.Gauge(bd.Face("x_max", depth=0.5), "displacement"),
    "grip": bd.Gauge(bd.Face("x_min", depth=0.5), "force", "sum"),
    "fastest": bd.Gauge(bd.Everything(), "velocity", "max_abs"),
    "turned": bd.Gauge(bd.Everything(), "rotation"),
    "spin": bd.Gauge(bd.Everything(), "angular_velocity", "sum"),
}
#: Those of a periodic cell, which has no faces.
INNER_GAUGES = {name: gauge for name, gauge in GAUGES.items() if gauge.region == bd.Everything()}
CELL_GAUGES = {
    "end": bd.Gauge(bd.Face("x_max"), "displacement"),
    "wall": bd.Gauge(bd.Face("x_min"), "force", "sum"),
    "loaded": bd.Gauge(bd.Face("y_max"), "force", "max_abs"),
}


# Of two cubes, whose motion has a closed form.
NUS, CUBE_STEPS, CUBE_DT = (0.2, 0.45, -0.2), 7, 1e-3


def bar() -> bd.Model:
    """A crooked bar of 4 × 3 × 3, held at one end, loaded twice by ramps at the other and driven in the middle."""
    rng = np.random.default_rng(1)
    grid = np.indices((4, 3, 3)).reshape(3, -1).T.astype(float)
    lattice = bd.connect(
        bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), rng.uniform(0.3, 0.4, len(grid))), reach=2.0
    )
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6)
    boundary = [
        bd.Fix(bd.Face("x_min", depth=0.5)),
        bd.Drive(bd.Index([len(grid) // 2]), vy=bd.Ramp(0.0, 0.4, 0.05), rx=bd.Ramp(0.0, 0.1, 0.03)),
        bd.Load(bd.Face("x_max", depth=0.5), force=(3e4, -1e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Load(bd.Index([len(grid) - 1, 2]), force=(0.0, 1e4, 0.0), moment=(1e3, 0.0, 0.0)),
        bd.BodyForce((0.0, 0.0, -30.0), schedule=bd.Ramp(0.0, 1.0, 0.05)),
        bd.BodyForce((10.0, 5.0, 0.0), bd.Index(range(20))),
    ]
    return bd.Model(lattice, law, density=rng.uniform(900.0, 1100.0, len(grid)), boundary=boundary)


CRITERIA: dict[str, Any] = {
    "peripheral": bd.PeripheralStress(tension=1.5e5, shear=1e5, scatter=bd.Weibull(modulus=6.0, volume=0.3, seed=2)),
    "mohr coulomb": bd.MohrCoulomb(tension=6e4, cohesion=5e4, friction_angle=0.5),
    "linear": bd.LinearSum(force=1.5e4, shear=1.5e4, bending=5e3, twisting=5e3, scatter=bd.Normal(deviation=0.1)),
    "elliptic": bd.Elliptic(elongation=0.011, rotation=0.04),
}


def breaking_bar(criterion: Any) -> bd.Model:
    """The bar, whose bonds break."""
    model = bar()
    return bd.Model(model.lattice, model.bond, model.density, boundary=model.boundary, failure=criterion)


def breaking_cell() -> bd.Model:
    """The periodic cell, whose bonds are alike but for their length."""
    model = cell()
    return bd.Model(model.lattice, model.bond, model.density, failure=bd.PeripheralStress(tension=4e5, shear=2e5))


def cell() -> bd.Model:
    """27 elements in a periodic cell, with bonds that are alike but for their length."""
    rng = np.random.default_rng(2)
    grid = np.indices((3, 3, 3)).reshape(3, -1).T.astype(float)
    particles = bd.Particles(grid + rng.uniform(-0.1, 0.1, grid.shape), np.full(27, 0.5), period=(3.0, 3.0, 3.0))
    return bd.Model(bd.connect(particles, reach=1.15), bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6), 1000.0)


@cache
def body(a: int, b: int, c: int, *, periodic: bool = False) -> bd.Lattice:
    """A crooked box, or periodic cell, of unit cells."""
    rng, counts = np.random.default_rng(1), (a, b, c)
    grid = np.indices(counts).reshape(3, -1).T + 0.5
    shape = bd.Cell(size=counts) if periodic else bd.Box(counts)
    centre, radius = grid + rng.uniform(-0.2, 0.2, grid.shape), rng.uniform(0.25, 0.3, len(grid))
    return bd.connect(bd.Particles(centre, radius, shape=shape), method="laguerre")


def free_body() -> tuple[bd.Model, State]:
    """A body of cells that bears compression badly, turned far as a whole, some of its facets damaged."""
    model = bd.Model(body(3, 3, 3), bd.CellBond(E=1e7, nu=-0.2, facet_rotation="full"), density=1000.0)
    state, far = moving(model), Rotation.from_rotvec([1.5, -1.0, 0.7])
    turned = np.tile(far.as_quat()[[3, 0, 1, 2]], (27, 1))
    state.set_pose(position=far.apply(state.position.copy()) + np.arange(3.0), orientation=turned)
    state.integrity[[3, 17]] = 0.0, 0.4
    return model, state


def held_bar() -> bd.Model:
    """A bar of two materials, held by one face, driven by another, loaded on a third; a cell is driven inside."""
    lattice = body(4, 3, 3)
    law = {bd.Everything(): bd.CellBond(E=1e7, nu=0.2), bd.Index(range(12)): bd.CellBond(E=2e7, nu=0.3)}
    boundary = [
        bd.Fix(bd.Face("x_min")),
        bd.Drive(bd.Face("x_max"), x=bd.Ramp(0.0, 0.2, 0.02), vy=bd.Ramp(0.0, 3.0, 0.02)),
        bd.Load(bd.Face("y_max"), force=(2e5, -1e5, 1e5), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Fix(bd.Face("z_min"), "z", ""),
        bd.Drive(bd.Index([16]), rx=bd.Ramp(0.0, 0.2, 0.03)),
    ]
    return bd.Model(lattice, law, density=np.linspace(900.0, 1100.0, 36), boundary=boundary)


def pressed_bar() -> bd.Model:
    """A nearly incompressible bar between a smooth wall and pressures that change, on a face twice."""
    boundary = [
        bd.Fix(bd.Face("x_min"), "x", ""),
        bd.Pressure(bd.Face("x_max"), 2e5, schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Pressure(bd.Face("y_max"), 1e5, schedule=bd.Ramp(1.0, 0.0, 0.03)),
        bd.Load(bd.Face("y_max"), force=(0.0, 2e5, 1e5), schedule=bd.Ramp(0.0, 1.0, 0.04)),
        bd.BodyForce((0.0, 0.0, -30.0), bd.Index(range(11)), schedule=bd.Ramp(0.5, 1.0, 0.02)),
    ]
    return bd.Model(body(4, 2, 3), bd.CellBond(E=1e7, nu=0.45), density=1000.0, boundary=boundary)


def sheet() -> bd.Model:
    """A clamped sheet one cell thick, whose layer bends."""
    return bd.Model(body(5, 4, 1), bd.CellBond(E=1e7, nu=0.3), density=1000.0, boundary=[bd.Fix(bd.Face("x_min"))])


def cubes(nu: float, *, walls: bool) -> tuple[bd.Model, State]:
    """Two cubes side by side that move apart, or both the same way between two smooth walls."""
    particles = bd.Particles([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]], 0.4, shape=bd.Box((2, 1, 1)))
    held = [bd.Fix(bd.Face(face), "x", "") for face in ("x_min", "x_max")] if walls else []
    model = bd.Model(bd.connect(particles, method="laguerre"), bd.CellBond(E=1e7, nu=nu), 1000.0, boundary=held)
    state = model.state()
    state.set_motion(velocity=np.array([[1.0 if walls else -1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]))
    return model, state


def moving(model: bd.Model, speed: float = 0.5) -> State:
    """A state in which all velocities have a sign: at rest, rounding would choose that of local damping."""
    rng = np.random.default_rng(7)
    n = len(model.lattice.particles)
    state = State(model)
    state.set_motion(velocity=rng.uniform(-speed, speed, (n, 3)), angular_velocity=rng.uniform(-speed, speed, (n, 3)))
    return state
