"""Chen et al. (2022): the unbonded component of the parallel bond, and damping component by component."""

import math

import numpy as np
import pytest

import bondem as bd
from tests.specimens import row, two_spheres
from validation.measures import chen_one_sided
from validation.studies import chen_damping, chen_unbonded

E, NU, R, F = 200e9, 0.3, 0.2, 1e3
G = E / (2.0 * (1.0 + NU))
A, I = math.pi * R**2, math.pi * R**4 / 4.0
BOND = bd.ParallelBond(E=E, nu=NU, radius=R)
pytestmark = pytest.mark.usefixtures("one_thread")


def tip(ks: float, count: int) -> float:
    """Two chains of springs in the middle of the bonds: F Σ (1/ks + (L - c)²/kb), by virtual work."""
    l = 2.0 * R
    arms = l * (count - 0.5 - np.arange(count))
    return F * (count / ks + (arms**2).sum() * l / (E * I))


# ---- the unbonded component


def test_pressed_component_adds_its_springs_and_no_moment_where_spheres_touch() -> None:
    pressed = chen_unbonded.pressed(0.1, None)
    thin = bd.ParallelBond(E=E, nu=NU, radius=0.1)
    x = np.array([0.0, 0.4, 1.0, 1.6])  # touching; touching unequal; a gap
    particles = bd.Particles(np.column_stack([x, 0 * x, 0 * x]), [0.2, 0.2, 0.4, 0.1])
    lattice = bd.Lattice(particles, [(0, 1), (1, 2), (2, 3)])
    both, alone = (bd.Model(lattice, law, 1000.0).stiffness for law in (pressed, thin))
    k = np.array([E * math.pi * 0.2**2 / 0.4, E * math.pi * 0.2**2 / 0.6, 0.0])
    np.testing.assert_allclose(both.kn - alone.kn, k, rtol=1e-12)
    np.testing.assert_allclose(both.ks - alone.ks, k / (2.0 * (1.0 + NU)), rtol=1e-12)
    for name in ("kb", "kt", "lever", "radius"):
        np.testing.assert_array_equal(getattr(both, name), getattr(alone, name))


@pytest.mark.parametrize("count", [1, 2, 10])
def test_pressed_component_takes_half_of_the_shear_of_case_1_and_nothing_of_its_bending(count: int) -> None:
    # E* = E_b, κ* = κ and r_b = R: both components are as stiff
    unbonded, lattice = chen_unbonded, row(count + 1, 2.0 * R)
    found = [
        bd.solve_static(unbonded.cantilever(lattice, law, F)).displacement[-1, 1]
        for law in (BOND, unbonded.pressed(R, None))
    ]
    ks = G * A / (2.0 * R)
    assert found == pytest.approx([tip(ks, count), tip(2.0 * ks, count)], rel=1e-9)


def test_the_component_resists_a_push_and_not_a_pull() -> None:
    loop, unbonded = chen_one_sided, chen_unbonded
    kn = E * A / (2.0 * R)
    for push, stiffness in ((1e3, 2.0 * kn), (-1e3, kn)):
        run = loop.run_to_rest(row(2, 2.0 * R), BOND, load=1.0, push=push, contact=unbonded.CONTACT, gamma=0.5)
        assert run.status == "STOPPED"
        assert run.gap[0] == pytest.approx(-push / stiffness, rel=1e-5)
        assert run.pressed_at_rest == pytest.approx(max(0.0, 0.5 * push), rel=1e-5)


@pytest.mark.validate
def test_the_load_of_the_cases_opens_the_contact_and_a_push_closes_it() -> None:
    loop, unbonded, lattice = chen_one_sided, chen_unbonded, row(3, 2.0 * R)
    ks = G * A / (2.0 * R)
    alone, both = tip(ks, 2), tip(2.0 * ks, 2)
    assert both < 0.95 * alone

    def run(push: float, contact: bd.LinearContact | None):
        return loop.run_to_rest(lattice, BOND, load=F, push=push, contact=contact, gamma=0.5)

    across = run(0.0, unbonded.CONTACT)
    assert across.displacement[-1, 1] == pytest.approx(alone, rel=1e-5)
    assert (across.gap > 0.0).all()
    assert across.pressed_at_rest == 0.0
    assert run(0.0, None).displacement[-1, 1] == pytest.approx(alone, rel=1e-5)
    assert run(5.0 * F, unbonded.CONTACT).displacement[-1, 1] == pytest.approx(both, rel=1e-4)
    # without friction it resists across as little as it does when it is open
    slippery = bd.LinearContact(E=E, kappa=unbonded.KAPPA, friction=0.0)
    assert run(5.0 * F, slippery).displacement[-1, 1] == pytest.approx(alone, rel=1e-4)


def test_between_unequal_spheres_the_contact_has_the_lever_of_each() -> None:
    loop, unbonded = chen_one_sided, chen_unbonded
    position = np.outer([0.0, 0.5, 1.0], [1.0, 0.0, 0.0])
    lattice = bd.Lattice(bd.Particles(position, [0.2, 0.3, 0.2]), [(0, 1), (1, 2)])
    pressed = bd.solve_static(unbonded.cantilever(lattice, unbonded.pressed(0.2, None), F)).displacement[-1, 1]
    run = loop.run_to_rest(lattice, BOND, load=F, push=10.0 * F, contact=unbonded.CONTACT, gamma=0.5)
    assert run.status == "STOPPED"
    assert run.displacement[-1, 1] == pytest.approx(pressed, rel=1e-4)


def test_the_loop_is_that_of_solve_explicit() -> None:
    lattice = row(4, 2.0 * R)
    ours = chen_one_sided.run_to_rest(lattice, BOND, load=F, gamma=0.2)
    model = chen_unbonded.cantilever(lattice, BOND, F, ramp=0.1)
    run = bd.solve_explicit(model, duration=ours.time, damping=bd.LocalDamping(0.2))
    np.testing.assert_allclose(run.state.displacement, ours.displacement, atol=1e-5 * ours.displacement[-1, 1])


# ---- damping


@pytest.mark.filterwarnings("ignore:Timoshenko. E = :bondem.errors.UnitWarning")  # too weak to matter
def test_local_damping_acts_on_each_component_by_its_own_velocity() -> None:
    # force and velocity are not parallel: by vectors, γ |F| v/|v| would change z too, and share x and y otherwise
    gamma, dt = 0.3, 1e-9
    force, velocity = np.array([3.0, -4.0, 0.0]), np.array([1.0, 2.0, -5.0])
    load = bd.Load(bd.Index([1]), force=(3.0, -4.0, 0.0), moment=(0.0, 2.0, -1.0))
    moment, spin = np.array([0.0, 2.0, -1.0]), np.array([4.0, -1.0, -2.0])
    weak = bd.Timoshenko(E=1e-3, nu=0.25, radius_ratio=0.5)
    model = bd.Model(two_spheres(), weak, 1200.0, boundary=[bd.Fix(bd.Index([0])), load])
    state = model.state()
    state.set_motion(velocity=np.array([[0.0] * 3, velocity]), angular_velocity=np.array([[0.0] * 3, spin]))
    run = bd.solve_explicit(model, duration=100 * dt, dt=dt, damping=bd.LocalDamping(gamma), state=state)
    gained = (run.state.velocity[1] - velocity) * model.mass[1] / (100 * dt)
    turned = (run.state.angular_velocity[1] - spin) * model.inertia[1] / (100 * dt)
    np.testing.assert_allclose(gained, force - gamma * np.abs(force) * np.sign(velocity), atol=1e-3)
    np.testing.assert_allclose(turned, moment - gamma * np.abs(moment) * np.sign(spin), atol=1e-3)


@pytest.mark.parametrize(("reading", "rests"), [("component", True), ("vector", True), ("printed", False)])
def test_equation_11_damps_with_the_size_of_the_force_and_not_as_printed(reading: str, rests: bool) -> None:
    found = chen_one_sided.run_to_rest(row(3, 2.0 * R), BOND, load=F, gamma=0.3, reading=reading, duration=0.6)
    assert (found.status == "STOPPED") == rests


@pytest.mark.validate
def test_each_eta_damps_a_mode_by_its_share_of_the_energy() -> None:
    damping, loop, lattice = chen_damping, chen_one_sided, row(4, 2.0 * R)
    omega, share, lag = damping.shares("PBM", lattice)
    assert 0.05 < share[1] < share[2] < 0.95
    for component, eta in enumerate(0.1 * np.eye(4)[:3]):  # nothing twists in the plane
        rate = omega**2 * float((eta * lag * share).sum())
        early, late = (loop.run_to_rest(lattice, BOND, load=F, eta=eta, duration=end, slow=0.0) for end in (0.2, 0.7))
        found = math.log(early.speed / late.speed) / (late.time - early.time)
        # what the higher modes leave
        assert found == pytest.approx(rate, rel=0.05, abs=0.1), component
        assert (rate > 0.5) == (component in (1, 2))
