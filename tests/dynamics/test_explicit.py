"""Explicit dynamics against closed forms and conservation laws; tolerances from the order of the schemes."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import settled
from bondem.dynamics.timestep import critical_step
from bondem.errors import InputError, UnstableStepError
from bondem.model.highest_frequency import highest_frequency
from bondem.model.stiffness_matrices import mass_diagonal
from tests.models import momenta, moving, time_step, total_energy
from tests.recording import Record
from tests.specimens import crooked_block, rod, two_spheres

E, RHO = 2.0e6, 1200.0
LAW = bd.Timoshenko(E=E, nu=0.25, radius_ratio=0.5)
#: Rows pulled out of line, bonded to their neighbours.
BLOCK = crooked_block((4, 3, 3), jitter=0.05, radius=0.5, reach=1.15, seed=2)
pytestmark = pytest.mark.usefixtures("one_thread")


@pytest.fixture
def tumbling_rod() -> tuple[bd.Model, bd.State]:
    """A free rod that spins, bends by tens of degrees between its ends, and twists."""
    model = bd.Model(rod(8), LAW, RHO)
    x = model.lattice.particles.position[:, 0]
    s = (x - x.mean()) / x.max()
    velocity = np.column_stack([0 * s, 1.2 * s + 1.5 * np.cos(2 * np.pi * s), 0.5 * s**2])
    spin = np.column_stack([0.6 * s, 0 * s, 0.3 + 0 * s])
    return model, moving(model, velocity, spin)


def test_a_free_lattice_keeps_momentum_and_angular_momentum_to_rounding(record: Record) -> None:
    model = bd.Model(BLOCK, LAW, RHO)
    rng, shape = np.random.default_rng(0), (len(model.lattice.particles), 3)
    state = moving(model, rng.uniform(-1.0, 3.0, shape), rng.uniform(-3.0, 4.0, shape))
    p0, h0 = momenta(model, state)
    # bonds turn by tens of degrees, which raises the highest frequency: above 0.895 of the step at rest energy grows
    dt = time_step(model, 0.8)
    # noise is motion of the shortest waves, whose energy the scheme swings by a tenth at this step
    plan = bd.Plan(duration=10_000 * dt, dt=dt, every=0, imbalance=None)
    result = integrate(model, plan, state=state)
    assert result.status is bd.Status.COMPLETED
    assert result.steps == 10_000
    p1, h1 = momenta(model, result.state)
    speed = np.linalg.norm(result.state.velocity, axis=1)
    travelled = np.linalg.norm(result.state.displacement, axis=1).min()
    assert travelled > 10.0
    arm = np.linalg.norm(result.state.position, axis=1)
    np.testing.assert_allclose(p1, p0, rtol=0.0, atol=1e-12 * (model.mass * speed).sum())
    np.testing.assert_allclose(h1, h0, rtol=0.0, atol=1e-12 * (model.mass * speed * arm).sum())
    record("momentum", np.abs(p1 - p0).max() / (model.mass * speed).sum())
    record("angular momentum", np.abs(h1 - h0).max() / (model.mass * speed * arm).sum())


def test_energy_error_of_a_tumbling_rod_is_second_order_and_does_not_drift(tumbling_rod, record: Record) -> None:
    model, start = tumbling_rod
    coarse = time_step(model, 0.8)
    duration = 2000 * coarse
    errors = []
    for k in (2, 4, 8):
        history = integrate(model, bd.Plan(duration=duration, dt=coarse / k, every=k), state=start.copy()).history
        total = total_energy(history)
        errors.append(np.abs(total - total[0]).max() / total[0])
    assert history.energy["bending"].max() > 0.01 * total[0]
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert errors[-1] > 1e-9  # not rounding
    np.testing.assert_allclose(rates, 2.0, atol=0.2)
    record("order of a tumbling rod", *rates)

    # what the error does slowly is the flow of energy between modes; a drift would be many times as large
    dt = 0.25 * coarse
    history = integrate(model, bd.Plan(duration=200_000 * dt, dt=dt, every=10), state=start.copy()).history
    assert len(history) == 20_001
    parts = np.array_split(total_energy(history) / total[0], 10)
    means = np.array([part.mean() for part in parts])
    assert np.ptp(means) < np.ptp(parts[0]) < 5e-4
    assert np.ptp(parts[-1]) < 8.0 * np.ptp(parts[0])


def test_a_run_goes_back_the_way_it_came(tumbling_rod) -> None:
    model, start = tumbling_rod
    dt = time_step(model, 0.5)
    plan = bd.Plan(duration=3000 * dt, dt=dt, every=0)
    there = integrate(model, plan, state=start.copy()).state
    assert np.abs(there.displacement).max() > 1.0
    back = model.state()
    back.set_pose(position=there.position, orientation=there.orientation)
    back.set_motion(velocity=-there.velocity, angular_velocity=-there.angular_velocity)
    back = integrate(model, plan, state=back).state
    np.testing.assert_allclose(back.position, start.position, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(back.velocity, -start.velocity, rtol=0.0, atol=1e-8 * np.abs(start.velocity).max())
    np.testing.assert_allclose(back.orientation, start.orientation, rtol=0.0, atol=1e-9)


def test_the_bond_turns_with_a_spinning_pair() -> None:
    """A dumbbell that spins about its centre stretches to kn (ℓ - L) = m ω² ℓ/2 and nothing else."""
    model = bd.Model(two_spheres(), LAW, RHO)
    kn, m, omega = model.stiffness.kn[0], model.mass[0], 5.0
    l = kn / (kn - 0.5 * m * omega**2)
    state = model.state()
    state.set_pose(position=np.array([[-0.5 * l, 0, 0], [0.5 * l, 0, 0]]))
    state.set_motion(
        velocity=np.array([[0, -0.5 * l * omega, 0], [0, 0.5 * l * omega, 0]]),
        angular_velocity=np.full((2, 3), [0, 0, omega]),
    )
    dt = time_step(model, 0.02)
    result = integrate(model, bd.Plan(duration=20.0, dt=dt, every=200), state=state)
    d = result.state.position[1] - result.state.position[0]
    phase = omega * result.state.time
    np.testing.assert_allclose(d, [l * math.cos(phase), l * math.sin(phase), 0.0], atol=1e-3)
    energy = result.history.energy
    np.testing.assert_allclose(energy["normal"], 0.5 * kn * (l - 1.0) ** 2, rtol=1e-2)
    assert (energy["shear"] + energy["bending"]).max() < 1e-3 * energy["normal"][0]


# ---- one oscillator: a held element, a bond and a free element that moves along the bond


def oscillator() -> tuple[bd.Model, float]:
    """The model and ω = √(kn/m)."""
    model = bd.Model(two_spheres(), LAW, RHO, boundary=[bd.Fix(bd.Index([0]))])
    return model, math.sqrt(model.stiffness.kn[0] / model.mass[1])


def ring(scheme: bd.Scheme, Omega: float, steps: int, x0: float, v0: float) -> tuple[np.ndarray, np.ndarray]:
    """Elongation [m] and velocity over ω at every step, for ω dt = Omega."""
    model, omega = oscillator()
    state = model.state()
    state.set_pose(position=np.array([[0.0, 0, 0], [1.0 + x0, 0, 0]]))
    state.set_motion(velocity=np.array([[0.0, 0, 0], [v0 * omega, 0, 0]]))
    dt = Omega / omega
    gauges = {"x": bd.Gauge(bd.Index([1]), "displacement"), "v": bd.Gauge(bd.Index([1]), "velocity")}
    plan = bd.Plan(duration=steps * dt, dt=dt, scheme=scheme, gauges=gauges, every=1)
    history = integrate(model, plan, state=state).history
    assert len(history) == steps + 1
    return history["x"][:, 0], history["v"][:, 0] / omega


@pytest.mark.parametrize("phi", [1.0, 1.05, 1.3])
@pytest.mark.parametrize("Omega", [0.1, 0.9, 1.5])
def test_tchamwa_wielgosz_has_its_amplification_matrix(phi: float, Omega: float) -> None:
    # x⁺ = x + dt v + φ dt² a, v⁺ = v + dt a, a = -ω² x; here for (x, v/ω)
    if Omega >= 2.0 / math.sqrt(2.0 * phi - 1.0):
        pytest.skip("not stable")
    amplification = np.array([[1.0 - phi * Omega**2, Omega], [-Omega, 1.0]])
    x, v = ring(bd.TchamwaWielgosz(phi), Omega, 60, 1e-3, 4e-4)
    expected = np.array([np.linalg.matrix_power(amplification, n) @ [1e-3, 4e-4] for n in range(61)])
    np.testing.assert_allclose(np.column_stack([x, v]), expected, rtol=0.0, atol=1e-13)


def test_tchamwa_wielgosz_dissipates_high_frequencies_and_spares_low_ones() -> None:
    # the determinant of its amplification matrix is 1 - (φ - 1) Ω²: damping over one period 2π/Ω
    for Omega in (0.01, 0.1, 1.0):
        periods = 3
        steps = round(2.0 * math.pi * periods / Omega)
        x, v = ring(bd.TchamwaWielgosz(1.3), Omega, steps, 0.0, 1e-3)
        kept = np.hypot(x[-1], v[-1]) / 1e-3
        assert kept == pytest.approx((1.0 - 0.3 * Omega**2) ** (0.5 * steps), rel=0.6 * Omega)
    assert kept < 0.05


def test_velocity_verlet_rings_at_its_own_frequency() -> None:
    # ω_d = 2/dt · asin(ω dt/2), and no amplitude is lost: x_n = x0 cos(n ω_d dt)
    for Omega in (0.1, 1.0, 1.9):
        x, _ = ring(bd.VelocityVerlet(), Omega, 400, 1e-3, 0.0)
        expected = 1e-3 * np.cos(np.arange(401) * 2.0 * math.asin(0.5 * Omega))
        np.testing.assert_allclose(x, expected, rtol=0.0, atol=1e-11)


@pytest.mark.parametrize("scheme", [bd.VelocityVerlet(), bd.TchamwaWielgosz(1.05), bd.TchamwaWielgosz(1.3)], ids=str)
def test_oscillator_is_stable_up_to_the_critical_step_of_the_scheme(scheme: bd.Scheme) -> None:
    below, _ = ring(scheme, 0.999 * scheme.critical, 3000, 1e-9, 0.0)
    above, _ = ring(scheme, 1.001 * scheme.critical, 150, 1e-12, 0.0)  # too little for the guard to end it
    assert np.abs(below[-100:]).max() < 2e-9
    assert np.abs(above[-10:]).max() > 10e-12


# ---- the critical time step of a lattice


def test_highest_frequency_is_that_of_the_eigenvalue_problem(record: Record) -> None:
    for lattice in (rod(3), rod(30), BLOCK):
        model = bd.Model(lattice, LAW, RHO)
        K, m = model.interaction.stiffness().tocsc().toarray(), mass_diagonal(model)
        exact = math.sqrt(np.linalg.eigvalsh(K / np.sqrt(m[:, None] * m)).max())
        assert exact <= highest_frequency(model) <= 1.003 * exact
        record("highest frequency", highest_frequency(model) / exact)


@pytest.mark.parametrize("scheme", [bd.VelocityVerlet(), bd.TchamwaWielgosz(1.3)], ids=["Verlet", "TW"])
def test_lattice_is_stable_below_the_critical_step_and_not_above(scheme: bd.Scheme) -> None:
    model = bd.Model(rod(6), LAW, RHO)
    K, m = model.interaction.stiffness().tocsc().toarray(), mass_diagonal(model)
    top = np.linalg.eigh(K / np.sqrt(m[:, None] * m))[1][:, -1] / np.sqrt(m)
    top = 1e-9 * (top / np.abs(top).max()).reshape(-1, 6)[model.layout.rank]
    growth = []
    for share in (0.995, 1.005):
        state = moving(model, top[:, :3], top[:, 3:])
        dt = share * critical_step(model, scheme)
        history = integrate(model, bd.Plan(duration=400 * dt, dt=dt, scheme=scheme, every=1), state=state).history
        total = total_energy(history)
        growth.append(total[-50:].max() / total[0])
    assert growth[0] < 300.0
    assert growth[1] > 1e6


def test_a_step_above_the_limit_is_refused_and_none_takes_nine_tenths() -> None:
    model = bd.Model(rod(5), LAW, RHO)
    for scheme in (bd.VelocityVerlet(), bd.TchamwaWielgosz(1.3)):
        limit = critical_step(model, scheme)
        assert limit == pytest.approx(scheme.critical / highest_frequency(model))
        assert settled(model, bd.Plan(duration=1.0, scheme=scheme)).dt == pytest.approx(0.9 * limit)
        with pytest.raises(UnstableStepError, match=r"exceeds the critical .*pass dt=None"):
            bd.solve_explicit(model, duration=1.0, dt=1.001 * limit, scheme=scheme)
        with pytest.raises(UnstableStepError, match="positive"):
            bd.solve_explicit(model, duration=1.0, dt=0.0, scheme=scheme)
    run = bd.solve_explicit(model, duration=time_step(model, 10.0))
    assert run.steps == 11
    assert run.status is bd.Status.COMPLETED


def test_a_second_run_goes_on_where_the_first_ended_under_other_conditions() -> None:
    model = bd.Model(
        rod(5), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), bd.Load(bd.Index([4]), force=(0.0, 5.0, 0.0))]
    )
    dt = time_step(model, 0.5)
    whole = bd.solve_explicit(model, duration=200 * dt, dt=dt)
    first = bd.solve_explicit(model, duration=120 * dt, dt=dt)
    second = bd.solve_explicit(model, duration=80 * dt, dt=dt, state=first.state)
    assert second.steps == 80
    assert second.state.time == pytest.approx(200 * dt)
    np.testing.assert_allclose(second.state.displacement, whole.state.displacement, rtol=1e-9, atol=1e-12)

    free = model.with_boundary([])
    third = bd.solve_explicit(free, duration=300 * dt, dt=dt, every=10, state=second.state)
    total = total_energy(third.history)
    assert third.history.energy["work"].max() == 0.0
    np.testing.assert_allclose(total, total[0], rtol=1e-2)
    assert total[0] == pytest.approx(whole.history.energy["work"][-1], rel=1e-2)
    with pytest.raises(InputError, match="another lattice"):
        bd.solve_explicit(bd.Model(rod(4), LAW, RHO), duration=dt, state=third.state)


# ---- guards


def spun_pair(spin: np.ndarray) -> tuple[bd.Model, bd.State]:
    model = bd.Model(two_spheres(), LAW, RHO)
    return model, moving(model, np.zeros((2, 3)), np.array([-spin, spin]))


@pytest.mark.parametrize("axis", [0, 2])
def test_a_bond_turned_too_far_ends_the_run(axis: int) -> None:
    # the ends may turn against each other while I ω² < the energy of the barrier, 2 kt (twist) or the like
    model, _ = spun_pair(np.zeros(3))
    k, I = model.stiffness, model.inertia[0]
    barrier = 2.0 * k.kt[0] if axis == 0 else 0.5 * (k.ks[0] + 4.0 * k.kb[0])
    dt = time_step(model, 0.2)
    plan = bd.Plan(duration=300 * dt, dt=dt, every=50)

    gentle = integrate(model, plan, state=spun_pair(np.eye(3)[axis] * 0.05 * math.sqrt(barrier / I))[1])
    assert gentle.status is bd.Status.COMPLETED
    assert "beam" not in gentle.message

    violent = integrate(model, plan, state=spun_pair(np.eye(3)[axis] * 3.0 * math.sqrt(barrier / I))[1])
    assert violent.status is bd.Status.UNSTABLE
    assert "unbroken bonds are turned" in violent.message
    assert "smaller dt" in violent.message
    assert violent.state.step == 0
    assert np.isfinite(violent.state.pose).all()
    assert violent.steps < 300


def test_a_wide_bond_is_reported() -> None:
    # w² < 0.75 from 60° of twist on
    for degrees, wide in ((70.0, True), (50.0, False)):
        twist = bd.Drive(bd.Index([1]), rx=bd.Ramp(0.0, math.radians(degrees), 1.0))
        result = integrate(
            bd.Model(two_spheres(), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), twist]), bd.Plan(duration=1.0, every=0)
        )
        assert result.status is bd.Status.COMPLETED
        assert ("no longer that of a beam" in result.message) == wide


def test_a_number_that_is_not_finite_ends_the_run(tumbling_rod) -> None:
    model, state = tumbling_rod
    state.motion[3, 1] = math.nan
    result = integrate(model, bd.Plan(duration=1.0, every=0), state=state)
    assert result.status is bd.Status.UNSTABLE
    assert "not finite" in result.message


# ---- prescribed motion


def test_a_driven_element_is_where_and_as_fast_as_its_schedule_says() -> None:
    path = bd.Ramp(0.0, -0.2, duration=0.5, begin=0.125)
    speed = bd.Table((0.0, 0.25, 0.75), (0.0, 0.6, -0.4))
    drive = bd.Drive(bd.Index([5]), x=path, vy=speed, rx=bd.Ramp(0.0, 0.9, 0.5), ry=0.0, rz=0.0)
    model = bd.Model(rod(6), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), drive])
    gauges = {name: bd.Gauge(bd.Index([5]), name) for name in ("displacement", "velocity", "rotation")}
    run = integrate(model, bd.Plan(duration=1.0, dt=1.0 / 512, gauges=gauges, every=16))
    t = run.history.time
    x, y, _ = run.history["displacement"].T
    v = np.interp(t, speed.times, speed.values)
    travelled = np.concatenate([[0.0], np.cumsum(0.5 * (v[1:] + v[:-1]) * np.diff(t))])  # kinks lie on records
    np.testing.assert_allclose(x, np.interp(t, [0.125, 0.625], [0.0, -0.2]), rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(y, travelled, rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(run.history["velocity"][:, 1], v, rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(run.history["rotation"][:, 0], np.minimum(1.8 * t, 0.9), rtol=0.0, atol=1e-12)


# ---- the ledger

DRIVES = {
    "load": (bd.Load(bd.Index([5]), force=(20.0, 60.0, -30.0), moment=(5.0, 0.0, 8.0), schedule=bd.Ramp(0, 1, 0.5)),),
    "displacement": (bd.Drive(bd.Index([5]), x=bd.Ramp(0.0, 0.02, 0.5), y=bd.Ramp(0.0, -0.2, 0.5), rz=0.0),),
    "velocity": (bd.Drive(bd.Index([5]), vx=0.1, vy=bd.Table((0.0, 0.25, 0.5), (0.0, 0.6, -0.4)), wx=0.5),),
}


@pytest.mark.parametrize("damping", [None, bd.LocalDamping(0.3)], ids=["undamped", "damped"])
@pytest.mark.parametrize("drive", DRIVES.values(), ids=DRIVES.keys())
def test_the_energy_ledger_closes_to_second_order(
    drive: tuple, damping: bd.LocalDamping | None, record: Record
) -> None:
    model = bd.Model(rod(6), LAW, RHO, boundary=[bd.Fix(bd.Index([0])), *drive])
    whole = 1.0 / 16.0  # kinks of the schedules fall on whole steps
    assert whole / 8 < time_step(model, 1.0)
    errors = []
    for k in (8, 16, 32):
        dt = whole / k
        history = integrate(model, bd.Plan(duration=0.75, dt=dt, damping=damping, every=k)).history
        energy = history.energy
        size = max(np.abs(energy["work"]).max(), 1e-30)
        errors.append(np.abs(energy["balance"]).max() / size)
    assert energy["work"][-1] > 0.0
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(rates, 2.0, atol=0.3)
    record("order of the ledger", *rates)
