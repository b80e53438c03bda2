"""Beams that soften on a device: passes over an index against the passes of the CPU, pauses, and contact."""

import numpy as np
import pytest

from bondem._tables.columns import EventColumn, HistoryColumn, SoftColumn
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import Plan
from tests.bits import assert_same_bits
from tests.device_runs import CASES
from tests.device_sides import (
    assert_pauses_change_no_bit,
    carried_out,
    continued_on_the_other_side,
    on_both_sides,
    on_device,
)

SOFTENING = [name for name in CASES if "soften" in name]
# Cases of contact are fast and soft, so that much happens in few steps.
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


@pytest.mark.parametrize("case", SOFTENING)
def test_a_device_softens_with_the_bits_of_the_cpu(case: str) -> None:
    assert_same_bits(*on_both_sides(CASES[case]()))


@pytest.mark.parametrize("case", SOFTENING)
def test_beams_begin_soften_and_part_in_these_runs(case: str) -> None:
    """Some are pressed that are partly or wholly broken, so that leaving out what presses would be seen."""
    this = CASES[case]()
    model, done = this[0], carried_out(this, on_device)
    integrity, softened = done.state.integrity, done.state.softened
    partly = (integrity > 0.0) & (integrity < 1.0)
    assert partly.sum() > 10
    assert (integrity == 0.0).sum() == len(done.state.broken) >= 5
    assert (softened[:, SoftColumn.LAST] > softened[:, SoftColumn.FIRST]).all()
    unloaded = softened[:, SoftColumn.RATE] < softened[:, SoftColumn.FIRST] ** 2
    assert partly[softened[unloaded, SoftColumn.BOND].astype(int)].any()
    steps = done.state.broken[:, EventColumn.STEP]
    assert len(np.unique(steps)) > 3
    if "alike" not in case:  # which is periodic
        d = done.state.pose[model.layout.j, :3] - done.state.pose[model.layout.i, :3]
        assert ((np.linalg.norm(d, axis=1) < model.bonds.length) & (integrity < 1.0)).any()


def test_contact_carries_pressure_where_beams_have_broken() -> None:
    done = carried_out(CASES["beams soften, Hertzian"](), on_device)
    assert (done.state.broken[:, EventColumn.GAP] < 0.0).sum() > 10
    assert len(done.state.touching) > 10
    assert np.abs(done.history.records[:, HistoryColumn.CONTACT]).max() > 0.0


def test_the_ledger_closes_through_softening() -> None:
    records = carried_out(CASES["softening, alike"](), on_device).history.records
    total = records[:, HistoryColumn.TRANSLATION:HistoryColumn.WORK].sum(axis=1) + records[:, HistoryColumn.RELEASED]
    assert records[-1, HistoryColumn.RELEASED] > 0.1 * total[0]
    assert abs(total[-1] - total[0]) < 0.02 * total[0]


@pytest.mark.parametrize("case", ["softening, peripheral", "beams soften, Hertzian"])
def test_pausing_changes_no_bit(case: str) -> None:
    assert_pauses_change_no_bit(CASES[case](), half=21)


@pytest.mark.parametrize("case", ["softening, peripheral", "beams soften, Hertzian"])
def test_a_run_resumes_on_the_other_side(case: str) -> None:
    """From the CPU to the device and back, while beams soften."""
    this = CASES[case]()
    cpu = carried_out(this, CoreLoop)
    for begun, whole in continued_on_the_other_side(this, this[2] // 4):
        assert 0 < len(begun.state.softened) < len(cpu.state.softened)
        assert_same_bits(cpu, whole)


def test_a_state_with_new_velocities_softens_as_on_the_cpu() -> None:
    """Forces are found again in a step of no time, in which no beam loses integrity."""
    this = model, _, steps, dt, options = CASES["softening, peripheral"]()
    half = carried_out(this, on_device, 30).state
    half.set_motion(velocity=half.velocity[::-1].copy())
    results = [
        integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=half.copy(), loop_of=loop)
        for loop in (CoreLoop, on_device)
    ]
    assert_same_bits(*results)
