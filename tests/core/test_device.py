"""Steps on a device: passes over an index, which the CPU carries out one by one, against the passes of the CPU."""

from collections.abc import Callable, Sequence

import numpy as np
import pytest

import bondem as bd
from bondem._core import pass_tables
from bondem._device import DeviceTables, Enqueue, Host
from bondem._passes import Kernel
from bondem._tables.columns import EventColumn, HistoryColumn, TouchState
from bondem._tables.device_tables import BondsOfElements
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.explicit import integrate
from bondem.dynamics.parts.contact_part import ContactTables
from bondem.dynamics.plan import Plan
from bondem.interactions.cells.cell_tables import STRESS
from tests.bits import assert_same_bits, assert_same_fracture, assert_same_run
from tests.core.test_stress_onset_on_device import ONSET
from tests.device_cases import CRITERIA, CUBE_DT, CUBE_STEPS, NUS, cell, cubes, moving, pressed_bar
from tests.device_cracks import CASES as CRACKING
from tests.device_runs import CASES, deviation
from tests.device_sides import (
    assert_pauses_change_no_bit,
    carried_out,
    continued_on_the_other_side,
    loop_on,
    on_both_sides,
    on_device,
)
from tests.device_yielding import CASES as YIELDING
from tests.recording import Record

# Cases of contact are fast and soft, so that much happens in few steps.
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.TurnedPressureWarning"),
]
LAUNCHED: set[str] = set()


class Noting(Host):
    """The CPU as a device, which notes what it has been asked for."""

    def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        LAUNCHED.add(one.name)
        return super().prepared(one, count, tables, halted)


class Backwards(Host):
    """The CPU as a device that begins with the last index."""

    def prepared(self, one: Kernel, count: int, tables: Sequence[int], halted: int) -> Enqueue:
        return super().prepared(one, -count, tables, halted)


def test_the_deepest_overlap_on_a_device_is_that_of_all_pairs() -> None:
    """Threads with 32 elements each raise one number; the reference is computed from positions at each guard."""
    model, start, _, dt, options = CASES["beams, parallel"]()
    loop, expected = DeviceLoop(model, Plan(duration=1.0, dt=dt, **options), start(model), dt, Host()), 0.0
    for _ in range(4):
        loop.run(100)
        owners = [getattr(part.keep, "__self__", None) for part in loop._parts]
        (part,) = (owner for owner in owners if isinstance(owner, ContactTables))
        pairs, radius = part._pairs, part._law.radius
        centre, i, j = loop.state.pose[:, :3], pairs.first, pairs.second
        overlap = (pairs.reach - np.linalg.norm(centre[j] - centre[i], axis=1)) / np.minimum(radius[i], radius[j])
        expected = max(expected, overlap[pairs.touch == TouchState.TOUCHING].max(initial=0.0))
    assert len(radius) > 64
    assert part._deepest == pytest.approx(expected, rel=1e-12)
    assert expected > 1e-3


@pytest.mark.parametrize("case", CASES)
def test_a_device_agrees_with_the_cpu(case: str, record: Record) -> None:
    cpu, device = on_both_sides(CASES[case]())
    found = deviation(cpu, device)
    if not cpu.state.model.interaction.on_facets:
        record("simulated device", found)
    else:
        record("simulated cells", found)
    assert found < 1e-12
    fails = "brittle" in case or "break" in case or "soften" in case or case in CRITERIA
    assert fails == (len(cpu.state.broken) > 3)


def test_these_runs_have_all_that_acts_on_bodies() -> None:
    """Leaving a pass out would be seen, because what it does counts in these runs."""
    for case in ("held cells", "pressed cells"):
        cpu = carried_out(CASES[case](), CoreLoop)
        records, work = cpu.history.records, cpu.state.work
        assert np.abs(cpu.state.pose[:, STRESS]).max() > 1e3
        assert abs(records[-1, HistoryColumn.WORK]) > 0.1 * records[-1, 1 : HistoryColumn.WORK].sum()
        assert np.abs(work).max() > 0.1 * abs(records[-1, HistoryColumn.WORK])  # of walls and tractions, by row
        assert (np.abs(records[-1, HistoryColumn.COUNT:]).reshape(-1, 3) > 0.0).any(axis=1).all()
    for make in (*CASES.values(), *CRACKING.values(), *YIELDING.values()):
        model, start, _, dt, options = make()
        DeviceLoop(model, Plan(duration=dt, dt=dt, **options), start(model), dt, Noting()).record_present()
    assert set(pass_tables("kernels")) - ONSET == LAUNCHED - ONSET


@pytest.mark.parametrize(
    "case",
    ["bar", "held cells", "peripheral", "beams break, Hertzian", "brittle cells", "cells break and touch"],
)
def test_pausing_changes_no_bit(case: str) -> None:
    assert_pauses_change_no_bit(CASES[case](), half=11)


@pytest.mark.parametrize(
    "case",
    [
        "peripheral", "brittle cells", "cells break and touch", "spheres and walls", "warming cells",
        pytest.param("beams break, stressed", marks=pytest.mark.validate),
        pytest.param("non-local, bonds break, contact", marks=pytest.mark.validate),
    ],
)  # fmt: skip
def test_the_order_of_indices_changes_no_bit(case: str) -> None:
    """Threads of a device have no order."""
    this = CASES[case]()
    forth, back = carried_out(this, on_device), carried_out(this, loop_on(Backwards))
    assert_same_run(forth, back)


@pytest.mark.parametrize("case", ["peripheral", "brittle cells", "warming brittle cells"])
def test_a_run_continues_on_the_other_side(case: str) -> None:
    """From the CPU to the device and back, while bonds break."""
    this = CASES[case]()
    cpu = carried_out(this, CoreLoop)
    for begun, whole in continued_on_the_other_side(this, this[2] // 2):
        assert 0 < len(begun.state.broken) < len(cpu.state.broken)
        if case == "brittle cells":  # on a device the work of walls belongs to the rows of their cells
            assert_same_fracture(cpu.state, whole.state)
            assert deviation(cpu, whole) < 1e-14
        else:
            assert_same_bits(cpu, whole)


@pytest.mark.parametrize("case", ["alike and brittle", "free brittle cells"])
def test_breakage_is_spread_over_bonds_and_steps(case: str) -> None:
    """Several bonds break in one step, so that their order counts, and the ledger closes with what they release."""
    device = carried_out(CASES[case](), on_device)
    steps = device.state.broken[:, EventColumn.STEP]
    assert len(steps) - 5 >= len(np.unique(steps)) > 3
    assert (device.state.integrity > 0.0).any()
    records = device.history.records
    total = records[:, HistoryColumn.TRANSLATION:HistoryColumn.WORK].sum(axis=1) + records[:, HistoryColumn.RELEASED]
    assert records[-1, HistoryColumn.RELEASED] > 0.1 * total[0]
    assert abs(total[-1] - total[0]) < 0.02 * total[0]


@pytest.mark.parametrize("walls", [False, True], ids=["free", "between walls"])
@pytest.mark.parametrize("nu", NUS)
def test_two_cubes_move_as_one_oscillator(nu: float, walls: bool) -> None:
    """Free: U = ½ 2G δ² + 2 · ½ λ' (δ/2)², λ' of five free facets; between walls, of four: U = ½ (4G + λ') u² each.

    Between walls the spring between the dilatations stores ½ c (2 λ' u)² more, c = min(λ, 2 G) / 12 λ² for cubes.
    With ω² from it and cos φ = 1 - ω² dt²/2, velocity Verlet gives u = v dt sin(n φ) / sin φ exactly.
    """
    E, rho, v = 1e7, 1000.0, 1.0
    G, lame = E / (2.0 * (1.0 + nu)), E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
    # c = Σ A d / V over the free facets, each with A = 1 m² and d = ½ m
    relaxed = lame / (1.0 + (4 if walls else 5) * 0.5 * lame / (2.0 * G))
    spring = min(lame, 2.0 * G) / (12.0 * lame**2) if lame > 0.0 else 0.0
    held = 4.0 * G + relaxed + 2.0 * spring * relaxed**2
    square = (held if walls else 2.0 * (2.0 * G + 0.5 * relaxed)) / rho
    phi = np.arccos(1.0 - 0.5 * square * CUBE_DT**2)
    moved = v * CUBE_DT * np.sin(CUBE_STEPS * phi) / np.sin(phi)
    model, state = cubes(nu, walls=walls)
    plan = Plan(duration=CUBE_STEPS * CUBE_DT, dt=CUBE_DT, every=0)
    found = integrate(model, plan, state=state, loop_of=on_device).state.pose[:, 0] - [0.5, 1.5]
    expected = [moved, moved] if walls else [-moved, moved]
    # of a displacement of 7 mm a position of 1 m keeps 14 digits
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@pytest.mark.parametrize("make", [cell, lambda: pressed_bar()], ids=["beams", "cells"])
def test_a_wild_run_ends_as_on_the_cpu(make: Callable[[], bd.Model]) -> None:
    model = make()
    plan = Plan(duration=12 * 2e-3, dt=2e-3, every=3)
    cpu, device = (
        integrate(model, plan, state=moving(model, speed=300.0), loop_of=loop) for loop in (CoreLoop, on_device)
    )
    assert cpu.status.name == device.status.name == "UNSTABLE"
    assert cpu.message == device.message
    np.testing.assert_array_equal(cpu.state.pose, device.state.pose)  # the start is kept


# ---- tables of a device


def test_views_of_an_array_are_views_of_its_copy() -> None:
    tables = DeviceTables(Host())
    whole = np.arange(12.0)
    part = whole[4:10].reshape(3, 2)
    assert tables.address(part) - tables.address(whole) == 32
    whole[:] = 0.0
    tables.fetch(part)
    np.testing.assert_array_equal(whole, [0, 0, 0, 0, 4, 5, 6, 7, 8, 9, 0, 0])
    whole[:] = 7.0
    tables.send(part)
    whole[:] = 0.0
    tables.fetch(whole)
    np.testing.assert_array_equal(whole, [0, 1, 2, 3, 7, 7, 7, 7, 7, 7, 10, 11])
    assert (tables.address(whole) - whole.ctypes.data) % 128 == 0


def test_a_pass_over_an_index_of_other_tables_is_refused() -> None:
    tables, bonds = DeviceTables(Host()), BondsOfElements(*[np.zeros(0)] * 3)
    with pytest.raises(ImportError, match="BondsOfElements stands for Moving"):
        tables.prepared([(Kernel("load_beam", (bonds, bonds, bonds)), 1)])
