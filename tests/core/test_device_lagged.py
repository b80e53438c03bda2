"""Bonds that store something from step to step, on a device: against the passes of the CPU, pauses, resumed runs."""

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from bondem.model.state import State
from tests.bits import assert_same_bits, assert_same_state
from tests.device_runs import deviation
from tests.device_sides import (
    assert_pauses_change_no_bit,
    carried_out,
    continued_on_the_other_side,
    on_both_sides,
    on_device,
)
from tests.lagged_runs import CASES

# Cases of contact are fast and soft, so that much happens in few steps.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


@pytest.mark.parametrize("case", CASES)
def test_a_device_has_the_bits_of_the_cpu(case: str) -> None:
    cpu, device = on_both_sides(CASES[case]())
    assert_same_bits(cpu, device)
    assert deviation(cpu, device) < 1e-12  # records as well
    assert np.abs(device.state.history).max() > 0.0
    assert ("contact" in case) == (len(device.state.touching) + len(device.state.wall_touching) > 3)
    assert ("break" in case) == (len(device.state.broken) > 10)


@pytest.mark.parametrize("case", [
    pytest.param(case, marks=pytest.mark.validate) if "break" in case else case for case in CASES
])  # fmt: skip
def test_pausing_changes_no_bit(case: str) -> None:
    assert_pauses_change_no_bit(CASES[case](), half=51)


@pytest.mark.parametrize("case", CASES)
def test_a_run_resumes_on_the_other_side(case: str) -> None:
    this = CASES[case]()
    cpu = carried_out(this, CoreLoop)
    for _, whole in continued_on_the_other_side(this, this[2] // 2):
        assert_same_bits(cpu, whole)


@pytest.mark.parametrize("case", CASES)
def test_forces_of_an_unchanged_state_are_found_again(case: str) -> None:
    """To the bit, in a step of no time; dashpots of contacts have no part in it."""
    model, start, _, dt, options = CASES[case]()
    plan = Plan(duration=40 * dt, dt=dt, **{**options, "damping": None})
    state = integrate(model, plan, state=start(model), loop_of=on_device).state
    cpu, device = state.copy(), state.copy()
    for again, loop in ((cpu, CoreLoop), (device, on_device)):
        again.stale = True
        loop(model, plan, again, dt).record_present()
    assert_same_state(cpu, device)
    if "contact" not in case:
        for array in ("history", "stress", "acceleration"):
            np.testing.assert_array_equal(getattr(device, array), getattr(state, array), err_msg=array)


def test_few_bonds_store_as_many() -> None:
    """Where there are fewer bonds than a group of lanes, the state has a copy of its own."""
    lattice = bd.connect(bd.Particles(np.array([[0.0, 0.0, 0.0], [0.9, 0.2, 0.1]]), np.array([0.4, 0.5])), reach=2.0)
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6, formulation="incremental")
    model = bd.Model(lattice, law, density=1e3)
    plan = Plan(duration=40e-4, dt=1e-4)
    results = []
    for loop in (CoreLoop, on_device):
        state = State(model)
        state.set_motion(velocity=np.array([[0.1, 0.2, 0.0], [0.0, -0.1, 0.3]]))
        results.append(integrate(model, plan, state=state, loop_of=loop))
    assert np.abs(results[0].state.history).max() > 0.0
    assert_same_bits(*results)
