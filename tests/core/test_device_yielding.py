"""Cells that yield, material planes, and cracks under strains that change, on a device: against the CPU."""

from collections.abc import Sequence
from unittest.mock import Mock

import numpy as np
import pytest

import bondem as bd
from bondem import _core
from bondem._device import Enqueue, Host
from bondem._passes import Kernel
from bondem._tables.columns import CrackStatus, HistoryColumn
from bondem.damage.crack_columns import FACET, STATUS
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.on_device.breakage_counterparts import resuming
from bondem.dynamics.on_device.counterparts import COUNTERPARTS
from bondem.dynamics.plan import Plan
from tests.bits import assert_same_bits, assert_same_fracture, assert_same_run
from tests.core.test_device import Backwards
from tests.device_runs import deviation
from tests.device_sides import (
    LoopOf,
    assert_pauses_change_no_bit,
    carried_out,
    continued_on_the_other_side,
    loop_on,
    on_both_sides,
    on_device,
)
from tests.device_yielding import CASES
from tests.recording import Record

pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")

#: Passes of a device of which a run would not be that of the CPU, each with a case that shows it.
TEETH = {
    "find_cell_stress": "crushed", "judge_cell": "crushed", "yield_cell": "crushed",
    "stretch_growing_cell": "crushed", "stretch_crack_of_cells": "crushed", "sum_portion_of_heat": "crushed",
    "sum_portion_of_crushing": "crushed and touching",
    "add_surface_stress": "crushed between walls", "stretch_wall_of_cell": "crushed between walls",
    "add_yielding_work_of_row": "crushed between walls",
    "mark_plane": "planes", "begin_marked_crack": "planes",
    "follow_lever": "warming and cracking", "add_crack_power": "warming and cracking",
    "follow_cell_factors": "warming and cracking",
    "stretch_facet_of_step": "warming and cracking", "stretch_wall_of_step": "warming and cracking",
    "keep_base_levers": "warming and crushed", "stretch_cell_anew": "warming and crushed",
    "stretch_wall_anew": "warming and crushed",
}  # fmt: skip
#: Those that matter where a run resumes, and where forces of the present are found without a step.
TEETH_OF_RESUMED = {
    "stretch_yielded_cell": "crushed", "find_still_stress": "crushed between walls",
    "add_still_surface_stress": "crushed between walls", "begin_crack_power": "warming and cracking",
}  # fmt: skip


def without(name: str) -> type[Host]:
    """A device that leaves a pass out."""

    class Lacking(Host):
        def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
            return super().prepared(one, 0 if one.name == name else count, tables, halted)

    return Lacking


def test_all_passes_of_the_cpu_have_counterparts() -> None:
    """A device runs whatever the CPU runs."""
    of_postponed = resuming((Mock(), Mock()))
    assert set(_core._library().step_passes) - set(COUNTERPARTS) - set(of_postponed) == set()


@pytest.mark.parametrize("case", CASES)
def test_a_device_agrees_with_the_cpu(case: str, record: Record) -> None:
    cpu, device = on_both_sides(CASES[case]())
    one, other = cpu.state, device.state
    record("simulated yielding", deviation(cpu, device))
    assert deviation(cpu, device) < 1e-12
    assert_same_fracture(one, other)
    np.testing.assert_array_equal(other.facet_force, one.facet_force)
    np.testing.assert_allclose(other.released, one.released, rtol=1e-12)
    assert len(one.cracks) > 20
    assert ("crushed" in case) == (cpu.history.records[-1, HistoryColumn.PLASTIC] > 0.0)


def test_these_runs_have_all_that_happens() -> None:
    """Cells yield at walls and lose all cohesion, faces part and touch, planes open and shear."""
    done = {case: carried_out(make(), CoreLoop).state for case, make in CASES.items()}
    for case, state in done.items():
        if "crushed" in case:
            assert (state.plastic[:, 9] > 0.0).sum() > 50
    touching, (slip,) = done["crushed and touching"], CASES["crushed and touching"]()[0].yielding
    assert (touching.plastic[:, 9] * slip.fade >= 1.0).sum() >= 3
    assert (touching.cracks[:, STATUS] == CrackStatus.PARTED).sum() >= 3
    for case in ("planes", "planes that shear"):
        state, softening = done[case], CASES[case]()[0].softening
        assert softening is not None
        assert softening.plane[state.cracks[:, FACET].astype(int)].sum() > 20
        assert len(state.broken) > 10


@pytest.mark.parametrize("case", [
    case if case == "crushed and touching" else pytest.param(case, marks=pytest.mark.validate) for case in CASES
])  # fmt: skip
def test_pausing_changes_no_bit(case: str) -> None:
    this = CASES[case]()
    assert_pauses_change_no_bit(this, half=this[2] // 2)


@pytest.mark.parametrize("case", ["crushed and touching", "planes that shear", "warming and crushed"])
def test_the_order_of_indices_changes_no_bit(case: str) -> None:
    this = CASES[case]()
    assert_same_run(carried_out(this, on_device), carried_out(this, loop_on(Backwards)))


@pytest.mark.parametrize("case", ["crushed between walls", "planes that shear", "warming and crushed"])
def test_a_run_continues_on_the_other_side(case: str) -> None:
    this = CASES[case]()
    cpu = carried_out(this, CoreLoop)
    for begun, whole in continued_on_the_other_side(this, this[2] // 2):
        assert 0.0 < begun.state.released[0] < cpu.state.released[0]
        assert deviation(cpu, whole) < 1e-12
        assert_same_fracture(cpu.state, whole.state)


def resumed(case: str, loop_of: LoopOf, stretch: float = 0.0) -> bd.ExplicitResult:
    """The second half of a run, from a state whose elements have been moved apart by a share of their places."""
    model, _, steps, dt, options = this = CASES[case]()
    half = carried_out(this, CoreLoop, steps // 2).state.copy()
    if stretch != 0.0:
        half.set_pose(position=(1.0 + stretch) * half.position)
    plan = Plan(duration=steps * dt, dt=dt, **options)
    return integrate(model, plan, state=half, loop_of=loop_of)


@pytest.mark.parametrize("case", ["crushed", "crushed between walls", "warming and cracking", "warming and crushed"])
def test_a_state_that_has_been_changed_continues_as_on_the_cpu(case: str) -> None:
    """Forces and stresses are found again in a step of no time, in which no cell yields."""
    cpu, device = (resumed(case, loop, 1e-5) for loop in (CoreLoop, on_device))
    assert deviation(cpu, device) < 1e-12
    assert_same_fracture(cpu.state, device.state)


@pytest.mark.filterwarnings("ignore::bondem.errors.ImbalanceWarning")
@pytest.mark.parametrize("name", [
    name if name in ("judge_cell", "add_crack_power") else pytest.param(name, marks=pytest.mark.validate)
    for name in TEETH
])  # fmt: skip
def test_a_run_without_a_pass_is_another_one(name: str) -> None:
    this = CASES[TEETH[name]]()
    assert deviation(carried_out(this, on_device), carried_out(this, loop_on(without(name)))) > 1e-10


@pytest.mark.filterwarnings("ignore::bondem.errors.ImbalanceWarning")
@pytest.mark.parametrize("name", TEETH_OF_RESUMED)
def test_a_resumed_run_without_a_pass_is_another_one(name: str) -> None:
    case, stretch = TEETH_OF_RESUMED[name], 1e-5 if "still" in name else 0.0
    whole, lacking = (resumed(case, loop, stretch) for loop in (on_device, loop_on(without(name))))
    assert deviation(whole, lacking) > 1e-10


def test_a_second_run_of_a_model_has_the_bits_of_the_first():
    case = CASES["crushed"]()
    assert_same_bits(carried_out(case, CoreLoop, 60), carried_out(case, CoreLoop, 60))
