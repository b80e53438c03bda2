"""Models, states and time steps that tests of several subjects share; their specimens are in `tests.specimens`."""

import numpy as np

import bondem as bd
from bondem.solve.timestep import critical_step
from tests.specimens import loose

VERLET = bd.VelocityVerlet()


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


def grains(position, radius=1.0, *, law: bd.ContactLaw | None, period=None, **options) -> bd.Model:
    """Model of spheres without bonds of 1000 kg/m³, which touch by a contact law."""
    return bd.Model(loose(position, radius, period=period), None, 1000.0, contact=law, **options)


def walls_of_box(edge: float, **of_last) -> list[bd.PlaneWall]:
    """The six plane walls of a cube with a corner at the origin; options of the one at x = edge."""
    walls = [bd.PlaneWall(np.zeros(3), axis) for axis in np.eye(3)]
    walls += [bd.PlaneWall(edge * axis, -axis) for axis in np.eye(3)[1:]]
    return [*walls, bd.PlaneWall((edge, 0, 0), (-1, 0, 0), **of_last)]


def cloud(
    edge: int, law: bd.ContactLaw, *, seed: int = 3, speed: float = 1.0, **options
) -> tuple[bd.Model, bd.State]:
    """Spheres of many sizes on a loose grid of edge³ places 2.3 m apart, thrown about."""
    rng = np.random.default_rng(seed)
    position = 2.3 * np.indices((edge,) * 3).reshape(3, -1).T + 1.15
    model = grains(position, rng.uniform(0.8, 1.1, len(position)), law=law, **options)
    return model, moving(model, speed * rng.normal(size=position.shape), rng.normal(size=position.shape))
