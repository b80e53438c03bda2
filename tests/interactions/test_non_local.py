"""The non-local law: closed forms, its own ledger, its lag, and its limits."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.explicit import integrate
from bondem.dynamics.lagged_timestep import growth
from bondem.errors import InputError, StepWarning, UnstableRunWarning
from bondem.interactions.non_local.contact_areas import weighted_areas
from bondem.interactions.non_local.non_local_strain import NonLocalStrain
from bondem.io.runfile import RunFile
from bondem.model.highest_frequency import highest_frequency
from bondem.statics.lagged_statics import LaggedStatics
from bondem.statics.linear import System
from tests.specimens import cells, grid

E, RHO = 40e9, 2400.0


@pytest.fixture(scope="module")
def body() -> bd.Lattice:
    return cells(bd.Cell((1.0, 1.0, 1.0)), 150, spread=0.25)


@pytest.fixture(scope="module")
def spheres(body: bd.Lattice) -> bd.Lattice:
    return bd.connect(body.particles, reach=1.3)


def law(nu: float = 0.2, **more) -> bd.NonLocal:
    return bd.NonLocal(E=E, nu=nu, **more)


def statics(lattice: bd.Lattice, bond: bd.NonLocal) -> LaggedStatics:
    model = bd.Model(lattice, bond, RHO)
    return LaggedStatics(model.interaction, System.of(model))


def strained(lattice: bd.Lattice, strain: np.ndarray) -> np.ndarray:
    return lattice.branch @ strain


@pytest.mark.parametrize("nu", [
    pytest.param(0.0, marks=pytest.mark.validate), 0.2, pytest.param(0.4, marks=pytest.mark.validate),
])  # fmt: skip
def test_moduli_of_the_material_come_back(body: bd.Lattice, nu: float):
    """Laguerre areas, levers to the facets: E within 1 %, ν within 0.005."""
    found = bd.bulk_moduli(body, law(nu))
    assert abs(found.E / E - 1.0) < 0.01
    assert found.nu == pytest.approx(nu, abs=0.005)


def test_uniform_strain_has_hookes_stress_in_every_cell(body: bd.Lattice):
    """Gaps of a uniform strain and its stress are a fixed point of the law: eq (1), (2) and (6) together."""
    nu, strain = 0.3, np.array([[1.0, 0.3, -0.2], [0.3, -0.5, 0.1], [-0.2, 0.1, 0.4]]) * 1e-6
    c = bd.Model(body, law(nu), RHO).interaction.by_user
    G, lame = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
    stress = 2 * G * strain + lame * np.trace(strain) * np.eye(3)
    gap = body.facets.span[:, None] * (c.normal @ strain)
    force = c.area[:, None] * (c.normal @ stress)
    spring = NonLocalStrain(body, c, gap, np.zeros_like(gap)).spring
    here = NonLocalStrain(body, c, gap, force - spring)
    six = stress[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    np.testing.assert_allclose(here.stress, np.tile(six, (150, 1)), rtol=0, atol=1e-9 * np.abs(six).max())
    np.testing.assert_allclose(here.lagged().force, force, rtol=0, atol=1e-9 * np.abs(force).max())


def test_lever_on_the_line_of_centres_is_exact_on_average_only(body: bd.Lattice):
    strain = np.diag([1e-6, -0.5e-6, 0.2e-6])
    c = bd.Model(body, law(0.0, lever="contact"), RHO).interaction.by_user
    force = c.area[:, None] * (c.normal @ strain) * E
    found = NonLocalStrain(body, c, np.zeros_like(force), force).stress[:, :3] / (E * np.diag(strain))
    assert np.average(found, axis=0, weights=c.volume) == pytest.approx(np.ones(3), abs=0.03)
    assert 0.02 < np.abs(found - 1.0).mean() < 0.2


def test_advice_on_stress_free_strains_can_be_followed(body: bd.Lattice):
    with pytest.raises(InputError, match="Eigenstrain needs stored rest lengths; NonLocal has none"):
        bd.Model(body, bd.NonLocal(E=E, nu=0.2), density=RHO, boundary=[bd.Eigenstrain(1e-4)])
    with pytest.raises(InputError, match="eigenstrain needs stored rest lengths; NonLocal has none"):
        bd.Model(body, bd.NonLocal(E=E, nu=0.2), density=RHO).state().set_eigenstrain(1e-4)


def test_path_leaves_no_trace(body: bd.Lattice):
    """The stress at the end does not know in how many steps the strain was applied, nor whether rounds were mixed."""
    slip = strained(body, np.diag([1.0, 0.0, 0.0]))
    rest = np.zeros((150, 6))
    bond = law(lever="contact", limited=False)
    one, many = (statics(body, bond).settle(rest, slip=slip, steps=k) for k in (1, 25))
    assert np.vdot(slip, many.strain.force) == pytest.approx(np.vdot(slip, one.strain.force), rel=1e-4)
    np.testing.assert_allclose(many.strain.stress, one.strain.stress, rtol=0, atol=2e-3 * E)
    # what no spring holds goes on: rotations without the limiter
    assert np.abs(many.motion[:, 3:] - one.motion[:, 3:]).max() > 0.1 * np.abs(one.motion[:, 3:]).max()


def test_limiter_keeps_extra_shear_within_the_stress(spheres: bd.Lattice):
    c = bd.Model(spheres, law(areas="weighted"), RHO).interaction.by_user
    generator = np.random.default_rng(0)
    gap = generator.standard_normal((len(spheres.pairs), 3))
    for limited in (True, False):
        now = NonLocalStrain(spheres, replace(c, limited=limited), gap, np.zeros_like(gap))
        stress = now.stress[spheres.pairs].mean(axis=1)
        s = stress[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3)
        t = c.area[:, None] * np.einsum("mab,mb->ma", s, c.normal)
        t -= (t * c.normal).sum(axis=1)[:, None] * c.normal
        e = now.lagged().extra
        e = e - (e * c.normal).sum(axis=1)[:, None] * c.normal
        over = np.linalg.norm(e, axis=1) / np.linalg.norm(t, axis=1)
        assert (over.max() <= 1.0 + 1e-12) == limited


def moving(lattice: bd.Lattice, bond: bd.NonLocal, speed: float = 1e-2) -> bd.State:
    state = bd.State(bd.Model(lattice, bond, RHO))
    velocity = np.random.default_rng(0).standard_normal((150, 3))
    state.set_motion(velocity=speed * (velocity - velocity.mean(axis=0)))
    return state


def run(state: bd.State, share: float, steps: int, **more):
    model = state.model
    dt = share * 2.0 / highest_frequency(model)
    return integrate(model, bd.Plan(duration=steps * dt, dt=dt, every=more.pop("every", 20), **more), state=state)


def test_ledger_closes_with_the_non_local_work(body: bd.Lattice):
    """What extra forces take up is an entry of its own, and what the ledger misses falls with the step."""
    missed = []
    for share, steps in ((0.1, 200), (0.05, 400)):
        ledger = run(moving(body, law()), share, steps).history.energy
        missed.append(np.abs(ledger["balance"]).max() / ledger["translation"][0])
        assert np.abs(ledger["non-local work"]).max() > 20.0 * np.abs(ledger["balance"]).max()
    assert missed[1] < 2e-3
    assert missed[1] < 0.8 * missed[0]


def test_a_spinning_body_is_warned_of_without_damping_and_stable_with_it():
    """Each end of a run that became unstable gives one warning."""
    model = bd.Model(cells(bd.Box((10e-3, 10e-3, 10e-3)), 300), bd.NonLocal(E=30e9, nu=0.2), 2500.0)
    state = model.state()
    state.set_velocity(bd.Everything(), (0.0, 0.0, 0.0), spin=(0.0, 30.0, 0.0))
    with pytest.warns(StepWarning, match="give damping="), pytest.warns(UnstableRunWarning) as caught:
        assert bd.solve_explicit(model, duration=1e-3, state=state).status is bd.Status.UNSTABLE
    assert [one.category for one in caught] == [StepWarning, UnstableRunWarning]
    damped = bd.solve_explicit(model, duration=1e-3, state=state, damping=bd.BondDamping(0.1))
    assert damped.status is bd.Status.COMPLETED


def test_forces_of_an_unchanged_state_change_nothing(body: bd.Lattice):
    state = run(moving(body, law()), 0.2, 50).state
    again = state.copy()
    again.stale = True
    integrate(again.model, bd.Plan(duration=0.0, dt=1e-6, every=0), state=again)
    largest = np.abs(state.acceleration).max()
    np.testing.assert_allclose(again.acceleration, state.acceleration, rtol=0, atol=1e-9 * largest)
    np.testing.assert_allclose(again.stress, state.stress, rtol=0, atol=1e-9 * np.abs(state.stress).max())
    np.testing.assert_array_equal(again.history[6], state.history[6])


def test_two_halves_are_the_whole_to_the_bit(spheres: bd.Lattice, tmp_path):
    """Gaps, extra forces and stresses are state, also in a run file."""
    bond = law(areas="weighted")
    model = bd.Model(spheres, bond, RHO)
    start = moving(spheres, bond)
    dt = 0.2 / highest_frequency(model)
    more = {"dt": dt, "every": 10, "damping": bd.LocalDamping(0.3), "state": start}
    whole = bd.solve_explicit(model, duration=60 * dt, **more)
    path = tmp_path / "run.h5"
    plan = bd.Plan(duration=60 * dt, dt=dt, every=10, damping=bd.LocalDamping(0.3))
    half = integrate(model, replace(plan, duration=30 * dt), state=start.copy())
    RunFile(path, model, plan).checkpoint(half.state, half.history)
    resumed = bd.resume(path)
    for name in ("pose", "motion", "history", "stress"):
        np.testing.assert_array_equal(getattr(resumed.state, name), getattr(whole.state, name))


def test_turning_as_a_rigid_body_changes_no_force(body: bd.Lattice):
    """Stresses and gaps stand in the frames of the elements."""
    free = cells(bd.Box((1.0, 1.0, 1.0)), 80, spread=0.2)
    model = bd.Model(free, law(), RHO)
    state = model.state()
    state.set_motion(velocity=np.random.default_rng(1).standard_normal((80, 3)))
    state = run(state, 0.2, 40).state
    dt = 0.4 / highest_frequency(model)
    q = np.array([np.cos(0.6), 0.0, np.sin(0.6) * 0.6, np.sin(0.6) * 0.8])
    w, v = q[0], q[1:]

    def turned(a: np.ndarray) -> np.ndarray:
        return a + 2.0 * np.cross(v, np.cross(v, a) + w * a)

    other = state.copy()
    p = state.pose[:, 4:]
    other.pose[:, :3] = turned(state.pose[:, :3])
    other.pose[:, 4] = w * p[:, 0] - p[:, 1:] @ v
    other.pose[:, 5:] = w * p[:, 1:] + p[:, :1] * v + np.cross(v, p[:, 1:])
    for columns in (slice(0, 3), slice(4, 7)):
        other.motion[:, columns] = turned(state.motion[:, columns])
    results = []
    for one in (state, other):
        one.stale, one.step = True, 0
        results.append(integrate(model, bd.Plan(duration=5 * dt, dt=dt, every=0), state=one).state)
    here, there = results
    size = np.abs(here.stress).max()
    np.testing.assert_allclose(there.stress, here.stress, rtol=0, atol=1e-8 * size)
    np.testing.assert_allclose(
        there.acceleration[:, :3], turned(here.acceleration[:, :3]), rtol=0, atol=1e-8 * abs(here.acceleration).max()
    )


def test_lag_feeds_motions_the_more_the_larger_nu(body: bd.Lattice):
    """With local damping of 0.3, half the critical step of the springs: calm at 0.2, divergence at 0.45."""
    left = {}
    for nu in (0.0, 0.2, 0.45):
        result = run(moving(body, law(nu), 1e-6), 0.5, 800, damping=bd.LocalDamping(0.3), every=0)
        left[nu] = result.status, float((result.state.velocity**2).sum())
    assert left[0.0][0] is left[0.2][0] is bd.Status.COMPLETED
    assert left[0.2][1] < 1e-20
    assert left[0.45][0] is bd.Status.UNSTABLE


def test_step_is_found_by_the_lagged_operator(body: bd.Lattice):
    """ω_max of the springs is no bound: at 0.9 of their critical step motions grow even at ν = 0."""
    model = bd.Model(body, law(0.0), RHO)
    critical = 2.0 / highest_frequency(model)
    terms = DampingTerms.of(bd.LocalDamping(0.3))
    assert growth(model, model.interaction, 0.95 * critical, terms) > 10.0
    assert growth(model, model.interaction, 0.3 * critical, terms) < 0.1
    chosen = bd.solve_explicit(model, duration=0.0, damping=bd.LocalDamping(0.3))
    assert chosen.dt <= 0.45 * critical
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        bd.solve_explicit(bd.Model(body, law(0.49), RHO), duration=0.0)
    assert any("lagged stress" in str(one.message) for one in caught)


def test_weighted_areas_of_a_cubic_lattice_close_cubes():
    """Six neighbours: the polyhedron is the cube about the sphere, and V = Σ A l / 3 its volume."""
    lattice = grid((4, 4, 4), 1.0, periodic=True)
    np.testing.assert_allclose(weighted_areas(lattice), 1.0, rtol=1e-12)
    found = bd.Model(lattice, law(areas="weighted"), RHO).interaction.by_user
    np.testing.assert_allclose(found.volume, 1.0, rtol=1e-12)
    np.testing.assert_allclose(found.kn, E, rtol=1e-12)


def test_authors_construction_is_near_but_not_exact(spheres: bd.Lattice):
    """The paper prints 38 of 40 GPa."""
    found = bd.bulk_moduli(spheres, law(areas="weighted"))
    assert 0.75 * E < found.E < 1.1 * E
    assert abs(found.E / E - 1.0) > 0.01


def test_free_bar_in_tension():
    bar = cells(bd.Box((3.0, 1.0, 1.0)), 300, spread=0.25)
    found = bd.labtests.static_tension(bar, law())
    assert abs(found.E / E - 1.0) < 0.02
    assert found.nu == pytest.approx(0.2, abs=0.01)


@pytest.mark.parametrize(
    ("make", "word"),
    [
        (lambda: bd.NonLocal(E=-1.0, nu=0.2), "E"),
        (lambda: bd.NonLocal(E=E, nu=0.5), "nu"),
        (lambda: bd.NonLocal(E=E, nu=-0.1), "nu"),
        (lambda: bd.NonLocal(E=E, nu=0.2, lever="middle"), "lever"),
        (lambda: bd.NonLocal(E=E, nu=0.2, areas="equal"), "areas"),
        (lambda: bd.NonLocal(E=E, nu=0.2, limited=1), "limited"),
    ],
)
def test_bad_values_are_refused(make, word: str):
    with pytest.raises(InputError, match=word):
        make()


def test_what_it_cannot_do_is_refused(body: bd.Lattice, spheres: bd.Lattice):
    with pytest.raises(InputError, match="laguerre"):
        bd.Model(spheres, law(), RHO)
    with pytest.raises(InputError, match="weighted"):
        bd.Model(body, law(areas="weighted"), RHO)
    with pytest.raises(InputError, match="whole model"):
        bd.Model(body, {bd.Everything(): law()}, RHO)
    model = bd.Model(body, law(), RHO)
    with pytest.raises(InputError, match="modes"):
        bd.solve_modes(model)
    with pytest.raises(InputError, match="nonlinear"):
        bd.solve_static(model, nonlinear=True)
    with pytest.raises(InputError, match="potential"):
        bd.solve_relaxed(model)
