"""Walls that are free, spherical walls, and walls from stage to stage, against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from tests.verification.test_contacts import E, grains, step


@pytest.mark.parametrize("mass", [1.0, 4188.790204786391, 1e6])
def test_a_free_ball_and_a_sphere_exchange_momentum(mass: float) -> None:
    """An impactor off the line of centres: momentum to rounding, energy to the order of the scheme, e = 1."""
    way = np.array([1.0, 0.3, -0.2]) / math.sqrt(1.13)
    ball = bd.SphereWall(0.5, centre=tuple(-1.6 * way), motion=bd.Free(mass, velocity=tuple(2.0 * way)))
    model = grains([[0, 0, 0]], [1.0], law=bd.LinearContact(E=E), walls=[ball])
    gauges = {"ball": bd.WallGauge(0, "velocity")}
    run = bd.solve_explicit(model, duration=0.3, dt=step(model, 0.01), every=1, gauges=gauges, state=model.state())
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
    dt, gauges = step(model), {"s": bd.WallGauge(0, "displacement"), "v": bd.WallGauge(0, "velocity")}
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
