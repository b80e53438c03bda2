"""Hertz-Mindlin contacts against closed forms."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.interactions.contact.contact_law import rebound
from tests.bits import assert_same_bits
from tests.models import cloud, grains, moving, time_step, walls_of_box

DENSITY, E, NU = 1000.0, 1e7, 0.25
STAR = E / (2.0 * (1.0 - NU**2))
G_STAR = E / (4.0 * (1.0 + NU) * (2.0 - NU))
FLOOR = bd.PlaneWall((0, 0, 0), (0, 0, 1))
PISTON = bd.Driven(x=bd.Ramp(0.0, -3.0, 0.6))


def hertz(mass: float, radius: float, modulus: float, speed: float) -> tuple[float, float]:
    """Duration [s] and deepest overlap [m] of a collision of spheres; Landau and Lifshitz, Elasticity, § 9."""
    k = 4.0 / 3.0 * modulus * math.sqrt(radius)
    deep = (1.25 * mass * speed**2 / k) ** 0.4
    # 2 ∫ du / √(1 - u^(5/2)) from 0 to 1, 2.9433
    return 2.0 * math.sqrt(math.pi) * math.gamma(1.4) / math.gamma(0.9) * deep / speed, deep


@pytest.mark.parametrize("speed", [0.01, 0.1, 1.0])
@pytest.mark.parametrize("partner", ["sphere", "wall"])
def test_a_collision_is_that_of_hertz(partner: str, speed: float, one_thread: None) -> None:
    """Contact time 2.94 u / v with u = (15 m̄ v² / 16 E* √R*)^(2/5): the deepest overlap, as the energy has it."""
    law, ra, rb = bd.HertzMindlin(E=E, nu=NU), 1.0, 0.6
    if partner == "sphere":
        model = grains([[0, 0, 0], [0, 0, ra + rb]], [ra, rb], law=law)
        velocity = [[0, 0, 0.25 * speed], [0, 0, -0.75 * speed]]
        mass = model.mass.prod() / model.mass.sum()
        lasting, deep = hertz(mass, ra * rb / (ra + rb), STAR, speed)
    else:
        model = grains([[0, 0, ra]], [ra], law=law, walls=[FLOOR])
        velocity = [[0, 0, -speed]]
        lasting, deep = hertz(model.mass[0], ra, 2.0 * STAR, speed)
    dt = lasting / 4000.0
    run = bd.solve_explicit(model, duration=1.1 * lasting, dt=dt, every=1, state=moving(model, velocity))
    energy = run.history.energy
    touched = run.history.time[energy["contact"] > 0.0]
    assert touched[-1] - touched[0] == pytest.approx(lasting, rel=1e-3)
    assert lasting == pytest.approx(2.9433 * deep / speed, rel=1e-4)
    # half way the overlap is the deepest, and all energy of the collision is in it
    k = 4.0 / 3.0 * (STAR * math.sqrt(ra * rb / (ra + rb)) if partner == "sphere" else 2.0 * STAR * math.sqrt(ra))
    assert energy["contact"].max() == pytest.approx(0.4 * k * deep**2.5, rel=1e-5)
    half = bd.solve_explicit(
        model, duration=round(0.5 * lasting / dt) * dt, dt=dt, every=0, state=moving(model, velocity)
    ).state.position[:, 2]  # fmt: skip
    gap = half[1] - half[0] - ra - rb if partner == "sphere" else half[0] - ra
    assert -gap == pytest.approx(deep, rel=1e-5)
    assert run.residual < 1e-6


@pytest.mark.parametrize("speed", [0.01, 0.1, 1.0])
@pytest.mark.parametrize("e", [0.95, 0.6, 0.2])
def test_restitution_is_what_was_asked_for(e: float, speed: float, one_thread: None) -> None:
    model = grains([[0, 0, 0], [2.0, 0, 0]], [1.0, 1.0], law=bd.HertzMindlin(E=E, nu=NU, restitution=e))
    lasting, _ = hertz(0.5 * model.mass[0], 0.5, STAR, speed)
    run = bd.solve_explicit(
        model, duration=6.0 * lasting, dt=lasting / 4000.0, every=0,
        state=moving(model, [[0.5 * speed, 0, 0], [-0.5 * speed, 0, 0]]),
    )  # fmt: skip
    found = run.state.velocity[1, 0] - run.state.velocity[0, 0]
    # dashpots are those of half a step before: first order in 1/4000 of the collision
    assert found / speed == pytest.approx(e, rel=3e-3)


def test_restitution_without_the_cut_is_that_of_antypov_and_elliott() -> None:
    """The law of the linear dashpot in u^(5/4): ended where the force vanishes, also beyond critical damping."""
    for beta in (0.05, 0.5, 0.71, 0.95, 0.999999, 1.0, 1.000001, 1.5, 4.0):
        # y'' + 2 β y' + y = 0 from y = 0, y' = 1, until y'' = 0: exactly, by the matrix of the motion
        A = np.array([[0.0, 1.0], [-1.0, -2.0 * beta]])
        values, vectors = np.linalg.eig(A.astype(complex) + 1e-13 * np.eye(2))
        times = np.linspace(0.0, 4.0, 4001)
        share = np.linalg.solve(vectors, np.array([0.0, 1.0]))
        y = (vectors @ (share[:, None] * np.exp(np.outer(values, times)))).real
        push = y[0] + 2.0 * beta * y[1]
        end = int(np.argmax(push < 0.0)) if (push < 0.0).any() else None
        assert end is not None
        assert y[1, end] == pytest.approx(-rebound(beta), abs=2e-3)
    for e in (1.0, 0.9, 0.3, 0.05):
        assert rebound(bd.HertzMindlin(E=1.0, nu=0.2, restitution=e).damping) == pytest.approx(e, rel=1e-12)
    # and less than what spheres that stick together until u = 0 would have
    beta = bd.HertzMindlin(E=1.0, nu=0.2, restitution=0.5).damping
    assert math.exp(-math.pi * beta / math.sqrt(1.0 - beta**2)) < 0.5


def test_a_held_sphere_yields_as_mindlin_says(one_thread: None) -> None:
    """Pressed by P, then pulled by Q < μ P, a sphere that cannot turn moves by Q / ks, ks = 8 G* √(R* u).

    The overlap u is that of F(u) + Q² / 4 ks u = P.
    """
    press, pull = 1e3, 200.0
    law = bd.HertzMindlin(E=E, nu=NU, friction=0.5, restitution=0.3)
    boundary = [
        bd.Load(bd.Index([0]), force=(0, 0, -press), schedule=bd.Ramp(0, 1, 0.3)),
        bd.Load(bd.Index([0]), force=(pull, 0, 0), schedule=bd.Ramp(0, 1, 0.5, begin=1.0)),
        bd.Fix(bd.Index([0]), translation=""),
    ]
    model = grains([[0, 0, 1.0]], [1.0], law=law, walls=[FLOOR], boundary=boundary)
    run = bd.solve_explicit(model, duration=4.0, dt=2e-4, every=0)
    deep = overlap_of(press, pull)
    assert deep < 0.995 * (press / (8.0 / 3.0 * STAR)) ** (2.0 / 3.0)
    assert -run.state.displacement[0, 2] == pytest.approx(deep, rel=1e-3)
    assert run.state.displacement[0, 0] == pytest.approx(pull / (16.0 * G_STAR * math.sqrt(deep)), rel=2e-3)


def overlap_of(press: float, pull: float) -> float:
    """Return the overlap of a unit sphere and a wall under both forces [m], F(u) + Q² / 4 ks u = P."""
    return brentq(
        lambda u: 8.0 / 3.0 * STAR * u**1.5 + pull**2 / (64.0 * G_STAR * u**1.5) - press,
        0.8 * (press / (8.0 / 3.0 * STAR)) ** (2.0 / 3.0), 1.0,
    )  # fmt: skip


def test_friction_of_a_cycle_is_what_slides(one_thread: None) -> None:
    """A sphere moved to and fro by ±A under P: 4 μ P (A - μ P / ks) a cycle, ks of the overlap at which it slides."""
    press, mu = 1e3, 0.5
    stretch = mu * press / (16.0 * G_STAR * math.sqrt(overlap_of(press, mu * press)))
    boundary = [
        bd.Load(bd.Index([0]), force=(0, 0, -press), schedule=bd.Ramp(0, 1, 0.3)),
        bd.Drive(bd.Index([0]), x=bd.Table([0, 4, 8, 16, 24, 32, 40], stretch * np.array([0, 0, 3, -3, 3, -3, 3]))),
        bd.Fix(bd.Index([0]), translation=""),
    ]
    law = bd.HertzMindlin(E=E, nu=NU, friction=mu, restitution=0.3)
    model = grains([[0, 0, 1.0]], [1.0], law=law, walls=[FLOOR], boundary=boundary)
    run = bd.solve_explicit(model, duration=40.0, dt=1e-3, every=8000)
    friction = run.history.energy["friction"]
    cycle = 4.0 * mu * press * (3.0 * stretch - stretch)
    np.testing.assert_allclose(friction[[3, 5]] - friction[[1, 3]], cycle, rtol=2e-3)
    assert abs(run.history.energy["balance"]).max() < 1e-5 * friction[-1]


def slope_of_four(cycles: int, swing: float) -> tuple[np.ndarray, float, bd.History]:
    """Four bonded spheres on a slope of 10° with μ = 0.5, and a normal load that swings at 500 Hz.

    Returns:
        Displacement along the slope after each cycle [m], and the overlap at rest [m], and the records.
    """
    radius, rate, angle, first = 1e-3, 500.0, math.radians(10.0), 10
    side, height = 2.0 * radius, radius * math.sqrt(8.0 / 3.0)
    turn = 2.0 / 3.0 * math.pi * np.arange(3)
    base = side / math.sqrt(3.0) * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(3)])
    place = np.vstack([base, np.array([[0.0, 0.0, height]])]) + np.array([0.0, 0.0, radius])
    pairs = np.array([[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]])
    time = np.linspace(0.0, (first + cycles) / rate, 64 * (first + cycles) + 1)
    load = 1.0 + np.where(time > first / rate, swing * np.sin(2.0 * math.pi * rate * time), 0.0)
    weight = 9.81 * np.array([math.sin(angle), 0.0, -math.cos(angle)])
    model = bd.Model(
        bd.Lattice(bd.Particles(place, np.full(4, radius)), pairs),
        bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.8), 2500.0, walls=[FLOOR],
        contact=bd.HertzMindlin(E=1e8, nu=0.3, friction=0.5, restitution=0.5, stress_free=False),
        boundary=[
            bd.BodyForce((weight[0], 0, 0)), bd.BodyForce((0, 0, weight[2]), schedule=bd.Table(time, load)),
        ],
    )  # fmt: skip
    gauges = {"u": bd.Gauge(bd.Everything(), "displacement")}
    run = bd.solve_explicit(model, duration=time[-1], dt=1.0 / rate / 1500, every=1500, gauges=gauges)
    moved = run.history["u"]
    return moved[first:, 0], -moved[first, 2], run.history


def test_spheres_on_a_slope_do_not_creep(one_thread: None) -> None:
    """Friction at most 0.7 of its limit: less than 1e-3 of the overlap in 100 cycles, and none of it by sliding."""
    moved, overlap, history = slope_of_four(90, 0.5)
    assert 7e-8 < overlap < 1.1e-7
    assert abs(moved[-1] - moved[-51]) < 0.5e-3 * overlap
    friction = history.energy["friction"]
    assert friction[-1] - friction[-51] < 1e-3 * friction[-1]


@pytest.mark.validate
@pytest.mark.parametrize("swing", [0.3, 0.5])
def test_spheres_on_a_slope_do_not_creep_in_a_thousand_cycles(swing: float, one_thread: None) -> None:
    moved, overlap, _ = slope_of_four(1000, swing)
    assert (abs(moved[100:] - moved[:-100]) < 1e-3 * overlap)[50:].all()


def test_a_sphere_slides_at_the_coefficient_that_was_entered() -> None:
    """A pressed sphere that is pulled aside carries μ P; above the largest F_t / F_n of its spring a law warns."""
    press, mu = 1e3, 0.9
    law = bd.HertzMindlin(E=E, nu=NU, friction=mu, restitution=0.3)
    boundary = [
        bd.Load(bd.Index([0]), force=(0, 0, -press), schedule=bd.Ramp(0, 1, 0.3)),
        bd.Drive(bd.Index([0]), vx=0.01),
        bd.Fix(bd.Index([0]), translation=""),
    ]
    model = grains([[0, 0, 1.0]], [1.0], law=law, walls=[FLOOR], boundary=boundary)
    run = bd.solve_explicit(model, duration=4.0, dt=1e-3, every=4000, gauges={"F": bd.WallGauge(0, "force")})
    np.testing.assert_allclose(run.history["F"][-1], [mu * press, 0.0, -press], rtol=1e-4, atol=1e-9)
    with pytest.warns(bd.errors.ContactWarning, match="friction = 2 of HertzMindlin acts as 1.13"):
        bd.HertzMindlin(E=E, nu=NU, friction=2.0)


@pytest.mark.parametrize("slope", [0.2, 0.6, 1.1])
def test_a_sphere_on_an_incline_rolls_or_slides(slope: float, one_thread: None) -> None:
    """Let go on a slope θ: rolls with 5/7 g sin θ where tan θ < 7/2 μ, else slides with g (sin θ - μ cos θ)."""
    mu, g = 0.3, 9.81
    weight = g * np.array([math.sin(slope), 0.0, -math.cos(slope)])
    deep = (DENSITY * 4.0 / 3.0 * math.pi * g * math.cos(slope) / (800.0 / 3.0 * STAR)) ** (2.0 / 3.0)
    # hard, so that it is round
    law = bd.HertzMindlin(E=100.0 * E, nu=NU, friction=mu, restitution=0.5, stress_free=False)
    model = grains([[0, 0, 1.0 - deep]], [1.0], law=law, walls=[FLOOR], boundary=[bd.BodyForce(tuple(weight))])
    run = bd.solve_explicit(model, duration=1.0, dt=2e-5, every=500)
    rolling = math.tan(slope) < 3.5 * mu
    expected = 5.0 / 7.0 * g * math.sin(slope) if rolling else g * (math.sin(slope) - mu * math.cos(slope))
    spin = expected if rolling else 2.5 * mu * g * math.cos(slope)
    assert run.state.velocity[0, 0] == pytest.approx(expected, rel=3e-3)
    assert run.state.angular_velocity[0, 1] == pytest.approx(spin, rel=5e-3)
    assert abs(run.history.energy["balance"]).max() < 1e-4 * run.history.energy["work"][-1]


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # soft spheres that overlap by a seventh
def test_the_ledger_closes_to_second_order(one_thread: None) -> None:
    """Oblique collisions between grains and with a driven wall: springs whose stiffness changes lose, and book it."""
    missed = []
    for share in (0.4, 0.2, 0.1):
        law = bd.HertzMindlin(E=E, nu=NU, friction=0.3, restitution=0.8, overlap=0.1)
        model, state = cloud(4, law, seed=5, walls=walls_of_box(9.2, motion=PISTON))
        dt = time_step(model, share)
        run = bd.solve_explicit(model, duration=0.7, dt=dt, every=20, state=state)
        ledger = run.history.energy
        turned = ledger["work"][-1] + ledger["translation"][0]
        assert ledger["friction"][-1] > 0.01 * turned
        assert ledger["loss"][-1] > 0.01 * turned
        missed.append(float(np.sqrt((ledger["balance"] ** 2).mean())) / turned)
    assert missed[2] < 1e-4
    assert np.log2(missed[0] / missed[2]) / 2.0 > 1.8


def test_the_time_step_counts_the_deepest_overlap(one_thread: None) -> None:
    """Stiffness goes as the root of the overlap, the step as its fourth root; and at it, all is stable."""
    shallow, deep = (
        time_step(grains([[0, 0, 0]], [1.0], law=bd.HertzMindlin(E=E, nu=NU, overlap=u)), 1.0) for u in (1e-4, 1e-2)
    )
    assert shallow / deep == pytest.approx(100.0**0.25, rel=1e-9)
    model = grains([[0, 0, 0], [2.0, 0, 0]], [1.0, 1.0], law=bd.HertzMindlin(E=E, nu=NU))
    _, u = hertz(0.5 * model.mass[0], 0.5, STAR, 1.0)
    speed = (0.01 / u) ** 1.25  # whose overlap is 0.01
    state = moving(model, [[0.5 * speed, 0, 0], [-0.5 * speed, 0, 0]])
    run = bd.solve_explicit(model, duration=1.0, every=0, state=state)
    assert run.state.velocity[1, 0] == pytest.approx(0.5 * speed, rel=1e-2)


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # soft spheres that overlap by a seventh
def test_going_on_from_a_run_file_changes_no_bit(tmp_path: Path, one_thread: None) -> None:
    law = bd.HertzMindlin(E=E, nu=NU, friction=0.4, restitution=0.7)
    model, state = cloud(4, law, seed=5, speed=4.0, walls=walls_of_box(9.2, motion=PISTON))
    dt = time_step(model, 0.5)
    options, path = {"dt": dt, "every": 7, "save_every": 50}, tmp_path / "run.h5"
    whole = bd.solve_explicit(model, duration=600 * dt, state=state, **options)
    assert whole.history.energy["friction"][-1] > 0.01 * whole.history.energy["translation"][0]
    bd.solve_explicit(model, duration=400 * dt, state=state, out=path, **options)
    kept = bd.read_run(path)
    assert kept.model.contact == model.contact
    assert len(kept.state.touching) > 3
    resumed = integrate(kept.model, replace(kept.plan, duration=600 * dt), state=kept.state, history=kept.history)
    assert_same_bits(whole, resumed)
