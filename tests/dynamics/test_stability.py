"""The stable time step, what happens above it, and that nothing happens below; callbacks at outputs."""

import math
from contextlib import nullcontext
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigvalsh_tridiagonal

import bondem as bd
from bondem._blas import one_blas_thread
from bondem.dynamics.explicit import integrate
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError, StepWarning, UnstableRunWarning
from bondem.model.highest_frequency import highest_frequency
from bondem.model.stiffness_matrices import mass_diagonal
from tests.models import cloud, moving, stirred, time_step, walls_of_box
from tests.recording import Record
from tests.specimens import crooked_block, row, two_cubes
from validation.frame.record import Record as StudyRecord
from validation.studies import energy_drift

LAW = bd.EulerBernoulli(E=2.0e6, nu=0.25, radius_ratio=0.5)
THIN = bd.EulerBernoulli(E=1e6, nu=0.3, radius=0.2)
VERLET = bd.VelocityVerlet()
#: Steps between two checks of a run.
GUARD_INTERVAL = 100


def block(law=LAW, *, seed: int = 0, **options) -> bd.Model:
    """6 × 4 × 4 elements of unequal radii in rows pulled out of line, bonded to their neighbours."""
    lattice = crooked_block((6, 4, 4), radius=(0.35, 0.55), reach=1.5, seed=seed)
    return bd.Model(lattice, bond=law, density=1200.0, **options)


@one_blas_thread
def exact_frequency(model: bd.Model) -> float:
    K, m = model.interaction.stiffness().tocsc().toarray(), mass_diagonal(model)
    return math.sqrt(np.linalg.eigvalsh(K / np.sqrt(m[:, None] * m))[-1])


# ---- the critical step


@pytest.mark.parametrize("law", [
    LAW,
    bd.Timoshenko(E=2.0e6, nu=0.25, radius_ratio=0.2),
    bd.ParallelBond(E=2.0e6, nu=0.25, radius_ratio=0.7),
    bd.Obermayr(E=2.0e6, nu=0.25, radius_ratio=0.5),
    bd.EulerBernoulli(E=2.0e6, nu=0.25, radius_ratio=2.0),
], ids=lambda law: type(law).__name__)  # fmt: skip
def test_the_highest_frequency_is_a_tight_upper_bound(law, record: Record) -> None:
    for seed in range(3):
        model = block(law, seed=seed)
        ratio = highest_frequency(model) / exact_frequency(model)
        assert 1.0 <= ratio <= 1.003
        record("highest frequency", ratio)


@pytest.mark.parametrize("heavier", [0.995, 0.97, 0.8])
def test_one_element_lighter_than_a_thousand_others_is_found(heavier: float) -> None:
    """The highest mode of a chain sits on its one light element, hardly above all others."""
    n, place = 1000, 617
    position = np.zeros((n, 3))
    position[:, 0] = np.arange(n)
    radius = np.full(n, 0.5)
    radius[place] *= heavier
    pairs = np.column_stack([np.arange(n - 1), np.arange(1, n)])
    model = bd.Model(bd.Lattice(bd.Particles(position, radius), pairs), THIN, 1.0)
    # axial vibration alone: tridiagonal, and above the others, as bending is soft in so thin a bond
    k, m = model.stiffness.kn[0], model.mass
    diagonal = np.r_[k, np.full(n - 2, 2.0 * k), k] / m
    exact = math.sqrt(eigvalsh_tridiagonal(diagonal, -k / np.sqrt(m[1:] * m[:-1]))[-1])
    assert 1.0 <= highest_frequency(model) / exact <= 1.003


def test_broken_bonds_raise_the_critical_step() -> None:
    model = block()
    state = model.state()
    state.integrity[::2] = 0.0
    rest = bd.Lattice(model.lattice.particles, model.lattice.pairs[state.bond_integrity > 0.0])
    law = bd.EulerBernoulli(E=2.0e6, nu=0.25, radius=0.5 * model.lattice.particles.mean_radius)
    fewer = bd.Model(rest, law, 1200.0)
    found = critical_step(model, VERLET, integrity=state.integrity)
    assert found == pytest.approx(critical_step(fewer, VERLET), rel=2e-3)
    assert found > time_step(model, 1.05)


def test_a_step_next_to_the_limit_is_warned_of_here_and_in_the_message() -> None:
    model = block()
    limit = time_step(model, 1.0)
    with pytest.warns(StepWarning, match=r"0\.950 of the critical .*pass dt=None or at most"):
        run = bd.solve_explicit(model, duration=3 * limit, dt=0.95 * limit)
    assert run.status is bd.Status.COMPLETED
    assert "0.950 of the critical" in run.message
    assert "critical" not in bd.solve_explicit(model, duration=3 * limit, dt=0.9 * limit).message


# ---- above it


@pytest.mark.parametrize("scheme", [VERLET, bd.TchamwaWielgosz(1.3)], ids=["Verlet", "TW"])
def test_a_run_above_the_critical_step_ends_in_time_with_a_good_state(scheme) -> None:
    model = block()
    state = stirred(model, 1e-3, seed=1)
    fastest = np.abs(state.velocity).max()
    dt = 1.05 * critical_step(model, scheme)
    run = integrate(model, bd.Plan(duration=2000 * dt, dt=dt, scheme=scheme, every=1), state=state)
    assert run.status is bd.Status.UNSTABLE
    stopped = int(run.message.split("step ")[1].split(":")[0])
    kinetic = run.history.energy["translation"] + run.history.energy["rotation"]
    grown = int(np.argmax(~(kinetic <= 1000.0 * kinetic[0])))
    assert grown < stopped <= grown + 2 * GUARD_INTERVAL
    for array in (run.state.pose, run.state.motion, run.state.acceleration):
        assert np.isfinite(array).all()
    assert np.abs(run.state.velocity).max() <= 10.0 * fastest


def test_growth_that_turns_no_bond_and_stays_finite_is_caught_by_its_energy() -> None:
    """A stretched chain, above its limit: nothing turns; nothing overflows in the hundred steps until the look."""
    model = bd.Model(row(20, 1.0), THIN, 1.0)
    state = moving(model, 1e-2 * (-1.0) ** np.arange(20)[:, None] * [1.0, 0.0, 0.0])
    dt = time_step(model, 1.002)
    run = integrate(model, bd.Plan(duration=3000 * dt, dt=dt, every=1), state=state)
    assert run.status is bd.Status.UNSTABLE
    assert "kinetic energy is a thousand times" in run.message
    kinetic = run.history.energy["translation"]
    assert np.isfinite(kinetic).all()
    assert len(kinetic) <= np.argmax(kinetic > 1000.0 * kinetic[0]) + GUARD_INTERVAL + 1


def test_the_state_given_back_is_no_older_than_ten_thousand_steps() -> None:
    model = block()
    state = model.state()
    dt = time_step(model, 0.5)
    state.set_motion(velocity=np.full((len(model.mass), 3), 0.1))

    def poison(state: bd.State, record) -> None:
        if state.step == 11_000:
            state.motion[3, 0] = math.nan

    run = integrate(model, bd.Plan(duration=20_000 * dt, dt=dt, every=1000), state=state, callback=poison)
    assert run.status is bd.Status.UNSTABLE
    assert f"stopped at step {11_000 + GUARD_INTERVAL}: a number is not finite" in run.message
    assert "the state is that of step 10000" in run.message
    assert run.state.step == 10_000
    assert run.state.displacement == pytest.approx(np.full((len(model.mass), 3), 0.1 * 10_000 * dt))
    assert math.isnan(state.motion[3, 0])  # what the run itself had come to


# ---- contacts, impact: guarded, and not stopped where they are well


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # soft grains at high speed
@pytest.mark.parametrize("options", [
    pytest.param({}, id="elastic", marks=pytest.mark.validate),
    pytest.param({"friction": 0.5, "damping": 0.2}, id="rubbing"),
])  # fmt: skip
def test_grains_that_collide_are_not_stopped(options: dict) -> None:
    model, state = cloud(4, bd.LinearContact(E=1e7, **options), speed=10.0, walls=walls_of_box(9.2))
    dt = time_step(model, 0.9)
    run = integrate(model, bd.Plan(duration=8_000 * dt, dt=dt, every=0, imbalance=None), state=state)
    assert run.status is bd.Status.COMPLETED
    assert np.abs(run.state.displacement).max() > 2.0


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # soft grains at high speed
def test_grains_above_the_limit_are_stopped() -> None:
    model, state = cloud(4, bd.LinearContact(E=1e7), speed=10.0, walls=walls_of_box(9.2))
    dt = time_step(model, 8.0)  # which counts twelve contacts an element: the true limit is higher
    run = integrate(model, bd.Plan(duration=20_000 * dt, dt=dt, every=10), state=state)
    assert run.status is bd.Status.UNSTABLE
    assert np.isfinite(run.state.motion).all()
    kinetic = run.history.energy["translation"]
    assert len(kinetic) <= np.argmax(~(kinetic <= 1000.0 * kinetic[0])) + 1 + GUARD_INTERVAL / 10


@pytest.mark.validate
def test_a_block_thrown_against_a_wall_is_not_stopped() -> None:
    wall = bd.PlaneWall((-1.0, 0, 0), (1, 0, 0))
    model = block(contact=bd.LinearContact(E=2e6, friction=0.3), walls=[wall])
    state = model.state()
    state.set_motion(velocity=np.tile([-4.0, 0.5, 0.0], (len(model.mass), 1)))  # a tenth of the speed of sound
    dt = time_step(model, 0.9)
    run = integrate(model, bd.Plan(duration=8_000 * dt, dt=dt), state=state)
    assert run.status is bd.Status.COMPLETED
    assert run.state.velocity[:, 0].mean() > 1.0  # it came back
    assert np.abs(run.state.displacement - run.state.displacement.mean(axis=0)).max() > 0.05


@pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning")  # a disordered crystal sticks out of its box
@pytest.mark.parametrize("condition", [
    bd.Drive(bd.Face("x_max"), vx=2.0, vy=1.0),
    bd.Load(bd.Face("x_max"), force=(3e3, -1e3, 500.0)),
    bd.Load(bd.Face("x_max"), force=(1e5, 0.0, 0.0), schedule=bd.Table((0.0, 0.2, 0.21, 0.4), (0.0, 1.0, -1.0, 0.0))),
], ids=["drive", "load", "pulse"])  # fmt: skip
def test_a_block_set_in_motion_from_rest_is_not_stopped(condition) -> None:
    shape = bd.Box(size=(6.0, 4.0, 4.0))
    at_rest = block()
    particles = bd.Particles(at_rest.lattice.particles.position + 0.5, at_rest.lattice.particles.radius, shape=shape)
    model = bd.Model(bd.Lattice(particles, at_rest.lattice.pairs), LAW, 1200.0, boundary=[condition])
    dt = time_step(model, 0.9)
    # large strains raise the frequencies: the pulse gains 3 % at this step
    run = integrate(model, bd.Plan(duration=3_000 * dt, dt=dt, imbalance=(0.05, 0.1)))
    assert run.status is bd.Status.COMPLETED
    assert np.abs(run.state.displacement).max() > 0.1


# ---- callbacks


@pytest.mark.parametrize(
    ("resists", "spin", "ends"),
    [("bending", (1.0, 0.0, 0.0), bd.Status.COMPLETED), ("bending", (0.0, 0.0, 1.0), bd.Status.UNSTABLE),
     ("none", (1.0, 0.0, 0.0), bd.Status.COMPLETED), ("full", (1.0, 0.0, 0.0), bd.Status.UNSTABLE)],
)  # fmt: skip
def test_a_cell_may_spin_about_a_facet_that_does_not_resist_it(
    resists: str, spin: tuple[float, float, float], ends: bd.Status, one_thread: None
) -> None:
    """Two cubes, turned against each other by three quarters of a turn, as what hangs on one facet may be."""
    rate = 1e4
    turn = {name: rate * part for name, part in zip(("wx", "wy", "wz"), spin, strict=True)}
    drive = bd.Drive(bd.Index([1]), vx=0.0, vy=0.0, vz=0.0, **turn)
    law = bd.CellBond(E=1e9, nu=0.2, facet_rotation=resists)
    model = bd.Model(two_cubes(1e-3), law, density=2000.0, boundary=[bd.Fix(bd.Index([0])), drive])
    with pytest.warns(UnstableRunWarning) if ends.failed else nullcontext():
        run = bd.solve_explicit(model, duration=1.5 * np.pi / rate, every=20)
    assert run.status is ends


def test_a_callback_sees_every_record_and_changes_no_bit() -> None:
    model = block()
    state = stirred(model, 0.1)  # motions of the shortest waves: at 0.8 of the limit their energy swings by a tenth
    dt = time_step(model, 0.8)
    plain = bd.solve_explicit(model, duration=1050 * dt, dt=dt, every=70, state=state.copy(), imbalance=None)
    seen = []

    def look(now: bd.State, record) -> None:
        assert record.time[0] == pytest.approx(now.time)
        seen.append((now.step, record.records[0]))

    run = bd.solve_explicit(model, duration=1050 * dt, dt=dt, every=70, state=state, callback=look, imbalance=None)
    assert run.status is bd.Status.COMPLETED
    assert [step for step, _ in seen] == list(range(0, 1051, 70))
    assert np.array_equal(np.array([row for _, row in seen]), plain.history.records)
    assert np.array_equal(run.history.records, plain.history.records)
    for name in bd.State.ARRAYS:
        assert np.array_equal(getattr(run.state, name), getattr(plain.state, name))


def test_a_callback_may_stop_the_run() -> None:
    model = block()
    state = stirred(model, 0.1)  # motions of the shortest waves: at 0.8 of the limit their energy swings by a tenth
    dt = time_step(model, 0.8)
    run = bd.solve_explicit(
        model,
        duration=1000 * dt,
        dt=dt,
        every=50,
        state=state,
        callback=lambda now, record: now.step >= 200,
        imbalance=None,
    )
    assert run.status is bd.Status.STOPPED
    assert run.steps == run.state.step == 200
    assert len(run.history) == 5
    assert "stopped by the callback" in run.message
    with pytest.raises(InputError, match="every="):
        bd.solve_explicit(model, duration=dt, dt=dt, every=0, callback=lambda now, record: None)


# ---- energy


def test_the_cylinder_keeps_its_energy_to_second_order_without_drift(tmp_path: Path) -> None:
    """The benchmark of a million steps, on a smaller scale."""
    record = StudyRecord(tmp_path / "drift.json")
    energy_drift.measure(record, elements=300, steps=20_000, order_steps=2000)
    found = record.data
    np.testing.assert_allclose(found["orders"], 2.0, atol=0.1)
    assert abs(found["drift, in its standard errors"]) < 5.0
    assert abs(found["drift over the run"]) < 0.1 * found["largest error"]
