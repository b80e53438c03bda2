"""Models with contacts and walls, for tests of the passes of contact."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

import bondem as bd
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State

E = 1e7
LINEAR = bd.LinearContact(E=E, friction=0.4, damping=0.1)
HERTZIAN = bd.HertzMindlin(E=E, nu=0.3, friction=0.3, restitution=0.8, overlap=0.05)
ROLLING = bd.LinearContact(E=E, friction=0.4, damping=0.1, rolling=0.3, twisting=0.2)
STICKY = bd.LinearContact(E=E, friction=0.4, damping=0.1, adhesion=bd.Adhesion(strength=5e4, reach=0.3))
BEAM = bd.Timoshenko(E=E, nu=0.2, radius=0.2)


def cloud(edge: int, law, *, walls=(), speed: float = 8.0, period=None):
    """Return loose spheres on a crooked grid with random velocities and spins, in a model and a state."""
    rng = np.random.default_rng(5)
    grid = 1.15 + 2.3 * np.indices((edge, edge, edge)).reshape(3, -1).T
    radius = rng.uniform(0.9, 1.05, len(grid))
    particles = bd.Particles(grid + rng.uniform(-0.08, 0.08, grid.shape), radius, period=period)
    lattice = bd.Lattice(particles, np.zeros((0, 2), dtype=np.int64))
    model = bd.Model(lattice, BEAM, density=1e3, contact=law, walls=list(walls))
    state = State(model)
    state.set_motion(
        velocity=rng.uniform(-speed, speed, grid.shape), angular_velocity=rng.uniform(-speed, speed, grid.shape)
    )
    return model, state


def all_walls(size: float) -> list:
    """Return walls of each kind and of each motion around a cube and within it."""
    middle = size / 2
    return [
        bd.PlaneWall((0, 0, 0), (1, 0, 0), motion=bd.Servo(2e5, speed=4.0, mass=3e5, damping=0.0)),
        bd.PlaneWall((0, 0, 0), (0, 1, 0), friction=0.1),
        bd.PlaneWall((0, 0, 0), (0, 0, 1), outer=0.9 * size, inner=0.2),
        bd.PlaneWall((size, 0, 0), (-1, 0, 0), motion=bd.Free(2e5, velocity=(-3.0, 0, 0), force=(-1e5, 0, 0))),
        bd.PlaneWall((0, size, 0), (0, -1, 0), motion=bd.Driven(y=bd.Ramp(0.0, -0.3, 0.1), vx=0.5)),
        bd.CylinderWall(0.6 * size, (0, middle, middle), (1, 0, 0), motion=bd.Driven(vgrowth=-0.4)),
        bd.CylinderWall(0.12, (1.15, 1, 2.3), (0, 1, 0), outside=True, motion=bd.Driven(growth=bd.Ramp(0, 0.2, 0.1))),
        bd.SphereWall(size, (middle, middle, middle), inside=True, motion=bd.Servo(3e5, speed=20.0, damping=0.0)),
        bd.SphereWall(0.15, (middle, middle, middle), motion=bd.Free(1e5, velocity=(3.0, 1.0, 0.0))),
    ]


def turning_walls(size: float) -> list:
    """Return walls of each kind around a cube and within it that turn, prescribed or freely."""
    middle = size / 2
    drum = {"axis": (1, 0, 0), "about": (0, middle, middle)}
    matrix = ((9e4, 1e4, -2e4), (1e4, 8e4, 1e4), (-2e4, 1e4, 9e4))
    rod = bd.Free(1e5, velocity=(0.0, 2.0, 0.0), inertia=matrix, spin=(0.0, 3.0, 0.0), torque=(1e4, 0.0, 0.0))
    return [
        bd.PlaneWall((0, 0, 0), (1, 0, 0), motion=bd.Driven(spin=0.4, axis=(0, 1, 0), about=(0, 0, middle), vx=0.5)),
        bd.PlaneWall((size, 0, 0), (-1, 0, 0)),
        *[
            bd.PlaneWall(point, normal, motion=bd.Driven(angle=bd.Ramp(0.0, 1.0, 0.5), **drum))
            for point, normal in (
                ((0, 0, 0), (0, 1, 0)), ((0, 0, 0), (0, 0, 1)),
                ((0, size, 0), (0, -1, 0)), ((0, 0, size), (0, 0, -1)),
            )
        ],
        bd.CylinderWall(0.15, (1.15, 1, 2.3), (0, 1, 0), outside=True, motion=rod),
        bd.PlaneWall((middle, middle, 0.1), (0, 0, 1), outer=2.0, motion=bd.Free(2e5, inertia=(2e5, 2e5, 4e5))),
        bd.SphereWall(0.15, (middle, middle, middle), motion=bd.Driven(spin=9.0, vgrowth=0.2)),
    ]  # fmt: skip


def by_kinds(law: bd.LinearContact | bd.HertzMindlin, *walls) -> dict:
    """Return laws by kinds of the first 64 elements, three of them at the given walls: pairs without friction too."""
    some, others = bd.Index(range(0, 64, 3)), bd.Index(range(0, 64, 2))
    rough = {(bd.Index(range(40)), wall): replace(law, friction=0.9, E=0.7 * law.E) for wall in walls}
    return {
        bd.Everything(): law,
        some: replace(law, E=0.4 * law.E, friction=0.0),
        (some, others): replace(law, friction=0.1, rolling=0.2, E=0.8 * law.E),
        **rough,
    }


def slit_bar(shape: tuple[int, int, int]) -> bd.Lattice:
    """Return a crooked bar with a slit: across it elements touch that no bond joins."""
    rng = np.random.default_rng(1)
    grid = np.indices(shape).reshape(3, -1).T.astype(float)
    particles = bd.Particles(grid + rng.uniform(-0.05, 0.05, grid.shape), rng.uniform(0.46, 0.5, len(grid)))
    whole = bd.connect(particles, reach=1.6)
    side = grid[:, 2] > (shape[2] - 1) / 2
    i, j = whole.pairs.T
    slit = (side[i] != side[j]) & (np.minimum(grid[i, 0], grid[j, 0]) > 0.5)
    return bd.Lattice(particles, whole.pairs[~slit])


def touching_beams(law, *, shape=(6, 3, 4), **options) -> bd.Model:
    """Return a bar with a slit that is pressed between walls and sheared along the slit."""
    top, bottom = bd.Face("z_max", depth=0.5), bd.Face("z_min", depth=0.5)
    boundary = [
        bd.Fix(bottom),
        bd.Drive(top - bottom, vz=bd.Ramp(0.0, -1.5, 0.02), vx=bd.Ramp(0.0, 1.5, 0.05)),
    ]
    walls = [
        bd.PlaneWall((-0.5, 0, 0), (1, 0, 0)),
        bd.PlaneWall((0, -0.5, 0), (0, 1, 0), motion=bd.Servo(1e5, speed=0.3, damping=0.0)),
    ]
    return bd.Model(
        slit_bar(shape), BEAM, density=1e3, boundary=boundary, contact=law, walls=walls, **options
    )


def moving_beams(law, **options) -> tuple[bd.Model, State]:
    """Return that bar with random velocities, in a model and a state."""
    model = touching_beams(law, **options)
    state = State(model)
    state.set_motion(velocity=np.random.default_rng(7).uniform(-0.5, 0.5, (len(state.pose), 3)))
    return model, state


def plan_of(model: bd.Model, steps: int, *, share: float = 0.5, **options) -> Plan:
    """Return a plan of some steps of a share of the critical step, with gauges of all walls."""
    dt = share * critical_step(model, bd.VelocityVerlet())
    former = "force", "displacement", "velocity", "growth"
    turns = "rotation", "angular_velocity", "torque", "power"
    gauges = {
        f"{quantity} {w}": bd.WallGauge(w, quantity)
        for quantities in (former, turns) for w in range(len(model.walls)) for quantity in quantities
    }  # fmt: skip
    return Plan(duration=steps * dt, dt=dt, gauges=gauges, **options)


WEAK = bd.PeripheralStress(tension=1.2e6, shear=1.2e6)
SOFT = bd.PeripheralStress(tension=2e5, shear=2e5, fracture_energy=3e3)
PARALLEL = bd.LinearContact(E=E / 10, friction=0.3, damping=0.2, parallel=True)
STRESSED = bd.LinearContact(E=E / 20, friction=0.2, stress_free=False)
#: Models, their states, and the damping of their runs.
CASES: dict[str, tuple[Callable[[], tuple[bd.Model, State]], object]] = {
    "spheres and walls": (lambda: cloud(4, LINEAR, walls=all_walls(9.2)), None),
    "beams, rolling": (lambda: moving_beams(ROLLING), None),
    "Hertzian spheres and walls": (lambda: cloud(4, HERTZIAN, walls=all_walls(9.2)), None),
    "spheres and walls that turn": (lambda: cloud(4, LINEAR, walls=turning_walls(9.2)), None),
    "Hertzian spheres and walls that turn": (lambda: cloud(4, HERTZIAN, walls=turning_walls(9.2)), None),
    "periodic cell": (lambda: cloud(5, LINEAR, period=(11.5, 11.5, 11.5)), None),
    "spheres and walls by kinds": (
        lambda: cloud(4, by_kinds(LINEAR, *all_walls(9.2)[:5:2]), walls=all_walls(9.2)), None
    ),
    "beams break, Hertzian by kinds": (lambda: moving_beams(by_kinds(HERTZIAN), failure=WEAK), None),
    "sticky spheres and walls": (lambda: cloud(4, STICKY, walls=all_walls(9.2)), None),
    "sticky spheres and walls that turn": (lambda: cloud(4, STICKY, walls=turning_walls(9.2)), None),
    "beams break, sticky, Hertzian": (
        lambda: moving_beams(replace(HERTZIAN, adhesion=bd.Adhesion(5e3, 0.1)), failure=WEAK), None
    ),
    "beams break, sticky, parallel": (
        lambda: moving_beams(replace(PARALLEL, adhesion=bd.Adhesion(5e3, 0.1)), failure=WEAK), None
    ),
    "beams, damped": (lambda: moving_beams(LINEAR), bd.LocalDamping(0.1)),
    "beams, Hertzian": (lambda: moving_beams(HERTZIAN), None),
    "beams, no friction": (lambda: moving_beams(bd.LinearContact(E=E, damping=0.2)), None),
    "beams, parallel": (lambda: moving_beams(PARALLEL), None),
    "beams break, Hertzian": (lambda: moving_beams(HERTZIAN, failure=WEAK), None),
    "beams break, parallel": (lambda: moving_beams(PARALLEL, failure=WEAK), None),
    "beams break, stressed": (lambda: moving_beams(STRESSED, failure=WEAK), None),
    "beams soften, Hertzian": (lambda: moving_beams(HERTZIAN, failure=SOFT), None),
}
STEPS = 400
