"""Contacts against closed forms and conservation laws."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics import neighbour_list as lists
from bondem.dynamics.explicit import integrate
from bondem.dynamics.parts.shared_tables import apart
from tests.bits import assert_same_bits, assert_same_run, need_two_threads, threads
from tests.models import cloud, grains, momenta, moving, time_step, walls_of_box
from tests.specimens import spheres, two_spheres

DENSITY = 1000.0
E = 1e7


# --- a pair -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("beta", [0.0, 0.1, 0.5, 0.71, 0.9])
def test_restitution_of_a_head_on_collision(beta: float) -> None:
    model = grains([[0, 0, 0], [2.1, 0, 0]], [1.0, 1.0], law=bd.LinearContact(E=E, damping=beta))
    run = bd.solve_explicit(
        model, duration=0.3, dt=time_step(model, 0.005), every=0, state=moving(model, [[0.5, 0, 0], [-0.5, 0, 0]])
    )
    e = run.state.velocity[1, 0] - run.state.velocity[0, 0]
    # the dashpot sets in with a jump: first order in ω dt, here 0.01
    assert e == pytest.approx(model.contact.restitution, abs=1e-6 if beta == 0.0 else 4e-3)


def test_no_pair_is_passed_over_that_touches() -> None:
    """Pairs at many gaps, both ends moving: each begins in the step in which its spheres meet."""
    gaps = np.concatenate([np.linspace(1e-4, 0.02, 60), np.linspace(0.03, 0.3, 10)])
    row = 5.0 * np.arange(len(gaps))
    one = np.column_stack([np.zeros_like(row), row, np.zeros_like(row)])
    other = one + np.column_stack([2.0 + gaps, np.zeros_like(row), np.zeros_like(row)])
    for share in (0.5, 0.1, 1.0):  # of the speed that is of the first sphere
        model = grains(np.concatenate([one, other]), np.ones(2 * len(gaps)), law=bd.LinearContact(E=E))
        velocity = np.zeros((2 * len(gaps), 3))
        velocity[: len(gaps), 0], velocity[len(gaps) :, 0] = share, share - 1.0
        dt = 2e-5
        run = bd.solve_explicit(model, duration=0.02, dt=dt, every=1, state=moving(model, velocity))
        met = gaps < 0.02 - 2.0 * dt
        kn = 0.5 * math.pi * E
        overlap = np.maximum(run.history.time[:, None] - gaps[None, met], 0.0)
        omega = math.sqrt(2.0 * kn / model.mass[0])
        stored = (0.5 * kn * (np.sin(omega * overlap) / omega) ** 2 * (omega * overlap < math.pi)).sum(axis=1)
        np.testing.assert_allclose(run.history.energy["contact"], stored, atol=2e-3 * stored.max())


def test_a_collision_lasts_half_a_period() -> None:
    """ω² = kn / m̄: the time of contact is π / ω, and the deepest overlap v / ω."""
    model = grains([[0, 0, 0], [2.0, 0, 0]], [1.0, 1.0], law=bd.LinearContact(E=E))
    omega = math.sqrt(E * math.pi / 2.0 / (0.5 * model.mass[0]))
    half = bd.solve_explicit(
        model, duration=0.5 * math.pi / omega, dt=math.pi / omega / 1000.0, every=0,
        state=moving(model, [[0.5, 0, 0], [-0.5, 0, 0]]),
    )  # fmt: skip
    overlap = 2.0 - np.diff(half.state.position[:, 0])[0]
    assert overlap == pytest.approx(1.0 / omega, rel=1e-5)
    assert abs(half.state.velocity).max() < 1e-5


def test_oblique_collision_obeys_coulomb() -> None:
    """A fast graze slides throughout: the tangential impulse is μ times the normal one, and turns both alike."""
    mu = 0.2
    # stiff, so that the pair does not turn while it touches
    law = bd.LinearContact(E=1e4 * E, friction=mu)
    model = grains([[0, 0, 0], [2.0, 0, 0]], [1.0, 1.0], law=law)
    run = bd.solve_explicit(
        model, duration=1e-3, dt=time_step(model, 0.01), every=10, state=moving(model, [[0.1, 2.0, 0], [-0.1, 0, 0]])
    )
    m, v, w = model.mass[0], run.state.velocity, run.state.angular_velocity
    normal = m * (v[1, 0] + 0.1)
    assert m * v[1, 1] == pytest.approx(mu * normal, rel=2e-3)
    assert v[1, 0] == pytest.approx(0.1, rel=1e-2)
    assert w[:, 2] == pytest.approx(-mu * normal / model.inertia[0], rel=1e-2)
    ledger = run.history.energy
    assert ledger["friction"][-1] > 0.1 * mu * normal
    assert abs(ledger["balance"]).max() < 1e-3 * ledger["friction"][-1]


def test_friction_that_sticks_is_a_spring() -> None:
    """Below μ N a tangential load moves a sphere that cannot turn by F / ks and no further."""
    law = bd.LinearContact(E=E, friction=0.5, kappa=2.0, damping=0.4)
    kn = E * math.pi
    press, pull = 1e3, 300.0
    model = grains(
        [[0, 0, 1.0]], [1.0], law=law, walls=[bd.PlaneWall((0, 0, 0), (0, 0, 1))],
        boundary=[
            bd.Load(bd.Index([0]), force=(0, 0, -press), schedule=bd.Ramp(0, 1, 0.1)),
            bd.Load(bd.Index([0]), force=(pull, 0, 0), schedule=bd.Ramp(0, 1, 0.2, begin=0.4)),
            bd.Fix(bd.Index([0]), translation=""),
        ],
    )  # fmt: skip
    run = bd.solve_explicit(model, duration=1.5, every=0)
    moved = run.state.displacement[0]
    assert moved[2] == pytest.approx(-press / kn, rel=1e-4)
    assert moved[0] == pytest.approx(pull / (kn / 2.0), rel=1e-3)
    slipping = bd.Model(
        model.lattice, None, density=DENSITY, contact=bd.LinearContact(E=E, friction=0.25, damping=0.4),
        walls=model.walls, boundary=model.boundary,
    )  # fmt: skip
    gone = bd.solve_explicit(slipping, duration=1.5, every=0).state.displacement[0, 0]
    assert gone > 100.0 * moved[0]


def test_a_sliding_ball_ends_rolling() -> None:
    """Whatever the friction, v = 5/7 v0 when it rolls, and 2/7 of its energy is gone, by friction alone."""
    weight = 1e4
    law = bd.LinearContact(E=1e8, friction=0.3, damping=0.3)
    model = grains(
        [[0, 0, 1.0]], [1.0], law=law, walls=[bd.PlaneWall((0, 0, 0), (0, 0, 1))],
        boundary=[bd.Load(bd.Index([0]), force=(0, 0, -weight), schedule=bd.Ramp(0, 1, 0.05))],
    )  # fmt: skip
    run = bd.solve_explicit(model, duration=1.0, every=20, state=moving(model, [[1.0, 0, 0]]))
    assert run.state.velocity[0, 0] == pytest.approx(5.0 / 7.0, rel=2e-3)
    assert run.state.angular_velocity[0, 1] == pytest.approx(5.0 / 7.0, rel=2e-3)
    ledger = run.history.energy
    assert ledger["friction"][-1] == pytest.approx(2.0 / 7.0 * ledger["translation"][0], rel=5e-3)
    assert abs(ledger["balance"]).max() < 2e-4 * ledger["translation"][0]


# --- many -------------------------------------------------------------------------------------------------------


def test_momentum_and_angular_momentum_are_kept() -> None:
    model, state = cloud(5, bd.LinearContact(E=E, friction=0.4, damping=0.2), speed=2.0)
    p0, l0 = momenta(model, state)
    scale = np.abs(np.cross(state.position, model.mass[:, None] * state.velocity)).sum()
    run = bd.solve_explicit(model, duration=1.0, every=10, state=state)
    p1, l1 = momenta(model, run.state)
    assert run.history.energy["friction"][-1] > 0.01 * run.history.energy["translation"][0]
    assert np.abs(p1 - p0).max() < 1e-12 * np.abs(model.mass[:, None] * run.state.velocity).sum()
    assert np.abs(l1 - l0).max() < 1e-12 * scale


def test_energy_closes_to_second_order() -> None:
    """Dashpots, friction, a driven wall and a loaded one: the ledger misses O(dt²) of what was turned over."""
    misses = []
    for share in (0.4, 0.2, 0.1):
        law = bd.LinearContact(E=E, friction=0.3, damping=0.1)
        piston = bd.Driven(x=bd.Ramp(0.0, -3.0, 0.6))
        model, state = cloud(4, law, walls=walls_of_box(9.2, motion=piston), seed=5)
        run = bd.solve_explicit(model, duration=0.7, dt=time_step(model, share), every=20, state=state)
        ledger = run.history.energy
        turned = ledger["work"][-1] + ledger["translation"][0]
        assert ledger["friction"][-1] > 0.01 * turned
        assert ledger["loss"][-1] > 0.05 * turned
        misses.append(abs(ledger["balance"][-1]) / turned)
    assert misses[2] < 1e-3
    assert misses[2] < 0.3 * misses[0]


@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_the_bits_depend_on_neither_threads_nor_lists(monkeypatch: pytest.MonkeyPatch) -> None:
    need_two_threads()
    edge = 12
    law = bd.LinearContact(E=E, friction=0.4, damping=0.1)
    walls = walls_of_box(2.3 * edge, motion=bd.Servo(1e6, speed=4.0, mass=1e6))
    runs = []
    for count, skin in ((1, 0.6), (2, 0.6), (2, 0.8)):
        monkeypatch.setattr(lists, "_SKIN_LEAST", skin)
        model, state = cloud(edge, law, walls=walls)
        rest = model.state()
        found = lists.ContactSearch(model, model.contacts, rest, (rest.integrity, apart(model, rest))).find(0)
        assert found is not None
        assert len(found.pairs.first) > 1000
        with threads(count):
            runs.append(bd.solve_explicit(model, duration=0.12, every=10, state=state))
    assert len(runs[0].state.contacts) > 50
    for other in runs[1:]:
        assert_same_bits(runs[0], other)
        np.testing.assert_array_equal(runs[0].history.energy["friction"], other.history.energy["friction"])


@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_going_on_from_a_run_file_changes_no_bit(tmp_path: Path) -> None:
    law = bd.LinearContact(E=E, friction=0.4, damping=0.1)
    walls = [
        *walls_of_box(11.5, motion=bd.Servo(3e5, speed=3.0)),
        bd.CylinderWall(8.0, (0, 5.75, 5.75), friction=0.1),
    ]
    options = {"every": 7, "save_every": 60, "gauges": {"piston": bd.WallGauge(5, "force")}}
    model, state = cloud(5, law, walls=walls)
    dt = time_step(model)
    whole = bd.solve_explicit(model, duration=200 * dt, dt=dt, state=state, **options)
    model, state = cloud(5, law, walls=walls)
    path = tmp_path / "run.h5"
    bd.solve_explicit(model, duration=120 * dt, dt=dt, state=state, out=path, **options)
    kept = bd.read_run(path)
    assert kept.model.walls == model.walls
    assert len(kept.state.touching) > 3
    resumed = integrate(kept.model, replace(kept.plan, duration=200 * dt), state=kept.state, history=kept.history)
    assert_same_run(whole, resumed)
    assert np.abs(whole.history["piston"]).max() > 1e4


def test_contacts_reach_across_a_periodic_border() -> None:
    law = bd.LinearContact(E=E)
    model = grains([[0.5, 5, 5], [9.4, 5, 5]], [0.5, 0.5], law=law, period=(10.0, 10.0, 10.0))
    run = bd.solve_explicit(
        model, duration=0.5, dt=time_step(model, 0.05), every=0, state=moving(model, [[-0.5, 0, 0], [0.5, 0, 0]])
    )
    assert run.state.velocity[:, 0] == pytest.approx([0.5, -0.5], rel=1e-4)


# --- walls ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("wall", "position", "velocity"),
    [
        (bd.PlaneWall((0, 0, 0), (1, 1, 0)), (1.5, 1.5, 0), (-1, -1, 0)),
        (bd.CylinderWall(5.0), (0, 3.0, 0), (0, 1, 0)),
        (bd.CylinderWall(2.0, (0, 0, 0), (0, 0, 1), outside=True), (0, -4.0, 3.0), (0, 1, 0)),
    ],
    ids=["plane", "vessel", "rod"],
)
def test_walls_reflect(wall, position, velocity) -> None:
    model = grains([position], [1.0], law=bd.LinearContact(E=E), walls=[wall])
    run = bd.solve_explicit(
        model, duration=3.0, dt=time_step(model, 0.02), every=50, state=moving(model, [velocity]),
        gauges={"wall": bd.WallGauge(0, "force")},
    )  # fmt: skip
    assert run.state.velocity[0] == pytest.approx(-np.array(velocity, dtype=float), abs=1e-4)
    assert run.history["wall"] @ np.array(velocity) == pytest.approx(
        np.linalg.norm(run.history["wall"], axis=1) * np.linalg.norm(velocity)
    )
    # what the wall was given is what the sphere has lost
    assert abs(run.history.energy["balance"]).max() < 1e-3 * run.history.energy["translation"][0]


def test_a_driven_wall_goes_where_it_is_told() -> None:
    walls = [
        bd.PlaneWall((0, 0, 0), (1, 0, 0), motion=bd.Driven(x=bd.Ramp(0, 0.3, 1.0), vy=bd.Ramp(0.0, 2.0, 1.0))),
        bd.CylinderWall(9.0, motion=bd.Driven(growth=bd.Table((0, 1, 2), (0, -0.2, 0.1)))),
    ]
    model = grains([[3, 0, 0]], [1.0], law=bd.LinearContact(E=E), walls=walls)
    gauges = {"growth": bd.WallGauge(1, "growth"), "way": bd.WallGauge(0, "displacement")}
    run = bd.solve_explicit(model, duration=2.0, dt=1e-3, every=100, gauges=gauges)
    assert run.state.wall_displacement[0] == pytest.approx([0.3, 3.0, 0.0])
    assert run.state.wall_growth == pytest.approx([0.0, 0.1])
    assert run.history["growth"][10, 0] == pytest.approx(-0.2)
    assert run.history["way"][5, :2] == pytest.approx([0.15, 0.25], rel=1e-3)


def test_a_growing_vessel_pushes_what_is_in_it() -> None:
    """Pressed from all sides by a shrinking cylinder, the work of the wall is the energy of the contacts."""
    angle = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    ring = np.column_stack([np.zeros(6), 3.0 * np.cos(angle), 3.0 * np.sin(angle)])
    walls = [
        bd.CylinderWall(4.0, motion=bd.Driven(growth=bd.Ramp(0, -0.02, 5.0))),
        bd.CylinderWall(2.0, outside=True, motion=bd.Servo(1e4, speed=0.05)),
    ]
    model = grains(ring, np.ones(6), law=bd.LinearContact(E=E, damping=0.5), walls=walls)
    run = bd.solve_explicit(model, duration=8.0, every=100, gauges={
        "vessel": bd.WallGauge(0, "growth"), "rod": bd.WallGauge(1, "growth"),
    })  # fmt: skip
    assert run.history["rod"][-1, 2] == pytest.approx(1e4, rel=1e-3)
    assert run.history["vessel"][-1, 2] == pytest.approx(1e4, rel=1e-3)
    # six contacts of kn = E π R share the force on either side
    rod, vessel = run.state.wall_growth[1], run.state.wall_growth[0]
    assert vessel == pytest.approx(-0.02)
    assert vessel - rod == pytest.approx(-2.0 * 1e4 / 6.0 / (E * math.pi), rel=1e-2)
    ledger = run.history.energy
    assert abs(ledger["balance"][-1]) < 1e-3 * ledger["work"].max()


@pytest.mark.parametrize("mass", [
    pytest.param(None, id="usual"), pytest.param(5e4, id="light", marks=pytest.mark.validate),
])  # fmt: skip
def test_a_servo_holds_the_force(mass: float | None) -> None:
    force = 2e5
    piston = bd.Servo(bd.Ramp(force, 2 * force, 0.5, begin=20.0), speed=1.0, mass=mass)
    law = bd.LinearContact(E=E, friction=0.2, damping=0.3)
    model, state = cloud(5, law, walls=walls_of_box(11.5, motion=piston), speed=0.1)
    run = bd.solve_explicit(model, duration=30.0, every=20, state=state, gauges={"force": bd.WallGauge(5, "growth")})
    held = run.history["force"][:, 2]
    when = run.history.time
    assert held[(when > 18.0) & (when < 20.0)].mean() == pytest.approx(force, rel=0.01)
    assert held[when > 28.0].mean() == pytest.approx(2 * force, rel=0.01)
    assert held[when > 28.0].std() < 0.02 * force


# --- with bonds -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("broken", [False, True], ids=["bonded", "broken"])
def test_a_packing_at_rest_bears_nothing(broken: bool) -> None:
    """Overlaps of the reference configuration do not press, with each other or with walls, bonds broken or not."""
    packed = spheres(bd.Box((10.0, 8.0, 8.0)), 500, seed=2)
    walls = [bd.PlaneWall((0, 0, 0), (1, 0, 0)), bd.PlaneWall((10, 0, 0), (-1, 0, 0))]
    law = bd.EulerBernoulli(E=E, nu=0.2, radius_ratio=0.6)
    model = bd.Model(packed, law, density=DENSITY, contact=bd.LinearContact(E=E, friction=0.3), walls=walls)
    state = model.state()
    state.integrity[:] = 0.0 if broken else 1.0
    run = bd.solve_explicit(model, duration=2e-3, every=10, state=state)
    assert run.state.wall_force == pytest.approx(0.0)
    # nothing but rounding moves, though the spheres overlap
    lengths = packed.particles.radius[packed.pairs].sum(axis=1) - packed.length
    assert lengths.max() > 1e-3
    assert np.abs(run.state.displacement).max() < 1e-13
    pressed = bd.Model(
        packed, law, density=DENSITY, walls=walls, contact=bd.LinearContact(E=E, friction=0.3, stress_free=False)
    )
    state = pressed.state()
    state.integrity[:] = 0.0 if broken else 1.0
    moved = np.abs(bd.solve_explicit(pressed, duration=2e-3, every=10, state=state).state.displacement).max()
    assert (moved > 1e-6) == broken


@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_an_intact_bond_has_no_contact_and_a_broken_one_has() -> None:
    lattice = two_spheres(1.99, 1.0)
    law = bd.EulerBernoulli(E=E, nu=0.2, radius=0.5)
    contact = bd.LinearContact(E=E)
    drive = [bd.Fix(bd.Index([0])), bd.Drive(bd.Index([1]), x=bd.Ramp(0, -0.01, 0.1))]

    def force(intact: float, contact: bd.LinearContact | None) -> float:
        model = bd.Model(lattice, law, density=DENSITY, contact=contact, boundary=drive)
        state = model.state()
        state.integrity[:] = intact
        gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
        run = bd.solve_explicit(model, duration=0.1, dt=1e-4, every=10, state=state, gauges=gauges)
        return run.history["grip"][-1, 0]

    assert force(1.0, contact) == pytest.approx(force(1.0, None), rel=1e-12)
    # of the reference overlap of 0.01 nothing presses: 0.01 of approach is 0.01 of overlap, as stiff as the bond was
    kn = E * math.pi * 0.25 / 1.99
    assert force(0.0, contact) == pytest.approx(kn * 0.01, rel=1e-9)
    assert force(0.0, bd.LinearContact(E=E, stress_free=False)) == pytest.approx(E * math.pi / 2.0 * 0.02, rel=1e-9)
