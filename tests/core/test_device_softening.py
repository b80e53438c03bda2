"""Beams that soften on a device: passes over an index against the passes of the CPU, pauses, and contact."""

import numpy as np
import pytest

import bondem as bd
from bondem._device import Host
from bondem.model.event_columns import BROKEN_GAP, BROKEN_STEP, FIRST, LAST, SOFT_BOND, SOFT_RATE
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.history import CONTACT, FRACTURE, TRANSLATION, WORK
from bondem.solve.loop_core import CoreLoop
from bondem.solve.loop_device import DeviceLoop, device_has
from bondem.solve.plan import ExplicitResult, Plan
from tests.bits import assert_same_bits
from tests.device_runs import CASES

SOFTENING = [name for name in CASES if "soften" in name]
# Cases of contact are fast and soft, so that much happens in few steps.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


def on_device(model: bd.Model, plan: Plan, state: State, dt: float) -> DeviceLoop:
    assert device_has(model)
    return DeviceLoop(model, plan, state, dt, Host())


def device_run(case: str) -> tuple[bd.Model, ExplicitResult]:
    model, start, steps, dt, options = CASES[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    return model, integrate(model, plan, state=start(model), loop_of=on_device)


@pytest.mark.parametrize("case", SOFTENING)
def test_a_device_softens_with_the_bits_of_the_cpu(case: str) -> None:
    model, start, steps, dt, options = CASES[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    cpu, device = (integrate(model, plan, state=start(model), loop_of=loop) for loop in (CoreLoop, on_device))
    assert_same_bits(cpu, device)


@pytest.mark.parametrize("case", SOFTENING)
def test_beams_begin_soften_and_part_in_these_runs(case: str) -> None:
    """Some are pressed that are partly or wholly broken, so that leaving out what presses would be seen."""
    model, done = device_run(case)
    integrity, softened = done.state.integrity, done.state.softened
    partly = (integrity > 0.0) & (integrity < 1.0)
    assert partly.sum() > 10
    assert (integrity == 0.0).sum() == len(done.state.broken) >= 5
    assert (softened[:, LAST] > softened[:, FIRST]).all()
    unloaded = softened[:, SOFT_RATE] < softened[:, FIRST] ** 2
    assert partly[softened[unloaded, SOFT_BOND].astype(int)].any()
    steps = done.state.broken[:, BROKEN_STEP]
    assert len(np.unique(steps)) > 3
    if "alike" not in case:  # which is periodic
        d = done.state.pose[model.layout.j, :3] - done.state.pose[model.layout.i, :3]
        assert ((np.linalg.norm(d, axis=1) < model.bonds.length) & (integrity < 1.0)).any()


def test_contact_carries_pressure_where_beams_have_broken() -> None:
    _, done = device_run("beams soften, Hertzian")
    assert (done.state.broken[:, BROKEN_GAP] < 0.0).sum() > 10
    assert len(done.state.touching) > 10
    assert np.abs(done.history.records[:, CONTACT]).max() > 0.0


def test_the_ledger_closes_through_softening() -> None:
    records = device_run("softening, alike")[1].history.records
    total = records[:, TRANSLATION:WORK].sum(axis=1) + records[:, FRACTURE]
    assert records[-1, FRACTURE] > 0.1 * total[0]
    assert abs(total[-1] - total[0]) < 0.02 * total[0]


@pytest.mark.parametrize("case", ["softening, peripheral", "beams soften, Hertzian"])
def test_pausing_changes_no_bit(case: str) -> None:
    model, start, steps, dt, options = CASES[case]()
    options["every"] = 0
    plans = [Plan(duration=steps * dt, dt=dt, save_every=interval, **options) for interval in (0, 17)]
    whole, parted = (integrate(model, plan, state=start(model), loop_of=on_device) for plan in plans)
    half = integrate(model, Plan(duration=21 * dt, dt=dt, **options), state=start(model), loop_of=on_device).state
    resumed = integrate(model, plans[0], state=half, loop_of=on_device)
    for other in (parted, resumed):
        assert_same_bits(whole, other)


@pytest.mark.parametrize("case", ["softening, peripheral", "beams soften, Hertzian"])
def test_a_run_resumes_on_the_other_side(case: str) -> None:
    """From the CPU to the device and back, while beams soften."""
    model, start, steps, dt, options = CASES[case]()
    whole = Plan(duration=steps * dt, dt=dt, **options)
    half = Plan(duration=steps // 2 * dt, dt=dt, **options)
    cpu = integrate(model, whole, state=start(model), loop_of=CoreLoop)
    for first, second in ((CoreLoop, on_device), (on_device, CoreLoop)):
        begun = integrate(model, half, state=start(model), loop_of=first)
        assert 0 < len(begun.state.softened) < len(cpu.state.softened)
        assert_same_bits(cpu, integrate(model, whole, state=begun.state, history=begun.history, loop_of=second))


def test_a_state_with_new_velocities_softens_as_on_the_cpu() -> None:
    """Forces are found again in a step of no time, in which no beam loses integrity."""
    model, start, steps, dt, options = CASES["softening, peripheral"]()
    half = integrate(model, Plan(duration=30 * dt, dt=dt, **options), state=start(model), loop_of=on_device).state
    half.set_motion(velocity=half.velocity[::-1].copy())
    results = [
        integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=half.copy(), loop_of=loop)
        for loop in (CoreLoop, on_device)
    ]
    assert_same_bits(*results)
