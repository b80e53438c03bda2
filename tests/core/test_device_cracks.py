"""Cracks on a device: passes over an index, which the CPU carries out one by one, against the passes of the CPU."""

import numpy as np
import pytest

import bondem as bd
from bondem._device import Host
from bondem.model.crack_columns import ACTIVE, PARTED, RESTING, STATUS
from bondem.model.state import State
from bondem.solve.explicit import integrate
from bondem.solve.history import FRACTURE
from bondem.solve.loop_core import CoreLoop
from bondem.solve.loop_device import DeviceLoop, device_has
from bondem.solve.plan import ExplicitResult, Plan
from tests.bits import assert_same_bits
from tests.device_cracks import CASES
from tests.device_runs import deviation
from tests.recording import Record

pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


def on_device(model: bd.Model, plan: Plan, state: State, dt: float) -> DeviceLoop:
    assert device_has(model)
    return DeviceLoop(model, plan, state, dt, Host())


def outcomes(case: str) -> tuple[ExplicitResult, ExplicitResult]:
    """A run by the CPU, and by the device."""
    model, start, steps, dt, options = CASES[case]()
    plan = Plan(duration=steps * dt, dt=dt, **options)
    cpu, device = (integrate(model, plan, state=start(model), loop_of=loop) for loop in (CoreLoop, on_device))
    return cpu, device


@pytest.mark.parametrize("case", CASES)
def test_a_device_agrees_with_the_cpu(case: str, record: Record) -> None:
    cpu, device = outcomes(case)
    one, other = cpu.state, device.state
    record("simulated cracks", deviation(cpu, device))
    assert deviation(cpu, device) < 1e-12
    np.testing.assert_array_equal(other.cracks[:, :2], one.cracks[:, :2])
    np.testing.assert_allclose(other.cracks, one.cracks, rtol=1e-10)
    for name in ("facet_force", "plastic", "grips"):
        size = np.abs(getattr(one, name)).max(initial=1e-300)
        np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=0.0, atol=1e-12 * size)
    np.testing.assert_allclose(other.released, one.released, rtol=1e-12)
    assert len(one.cracks) > 20
    assert {ACTIVE, RESTING} <= set(one.cracks[:, STATUS])
    assert cpu.history.records[-1, FRACTURE] > 0.0


def test_these_runs_have_all_that_happens_to_cracks() -> None:
    """Cracks break and part, and contact begins between parted faces."""
    cpu = [integrate_by_cpu(case) for case in ("brittle", "driven together and touching")]
    assert len(cpu[0].state.broken) > 10
    assert (cpu[1].state.cracks[:, STATUS] == PARTED).sum() >= 3


def integrate_by_cpu(case: str) -> ExplicitResult:
    model, start, steps, dt, options = CASES[case]()
    return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=start(model), loop_of=CoreLoop)


@pytest.mark.parametrize("case", CASES)
def test_pausing_changes_no_bit(case: str) -> None:
    model, start, steps, dt, options = CASES[case]()
    options["every"] = 0
    plans = [Plan(duration=steps * dt, dt=dt, save_every=interval, **options) for interval in (0, 17)]
    whole, parted = (integrate(model, plan, state=start(model), loop_of=on_device) for plan in plans)
    half = integrate(model, Plan(duration=steps // 2 * dt, dt=dt, **options), state=start(model), loop_of=on_device)
    resumed = integrate(model, plans[0], state=half.state, loop_of=on_device)
    for other in (parted, resumed):
        assert_same_bits(whole, other)


@pytest.mark.parametrize("loops", [(CoreLoop, on_device), (on_device, CoreLoop)], ids=["to device", "to CPU"])
def test_a_run_continues_on_the_other_side(loops: tuple) -> None:
    model, start, steps, dt, options = CASES["held and pulled"]()
    whole, half = (Plan(duration=count * dt, dt=dt, **options) for count in (steps, 60))
    cpu = integrate(model, whole, state=start(model), loop_of=CoreLoop)
    begun = integrate(model, half, state=start(model), loop_of=loops[0])
    assert 0 < len(begun.state.cracks) < len(cpu.state.cracks)
    found = integrate(model, whole, state=begun.state, history=begun.history, loop_of=loops[1])
    assert deviation(cpu, found) < 1e-12
    np.testing.assert_array_equal(found.state.cracks[:, :2], cpu.state.cracks[:, :2])
