"""Resistance of contacts to rolling and twisting against closed forms, conservation laws and run files."""

import math
import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from tests.bits import assert_same_bits
from tests.core.contact_cases import HERTZIAN, ROLLING, all_walls, cloud, plan_of
from tests.models import grains, momenta, moving

E, G = 1e9, 9.81
FLOOR = bd.PlaneWall((0, 0, 0), (0, 0, 1))
LAWS = {
    "linear": lambda **given: bd.LinearContact(E=E, damping=0.3, stress_free=False, **given),
    "Hertzian": lambda **given: bd.HertzMindlin(E=E, nu=0.25, restitution=0.4, stress_free=False, **given),
}


def on_slope(law: bd.ContactLaw, slope: float) -> bd.Model:
    """Return a ball of unit radius and 1000 kg/m³ on the floor, with gravity turned by a slope."""
    weight = bd.BodyForce((G * math.sin(slope), 0, -G * math.cos(slope)))
    return grains([[0, 0, 1.0]], [1.0], law=law, walls=[FLOOR], boundary=[weight])


@pytest.mark.parametrize("kind", LAWS)
@pytest.mark.parametrize(
    ("mu", "mu_r", "tangent", "rests"),
    [(0.5, 0.2, 0.19, True), (0.5, 0.2, 0.21, False), (0.2, 0.5, 0.19, True), (0.2, 0.5, 0.21, False)],
)
def test_a_ball_rests_on_a_slope(
    kind: str, mu: float, mu_r: float, tangent: float, rests: bool, one_thread: None
) -> None:
    """It does iff tan α <= min(μ, μ_r), and then moves by less than its springs stretch."""
    slope = math.atan(tangent)
    run = bd.solve_explicit(on_slope(LAWS[kind](friction=mu, rolling=mu_r), slope), duration=1.5, every=0)
    away = run.state.displacement[0, 0]
    if rests:
        assert abs(away) < 1e-3
        return
    # it slides where friction is less, and else rolls: 7/5 a = g (sin α - μ_r cos α)
    down = G * (math.sin(slope) - min(mu, mu_r) * math.cos(slope))
    assert away == pytest.approx(0.5 * down * (1.0 if mu < mu_r else 5.0 / 7.0) * 1.5**2, rel=0.1)


@pytest.mark.parametrize("kind", LAWS)
def test_a_rolling_ball_stops(kind: str, one_thread: None) -> None:
    """After 7 v² / 10 μ_r g; all its energy is then in "friction"."""
    mu_r, speed = 0.1, 1.0
    model = on_slope(LAWS[kind](friction=0.8, rolling=mu_r), 0.0)
    state = moving(model, [[speed, 0, 0]], [[0, speed, 0]])
    run = bd.solve_explicit(model, duration=2.5, every=100, state=state)
    assert run.state.displacement[0, 0] == pytest.approx(0.7 * speed**2 / (mu_r * G), rel=1e-2)
    energy = run.history.energy
    assert energy["friction"][-1] == pytest.approx(energy["translation"][0] + energy["rotation"][0], rel=1e-2)
    assert abs(energy["balance"]).max() < 1e-4 * energy["friction"][-1]


@pytest.mark.parametrize("kind", LAWS)
def test_a_spinning_ball_stops(kind: str, one_thread: None) -> None:
    """About the normal of the wall: ω falls by 5 μ_w g / 2 R in unit time."""
    mu_w, spin = 0.1, 3.0
    model = on_slope(LAWS[kind](friction=0.8, twisting=mu_w), 0.0)
    duration = 0.5 * spin / (2.5 * mu_w * G)
    settled = bd.solve_explicit(model, duration=1.0, every=0).state
    settled.set_motion(angular_velocity=[[0, 0, spin]])
    run = bd.solve_explicit(model, duration=duration, every=0, state=settled)
    assert run.state.angular_velocity[0, 2] == pytest.approx(0.5 * spin, rel=1e-2)


def test_two_spheres_stop_turning_against_each_other(one_thread: None) -> None:
    """Pressed together, with opposite spins across and along the normal: the moment is μ F R̄ on each."""
    press, spin = 1e5, 0.5
    law = bd.LinearContact(E=E, rolling=0.2, twisting=0.1)
    sides = [bd.Load(bd.Index([e]), force=(press * (1 - 2 * e), 0, 0)) for e in (0, 1)]
    model = grains([[0, 0, 0], [1.6, 0, 0]], [1.0, 0.6], law=law, boundary=sides)
    u = press / (math.pi * E * 0.36 / 1.6)
    state = model.state()
    state.position = [[0, 0, 0], [1.6 - u, 0, 0]]
    state.set_motion(angular_velocity=[[spin, 0, spin], [-spin, 0, -spin]])
    before = momenta(model, state)
    duration = 0.008
    run = bd.solve_explicit(model, duration=duration, every=10, state=state)
    arm = 1.0 * 0.6 / 1.6
    for mine, sign in ((0, -1.0), (1, 1.0)):
        change = run.state.angular_velocity[mine, [0, 2]] - sign * np.array([-spin, -spin])
        expected = sign * np.array([0.1, 0.2]) * press * arm * duration / model.inertia[mine]
        np.testing.assert_allclose(change, expected, rtol=2e-2)
    for now, then in zip(momenta(model, run.state), before, strict=True):
        np.testing.assert_allclose(now, then, rtol=0, atol=1e-9 * spin * model.inertia[0])
    assert run.history.energy["friction"][-1] > 0.0
    assert abs(run.history.energy["balance"]).max() < 1e-4 * run.history.energy["friction"][-1]


SOFT, HARD = ROLLING, replace(HERTZIAN, rolling=0.3, twisting=0.2)
# clouds are fast and soft
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning"),
]


@pytest.mark.parametrize("law", [SOFT, HARD], ids=["linear", "Hertzian"])
def test_threads_pauses_and_files_change_no_bit(
    law: bd.ContactLaw, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    results = []
    for count, every in ((1, 40), (3, 7)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        model, state = cloud(9, law, walls=all_walls(21.0), speed=30.0)
        results.append(integrate(model, plan_of(model, 120, every=every), state=state, loop_of=CoreLoop))
    assert len(results[0].state.rolled) > 20
    assert np.abs(results[0].state.wall_rolled).max() > 0.0
    for name in ("rolled", "wall_rolled"):
        np.testing.assert_array_equal(getattr(results[0].state, name), getattr(results[1].state, name))
    assert_same_bits(*results)

    model, state = cloud(4, law, walls=all_walls(9.2))
    whole = bd.solve_explicit(model, duration=300 * 1e-4, dt=1e-4, every=20, state=state)
    model, state = cloud(4, law, walls=all_walls(9.2))
    path = tmp_path / "run.h5"
    bd.solve_explicit(model, duration=140 * 1e-4, dt=1e-4, every=20, state=state, out=path, save_every=20)
    kept = bd.read_run(path)
    assert len(kept.state.rolled) == len(kept.state.touching) > 0
    assert_same_bits(
        whole, integrate(kept.model, replace(kept.plan, duration=300 * 1e-4), state=kept.state, history=kept.history)
    )


def test_a_law_without_rolling_keeps_no_memory_of_it() -> None:
    model, state = cloud(4, SOFT)
    state = integrate(model, plan_of(model, 100), state=state).state
    assert len(state.rolled) == len(state.touching) > 0
    without = replace(model, contact=bd.LinearContact(E=1e7, friction=0.4))
    after = bd.solve_explicit(without, state=state, duration=1e-3, every=0).state
    assert len(after.rolled) == len(after.wall_rolled) == 0


@pytest.mark.validate
def test_the_example_of_piles() -> None:
    """Grains that resist rolling rest on a steeper slope."""
    smooth, rough = runpy.run_path(str(Path(__file__).parents[2] / "examples/pile.py"))["main"]()
    assert 10.0 < smooth < 18.0
    assert 1.3 * smooth < rough < math.degrees(math.atan(0.5))


@pytest.mark.parametrize("name", ["rolling", "twisting"])
def test_a_coefficient_is_not_negative(name: str) -> None:
    for law in LAWS.values():
        with pytest.raises(bd.errors.InputError, match=f"{name} = -0.1; give a coefficient of zero or more"):
            law(**{name: -0.1})


@pytest.mark.parametrize("kind", LAWS)
def test_a_turning_wall_spins_a_ball_by_its_resistance(kind: str, one_thread: None) -> None:
    """About the normal: μ_w R F_n on the ball, the opposite on the wall, whose work is kept or lost."""
    mu_w = 0.1
    wall = bd.PlaneWall((0, 0, 0), (0, 0, 1), motion=bd.Driven(spin=2.0, axis=(0, 0, 1)))
    law = LAWS[kind](twisting=mu_w)
    model = grains([[0, 0, 1.0]], [1.0], law=law, walls=[wall], boundary=[bd.BodyForce((0, 0, -G))])
    state = model.state()
    weight = model.mass[0] * G
    gauges = {"T": bd.WallGauge(0, "torque")}
    run = bd.solve_explicit(model, duration=0.5, every=100, state=state, gauges=gauges)
    spin = run.state.angular_velocity[0, 2]
    assert spin == pytest.approx(2.5 * mu_w * G * 0.5, rel=3e-2)
    torque = run.history["T"][len(run.history.time) // 2 :, 2]
    assert torque.mean() == pytest.approx(-mu_w * weight, rel=3e-2)
    assert abs(run.history.energy["balance"]).max() < 1e-4 * run.history.energy["work"][-1]
