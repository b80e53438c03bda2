"""Models, states and time steps that tests of several subjects share; their specimens are in `tests.specimens`."""

from collections.abc import Sequence
from typing import Any

import numpy as np

import bondem as bd
from bondem.dynamics.timestep import critical_step
from tests.specimens import bar, crooked_block, loose, row, two_cubes

VERLET = bd.VelocityVerlet()
STONE = bd.CellBond(E=1e9, nu=0.2)


def time_step(model: bd.Model, share: float = 0.5, *damping: bd.AnyDamping) -> float:
    """A share of the critical step of velocity Verlet [s]."""
    return share * critical_step(model, VERLET, *damping)


# ---- states


def moving(model: bd.Model, velocity, spin=None) -> bd.State:
    """State at rest positions with velocities [m/s] and angular velocities [rad/s] of all elements."""
    state = model.state()
    state.set_motion(velocity=np.asarray(velocity, dtype=float), angular_velocity=spin)
    return state


def stirred(model: bd.Model, speed: float = 1.0, *, spin: float = 0.0, seed: int = 0) -> bd.State:
    """State at rest positions with normal random velocities [m/s] and angular velocities [rad/s]."""
    rng = np.random.default_rng(seed)
    shape = (len(model.lattice.particles), 3)
    return moving(model, speed * rng.standard_normal(shape), spin * rng.standard_normal(shape))


# ---- models


def clamped(body: bd.Lattice, law: bd.BondLaw | bd.CellBond, **load) -> bd.Model:
    """Body of unit density that is clamped at x_min, and loaded at x_max where a force or moment is given."""
    loads = [bd.Load(bd.Face("x_max"), **load)] if load else []
    return bd.Model(body, law, 1.0, boundary=[bd.Fix(bd.Face("x_min")), *loads])


def cantilever(
    lattice: bd.Lattice, law: bd.BondLaw, density: float, *, ramp: float | None = None, **load
) -> bd.Model:
    """Row of elements of which the first is fixed and the last is loaded, at once or along a ramp [s]."""
    schedule = bd.Constant(1.0) if ramp is None else bd.Ramp(0.0, 1.0, ramp)
    tip = bd.Load(bd.Index([len(lattice.particles) - 1]), schedule=schedule, **load)
    return bd.Model(lattice, law, density, boundary=[bd.Fix(bd.Index([0])), tip])


def crooked_beams(count: int, failure: bd.Criterion | None = None, *, E: float = 1e7, **options) -> bd.Model:
    """Crooked block of count³ elements of 1000 kg/m³ with Timoshenko beams of a modulus E [Pa]."""
    law = bd.Timoshenko(E=E, nu=0.2, radius_ratio=0.6)
    return bd.Model(crooked_block((count,) * 3), law, 1000.0, failure=failure, **options)


def loaded_row(force: tuple[float, float, float], *, ramp: float | None = None, **law) -> bd.Model:
    """Cantilever of twelve spheres 1 mm apart, with a force [N] on the last; options of the law."""
    beams = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5, **law)
    return cantilever(row(12), beams, 2500.0, ramp=ramp, force=force)


def torn_row() -> bd.Model:
    """Twelve spheres 1 mm apart, fixed at one end and pulled at the other until bonds break."""
    ends = [bd.Fix(bd.Index([0])), bd.Drive(bd.Index([11]), vx=bd.Ramp(0.0, 2.0, 1e-5))]
    law = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
    return bd.Model(row(12), law, 2500.0, failure=bd.PeripheralStress(tension=50e6, shear=1e9), boundary=ends)


def turned_cubes() -> tuple[bd.Model, bd.State]:
    """Two cubes of 1 m, the second turned by 90 degrees about x and moved along x, with two walls."""
    walls = [bd.PlaneWall((0, 0, 0), (1, 0, 0)), bd.SphereWall(0.2, (3.0, 0.5, 0.5))]
    model = bd.Model(two_cubes(), STONE, 1e3, contact=bd.LinearContact(E=1e9), walls=walls)
    state, half = model.state(), np.sqrt(0.5)
    place = np.array([[0.5, 0.5, 0.5], [1.9, 0.5, 0.5]])
    state.set_pose(position=place, orientation=np.array([[1.0, 0.0, 0.0, 0.0], [half, half, 0.0, 0.0]]))
    state.walls[1, :3] = -0.4, 0.0, 0.0
    return model, state


def parted(body: bd.Lattice, side: np.ndarray, law: bd.CellBond | bd.BondLaw = STONE, to: float = 0.0) -> bd.State:
    """State in which all facets or bonds between two sides have an integrity."""
    state = bd.Model(body, law, 1e3).state()
    between = side[body.pairs[:, 0]] != side[body.pairs[:, 1]]
    state.integrity[between[state.layout.bond_order]] = to
    return state


def grains(
    position, radius: float | Sequence | np.ndarray = 1.0, *, law: bd.ContactLaw | None, period=None, **options
) -> bd.Model:
    """Model of spheres without bonds of 1000 kg/m³, which touch by a contact law."""
    return bd.Model(loose(position, radius, period=period), None, 1000.0, contact=law, **options)


def walls_of_box(edge: float, **of_last) -> list[bd.PlaneWall]:
    """The six plane walls of a cube with a corner at the origin; options of the one at x = edge."""
    walls = [bd.PlaneWall((0, 0, 0), axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    walls += [bd.PlaneWall((0, edge, 0), (0, -1, 0)), bd.PlaneWall((0, 0, edge), (0, 0, -1))]
    return [*walls, bd.PlaneWall((edge, 0, 0), (-1, 0, 0), **of_last)]


def cloud(
    edge: int, law: bd.ContactLaw, *, seed: int = 3, speed: float = 1.0, **options
) -> tuple[bd.Model, bd.State]:
    """Spheres of many sizes on a loose grid of edge³ places 2.3 m apart, thrown about."""
    rng = np.random.default_rng(seed)
    position = 2.3 * np.indices((edge,) * 3).reshape(3, -1).T + 1.15
    model = grains(position, rng.uniform(0.8, 1.1, len(position)), law=law, **options)
    return model, moving(model, speed * rng.normal(size=position.shape), rng.normal(size=position.shape))


# ---- concrete that softens

CONCRETE = bd.Rankine(tension=4e6, fracture_energy=50.0)
PULL = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), vx=0.1)]


def pulled(body: bd.Lattice, way: float = 1e-6, nu: float = 0.2, **given: Any) -> bd.Model:
    """Concrete pulled along x by `way` [m] between platens that leave its sides free; strengths by name."""
    failure = bd.Rankine(**{"tension": CONCRETE.tension, "fracture_energy": CONCRETE.fracture_energy} | given)
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=way)]
    law = bd.CellBond(E=40e9, nu=nu, facet_rotation="full")
    return bd.Model(body, law, density=2500.0, failure=failure, boundary=ends)


def follow(model: bd.Model, **given: Any) -> bd.QuasistaticResult:
    """Path of load factors, one event at a time."""
    return bd.solve_quasistatic(model, bd.Face("x_max"), together=0.0, **given)


def slowly_torn(failure: bd.Criterion, share: float = 0.9, speed: float = 0.1) -> tuple[bd.Model, float]:
    """Bar of 250 cells of concrete pulled apart, slowly enough for one crack; and a share of its step."""
    law = bd.CellBond(E=40e9, nu=0.2, facet_rotation="full")
    ends = PULL if speed == 0.1 else [PULL[0], bd.Drive(bd.Face("x_max"), vx=speed)]
    model = bd.Model(bar(250), law, density=2500.0, failure=failure, boundary=ends)
    return model, time_step(model, share)


def torn_then_pressed(failure: bd.Criterion) -> tuple[bd.Model, float]:
    """Body of 1200 cells of concrete torn fast and then pressed, so that cracks open, close and rub; and its step."""
    way = bd.Table([0.0, 1e-5, 1.2e-5, 4e-5], [1.0, 1.0, -2.0, -2.0])
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=way)]
    model = bd.Model(bar(1200), bd.CellBond(E=40e9, nu=0.2), density=2500.0, failure=failure, boundary=ends)
    return model, time_step(model, 0.9)


# ---- what runs keep


def momenta(model: bd.Model, state: bd.State) -> tuple[np.ndarray, np.ndarray]:
    """Momentum [N·s] and angular momentum about the origin [N·m·s]."""
    p = model.mass[:, None] * state.velocity
    spin = model.inertia[:, None] * state.angular_velocity
    return p.sum(axis=0), (np.cross(state.position, p) + spin).sum(axis=0)


def total_energy(history: bd.History) -> np.ndarray:
    """Kinetic and elastic energy of each record [J]."""
    parts = ("translation", "rotation", "normal", "shear", "bending", "twisting")
    return sum((history.energy[part] for part in parts), np.zeros(len(history)))
