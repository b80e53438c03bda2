"""Small models for devices: bodies of beams and of cells, with all that acts on them, and moving states of them.

Scripts of simulated devices take the bodies that the CPU has cut: cut by plain Python they differ by rounding, and
levers, which are whole numbers of a grid, then by 1e-9.
"""

import importlib
import os
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.model.state import State
from bondem.solve.plan import ExplicitResult

if "NUMBA_ENABLE_CUDASIM" in os.environ:
    importlib.import_module("cuda_in_turn").simulate_in_turn()

#: Whether to carry out variants, too, that differ from others by how a run is paused alone.
EVERY = "BONDEM_EVERY_CASE" in os.environ

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


DAMPED = bd.LocalDamping(0.1)

# Bodies of cells by name, as they have been cut.
BODIES: dict[str, bd.Lattice] = {}
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


def body(a: int, b: int, c: int, *, periodic: bool = False) -> bd.Lattice:
    """A crooked box, or periodic cell, of unit cells."""
    rng, counts = np.random.default_rng(1), (a, b, c)
    grid = np.indices(counts).reshape(3, -1).T + 0.5
    shape = bd.Cell(size=counts) if periodic else bd.Box(counts)
    centre, radius = grid + rng.uniform(-0.2, 0.2, grid.shape), rng.uniform(0.25, 0.3, len(grid))
    return cut(f"{counts} {periodic}", bd.Particles(centre, radius, shape=shape))


def cut(name: str, particles: bd.Particles) -> bd.Lattice:
    """Particles cut into cells, or the body of that name that is known."""
    if name not in BODIES:
        BODIES[name] = bd.connect(particles, method="laguerre")
    return BODIES[name]


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


def cubes(nu: float, *, walls: bool) -> tuple[bd.Model, State]:
    """Two cubes side by side that move apart, or both the same way between two smooth walls."""
    particles = bd.Particles([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]], 0.4, shape=bd.Box((2, 1, 1)))
    held = [bd.Fix(bd.Face(face), "x", "") for face in ("x_min", "x_max")] if walls else []
    model = bd.Model(cut("cubes", particles), bd.CellBond(E=1e7, nu=nu), 1000.0, boundary=held)
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


def strained(model: bd.Model, size: float) -> State:
    state = moving(model)
    state.set_eigenstrain(size * np.random.default_rng(3).standard_normal(len(model.lattice.pairs)))
    return state


def held_beams() -> bd.Model:
    """The bar, held at one end and free of anything else."""
    law = bd.Timoshenko(E=1e7, nu=0.2, radius=0.2)
    return bd.Model(bar().lattice, law, 1000.0, boundary=[bd.Fix(bd.Face("x_min", depth=0.5))])


def brittle_beams() -> bd.Model:
    """These beams, which break."""
    model, failure = held_beams(), bd.PeripheralStress(tension=5e4, shear=5e4)
    return bd.Model(model.lattice, model.bond, 1000.0, boundary=model.boundary, failure=failure)


def absorbing_bar() -> bd.Model:
    """A bar of cells with an absorbing end, a moment on a region, and a pressure that follows its face."""
    return bd.Model(body(4, 3, 3), bd.CellBond(E=1e7, nu=0.2), density=1000.0, boundary=[
        bd.Absorbing(bd.Face("x_max"), density=1000.0, E=1e7, nu=0.2),
        bd.Load(bd.Face("x_min"), moment=(1e4, 0.0, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
        bd.Pressure(bd.Face("y_max"), 1e5, schedule=bd.Ramp(0.0, 1.0, 0.01), follows=True),
    ])  # fmt: skip


Case = tuple[bd.Model, Callable[[bd.Model], State], int, float, dict[str, Any]]
CASES: dict[str, Callable[[], Case]] = {
    "bar": lambda: (bar(), moving, 320, 2e-3, {"damping": DAMPED, "gauges": GAUGES, "every": 6}),
    "dissipative": lambda: (
        bar(), moving, 240, 2e-3, {"scheme": bd.TchamwaWielgosz(1.2), "gauges": GAUGES, "every": 5}
    ),
    "dashpots": lambda: (bar(), moving, 240, 1e-3, {"damping": bd.BondDamping(eta=0.1), "every": 7}),
    "dragged": lambda: (bar(), moving, 240, 2e-3, {"damping": bd.MassDamping(alpha=5.0), "every": 0}),
    "held": lambda: (held_beams(), moving, 240, 2e-3, {}),
    "dragged and free": lambda: (cell(), moving, 150, 2e-3, {"damping": bd.MassDamping(alpha=5.0), "every": 9}),
    "periodic": lambda: (cell(), lambda model: strained(model, 1e-3), 240, 2e-3, {"every": 6}),
    "free cells": lambda: (free_body()[0], lambda _: free_body()[1], 150, 1e-3, {"every": 3}),
    "held cells": lambda: (
        held_bar(), moving, 240, 1e-3, {"damping": DAMPED, "gauges": CELL_GAUGES, "every": 6}
    ),
    "pressed cells": lambda: (
        pressed_bar(), moving, 240, 8e-4, {"scheme": bd.TchamwaWielgosz(1.2), "gauges": CELL_GAUGES, "every": 5}
    ),
    "periodic cells": lambda: (
        bd.Model(body(3, 3, 3, periodic=True), bd.CellBond(E=1e7, nu=0.2), density=1000.0),
        lambda model: strained(model, 1e-2), 150, 1e-3, {"damping": DAMPED, "every": 3},
    ),
    **{
        name: lambda criterion=criterion: (
            breaking_bar(criterion), moving, 60, 2e-3, {"damping": DAMPED, "gauges": GAUGES, "every": 5}
        )
        for name, criterion in CRITERIA.items()
    },
    "dissipative and brittle": lambda: (
        breaking_bar(CRITERIA["peripheral"]), moving, 60, 2e-3, {"every": 5, "scheme": bd.TchamwaWielgosz(1.2)}
    ),
    "alike and brittle": lambda: (
        breaking_cell(), lambda model: moving(model, speed=1.2), 60, 2e-3, {"every": 5}
    ),
    "dashpots and brittle": lambda: (
        breaking_bar(CRITERIA["peripheral"]), moving, 60, 1e-3, {"every": 0, "damping": bd.BondDamping(eta=0.1)}
    ),
    "held and brittle": lambda: (brittle_beams(), moving, 60, 2e-3, {}),
    "absorbing cells": lambda: (absorbing_bar(), moving, 150, 1e-3, {"gauges": CELL_GAUGES, "every": 10}),
}  # fmt: skip


def deviation(expected: ExplicitResult, found: ExplicitResult) -> float:
    """Return the largest difference of two runs, each array over its largest value; inf where they end otherwise.

    Energies are compared with the largest of a record, as they come and go, and works by their sum: on a device the
    work of walls and tractions belongs to the rows of their cells.
    """
    if (expected.status, expected.message) != (found.status, found.message):
        return np.inf
    one, other = expected.state, found.state
    pairs = [(getattr(one, name), getattr(other, name)) for name in _FIELDS]
    work = max(np.abs(one.work).max(initial=0.0), 1e-300)
    pairs.append((np.array([work, one.work.sum()]), np.array([work, other.work.sum()])))
    records = [result.history.records for result in (expected, found)]
    pairs += [(records[0][:, 1:11], records[1][:, 1:11])]
    pairs += [(records[0][:, c], records[1][:, c]) for c in (0, *range(11, records[0].shape[1]))]
    if any(a.shape != b.shape for a, b in pairs):
        return np.inf
    return max(float(np.abs(b - a).max(initial=0.0) / (np.abs(a).max(initial=0.0) or 1.0)) for a, b in pairs)


_FIELDS = "pose", "motion", "acceleration", "loss", "reaction", "integrity", "broken"
