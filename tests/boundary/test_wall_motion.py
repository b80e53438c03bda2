"""Walls that are free, spherical walls, and walls from stage to stage, against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from tests.models import grains, time_step

E = 1e7


@pytest.mark.parametrize("mass", [1.0, 4188.790204786391, 1e6])
def test_a_free_ball_and_a_sphere_exchange_momentum(mass: float) -> None:
    """An impactor off the line of centres: momentum to rounding, energy to the order of the scheme, e = 1."""
    way = np.array([1.0, 0.3, -0.2]) / math.sqrt(1.13)
    ball = bd.SphereWall(0.5, centre=tuple(-1.6 * way), motion=bd.Free(mass, velocity=tuple(2.0 * way)))
    model = grains([[0, 0, 0]], [1.0], law=bd.LinearContact(E=E), walls=[ball])
    gauges = {"ball": bd.WallGauge(0, "velocity")}
    run = bd.solve_explicit(
        model, duration=0.3, dt=time_step(model, 0.01), every=1, gauges=gauges, state=model.state()
    )
    m, u = float(model.mass[0]), run.state.velocity[0]
    v = run.history["ball"][-1]
    np.testing.assert_allclose(m * u + mass * v, 2.0 * mass * way, rtol=1e-12, atol=1e-12 * mass)
    np.testing.assert_allclose(u, 2.0 * 2.0 * mass / (m + mass) * way, rtol=1e-5)
    given = 0.5 * mass * (4.0 - v @ v)
    assert run.history.energy["work"][-1] == pytest.approx(given, rel=1e-4)
    assert run.residual < 1e-4


def test_a_free_plane_falls_under_its_weight() -> None:
    """Nothing in its way: the scheme is exact."""
    falls = bd.Free(2.0, velocity=(0.0, 0.0, 1.0), force=(0.0, 0.0, -19.62))
    wall = bd.PlaneWall((0, 0, 100.0), (0, 0, -1), motion=falls)
    model = grains([[0, 0, 0]], [1.0], law=bd.LinearContact(E=E), walls=[wall])
    dt, gauges = time_step(model), {"s": bd.WallGauge(0, "displacement"), "v": bd.WallGauge(0, "velocity")}
    run = bd.solve_explicit(model, duration=100 * dt, dt=dt, every=1, gauges=gauges, state=model.state())
    t = run.history.time
    np.testing.assert_allclose(run.history["v"][:, 2], 1.0 - 9.81 * t, rtol=1e-12)
    np.testing.assert_allclose(run.history["s"][:, 2], t - 0.5 * 9.81 * t**2, rtol=1e-9, atol=1e-15)


@pytest.mark.parametrize("inside", [False, True])
def test_a_spherical_wall_presses_along_the_line_of_centres(inside: bool) -> None:
    radius, way = 3.0, np.array([2.0, -1.0, 2.0]) / 3.0
    distance = radius - 1.0 + 1e-3 if inside else radius + 1.0 - 1e-3
    law = bd.LinearContact(E=E, stress_free=False)
    model = grains([distance * way], [1.0], law=law, walls=[bd.SphereWall(radius, inside=inside)])
    dt = 1e-9
    run = bd.solve_explicit(model, duration=3 * dt, dt=dt, every=1, gauges={"wall": bd.WallGauge(0, "force")})
    push = math.pi * E * 1e-3 * (1.0 if inside else -1.0)
    np.testing.assert_allclose(run.history["wall"][0], push * way, rtol=1e-9)


@pytest.mark.parametrize(("place", "nearest"), [
    ((0.3, 0.0, 0.999), None),  # over the hole's middle parts nothing is touched
    ((2.0, 1.0, 0.999), (2.0, 1.0, 0.0)),  # over the disc itself
    ((3.6, 0.0, 0.79), (3.0, 0.0, 0.0)),  # beside the outer rim
    ((0.0, 1.4, 0.79), (0.0, 2.0, 0.0)),  # beside the rim of the hole
])  # fmt: skip
def test_a_disc_with_a_hole_presses_from_its_nearest_place(place, nearest) -> None:
    """Along the line from there to the centre of the sphere; infinitely stiff sideways as little as along."""
    law = bd.LinearContact(E=E, stress_free=False)
    disc = bd.PlaneWall((0, 0, 0), (0, 0, 2.0), outer=3.0, inner=2.0)
    model = grains([list(place)], [1.0], law=law, walls=[disc])
    run = bd.solve_explicit(model, duration=3e-9, dt=1e-9, every=1, gauges={"wall": bd.WallGauge(0, "force")})
    way = np.zeros(3) if nearest is None else np.array(place) - nearest
    overlap = 0.0 if nearest is None else 1.0 - np.linalg.norm(way)
    push = -math.pi * E * overlap * way / max(float(np.linalg.norm(way)), 1e-300)
    np.testing.assert_allclose(run.history["wall"][0], push, rtol=1e-6, atol=1e-6 * math.pi * E * 1e-3)


def test_a_piston_of_finite_mass_gives_back_what_a_sphere_gives_its_rim() -> None:
    """A sphere that meets the rim of a free disc: momentum to rounding, energy to the order of the scheme."""
    piston = bd.PlaneWall((0, 0, -1.3), (0, 0, 1), motion=bd.Free(2000.0, velocity=(0.0, 0.0, 3.0)), outer=0.6)
    model = grains([[1.0, 0, 0]], [1.0], law=bd.LinearContact(E=E), walls=[piston])
    gauges = {"v": bd.WallGauge(0, "velocity")}
    run = bd.solve_explicit(
        model, duration=0.5, dt=time_step(model, 0.01), every=1, gauges=gauges, state=model.state()
    )
    m, u, v = float(model.mass[0]), run.state.velocity[0], run.history["v"][-1]
    np.testing.assert_allclose(m * u + 2000.0 * v, [0.0, 0.0, 6000.0], atol=1e-9 * 6000.0)
    assert u[0] > 0.1
    assert u[2] > 0.1
    assert 0.5 * m * u @ u + 1000.0 * v @ v == pytest.approx(9000.0, rel=1e-4)


def test_a_wall_that_is_held_from_now_on_stands_still() -> None:
    """Before, a wall that had been driven went on by itself in a stage that holds it."""
    law = bd.LinearContact(E=E)

    def stage(motion: bd.Driven | bd.Free | None) -> bd.Model:
        return grains([[0, 0, 0]], [1.0], law=law, walls=[bd.PlaneWall((-3, 0, 0), (1, 0, 0), motion=motion)])

    driven = bd.solve_explicit(stage(bd.Driven(vx=-1.0)), duration=1e-2).state
    held = bd.solve_explicit(stage(None), duration=1e-2, state=driven).state
    np.testing.assert_array_equal(held.walls[0, :3], driven.walls[0, :3])
    let_go = bd.solve_explicit(stage(bd.Free(1.0, velocity=(-2.0, 0.0, 0.0))), duration=1e-2, state=held).state
    assert let_go.walls[0, 0] == pytest.approx(held.walls[0, 0] - 2.0 * let_go.time + 2.0 * held.time, rel=1e-12)
    further = bd.solve_explicit(stage(bd.Free(1.0, velocity=(5.0, 0.0, 0.0))), duration=1e-2, state=let_go).state
    assert further.walls[0, 4] == -2.0
