"""Every pass of a device that is left out changes a run, so that the comparisons with the CPU would show it."""

import faulthandler
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cache, partial

import numpy as np
import pytest

import bondem as bd
from bondem._core import pass_tables
from bondem._device import Enqueue, Host
from bondem._passes import Kernel
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.plan import ExplicitResult, Plan
from bondem.errors import ContactWarning
from tests.core.test_stress_onset_on_device import OF_EACH, ONSET
from tests.device_cases import Case, cell, moving, pressed_bar
from tests.device_cracks import CASES as CRACKING
from tests.device_runs import CASES as RUNS
from tests.device_runs import deviation
from tests.device_sides import carried_out, loop_on, on_device
from tests.device_yielding import CASES as YIELDING

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")
_ALL = {f"{kind} {name}": make for kind, cases in (("run", RUNS), ("crack", CRACKING), ("yield", YIELDING))
        for name, make in cases.items()}  # fmt: skip
# Passes that other tests hold: criteria that no case has, the guard, and how long a list of contacts holds.
_ELSEWHERE = {*OF_EACH["mean stress"], *OF_EACH["function"], "check_portion", "check_portion_of_facets",
              "check_travel_of_wall", "measure_overlaps"}  # fmt: skip
# Smallest deviation that counts, and cases tried for a pass at most.
_SEEN, _TRIED = 1e-10, 14


def without(name: str) -> type[Host]:
    """A device that leaves a pass out."""

    class Lacking(Host):
        def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
            return super().prepared(one, 0 if one.name == name else count, tables, halted)

    return Lacking


@cache
def launched() -> dict[str, tuple[ExplicitResult, frozenset[str]]]:
    """Each case by a device, and the passes that it has launched, the shortest runs first."""
    found = {}
    for case, make in _ALL.items():
        names = set[str]()

        class Noting(Host):
            def prepared(
                self, one: Kernel, count: int, tables: Sequence[int], halted: int, names: set[str] = names
            ) -> Enqueue:
                names.add(one.name)
                return super().prepared(one, count, tables, halted)

        found[case] = carried_out(make(), loop_on(Noting)), frozenset(names)
    return dict(sorted(found.items(), key=lambda one: one[1][0].state.step * one[1][0].state.pose.size))


def resumed(case: Case, device: type[Host], stretch: float) -> ExplicitResult:
    """The second half of a run, whose first half is that of the CPU, from places that are moved apart by a share."""
    model, _, steps, dt, options = case
    half = carried_out(case, CoreLoop, steps // 2).state.copy()
    if stretch != 0.0:
        half.set_pose(position=(1.0 + stretch) * half.position)
    return integrate(model, Plan(duration=steps * dt, dt=dt, **options), state=half, loop_of=loop_on(device))


def pairs_of(name: str) -> Iterator[tuple[Callable[[], ExplicitResult], ...]]:
    """Runs with and without a pass: from the start, resumed, and resumed from a state that has been changed."""
    cases = [case for case, (_, names) in launched().items() if name in names][:_TRIED]
    lacking = without(name)
    for case in cases:
        whole = launched()[case][0]
        yield partial(lambda found: found, whole), partial(carried_out, _ALL[case](), loop_on(lacking))
    for stretch in (0.0, 1e-5):
        for case in cases:
            yield tuple(partial(resumed, _ALL[case](), device, stretch) for device in (Host, lacking))


def is_seen(name: str) -> bool:
    """Whether a run without a pass is another one, or none at all."""
    for whole, lacking in pairs_of(name):
        found = np.inf
        with suppress(Exception):
            found = deviation(whole(), lacking())
        if found > _SEEN:
            return True
    return False


@pytest.mark.validate
@pytest.mark.parametrize("name", sorted(set(pass_tables("kernels")) - _ELSEWHERE))
def test_a_run_without_a_pass_is_another_one(name: str) -> None:
    """In a process of its own, as tables that a pass should have filled may have any numbers."""
    launched()
    child = os.fork()
    if child == 0:
        faulthandler.disable()
        os._exit(0 if is_seen(name) else 3)
    _, ended = os.waitpid(child, 0)
    assert not (os.WIFEXITED(ended) and os.WEXITSTATUS(ended) == 3)


def test_these_are_all_passes() -> None:
    assert set(pass_tables("kernels")) >= _ELSEWHERE
    assert OF_EACH["mean stress"] | OF_EACH["function"] <= ONSET


@pytest.mark.parametrize("name", ["check_portion", "check_portion_of_facets"])
def test_the_guard_of_rotations_ends_a_wild_run(name: str) -> None:
    model = cell() if name == "check_portion" else pressed_bar()
    plan = Plan(duration=12 * 2e-3, dt=2e-3, every=0)
    whole, lacking = (
        integrate(model, plan, state=moving(model, speed=300.0), loop_of=loop_on(one))
        for one in (Host, without(name))
    )
    assert whole.status.name == "UNSTABLE"
    assert whole.message != lacking.message


def struck() -> Case:
    """Two spheres at rest, and a fast wall that reaches them from further away than a list of contacts does."""
    lattice = bd.Lattice(bd.Particles([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]], [0.5, 0.5]), np.zeros((0, 2), dtype=int))
    law = bd.Timoshenko(E=1e7, nu=0.2, radius=0.2)
    wall = bd.PlaneWall((0.0, 0.0, -4.0), (0.0, 0.0, 1.0), motion=bd.Driven(vz=20.0))
    model = bd.Model(lattice, law, 1000.0, contact=bd.LinearContact(E=1e7), walls=[wall])
    return model, bd.Model.state, 250, 1e-3, {"every": 0}


def test_a_wall_that_moves_renews_the_list_of_contacts() -> None:
    cpu, device = carried_out(struck(), CoreLoop), carried_out(struck(), on_device)
    assert deviation(cpu, device) < 1e-12
    assert cpu.state.velocity[0, 2] > 1.0
    assert deviation(device, carried_out(struck(), loop_on(without("check_travel_of_wall")))) > _SEEN


@pytest.mark.filterwarnings("default::UserWarning")
def test_deep_overlaps_are_warned_about() -> None:
    model, start, _, dt, options = struck()
    deep = bd.Model(model.lattice, model.bond, 1000.0, contact=bd.LinearContact(E=1e5), walls=model.walls)
    case = deep, start, 250, dt, options
    for loop in (CoreLoop, on_device):
        with pytest.warns(ContactWarning, match="overlaps by"):
            carried_out(case, loop)
