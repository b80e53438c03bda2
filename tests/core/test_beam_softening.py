"""Beams that soften by the core: the energy of fracture, pressure, and bits."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import SoftColumn
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.dynamics.timestep import critical_step
from bondem.model.model import Model
from bondem.model.state import State
from tests.bits import assert_same_bits
from tests.core.test_steps import HELD, LAWS, crooked, moving_state, plan_of

TOUGH = {
    "Timoshenko": bd.PeripheralStress(tension=1e5, shear=2e5, fracture_energy=2e3),
    "Euler–Bernoulli": bd.MohrCoulomb(
        tension=1e5, cohesion=1e5, friction_angle=0.5, fracture_energy=5e3, fracture_energy_shear=1e4
    ),
}


def softening(law: str, shape: tuple[int, int, int] = (6, 4, 4)) -> Model:
    return bd.Model(crooked(shape), LAWS[law], density=1e3, boundary=HELD, failure=TOUGH[law])


@pytest.mark.parametrize("law", TOUGH)
@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_threads_and_pauses_change_no_bit(monkeypatch, law):
    model = softening(law, (12, 10, 10))
    results = []
    for count, every in ((1, 50), (2, 50), (3, 7), (4, 0)):
        monkeypatch.setattr(core_loop, "current_threads", lambda count=count: count)
        plan = plan_of(model, 120, every=every)
        results.append(integrate(model, plan, state=moving_state(model), loop_of=CoreLoop))
    assert len(results[0].state.broken) > 0
    assert len(results[0].state.softened) > 100
    for other in results[1:]:
        assert_same_bits(results[0], other)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_a_run_goes_on_from_its_state():
    model = softening("Timoshenko")
    whole = integrate(model, plan_of(model, 300), state=moving_state(model), loop_of=CoreLoop)
    part = integrate(model, plan_of(model, 140), state=moving_state(model), loop_of=CoreLoop)
    assert 0 < len(part.state.softened) < len(whole.state.softened)
    plan = plan_of(model, 300)
    assert plan.dt is not None
    CoreLoop(model, plan, part.state, plan.dt).run(160)
    np.testing.assert_array_equal(part.state.pose, whole.state.pose)
    np.testing.assert_array_equal(part.state.softened, whole.state.softened)
    assert part.state.released[0] == whole.state.released[0]


def pair_of(**failure) -> tuple[Model, float]:
    """Two elements with one beam, and its section [m²]."""
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.full(2, 0.5)), reach=2.0)
    law = bd.Timoshenko(E=1e7, nu=0.2, radius=0.2)
    return bd.Model(lattice, law, density=1e3, failure=bd.PeripheralStress(**failure)), math.pi * 0.2**2


def plan_of_pair(model: Model) -> Plan:
    dt = 0.001 * critical_step(model, bd.VelocityVerlet())
    return Plan(duration=5000 * dt, dt=dt, gauges={})


@pytest.mark.parametrize(("direction", "energy"), [("x", 800.0), ("twist", 2.4e3)])
@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")
def test_a_beam_dissipates_its_fracture_energy(direction, energy):
    """G_f A where it is pulled, and G_II A where it is twisted, whatever the step."""
    model, section = pair_of(tension=8e4, shear=8e4, fracture_energy=800.0, fracture_energy_shear=2.4e3)
    state = State(model)
    velocity = np.array([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    if direction == "x":
        state.set_motion(velocity=velocity)
    else:
        state.set_motion(angular_velocity=8.0 * velocity)
    run = integrate(model, plan_of_pair(model), state=state, loop_of=CoreLoop)
    assert run.state.integrity.tolist() == [0.0]
    assert run.state.released[0] == pytest.approx(energy * section, rel=1e-2)
    assert run.state.softened[0, SoftColumn.SPENT] == run.state.released[0] == run.state.broken[0, 5]
    assert run.state.softened[0, SoftColumn.BOND] == 0.0


def test_a_softened_beam_carries_pressure_as_a_whole_one():
    """A beam that has lost most of its integrity has the force and energy of the whole one when it is pressed."""
    model, _ = pair_of(tension=8e4, shear=8e4, fracture_energy=800.0)
    kn = float(model.bonds.kn[0])
    state = State(model)
    state.integrity[0] = 0.3
    state.softened = np.array([[0.0, 10.0, 20.0, 0.0, 0.0, 1.0, 0.0]])
    state.pose[1, 0] -= 0.01
    state.stale = True
    plan = plan_of_pair(model)
    assert plan.dt is not None
    record = CoreLoop(model, plan, state, plan.dt).record_present()[0]
    force = state.acceleration[:, 0] / state.motion[:, 3]
    np.testing.assert_allclose(force, [-0.01 * kn, 0.01 * kn], rtol=1e-10)
    assert record[3] == pytest.approx(0.5 * kn * 0.01**2, rel=1e-10)


def test_contact_carries_the_pressure_on_a_beam_from_the_step_in_which_it_breaks():
    """A beam that is pressed and twisted loses its integrity in one step: the force on its ends does not jump."""
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), np.full(2, 0.5)), reach=2.0)
    failure = bd.PeripheralStress(tension=8e4, shear=8e4, fracture_energy=800.0)
    law = bd.Timoshenko(E=1e7, nu=0.2, radius=0.2)
    model = bd.Model(lattice, law, density=1e3, failure=failure, contact=bd.LinearContact(E=1e7))
    kn, state, turn = float(model.bonds.kn[0]), State(model), 0.02
    state.integrity[0] = 0.3
    state.softened = np.array([[0.0, 1e-6, 2e-6, 0.0, 0.0, 2.0, 0.0]])
    state.pose[1, 0] -= 0.01
    state.pose[1, 4:6] = np.cos(turn / 2), np.sin(turn / 2)  # a twist, so that -∂U/∂s is not zero
    state.stale = True
    plan = plan_of_pair(model)
    assert plan.dt is not None
    loop = CoreLoop(model, plan, state, plan.dt)
    before = loop.record_present()[0]
    force = state.acceleration[:, 0] / state.motion[:, 3]
    np.testing.assert_allclose(force, [-0.01 * kn, 0.01 * kn], rtol=1e-3)
    loop.run(1)
    assert state.integrity[0] == 0.0
    assert len(state.broken) == 1
    np.testing.assert_allclose(state.acceleration[:, 0] / state.motion[:, 3], force, rtol=1e-3)
    after = loop.record_present()[0]
    assert after[3] == 0.0
    assert after[7] == pytest.approx(before[3], rel=1e-3)  # of contact, and of normal force before
    assert state.released[0] > 0.0
