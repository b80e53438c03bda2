"""Damping of elements, of bonds and by the scheme, against closed forms."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.errors import InputError
from bondem.model.highest_frequency import highest_frequency
from tests.models import momenta, moving, stirred, time_step
from tests.recording import Record
from tests.specimens import crooked_block, rod, two_spheres
from validation.studies.cell_damping import SIZE, damping_of_mode

E, RHO = 2.0e6, 1200.0
LAW = bd.Timoshenko(E=E, nu=0.25, radius_ratio=0.5)
BLOCK = crooked_block((4, 3, 3), jitter=0.05, radius=(0.4, 0.5), reach=1.3, seed=2)
pytestmark = pytest.mark.usefixtures("one_thread")


def decaying(t: np.ndarray, v0: float, omega: float, zeta: float) -> np.ndarray:
    """Displacement of a damped oscillator that starts at 0 with velocity v0."""
    damped = omega * math.sqrt(1.0 - zeta**2)
    return v0 / damped * np.exp(-zeta * omega * t) * np.sin(damped * t)


# component of the bond, the relative motion that excites it alone, and what is held
COMPONENTS = {
    "normal": ("kn", "velocity", 0, ""),
    "shear": ("ks", "velocity", 1, "xyz"),
    "bending": ("kb", "rotation", 2, ""),
    "twisting": ("kt", "rotation", 0, ""),
}


@pytest.mark.parametrize("kind_of_damping", ["eta", "beta"])
@pytest.mark.parametrize("component", COMPONENTS)
def test_each_component_of_a_damped_pair_is_a_damped_oscillator(component: str, kind_of_damping: str) -> None:
    name, kind, axis, held = COMPONENTS[component]
    boundary = [bd.Fix(bd.Everything(), translation="", rotation=held)] if held else []
    model = bd.Model(two_spheres(), bond=LAW, density=RHO, boundary=boundary)
    k = getattr(model.stiffness, name)[0]
    inert = 0.5 * (model.mass[0] if kind == "velocity" else model.inertia[0])
    omega = math.sqrt(k / inert)
    zeta = 0.1
    damping = bd.BondDamping(zeta) if kind_of_damping == "eta" else bd.BondDamping(beta=2.0 * zeta / omega)
    relative = np.zeros((2, 3))
    relative[:, axis] = (-0.5e-4 * omega, 0.5e-4 * omega)
    errors = []
    for share in (0.01, 0.005):
        dt = time_step(model, share)
        state = model.state()
        state.set_motion(**{"velocity" if kind == "velocity" else "angular_velocity": relative})
        quantity = "displacement" if kind == "velocity" else "rotation"
        gauges = {name: bd.Gauge(bd.Index([e]), quantity) for e, name in enumerate("ij")}
        plan = bd.Plan(duration=12.0 / omega, dt=dt, damping=damping, gauges=gauges, every=1)
        history = integrate(model, plan, state=state).history
        x = history["j"][:, axis] - history["i"][:, axis]
        errors.append(np.abs(x - decaying(history.time, 1e-4 * omega, omega, zeta)).max() / 1e-4)
    # the dashpots see the velocity half a step ago: first order
    assert errors[0] < 4.0 * zeta * time_step(model, 0.01) * omega
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.2)


def test_bond_damping_keeps_momentum_and_angular_momentum() -> None:
    model = bd.Model(BLOCK, LAW, RHO)
    damping = bd.BondDamping(0.2)
    dt = time_step(model, 0.5, damping)
    start = stirred(model, 1.0, spin=1.0)
    before, size = momenta(model, start), float(np.abs(model.mass[:, None] * start.velocity).sum())
    # noise: the scheme swings the energy of the shortest waves
    run = integrate(model, bd.Plan(duration=400 * dt, dt=dt, damping=damping, imbalance=None), state=start)
    assert np.abs(np.subtract(momenta(model, run.state), before)).max() < 1e-13 * size
    energy = run.history.energy
    assert energy["loss"][-1] > 0.3 * energy["translation"][0]


def test_a_rigid_motion_is_not_damped_by_bonds() -> None:
    model = bd.Model(BLOCK, LAW, RHO)
    state = model.state()
    omega = np.array([0.0, 0.0, 3.0])
    velocity = np.cross(omega, state.position) + np.array([1.0, 0.0, 0.0])
    state.set_motion(velocity=velocity, angular_velocity=np.tile(omega, (len(state.pose), 1)))
    dt = 1e-4 * time_step(model, 1.0)
    plan = bd.Plan(duration=dt, dt=dt, damping=bd.BondDamping(0.3), every=1)
    energy = integrate(model, plan, state=state).history.energy
    assert abs(energy["loss"][-1]) < 1e-12 * energy["translation"][0]


@pytest.mark.parametrize(
    "damping", [bd.BondDamping(0.2), bd.MassDamping(20.0), (bd.LocalDamping(0.1), bd.BondDamping(0.05))], ids=str
)
def test_the_ledger_closes_to_second_order(damping, record: Record) -> None:
    model = bd.Model(rod(6), LAW, RHO)
    x = model.lattice.particles.position[:, 0] / 5.0
    errors = []
    for k in (64, 128, 256):
        state = moving(model, np.column_stack([0.3 * x, 0.5 * np.cos(4.0 * x), 0.2 * x**2]))
        dt = 1.0 / 8.0 / k
        history = integrate(model, bd.Plan(duration=0.5, dt=dt, damping=damping, every=k), state=state).history
        errors.append(np.abs(history.energy["balance"]).max() / history.energy["translation"][0])
    assert history.energy["loss"][-1] > 0.05 * history.energy["translation"][0]
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(rates, 2.0, atol=0.4)
    record("order of the ledger", *rates)


@pytest.mark.parametrize(("zeta", "steps"), [(0.1, 150), (1.0, 600)])
def test_the_critical_step_of_damped_bonds_is_the_limit(zeta: float, steps: int, record: Record) -> None:
    # with C = β K every mode is an oscillator of its own, and the bound is sharp
    model = bd.Model(rod(6), LAW, RHO)
    omega = highest_frequency(model)
    damping = bd.BondDamping(beta=2.0 * zeta / omega)
    limit = time_step(model, 1.0, damping)
    assert limit == pytest.approx(2.0 / omega * (math.sqrt(1.0 + zeta**2) - zeta), rel=1e-9)
    kept = []
    for share in (0.99, 1.01):
        plan = bd.Plan(duration=steps * share * limit, dt=share * limit, damping=damping, every=steps)
        energy = integrate(model, plan, state=stirred(model, 1e-12, spin=1e-12)).history.energy
        kept.append((energy["translation"] + energy["rotation"])[-1] / energy["translation"][0])
    assert kept[0] < 1.0
    assert kept[1] > 100.0
    record("stable at 0.99 of the limit", bool(kept[0] < 1.0))
    record("unstable at 1.01 of the limit", bool(kept[1] > 100.0))


def test_the_critical_step_of_a_pair_share_is_safe() -> None:
    model = bd.Model(BLOCK, LAW, RHO)
    for damping in (bd.BondDamping(0.1), bd.BondDamping(0.5), (bd.BondDamping(0.2), bd.LocalDamping(0.5))):
        limit = time_step(model, 1.0, damping)
        assert limit < time_step(model, 1.0)
        plan = bd.Plan(duration=2000 * limit, dt=0.999 * limit, damping=damping, every=500, imbalance=None)
        energy = integrate(model, plan, state=stirred(model, 1e-6, spin=1e-6)).history.energy
        assert energy["translation"][-1] < energy["translation"][0]


def mode_run(model: bd.Model, number: int, plan: dict, share: float) -> tuple[np.ndarray, np.ndarray, float, float]:
    """Times, amplitude of a mode that starts with unit velocity, its ω and dt = share / ω."""
    modes = bd.solve_modes(model, count=number + 1)
    shape = modes.shape[number]
    omega = 2.0 * math.pi * modes.frequency[number]
    weight = np.repeat(np.column_stack([model.mass, model.inertia]), 3, axis=1)
    scale = 1e-6 / np.abs(shape).max()
    state = moving(model, scale * shape[:, :3], scale * shape[:, 3:])
    dt = share / omega
    every = max(1, round(0.05 / share))
    gauges = {}
    for e in range(len(shape)):
        gauges[f"u{e}"] = bd.Gauge(bd.Index([e]), "displacement")
        gauges[f"r{e}"] = bd.Gauge(bd.Index([e]), "rotation")
    run = integrate(model, bd.Plan(dt=dt, duration=20.0 / omega, gauges=gauges, every=every, **plan), state=state)
    moved = np.stack([np.hstack([run.history[f"u{e}"], run.history[f"r{e}"]]) for e in range(len(shape))], axis=1)
    amplitude = (moved * weight * shape).sum(axis=(1, 2)) / (weight * shape**2).sum() / scale
    return run.history.time, amplitude, omega, dt


@pytest.fixture
def held_bar() -> bd.Model:
    """Its first modes are transverse, so it is guided: only axial ones are left."""
    model = bd.Model(rod(12), LAW, RHO)
    guide = bd.Fix(bd.Everything(), translation="yz", rotation="xyz")
    return model.with_boundary([guide, bd.Fix(bd.Index([0]), translation="x", rotation="")])


def test_an_axial_mode_decays_with_half_the_rate_of_mass_damping(held_bar) -> None:
    model = held_bar
    errors = []
    for share in (0.02, 0.01):
        omega = 2.0 * math.pi * bd.solve_modes(model, count=1).frequency[0]
        alpha = 0.1 * omega
        t, amplitude, omega, _ = mode_run(model, 0, {"damping": bd.MassDamping(alpha)}, share)
        errors.append(np.abs(amplitude - decaying(t, 1.0, omega, 0.05)).max() * omega)
    assert errors[0] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, abs=0.5)


def test_mass_damping_slows_rigid_motion_and_does_not_lower_the_step() -> None:
    model = bd.Model(BLOCK, LAW, RHO)
    assert time_step(model, 1.0, bd.MassDamping(1e9)) == time_step(model, 1.0)
    dt = time_step(model, 0.99)
    stiff = integrate(
        model,
        bd.Plan(duration=500 * dt, dt=dt, damping=bd.MassDamping(5.0 / dt)),
        state=stirred(model, 1.0, spin=1.0),
    )
    assert np.abs(stiff.state.velocity).max() < 1e-3
    state = moving(model, np.tile([1.0, 2.0, 0.0], (36, 1)))
    run = integrate(model, bd.Plan(duration=0.5, dt=1e-3, damping=bd.MassDamping(3.0)), state=state)
    slowed = np.exp(-1.5) * np.tile([1.0, 2.0, 0.0], (36, 1))
    np.testing.assert_allclose(run.state.velocity, slowed, rtol=1e-5, atol=1e-12)


def test_local_damping_takes_a_fixed_share_of_each_swing() -> None:
    # towards the centre the force is (1 - γ) k x, away from it (1 + γ) k x
    gamma = 0.2
    model = bd.Model(two_spheres(), bond=LAW, density=RHO, boundary=[bd.Fix(bd.Index([0]))])
    omega = math.sqrt(model.stiffness.kn[0] / model.mass[1])
    half = 0.5 * math.pi / omega * (1.0 / math.sqrt(1.0 - gamma) + 1.0 / math.sqrt(1.0 + gamma))
    state = model.state()
    state.set_pose(position=np.array([[0.0, 0, 0], [1.0 + 1e-4, 0, 0]]))
    dt = half / 2000
    gauges = {"x": bd.Gauge(bd.Index([1]), "displacement")}
    plan = bd.Plan(duration=6 * half, dt=dt, damping=bd.LocalDamping(gamma), gauges=gauges, every=2000)
    x = integrate(model, plan, state=state).history["x"][:, 0]
    ratio = -math.sqrt((1.0 - gamma) / (1.0 + gamma))
    np.testing.assert_allclose(x, 1e-4 * ratio ** np.arange(7), atol=2e-3 * 1e-4)


@pytest.mark.parametrize("number", [0, 4, 10])
def test_a_mode_decays_as_the_amplification_matrix_of_tchamwa_wielgosz(held_bar, number: int) -> None:
    phi, share = 1.2, 0.05
    t, amplitude, omega, dt = mode_run(held_bar, number, {"scheme": bd.TchamwaWielgosz(phi)}, share)
    step = np.array([[1.0 - phi * share**2, dt], [-omega * share, 1.0]])
    expected = [(np.linalg.matrix_power(step, round(time / dt)) @ [0.0, 1.0])[0] for time in t]
    assert np.abs(amplitude - expected).max() * omega < 1e-6
    kept = (1.0 - (phi - 1.0) * share**2) ** (0.5 * len(t))
    assert kept < 0.95


def test_damping_that_makes_no_sense_is_refused() -> None:
    for make in (lambda: bd.MassDamping(-1.0), lambda: bd.BondDamping(-0.1), lambda: bd.BondDamping(beta=math.nan)):
        with pytest.raises(InputError, match="zero or more"):
            make()
    model = bd.Model(rod(3), LAW, RHO)
    with pytest.raises(InputError, match="two LocalDamping"):
        bd.solve_explicit(model, duration=1.0, damping=(bd.LocalDamping(0.1), bd.LocalDamping(0.2)))
    with pytest.raises(InputError, match=r"damping= takes bd\.LocalDamping"):
        bd.solve_explicit(model, duration=1.0, damping=0.3)


@pytest.mark.parametrize(("nu", "least", "largest"), [(0.0, 0.86, 1.01), (0.2, 0.79, 0.95), (None, 0.99, 1.01)])
def test_beta_damps_modes_of_beams_by_rayleigh_and_of_cells_by_less(
    nu: float | None, least: float, largest: float
) -> None:
    """The docstring and docs/steps.md state the range of cells; None are beams."""
    packed = bd.pack(bd.Box(SIZE), count=200, method="even" if nu is not None else "quench", seed=4)
    body = bd.connect(packed, method="laguerre") if nu is not None else bd.connect(packed)
    model = bd.Model(body, LAW if nu is None else bd.CellBond(E=E, nu=nu), RHO)
    modes = bd.solve_modes(model, count=7)
    pairs = [one for one in zip(modes.frequency, modes.shape, strict=True) if one[0] > 1e-3 * max(modes.frequency)]
    found = [damping_of_mode(model, float(frequency), shape) for frequency, shape in pairs[:2]]
    assert least < min(found) <= max(found) < largest
