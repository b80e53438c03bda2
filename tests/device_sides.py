"""The same run by the CPU and by a device that the CPU simulates, with pauses, and continued on the other side."""

from collections.abc import Callable

import bondem as bd
from bondem._device import Host
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import ExplicitResult, Plan
from bondem.model.state import State
from tests.bits import assert_same_bits
from tests.device_cases import Case

LoopOf = Callable[[bd.Model, Plan, State, float], DeviceLoop | CoreLoop]


def loop_on(device: type[Host]) -> LoopOf:
    """The loop of a run on a device of a kind."""

    def loop(model: bd.Model, plan: Plan, state: State, dt: float) -> DeviceLoop:
        return DeviceLoop(model, plan, state, dt, device())

    return loop


on_device = loop_on(Host)


def carried_out(case: Case, loop_of: LoopOf, steps: int | None = None) -> ExplicitResult:
    """A case by one side, all its steps or so many."""
    model, start, whole, dt, options = case
    plan = Plan(duration=(steps or whole) * dt, dt=dt, **options)
    return integrate(model, plan, state=start(model), loop_of=loop_of)


def on_both_sides(case: Case) -> tuple[ExplicitResult, ExplicitResult]:
    """A case by the CPU, and by the device."""
    return carried_out(case, CoreLoop), carried_out(case, on_device)


def assert_pauses_change_no_bit(case: Case, half: int) -> None:
    """Assert that a run with pauses, and one resumed after some steps, have the bits of a run without."""
    model, start, steps, dt, options = case
    plain = model, start, steps, dt, {**options, "every": 0}
    whole, begun = carried_out(plain, on_device), carried_out(plain, on_device, half)
    parted = carried_out((model, start, steps, dt, {**plain[-1], "save_every": 17}), on_device)
    resumed = integrate(model, Plan(duration=steps * dt, dt=dt, **plain[-1]), state=begun.state, loop_of=on_device)
    for other in (parted, resumed):
        assert_same_bits(whole, other)


def continued_on_the_other_side(case: Case, half: int) -> list[tuple[ExplicitResult, ExplicitResult]]:
    """What has begun after some steps, and the whole run: from the CPU to the device, and back."""
    model, _, steps, dt, options = case
    whole, found = Plan(duration=steps * dt, dt=dt, **options), []
    for first, second in ((CoreLoop, on_device), (on_device, CoreLoop)):
        begun = carried_out(case, first, half)
        history, state = begun.history, begun.state.copy()
        found.append((begun, integrate(model, whole, state=state, history=history, loop_of=second)))
    return found
