"""Walls that turn, prescribed or freely, against closed forms and conservation laws."""

import math
import runpy
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.boundary.wall_rows import wall_rows
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError
from tests.bits import EnoughError, assert_same_bits
from tests.models import VERLET, grains, moving, time_step
from tests.scripts import python
from tests.specimens import spheres

E, DENSITY = 1e7, 1000.0
MASS = 4.0 / 3.0 * math.pi * DENSITY  # of a sphere of 1 m
LAW = bd.LinearContact(E=E, friction=0.4)
DRUM = {"spin": 2.0, "axis": (0, 1, 0)}


def polygon(sides: int, radius: float, **drum) -> list[bd.PlaneWall]:
    """Planes around the y axis that turn as one body."""
    angles = 2.0 * np.pi * np.arange(sides) / sides
    return [
        bd.PlaneWall((radius * math.cos(a), 0, radius * math.sin(a)), (-math.cos(a), 0, -math.sin(a)),
                     motion=bd.Driven(**drum))
        for a in angles
    ]  # fmt: skip


def nine(walls, *, seed: int = 0, law: bd.ContactLaw = LAW) -> tuple[bd.Model, bd.State]:
    """Nine spheres with random motions within walls."""
    rng = np.random.default_rng(seed)
    place = np.array([[x, 0, z] for x in (-2.2, 0, 2.2) for z in (-2.2, 0.0, 2.2)])
    model = grains(place + rng.uniform(-0.05, 0.05, (9, 3)), np.ones(9), law=law, walls=walls)
    return model, moving(model, rng.uniform(-1, 1, (9, 3)), rng.uniform(-1, 1, (9, 3)))


def test_a_turning_cylinder_drags_a_ball_from_slip_to_rolling() -> None:
    """v = μ g t until 2 V / (7 μ g), then 2 V / 7: the ball keeps m v - 2/5 m r ω = 0 at the place of contact."""
    g, friction, speed, far = 9.81, 0.3, 0.5, 1e4
    law = bd.LinearContact(E=1e10, friction=friction, damping=0.3, stress_free=False)
    sunk, end = MASS * g / (math.pi * 1e10), 2.0 * speed / (7.0 * friction * g)
    turn = bd.Driven(spin=-speed / far, axis=(0, 1, 0), about=(0, 0, far - 1.0))
    drum = bd.CylinderWall(far, (0, 0, far - 1.0), (0, 1, 0), motion=turn)
    model = grains([[0, 0, -sunk]], law=law, walls=[drum], boundary=[bd.BodyForce((0, 0, -g))])
    gauges = {"v": bd.Gauge(bd.Everything(), "velocity"), "torque": bd.WallGauge(0, "torque")}
    run = bd.solve_explicit(
        model, duration=2.0 * end, dt=time_step(model, 0.1), every=5, gauges=gauges, state=model.state()
    )
    t, v = run.history.time, run.history["v"][:, 0]
    slips = (t > 0.1 * end) & (t < 0.9 * end)
    np.testing.assert_allclose(v[slips], friction * g * t[slips], rtol=5e-3)
    np.testing.assert_allclose(run.history["torque"][slips, 1], friction * MASS * g * far, rtol=1e-5)
    assert v[-1] == pytest.approx(2.0 * speed / 7.0, rel=1e-6)
    np.testing.assert_allclose(run.state.angular_velocity[0], [0.0, -2.5 * v[-1], 0.0], rtol=1e-5, atol=1e-9)
    assert run.residual < 1e-6


@pytest.mark.parametrize("walls", [
    polygon(6, 4.3, **DRUM),
    [bd.CylinderWall(4.2, (0, 0, 0), (0, 1, 0), motion=bd.Driven(**DRUM))],
    [bd.CylinderWall(4.2, (0, 0, 0), (0, 1, 0), motion=bd.Driven(spin=2.0, axis=(1, 1, 0), about=(0, 2, 0)))],
], ids=["planes", "cylinder", "tumbling cylinder"])  # fmt: skip
def test_torque_by_angle_is_work_and_the_energy_closes_in_second_order(walls) -> None:
    """The work of a turn is ∫ T dθ; the ledger closes to the order of the scheme, also where normals turn."""
    residuals = []
    for share in (0.2, 0.1, 0.05):
        model, state = nine(walls)
        count = range(len(walls))
        gauges = {f"{name}{k}": bd.WallGauge(k, name) for k in count for name in ("torque", "power")}
        gauges["spin"] = bd.WallGauge(0, "angular_velocity")
        run = bd.solve_explicit(
            model, duration=1.0, dt=time_step(model, share), every=1, gauges=gauges, state=state
        )
        h, work = run.history, run.history.energy["work"][-1]
        torque, power = (sum(h[f"{name}{k}"] for k in count) for name in ("torque", "power"))
        np.testing.assert_allclose(h["spin"][1:], h["spin"][1:2].repeat(len(h.time) - 1, axis=0), rtol=1e-12)
        angle = h["spin"][1] * h.time[-1]
        by_hand = -np.trapezoid(torque @ h["spin"][1], h.time)
        assert by_hand == pytest.approx(work, rel=1e-6)
        assert np.trapezoid(power[:, 2], h.time) == pytest.approx(work, rel=1e-6)
        np.testing.assert_allclose(
            Rotation.from_rotvec(angle).inv().apply(Rotation.from_quat(run.state.wall_orientation[0][[1, 2, 3, 0]])
                                                    .apply(np.eye(3))), np.eye(3), atol=1e-12)  # fmt: skip
        residuals.append(run.residual)
    assert abs(work) > 1e3
    assert residuals[2] < 5e-5
    assert residuals[2] < 0.2 * residuals[0]


def test_a_ball_that_turns_with_its_drum_feels_nothing_but_the_centripetal_force() -> None:
    """In the frame of the wall it rests: no torque, no friction, and the force is m ω² r."""
    turn, radius = 2.0, 5.0
    overlap = MASS * turn**2 * (radius - 1.0) / (math.pi * E - MASS * turn**2)
    reach = radius - 1.0 + overlap
    law = bd.LinearContact(E=E, friction=0.5, stress_free=False)
    drum = bd.CylinderWall(radius, (0, 0, 0), (0, 1, 0), motion=bd.Driven(spin=turn, axis=(0, 1, 0)))
    model = grains([[reach, 0, 0]], law=law, walls=[drum])
    gauges = {"force": bd.WallGauge(0, "force"), "torque": bd.WallGauge(0, "torque")}
    run = bd.solve_explicit(
        model, duration=math.pi, dt=time_step(model, 0.05), every=20, gauges=gauges,
        state=moving(model, [[0, 0, -turn * reach]], [[0, turn, 0]]),
    )  # fmt: skip
    push = np.linalg.norm(run.history["force"][1:], axis=1)
    np.testing.assert_allclose(push, MASS * turn**2 * reach, rtol=1e-5)
    assert np.abs(run.history["torque"]).max() < 1e-6 * push.max() * radius
    assert run.history.energy["friction"][-1] < 1e-9 * run.history.energy["translation"][0]


def test_grains_in_a_drum_keep_the_balance_of_their_angular_momentum() -> None:
    """d/dt Σ (m x × v + I ω) about the axis is M g x̄ less the torque of the grains on the drum, at every moment."""
    g, drum = 9.81, polygon(8, 4.3, **DRUM)
    ends = [bd.PlaneWall((0, y, 0), (0, -y, 0), friction=0.0) for y in (-1.05, 1.05)]
    model, state = nine([*drum, *ends])
    model = bd.Model(
        model.lattice, None, DENSITY, contact=LAW, walls=model.walls, boundary=[bd.BodyForce((0, 0, -g))]
    )
    state.begin(model)
    where = bd.Gauge(bd.Everything(), "displacement")
    gauges = {"place": where} | {f"torque{k}": bd.WallGauge(k, "torque") for k in range(8)}

    def momentum(of: bd.State) -> float:
        turning = MASS * np.cross(of.position, of.velocity) + 0.4 * MASS * of.angular_velocity
        return float(turning[:, 1].sum())

    before = momentum(state)
    run = bd.solve_explicit(
        model, duration=1.5, dt=time_step(model, 0.1), every=1, gauges=gauges, state=state
    )
    torque = sum(run.history[f"torque{k}"][:, 1] for k in range(8))
    middle = run.history["place"][:, 0] + model.lattice.centre[:, 0].mean()
    weight = 9.0 * MASS * g * middle  # (x × m g)_y = x m g
    change = momentum(run.state) - before
    assert np.abs(change) > 1e4
    assert change == pytest.approx(np.trapezoid(weight - torque, run.history.time), rel=1e-5)


def test_agglomerates_that_break_in_a_drum_keep_the_balance_of_their_angular_momentum() -> None:
    """As grains do, whatever breaks and rubs."""
    rock = spheres(bd.Ball(radius=5e-3), 30, seed=1, reach=1.01)
    places = [(11e-3 * (i - 1.5), 0.0, -25e-3 + 11e-3 * k) for i in range(4) for k in range(3)]
    turn = bd.Driven(spin=20.0, axis=(0, 1, 0))
    ends = [bd.PlaneWall((0, side * 6e-3, 0), (0, -side, 0), friction=0.0) for side in (-1, 1)]
    model = bd.Model(
        bd.replicate(rock, places, rotations="random", seed=1), bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6),
        2500.0, contact=bd.LinearContact(E=1e7, friction=0.5, damping=0.2), boundary=[bd.Gravity()],
        walls=[bd.CylinderWall(36e-3, axis=(0, 1, 0), motion=turn), *ends],
        failure=bd.PeripheralStress(tension=1e5, shear=2e5),
    )  # fmt: skip
    start = model.state()
    start.velocity = (0.0, 0.0, -2.0)
    gauges = {str(k): bd.Gauge(bd.Index([k]), "displacement") for k in range(len(model.mass))}
    run = bd.solve_explicit(model, duration=4e-3, every=20, state=start.copy(), gauges=gauges)

    def momentum(of: bd.State) -> float:
        orbit = model.mass @ np.cross(of.position, of.velocity)[:, 1]
        return float(orbit + model.inertia @ of.angular_velocity[:, 1])

    moved = sum(m * run.history[str(k)] for k, m in enumerate(model.mass))
    x, drop = moved[:, 0] + model.mass @ model.lattice.centre[:, 0], -moved[-1, 2]
    # the impulse of the drum is its work over its spin
    drum = (run.history.energy["work"][-1] - 9.81 * drop) / 20.0
    given = 9.81 * np.trapezoid(x, run.history.time) + drum
    assert 0.02 < len(run.events) / len(model.lattice.pairs) < 0.9
    assert run.history.energy["friction"][-1] > 0.0
    assert momentum(run.state) - momentum(start) == pytest.approx(given, rel=1e-4)


@pytest.mark.validate
def test_a_drum_with_lifters_takes_the_torque_of_its_charge(capsys) -> None:
    """The example asserts it: M g x̄ within 1 % over a turn, and the power T ω."""
    path = Path(__file__).parents[2] / "examples" / "drum.py"
    run = runpy.run_path(str(path))["main"]()
    assert run.residual < 1e-3
    assert "N m" in capsys.readouterr().out


def test_a_free_wall_turns_after_eulers_equations() -> None:
    """About its intermediate axis, where it tumbles, beside an integration of eighth order; of second order."""
    moments, spin = np.array([1.0, 2.0, 3.0]), np.array([0.1, 1.0, 0.1])

    def rates(_: float, y: np.ndarray) -> np.ndarray:
        (a, b, c, d), w = y[:4], y[4:]
        turn = [-b * w[0] - c * w[1] - d * w[2], a * w[0] + c * w[2] - d * w[1], a * w[1] - b * w[2] + d * w[0],
                a * w[2] + b * w[1] - c * w[0]]  # fmt: skip
        return np.concatenate([0.5 * np.array(turn), np.cross(moments * w, w) / moments])

    errors = []
    for dt, inertia, axes in ((2e-3, tuple(moments), np.eye(3)), (5e-4, None, None)):
        if inertia is None:  # the same body with principal axes along none of the coordinates
            axes = Rotation.from_rotvec([0.4, -0.7, 0.2]).as_matrix()
            matrix = axes @ np.diag(moments) @ axes.T
            inertia = tuple(tuple(row) for row in 0.5 * (matrix + matrix.T))
        body = bd.Free(2.0, inertia=inertia, spin=tuple(axes @ spin))
        wall = bd.PlaneWall((0, 0, -50.0), (0, 0, 1), outer=1.0, motion=body)
        model = grains([[0, 0, 0]], law=bd.LinearContact(E=1e3), walls=[wall])
        gauges = {"spin": bd.WallGauge(0, "angular_velocity"), "turn": bd.WallGauge(0, "rotation")}
        run = bd.solve_explicit(model, duration=10.0, dt=dt, every=100, gauges=gauges, state=model.state())
        t = run.history.time
        exact = solve_ivp(rates, (0.0, t[-1]), [1, 0, 0, 0, *spin], "DOP853", t, rtol=1e-12, atol=1e-13)
        turned = Rotation.from_quat(exact.y[[1, 2, 3, 0]].T)
        away = run.history["spin"] - turned.apply(exact.y[4:].T) @ axes.T
        found = Rotation.from_rotvec(run.history["turn"])
        apart = (Rotation.from_matrix(axes) * turned * Rotation.from_matrix(axes.T) * found.inv()).magnitude()
        errors.append(max(float(np.abs(away).max()), float(apart.max())))
        assert float(turned.magnitude().max()) > 2.0
        momentum = wall_rows(run.state.walls)["momentum"][0]
        np.testing.assert_allclose(momentum, axes @ (moments * spin), rtol=1e-12)
    assert errors[1] < 1e-6
    assert errors[1] == pytest.approx(errors[0] / 16.0, rel=0.05)


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_a_ball_and_a_free_disc_exchange_both_momenta(friction: float) -> None:
    """Off the centre of a disc that turns: momenta to rounding, and energy to the order of the scheme."""
    inertia = ((900.0, 30.0, -20.0), (30.0, 900.0, 10.0), (-20.0, 10.0, 1700.0))
    spin, start = np.array([0.1, 0.2, 0.3]), np.array([0.0, 0.0, -1.3])
    body = bd.Free(2000.0, velocity=(0, 0, 3.0), inertia=inertia, spin=tuple(spin))
    disc = bd.PlaneWall(tuple(start), (0, 0, 1), outer=1.6, motion=body)
    law = bd.LinearContact(E=E, friction=friction)
    model = grains([[1.0, 0.4, 0]], law=law, walls=[disc])
    run = bd.solve_explicit(model, duration=0.4, dt=time_step(model, 0.05), state=model.state())
    state, row = run.state, wall_rows(run.state.walls)[0]
    ball, v, w = float(model.inertia[0]), state.velocity[0], state.angular_velocity[0]
    assert v[2] > 0.5
    np.testing.assert_allclose(MASS * v + 2000.0 * row["velocity"], [0, 0, 6000.0], atol=1e-9)
    about = MASS * np.cross(state.position[0], v) + ball * w + row["momentum"]
    about += 2000.0 * np.cross(start + row["displacement"], row["velocity"])
    np.testing.assert_allclose(about, np.array(inertia) @ spin, atol=1e-8)
    given = 9000.0 + 0.5 * spin @ np.array(inertia) @ spin
    given -= 1000.0 * row["velocity"] @ row["velocity"] + 0.5 * row["spin"] @ row["momentum"]
    assert run.history.energy["work"][-1] == pytest.approx(given, rel=1e-6)
    assert run.residual < 1e-3


def test_a_torque_turns_a_free_wall_evenly() -> None:
    """About a principal axis, with the closed form of a free fall."""
    body = bd.Free(1.0, inertia=(2.0, 3.0, 4.0), spin=(0, 0, 0.5), torque=(0, 0, 0.2))
    wall = bd.SphereWall(0.5, (0, 0, 50.0), motion=body)
    model = grains([[0, 0, 0]], law=bd.LinearContact(E=1e3), walls=[wall])
    gauges = {"w": bd.WallGauge(0, "angular_velocity"), "q": bd.WallGauge(0, "rotation")}
    run = bd.solve_explicit(model, duration=2.0, dt=1e-3, every=50, gauges=gauges, state=model.state())
    t = run.history.time
    np.testing.assert_allclose(run.history["w"][:, 2], 0.5 + 0.05 * t, rtol=1e-12)
    np.testing.assert_allclose(run.history["q"][:, 2], 0.5 * t + 0.025 * t**2, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(("wall", "lever", "reduced"), [
    (bd.SphereWall(0.5, (0, 0, -1.5), motion=bd.Free(3000.0)), 0.0, 3000.0),
    (bd.PlaneWall((0.8, 0, -1.0), (0, 0, 1), outer=2.0, motion=bd.Free(3000.0, inertia=(2e3, 2e3, 4e3))),
     0.8, 1.0 / (1.0 / 3000.0 + 0.8**2 / 2e3)),
])  # fmt: skip
def test_dashpots_of_a_free_wall_rebound_as_those_of_two_spheres(wall, lever, reduced) -> None:
    """The share β of the critical damping is that of the reduced mass, so that the restitution is e(β)."""
    law, speed = bd.LinearContact(E=E, damping=0.2), 0.01
    model = grains([[0, 0, 1e-6]], law=law, walls=[wall])
    state = moving(model, [[0, 0, -speed]])
    run = bd.solve_explicit(model, duration=0.1, dt=time_step(model, 0.02), state=state)
    row = wall_rows(run.state.walls)[0]
    parting = run.state.velocity[0, 2] - row["velocity"][2] - np.cross(row["spin"], [-lever, 0, 0])[2]
    assert parting == pytest.approx(law.restitution * speed, rel=1e-3)
    light = MASS * reduced / (MASS + reduced)
    assert 0.5 * light * (speed**2 - parting**2) == pytest.approx(run.history.energy["loss"][-1], rel=1e-3)


def test_a_free_wall_that_turns_shortens_the_step() -> None:
    """It counts with 1 / (1/M + lever² / I): light at its rim."""
    def step(**options) -> float:
        wall = bd.PlaneWall((0, 0, -1), (0, 0, 1), outer=2.0, motion=bd.Free(100.0, **options))
        return critical_step(grains([[0, 0, 0]], law=LAW, walls=[wall]), VERLET)

    rim = 1.0 / (1.0 / 100.0 + 2.0**2 / 50.0)
    light = bd.PlaneWall((0, 0, -1), (0, 0, 1), outer=2.0, motion=bd.Free(rim))
    assert step(inertia=(50.0, 50.0, 100.0)) == critical_step(grains([[0, 0, 0]], law=LAW, walls=[light]), VERLET)
    assert step(inertia=(50.0, 50.0, 100.0)) < 0.5 * step()


def test_stages_and_pauses_of_turning_walls(tmp_path) -> None:
    """A run that stops and goes on has the same bits; a later stage continues from the orientation."""
    walls = [*polygon(6, 4.3, angle=bd.Ramp(0.0, 1.0, 0.5), axis=(0, 1, 0)),
             bd.CylinderWall(0.1, (0, 0, 1.1), (0, 1, 0), outside=True,
                             motion=bd.Free(500.0, inertia=(90.0, 10.0, 95.0), spin=(0, 3, 0)))]  # fmt: skip
    model, state = nine(walls)
    dt, gauges = time_step(model, 0.3), {"torque": bd.WallGauge(0, "torque")}
    options = {"duration": 400 * dt, "dt": dt, "every": 20, "gauges": gauges}
    whole = bd.solve_explicit(model, **options, state=state.copy())

    def stop(share: float) -> None:
        if share > 0.5:
            raise EnoughError

    with pytest.raises(EnoughError):
        bd.solve_explicit(
            model, **options, state=state.copy(), out=tmp_path / "run.h5", save_every=50, progress=stop
        )
    read = bd.read_run(tmp_path / "run.h5")
    assert 0 < read.state.step < 400
    assert [wall.motion for wall in read.model.walls] == [wall.motion for wall in walls]
    assert_same_bits(whole, bd.resume(tmp_path / "run.h5"))
    # in a stage that turns them about another point, walls stay where they are
    other = polygon(6, 4.3, spin=1.0, axis=(0, 1, 0), about=(1.0, 0.0, 0.5))
    place = _corner(read.state, 0, np.zeros(3))
    later = bd.Model(model.lattice, None, DENSITY, contact=LAW, walls=other)
    begun = read.state.copy()
    begun.begin(later)
    np.testing.assert_allclose(_corner(begun, 0, np.array([1.0, 0.0, 0.5])), place, atol=1e-14)
    np.testing.assert_array_equal(begun.wall_orientation[0], read.state.wall_orientation[0])


BREAKING_DRUM = """
import math, sys
from pathlib import Path
import bondem as bd
from tests.bits import assert_resumes_to, assert_same_run, digest, threads
from tests.specimens import spheres

rock = spheres(bd.Ball(radius=5e-3), 60, seed=1, reach=1.01)
places = [(11e-3 * (i - 1.5), 12e-3 * (j - 0.5), -25e-3 + 11e-3 * k)
          for j in range(2) for i in range(4) for k in range(3)]
turn = {"motion": bd.Driven(spin=20.0, axis=(0, 1, 0)), "axis": (0, 1, 0)}
bars = [bd.CylinderWall(4e-3, (34e-3 * math.cos(a), 0, 34e-3 * math.sin(a)), outside=True, **turn)
        for a in (3.6, 4.7, 5.8)]
walls = [bd.CylinderWall(36e-3, **turn), *bars,
         *[bd.PlaneWall((0, side * 12.5e-3, 0), (0, -side, 0)) for side in (-1, 1)]]
model = bd.Model(
    bd.replicate(rock, places, rotations="random", seed=1), bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.6),
    2500.0, contact=bd.LinearContact(E=1e7, friction=0.5, damping=0.2), walls=walls,
    boundary=[bd.Gravity()], failure=bd.PeripheralStress(tension=1e5, shear=2e5),
)
start = model.state()
start.velocity = (0.0, 0.0, -2.0)


def run(**options):
    gauges = {"torque": bd.WallGauge(0, "torque")}
    return bd.solve_explicit(model, duration=1.6e-3, every=50, state=start.copy(), gauges=gauges, **options)


runs = []
for count in (1, 2, 3, 4):
    with threads(count):
        runs.append(run())
for other in runs[1:]:
    assert_same_run(runs[0], other)
with threads(2):
    assert_resumes_to(runs[0], lambda **options: run(save_every=50, **options), Path(sys.argv[1]), 0.8)
print(len(runs[0].events) / len(model.lattice.pairs), abs(runs[0].history["torque"][:, 1]).max(), digest(runs[0]))
"""


def test_agglomerates_that_break_in_a_drum_have_the_same_bits(tmp_path) -> None:
    """On 1 to 4 threads, and on others than before where a run is cut off amid what breaks and resumed."""
    [found] = python(BREAKING_DRUM, tmp_path / "run.h5")
    broken, torque = (float(word) for word in found.split()[:2])
    assert 0.05 < broken < 0.9
    assert torque > 0.0


def _corner(state: bd.State, wall: int, about: np.ndarray) -> np.ndarray:
    """Return where the point (4, 1, 2) of a wall has gone."""
    turn = Rotation.from_quat(state.wall_orientation[wall][[1, 2, 3, 0]])
    return about + state.wall_displacement[wall] + turn.apply(np.array([4.0, 1.0, 2.0]) - about)


@pytest.mark.parametrize(("make", "words"), [
    (lambda: bd.Driven(angle=1.0, spin=2.0), "name each component once"),
    (lambda: bd.Driven(spin=1.0, axis=(0, 0, 0)), "not all zero"),
    (lambda: bd.Driven(x=0.0, axis=(0, 0, 1)), "give angle="),
    (lambda: bd.Driven(x=0.0, about=(0, 0, 1)), "give angle="),
    (lambda: bd.Driven(turn=1.0), "unknown component 'turn'"),
    (lambda: bd.Servo(1.0, speed=1.0, spin=1.0), "spin"),
    (lambda: bd.Free(1.0, inertia=(1.0, 0.0, 1.0)), "principal moment of inertia is 0"),
    (lambda: bd.Free(1.0, inertia=(1.0, -1.0, 1.0)), "principal moment of inertia is -1"),
    (lambda: bd.Free(1.0, inertia=(1.0, 1.0, 3.0)), "no body has"),
    (lambda: bd.Free(1.0, inertia=((1.0, 0.5, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))), "not symmetric"),
    (lambda: bd.Free(1.0, inertia=2.0), "has the shape"),
    (lambda: bd.Free(1.0, inertia=(1.0, np.nan, 1.0)), "not finite"),
    (lambda: bd.Free(1.0, spin=(0, 0, 1.0)), "give inertia="),
    (lambda: bd.Free(1.0, torque=(0, 0, 1.0)), "give inertia="),
    (lambda: bd.WallGauge(0, "angle"), "rotation"),
])  # fmt: skip
def test_input_that_turns_nothing_is_refused(make, words: str) -> None:
    with pytest.raises((InputError, TypeError), match=words):
        make()


def test_an_angle_that_does_not_begin_at_its_wall_is_refused() -> None:
    jump = bd.PlaneWall((0, 0, -5), (0, 0, 1), motion=bd.Driven(angle=bd.Ramp(0.3, 1.0, 1.0)))
    model = grains([[0, 0, 0]], law=LAW, walls=[jump])
    with pytest.raises(InputError, match=r"Driven\(angle=\) begins at 0\.3"):
        bd.solve_explicit(model, duration=1e-3)
