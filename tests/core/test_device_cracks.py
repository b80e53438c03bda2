"""Cracks on a device: passes over an index, which the CPU carries out one by one, against the passes of the CPU."""

import numpy as np
import pytest

from bondem._tables.columns import CrackStatus, HistoryColumn
from bondem.damage.crack_columns import STATUS
from bondem.dynamics.core_loop import CoreLoop
from bondem.interactions.contact.contact_columns import BETWEEN, KIND
from tests.device_cracks import CASES
from tests.device_runs import deviation
from tests.device_sides import (
    assert_pauses_change_no_bit,
    carried_out,
    continued_on_the_other_side,
    on_both_sides,
)
from tests.recording import Record

#: Cases in which cracks open so wide that they rest.
RESTS = "brittle", "driven together and touching", "sliding on a joint"

pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")


@pytest.mark.parametrize("case", CASES)
def test_a_device_agrees_with_the_cpu(case: str, record: Record) -> None:
    cpu, device = on_both_sides(CASES[case]())
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
    assert CrackStatus.ACTIVE in one.cracks[:, STATUS]
    assert (case in RESTS) == (CrackStatus.RESTING in one.cracks[:, STATUS])
    assert cpu.history.records[-1, HistoryColumn.RELEASED] > 0.0


def test_these_runs_have_all_that_happens_to_cracks() -> None:
    """Cracks break and part, and contact begins between parted faces: some press, some lie between cells."""
    cases = "brittle", "driven together and touching", "sliding on a joint"
    cpu = [carried_out(CASES[case](), CoreLoop) for case in cases]
    assert len(cpu[0].state.broken) > 10
    assert (cpu[1].state.cracks[:, STATUS] == CrackStatus.PARTED).sum() >= 3
    kind = cpu[2].state.stretch[:, KIND]
    assert (kind > 0.0).sum() > 10
    assert (kind == BETWEEN).any()


@pytest.mark.parametrize("case", CASES)
def test_pausing_changes_no_bit(case: str) -> None:
    this = CASES[case]()
    assert_pauses_change_no_bit(this, half=this[2] // 2)


def test_a_run_continues_on_the_other_side() -> None:
    this = CASES["held and pulled"]()
    cpu = carried_out(this, CoreLoop)
    for begun, whole in continued_on_the_other_side(this, 60):
        assert 0 < len(begun.state.cracks) < len(cpu.state.cracks)
        assert deviation(cpu, whole) < 1e-12
        np.testing.assert_array_equal(whole.state.cracks[:, :2], cpu.state.cracks[:, :2])
