"""Bonds of the non-local law that break: when, what follows, with which ledger, and the same bits however run."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.explicit import integrate
from bondem.model.highest_frequency import highest_frequency
from tests.bits import assert_resumes_to, assert_same_bits, need_two_threads, threads
from tests.core.law_samples import stress_bounds
from tests.models import momenta, time_step
from tests.recording import Record
from tests.specimens import cells, cubes

E, NU, RHO = 1e9, 0.25, 1000.0
VERLET = bd.VelocityVerlet()
WEAK = bd.MohrCoulomb(tension=1e12, cohesion=5e5, friction_angle=math.radians(40.0))
STEEP = bd.MohrCoulomb(tension=1e12, cohesion=1e6, friction_angle=math.radians(40.0))


AXIS, ACROSS = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.6, 0.8])


def two(failure: bd.Criterion, drive: bd.Drive, contact: bd.ContactLaw | None = None) -> bd.Model:
    """Two unequal cells that share one facet of 1 m², normal to x; the second one is driven."""
    position = np.array([[0.5, 0.5, 0.5], [1.4, 0.5, 0.5]])
    particles = bd.Particles(position, np.array([0.5, 0.4]), shape=bd.Box((2.0, 1.0, 1.0)))
    body = bd.connect(particles, method="laguerre")
    boundary = [bd.Fix(bd.Index([0])), drive]
    return bd.Model(body, bd.NonLocal(E=E, nu=NU), RHO, failure=failure, contact=contact, boundary=boundary)


def driven(model: bd.Model, share: float, duration: float, **options) -> bd.ExplicitResult:
    """A run at a share of the critical step of the springs; all elements are held: no lag feeds any motion."""
    dt = share * 2.0 / highest_frequency(model)
    return integrate(model, bd.Plan(duration=duration, dt=dt, every=1, **options))


def moved(way: np.ndarray, end: float) -> bd.Drive:
    """The second sphere goes along a vector [m] in a time, and does not turn."""
    x, y, z = (bd.Ramp(0.0, part, end) for part in way)
    return bd.Drive(bd.Index([1]), x=x, y=y, z=z, rx=0.0, ry=0.0, rz=0.0)


def mean_tensor(model: bd.Model, force: np.ndarray) -> np.ndarray:
    """Mean stress of both elements, eqs (1) and (5), of forces on the first [N], (s, 3)."""
    c = model.interaction.by_user
    lever = 0.5 * (c.lever_i[0] / c.volume[0] - c.lever_j[0] / c.volume[1])
    tensor = lever[None, :, None] * force[:, None, :]
    return 0.5 * (tensor + tensor.transpose(0, 2, 1))


WAYS = {"pulled": (1.0, 0.0), "sheared": (0.1, 1.0), "pressed and sheared": (-0.1, 1.0)}


@pytest.mark.parametrize("criterion", [bd.Rankine(tension=1e6), WEAK], ids=["Rankine", "Mohr-Coulomb"])
@pytest.mark.parametrize("way", WAYS)
def test_one_bond_breaks_in_the_step_in_which_the_mean_stress_reaches_the_strength(
    way: str, criterion: bd.Criterion, one_thread: None
) -> None:
    """Eqs (1), (5), (8) and (9) by hand, from the force that the first sphere's grip feels in every step."""
    along, beside = WAYS[way]
    drive = moved(2e-2 * (along * AXIS + beside * ACROSS), 2.0)
    model = two(criterion, drive)
    run = driven(model, 0.3, 2.0)
    assert len(run.events) == 1
    # what is recorded of the step that breaks it is without the bond: the force is that of one which holds
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    strong = driven(two(bd.Rankine(tension=1e12), drive), 0.3, run.events.time[0] + 2.0 * run.dt, gauges=gauges)
    stress = np.linalg.eigvalsh(mean_tensor(model, -strong.history["grip"]))
    low, high = stress[:, 0], stress[:, 2]
    if isinstance(criterion, bd.Rankine):
        index = high / criterion.tension
    else:
        sine, cosine = math.sin(criterion.friction_angle), math.cos(criterion.friction_angle)
        index = ((high - low) / 2.0 + (high + low) / 2.0 * sine) / (criterion.cohesion * cosine)
    assert run.events.step[0] == np.flatnonzero(index >= 1.0)[0]
    assert run.events.mode[0] == ("tension" if isinstance(criterion, bd.Rankine) else "shear")


def test_strength_of_one_bond_in_closed_form(one_thread: None) -> None:
    """Pulled along its axis it bears A E / L δ, and σ1 is that times the mean of l / V."""
    for strength in (0.5e6, 1e6):
        model = two(bd.Rankine(tension=strength), moved(4e-3 * AXIS, 1.0))
        c = model.interaction.by_user
        lever = 0.5 * (c.lever_i[0] / c.volume[0] - c.lever_j[0] / c.volume[1]) @ AXIS
        run = driven(model, 0.1, 1.0)
        expected = strength / (c.kn[0] * lever)
        per_step = 4e-3 * run.dt
        assert 0.0 <= run.events.gap[0] - expected <= 1.001 * per_step
        assert run.events.energy[0] == pytest.approx(0.5 * c.kn[0] * run.events.gap[0] ** 2, rel=1e-9)
        assert run.events.mode[0] == "tension"


def test_scatter_multiplies_the_strength_of_each_bond(one_thread: None) -> None:
    scatter = bd.Weibull(modulus=3.0, volume=1.0, seed=4)
    gaps = []
    for failure in (bd.Rankine(tension=1e6), bd.Rankine(tension=1e6, scatter=scatter)):
        model = two(failure, moved(8e-3 * AXIS, 2.0))
        run = driven(model, 0.1, 2.0)
        gaps.append(run.events.gap[0])
    c = model.interaction.by_user
    factor = scatter.factors(c.area * model.lattice.length, model.lattice.centre[:1] + c.lever_i)[0]
    assert abs(factor - 1.0) > 0.05
    assert gaps[1] / gaps[0] == pytest.approx(factor, abs=2.0 * 4e-3 * run.dt / gaps[0])


def sheared_and_pressed(friction: float) -> tuple[bd.Model, list[bd.Table]]:
    """Two cells: their bond breaks under pressure by the shear that follows, then a contact bears; and the way."""
    time, pressed, slid = [0.0, 0.2, 0.6, 1.0], [0.0, -1e-3, -1e-3, 1e-3], [0.0, 0.0, 5e-3, 5e-3]
    way = [bd.Table(time, [n * a + t * b for n, t in zip(pressed, slid, strict=True)])
           for a, b in zip(AXIS, ACROSS, strict=True)]  # fmt: skip
    drive = bd.Drive(bd.Index([1]), x=way[0], y=way[1], z=way[2], rx=0.0, ry=0.0, rz=0.0)
    return two(bd.Rankine(tension=2e4), drive, bd.LinearContact(E=E, friction=friction)), way


def test_stresses_after_a_step_with_breaks_are_those_of_what_still_bears(one_thread: None) -> None:
    """Eq (1), σ = Σ sym(l f) / V: of the contact that takes over, at its own lever, and of nothing else."""
    model, _ = sheared_and_pressed(friction=0.3)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    broken = driven(model, 0.2, 1.0)
    step = int(broken.events.step[0])
    run = driven(model, 0.2, step * broken.dt, gauges=gauges)
    assert run.events.step.tolist() == [step]
    volume, radius = model.interaction.by_user.volume, model.contact_radius
    share = radius[0] / radius.sum()
    force, branch = -run.history["grip"][-1], np.diff(run.state.position, axis=0)[0]
    assert force[0] < 0.0
    for p, lever in ((0, share * branch), (1, (1.0 - share) * branch)):
        tensor = 0.5 * (np.outer(lever, force) + np.outer(force, lever)) / volume[p]
        expected = tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        np.testing.assert_allclose(run.state.stress[p], expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


def test_a_pair_that_breaks_under_pressure_repels_and_rubs(one_thread: None) -> None:
    """The normal force is kn (L - l) from then on, friction grows as its spring does and ends at μ N; no tension."""
    model, way = sheared_and_pressed(friction=0.3)
    gauges = {"grip": bd.Gauge(bd.Index([0]), "force", "sum")}
    run = driven(model, 0.2, 1.0, gauges=gauges)
    assert len(run.events) == 1
    after = run.history.time > run.events.time[0]
    t = run.history.time[after]
    ends = np.stack([[schedule.at(now) for schedule in way] for now in t.tolist()]) + model.lattice.branch[0]
    length = np.linalg.norm(ends, axis=1)
    normal = ends / length[:, None]
    force = run.history["grip"][after]
    pressed = np.einsum("tk,tk->t", force, normal)
    kn, rest = model.interaction.by_user.kn[0], model.lattice.length[0]
    np.testing.assert_allclose(pressed, kn * np.maximum(rest - length, 0.0), rtol=1e-6, atol=1e-6 * kn * 1e-3)
    rubbing = np.linalg.norm(force - pressed[:, None] * normal, axis=1)
    assert (rubbing <= 0.3 * pressed * (1.0 + 1e-9) + 1e-12).all()
    sliding = (t > 0.55) & (t < 0.6)
    np.testing.assert_allclose(rubbing[sliding], 0.3 * pressed[sliding], rtol=1e-6)
    assert (pressed[t > 0.9] == 0.0).all()


def test_a_bar_under_slow_tension_breaks_at_the_strength(one_thread: None) -> None:
    """Uniform stress F / S: away from the grips, whose force is no part of the stress, bonds break at F / S = f_t."""
    body = cubes((8, 3, 3))
    grips = [
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2e-2, 0.2)),
    ]
    model = bd.Model(body, bd.NonLocal(E=E, nu=0.0), RHO, failure=bd.Rankine(tension=1e6), boundary=grips)
    gauges = {"grip": bd.Gauge(bd.Face("x_min"), "force", "sum")}
    dt = time_step(model, 0.3, bd.LocalDamping(0.7))
    run = bd.solve_explicit(model, duration=0.9, dt=dt, every=1, damping=bd.LocalDamping(0.7), gauges=gauges)
    assert len(run.events) > 0
    first = int(run.events.step[0])
    assert -run.history["grip"][first - 1, 0] / 9.0 == pytest.approx(1e6, rel=2e-3)
    at = run.events.position[run.events.step == first]
    assert ((at[:, 0] > 1.5) & (at[:, 0] < 6.5)).all()


def test_plates_count_in_the_stress_of_what_they_press(one_thread: None) -> None:
    """Uniform compression between smooth plates: every cell, those at the plates too, has σ = -F / S and no other.

    To the strain, 2e-4, by which levers and the section differ from those of the reference.
    """
    body = cubes((5, 3, 3))
    walls = [
        bd.PlaneWall(point=(0.0, 0.0, 0.0), normal=(1.0, 0.0, 0.0)),
        bd.PlaneWall(point=(5.0, 0.0, 0.0), normal=(-1.0, 0.0, 0.0), motion=bd.Driven(x=bd.Ramp(0.0, -1e-3, 0.05))),
    ]
    model = bd.Model(body, bd.NonLocal(E=E, nu=NU), RHO, contact=bd.LinearContact(E=E), walls=walls)
    run = bd.solve_explicit(model, duration=0.15, damping=bd.LocalDamping(0.7), every=0)
    force = run.state.wall_force[:, 0]
    assert force[1] == pytest.approx(-force[0], rel=1e-6)
    expected = np.zeros((45, 6))
    expected[:, 0] = -force[1] / 9.0
    assert force[1] / 9.0 > 1e5
    np.testing.assert_allclose(run.state.stress, expected, rtol=0.0, atol=2e-4 * force[1] / 9.0)


@functools.cache
def crushed(failure: bd.Criterion) -> bd.Model:
    """A body of 500 cells between two rough plates that come together at 2 m/s."""
    body = cells(bd.Box((2.0, 1.0, 1.0)), 500, spread=0.25)
    walls = [
        bd.PlaneWall(point=(0.0, 0.0, 0.0), normal=(1.0, 0.0, 0.0)),
        bd.PlaneWall(point=(2.0, 0.0, 0.0), normal=(-1.0, 0.0, 0.0), motion=bd.Driven(vx=-2.0)),
    ]
    contact = bd.LinearContact(E=E, friction=0.3, damping=0.05)
    return bd.Model(body, bd.NonLocal(E=E, nu=NU), RHO, failure=failure, contact=contact, walls=walls)


def crushing(share: float, steps: int, failure: bd.Criterion = STEEP, **options) -> bd.ExplicitResult:
    model, damping = crushed(failure), options.pop("damping", bd.LocalDamping(0.2))
    dt = time_step(model, share, damping)
    return bd.solve_explicit(model, duration=steps * dt, dt=dt, damping=damping, **options)


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_the_ledger_closes_through_breakage_and_friction(one_thread: None, record: Record) -> None:
    """With the non-local work as an entry of its own; what is missed falls with the step as the lag does."""
    missed = []
    for share, steps in ((0.8, 1000), (0.2, 4000)):
        run = crushing(share, steps, every=steps // 100)
        energy = run.history.energy
        assert len(run.events) > 300
        assert energy["friction"][-1] > 0.0
        assert energy["fracture"][-1] == pytest.approx(run.events.energy.sum(), rel=1e-9)
        assert (run.events.energy > 0.0).all()
        missed.append(np.abs(energy["balance"]).max() / energy["work"].max())
        assert np.abs(energy["non-local work"]).max() > 10.0 * np.abs(energy["balance"]).max()
    assert missed[0] < 2e-3
    assert missed[1] < 0.5 * missed[0]
    record("missed", missed[0])


def test_momentum_is_kept_through_breakage(one_thread: None) -> None:
    """Also angular momentum: both forces of a bond act at one point, and so do those of the contact that follows."""
    body = cells(bd.Box((1.0, 1.0, 1.0)), 150, spread=0.25)
    failure, contact = bd.Rankine(tension=1e6), bd.LinearContact(E=E, friction=0.3)
    model = bd.Model(body, bd.NonLocal(E=E, nu=NU), RHO, failure=failure, contact=contact)
    state, mass = model.state(), model.mass[:, None]
    outwards = body.centre - (mass * body.centre).sum(axis=0) / mass.sum()
    state.set_motion(velocity=6.0 * outwards + np.cross((0.0, 0.0, 5.0), outwards))
    dt = 0.5 / highest_frequency(model)  # nothing takes out what the lag feeds; the run is short
    run = integrate(model, bd.Plan(duration=1e-3, dt=dt, every=0), state=state.copy())
    assert len(run.events) > 100
    scale = np.abs(mass * state.velocity).sum()
    change = np.subtract(momenta(model, run.state), momenta(model, state))
    assert np.abs(change).max() < 1e-11 * scale


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_same_bits_of_a_body_that_is_crushed(tmp_path: Path, record: Record) -> None:
    """On one and two threads, recorded often or seldom, saved and resumed."""
    need_two_threads()

    def run(count: int, every: int, **options) -> bd.ExplicitResult:
        with threads(count):
            return crushing(0.8, 800, every=every, **options)

    whole = run(1, 100)
    assert len(whole.events) > 300
    assert len(whole.state.touching) > 20
    assert_same_bits(whole, run(2, 7))
    assert_resumes_to(whole, functools.partial(run, 2, 100, save_every=31), tmp_path / "run.h5", 0.7)
    record("same bits", True)


@pytest.mark.filterwarnings("ignore::bondem.errors.NotQuasistaticWarning")  # fast on purpose
def test_index_says_how_near_each_bond_is(one_thread: None) -> None:
    """Below 1 of all that is whole, and the last of them that broke was the nearest a step before."""
    states: dict[int, bd.State] = {}

    def look(state: bd.State, record: bd.History) -> None:
        states[state.step] = state.copy()

    run = crushing(0.8, 500, every=1, callback=look)
    step = int(run.events.step[0])
    before = bd.failure_index(run.state.model, states[step - 1])
    assert 0.9 < before.max() < 1.0
    assert before[run.events.bond[run.events.step == step]].max() == before.max()
    now = bd.failure_index(run.state.model, run.state)
    assert (now[run.state.bond_integrity == 0.0] == 0.0).all()


def test_bounds_of_principal_stresses_are_close_and_never_inside() -> None:
    """Random stresses of all sizes, and those with two or three equal principal stresses."""
    rng = np.random.default_rng(1)
    stresses = rng.standard_normal((20_000, 6)) * 10.0 ** rng.uniform(-3.0, 9.0, (20_000, 1))
    turned = np.linalg.qr(rng.standard_normal((100, 3, 3)))[0]
    for diagonal in ([-5.5e7, 0.0, 0.0], [4e6, 0.0, 0.0], [1e6, 1e6, 1e6], [2e6, 2e6, -3e6], [1e6, 0.0, -1e6]):
        full = turned @ (np.array(diagonal)[:, None] * turned.transpose(0, 2, 1))
        stresses = np.vstack([stresses, full[:, [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]])
    stresses = np.vstack([stresses, np.zeros(6)])
    found = stress_bounds(stresses.T, np.zeros(len(stresses)))[:2].T
    exact = np.linalg.eigvalsh(stresses[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3))
    size = np.abs(stresses).max(axis=1)
    rounding = 1e-14 * size
    beyond = np.column_stack([found[:, 0] - exact[:, 2], exact[:, 0] - found[:, 1]])
    assert (beyond >= -rounding[:, None]).all()
    assert (beyond <= 1e-5 * size[:, None]).all()
