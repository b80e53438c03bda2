"""Models with contacts and walls, for tests of the passes of contact."""

import numpy as np

import bondem as bd
from bondem.model.state import State
from bondem.solve.plan import Plan
from bondem.solve.timestep import critical_step
from tests.core.test_steps import X_MAX, X_MIN, crooked

E = 1e7
LINEAR = bd.LinearContact(E=E, friction=0.4, damping=0.1)
HERTZIAN = bd.HertzMindlin(E=E, nu=0.3, friction=0.3, restitution=0.8, overlap=0.05)
BEAM = bd.Timoshenko(E=E, nu=0.2, radius=0.2)


def cloud(edge: int, law: bd.LinearContact | bd.HertzMindlin, *, walls=(), speed: float = 8.0, period=None):
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
        bd.PlaneWall((0, 0, 0), (1, 0, 0), motion=bd.Servo(2e5, speed=4.0, mass=2e4)),
        bd.PlaneWall((0, 0, 0), (0, 1, 0), friction=0.1),
        bd.PlaneWall((0, 0, 0), (0, 0, 1), outer=0.9 * size, inner=0.2),
        bd.PlaneWall((size, 0, 0), (-1, 0, 0), motion=bd.Free(1e4, velocity=(-3.0, 0, 0), force=(-1e4, 0, 0))),
        bd.PlaneWall((0, size, 0), (0, -1, 0), motion=bd.Driven(y=bd.Ramp(0.0, -0.3, 0.1), vx=0.5)),
        bd.CylinderWall(0.6 * size, (0, middle, middle), (1, 0, 0), motion=bd.Driven(vgrowth=-0.4)),
        bd.CylinderWall(0.12, (1.15, 1.0, 2.3), (0, 1, 0), outside=True, motion=bd.Driven(growth=bd.Ramp(0, 0.2, 0.1))),
        bd.SphereWall(size, (middle, middle, middle), inside=True, motion=bd.Servo(3e5, speed=20.0)),
        bd.SphereWall(0.15, (middle, middle, middle), motion=bd.Free(5e2, velocity=(3.0, 1.0, 0.0))),
    ]


def touching_beams(law) -> bd.Model:
    """Return a crooked bar whose ends are driven past each other, between walls that it touches."""
    boundary = [
        bd.Fix(X_MIN),
        bd.Drive(X_MAX, vx=bd.Ramp(0.0, -4.0, 0.02), vy=bd.Ramp(0.0, 2.0, 0.05)),
        bd.Load(bd.Face("z_max", depth=0.5) - X_MIN - X_MAX, force=(0, 0, -2e5), schedule=bd.Ramp(0.0, 1.0, 0.02)),
    ]
    walls = [bd.PlaneWall((0, 0, -0.4), (0, 0, 1)), bd.CylinderWall(0.5, (2, 1, 3.2), (0, 1, 0), outside=True)]
    return bd.Model(crooked((5, 3, 3)), BEAM, density=1e3, boundary=boundary, contact=law, walls=walls)


def plan_of(model: bd.Model, steps: int, *, share: float = 0.5, gauges: bool = True, **options) -> Plan:
    """Return a plan of some steps of a share of the critical step, with gauges of all walls."""
    dt = share * critical_step(model, bd.VelocityVerlet())
    quantities = ("force", "displacement", "velocity", "growth")
    names = {
        f"{quantity} {wall}": bd.WallGauge(wall, quantity)
        for wall in range(len(model.walls) if gauges else 0) for quantity in quantities
    }  # fmt: skip
    return Plan(duration=steps * dt, dt=dt, gauges=names, **options)
