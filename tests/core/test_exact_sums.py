"""Sums without rounding: those of `math.fsum`, in any order, on any threads, in any blocks and on a device."""

import re
from fractions import Fraction
from math import fsum, inf, nan

import numpy as np
import pytest

import bondem as bd
from bondem._cache_lines import exact_sums
from bondem._core import run_pass
from bondem._core_steps import Composer
from bondem._device import Host
from bondem._passes import calls, steps
from bondem._tables.columns import HistoryColumn, WallSum
from bondem._tables.contact_tables import WallContacts, WallMotions, Walls
from bondem._tables.step_tables import (
    BeamEnergies,
    Beams,
    HistoryRows,
    Ledger,
    Moving,
    Poses,
    Rows,
    StepBlocks,
    StepPasses,
    StepScheme,
    StepSpan,
)
from bondem.boundary.wall_rows import no_rows, wall_rows
from bondem.dynamics import core_loop
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.device_loop import DeviceLoop
from bondem.dynamics.parts.shared_tables import new_ledger
from bondem.dynamics.plan import Plan
from bondem.interactions.step_part import Passes
from tests.core.tables import SOURCE
from tests.core.test_device import Backwards
from tests.core.test_steps import LAWS, crooked
from tests.device_cracks import CASES as CRACKING
from tests.device_runs import CASES
from tests.device_sides import carried_out as carried
from tests.device_yielding import CASES as YIELDING

LARGEST = float(np.finfo(float).max)
LEAST, HALF = 5e-324, 2.0**970  # and half of the last digit of the largest


def wide(rng: np.random.Generator, count: int) -> np.ndarray:
    """Return doubles of all exponents: random bits, without those that are not finite."""
    bits = rng.integers(0, 2**64, count, dtype=np.uint64, endpoint=False)
    terms = bits.view(float)
    return np.where(np.isfinite(terms), terms, 1.0) * 2.0**-14  # sums stay below the largest


def cancelling(rng: np.random.Generator, count: int) -> np.ndarray:
    """Return large terms that cancel to small ones, shuffled."""
    large = np.ldexp(rng.uniform(-1.0, 1.0, count // 2), rng.integers(-900, 900, count // 2))
    return rng.permutation(np.concatenate([large, -large, np.ldexp(rng.uniform(-1.0, 1.0, 3), -950)]))


def ties(rng: np.random.Generator, count: int) -> np.ndarray:
    """Return terms whose sum lies half way between two doubles, or next to there."""
    whole = np.ldexp(1.0, int(rng.integers(-900, 900)))
    half, odd = whole * 2.0**-53, whole * 2.0**-52 * float(rng.integers(0, 2))
    beside = float(rng.integers(-1, 2)) * whole * 2.0**-120
    return np.concatenate([[whole, odd, half, beside], np.zeros(count)]) * rng.choice([-1.0, 1.0])


def small(rng: np.random.Generator, count: int) -> np.ndarray:
    """Return numbers below the normal ones, and some next to them."""
    return np.concatenate([rng.integers(-(2**53), 2**53, count) * LEAST, [np.finfo(float).tiny, -LEAST]])


KINDS = {one.__name__: one for one in (wide, cancelling, ties, small)}


def carried_out(record: Passes, ledger: Ledger, n: int = 0, m: int = 0, threads: int = 1) -> None:
    """Carry out the passes of a record, on tables of n elements and m bonds."""
    composer, none, short = Composer(), np.zeros(1, dtype=np.int64), np.zeros(0, dtype=np.uint32)
    blocks = StepBlocks(
        domain=none, bond=none, move=none, first_owner=none[:0], ready=short, ready_row=short, row_i=short,
        row_j=short, shared=short, shared_row=short, shared_first_owner=0, part=none, parts=1, sums=np.zeros((0, 8)),
    )  # fmt: skip
    lists = StepPasses(*[composer([])] * len(StepPasses._fields))._replace(record=composer(record))
    span = StepSpan(0, 0, 0, True, False, True, n, m, np.zeros(4, dtype=np.int64))
    run_pass(calls.take_steps(lists, blocks, StepScheme(*[0.0] * 6), span, ledger), threads=threads)


def summed(terms: np.ndarray, threads: int = 1, ledger: Ledger | None = None) -> float:
    """Return the sum of terms as a record has it, in portions of elements on some threads."""
    n, ledger = len(terms), new_ledger() if ledger is None else ledger
    loss = np.zeros((n, 3))
    loss[:, 0] = terms
    moving = Moving(np.zeros((n, 8)), np.ones((n, 8)), np.zeros((n, 6)), loss, np.zeros((n, 3)))
    history = HistoryRows(np.zeros((1, HistoryColumn.COUNT)))
    rows = rows_of(np.zeros(0), n)
    passes = [steps.sum_element_energies(moving, ledger), steps.write_ledger(rows, ledger, history)]
    carried_out(passes, ledger, n, threads=threads)
    assert not ledger.sums.any()
    return float(history.record[0, HistoryColumn.LOSS])


def rows_of(work: np.ndarray, n: int = 0) -> Rows:
    """Return no rows, and a list of works."""
    none = np.zeros((0, 6))
    return Rows(np.full(n, -1), none.astype(np.uint8), none, none, none, none, none, work)


def same_bits(a: float, b: float) -> bool:
    """Return whether two numbers have the same bits, or neither is a number."""
    return np.float64(a).tobytes() == np.float64(b).tobytes() or bool(np.isnan(a) and np.isnan(b))


# ---- one sum


@pytest.mark.parametrize("kind", KINDS)
def test_a_sum_is_that_of_fsum_in_any_order_and_on_any_threads(kind: str) -> None:
    for seed in range(40):
        rng = np.random.default_rng(seed)
        terms = KINDS[kind](rng, int(rng.integers(1, 3500)))
        expected = fsum(terms) + 0.0  # a sum of zeros has no sign
        for threads in (1, 2, 3):
            assert same_bits(summed(rng.permutation(terms), threads), expected), (seed, threads)


def test_plain_sums_are_others() -> None:
    """The terms of these tests have sums that are rounded differently in another order."""
    for kind in ("wide", "cancelling"):
        terms = KINDS[kind](np.random.default_rng(0), 3000)
        assert {float(np.add.accumulate(one)[-1]) for one in (terms, terms[::-1], np.sort(terms))} - {fsum(terms)}


def test_only_the_sum_may_be_beyond_the_largest_number() -> None:
    for terms in ([LARGEST, LARGEST, -LARGEST], [LARGEST, HALF, -1.0], [-LARGEST, -HALF, LEAST],
                  [-LARGEST, -LARGEST, LARGEST, LEAST], [LARGEST] * 2000 + [-LARGEST] * 1999):  # fmt: skip
        whole = sum(map(Fraction, terms))
        assert same_bits(summed(np.array(terms)), float(whole)), terms
    assert summed(np.array([LARGEST, LARGEST])) == inf
    assert summed(np.array([-LARGEST, -HALF])) == -inf  # a tie, to the even number
    assert summed(np.array([LARGEST] * 3000)) == inf


@pytest.mark.parametrize(
    ("terms", "expected"),
    [([inf, 1.0], inf), ([-inf, LARGEST], -inf), ([inf, -inf], nan), ([nan, 1.0], nan), ([nan, inf], nan),
     ([inf, inf], inf), ([], 0.0), ([-0.0], 0.0), ([LEAST], LEAST), ([-LEAST, -LEAST], -1e-323)],
)  # fmt: skip
def test_terms_that_are_not_finite_and_the_least_are_seen(terms: list[float], expected: float) -> None:
    far = np.concatenate([terms, np.zeros(1500), terms[:1]]) if len(terms) > 1 else np.array(terms)
    for threads in (1, 2):
        assert same_bits(summed(far if not np.isfinite(expected) else np.array(terms), threads), expected)


def test_a_sum_that_is_read_is_empty() -> None:
    ledger = new_ledger()
    for terms in ([inf], [nan], [1e300, 1.0, -1e300], [-3.5]):
        assert same_bits(summed(np.array(terms), ledger=ledger), fsum(terms))


def test_works_add_to_the_sums_of_the_ledger() -> None:
    terms = cancelling(np.random.default_rng(1), 400)
    history, ledger = HistoryRows(np.zeros((1, HistoryColumn.COUNT))), new_ledger()
    carried_out([steps.write_ledger(rows_of(terms), ledger, history)], ledger)
    assert history.record[0, HistoryColumn.WORK] == fsum(terms)


# ---- walls


def test_forces_of_walls_are_exact_sums_of_those_of_contacts() -> None:
    rng, count, walls = np.random.default_rng(3), 300, 4
    f, i, rows3 = np.zeros(0), np.zeros(0, dtype=np.int64), np.zeros((0, 3))
    still = WallMotions(f, f, i, i, i, i, i.astype(np.uint8), rows3, i, i, f, f, f, i, f, rows3, rows3)
    still = still._replace(start=np.zeros(1, dtype=np.int64))
    table = Walls(*(no_rows(name, walls) for name in ("WallShape", "WallRow", "WallInertia", "WallListed")))
    wall, load = rng.integers(0, walls, count), wide(rng, 7 * count).reshape(count, 7)
    for order in (np.arange(count), rng.permutation(count)):
        short = np.zeros(count, dtype=np.uint32)
        contacts = WallContacts(
            np.zeros(1, dtype=np.int64), short, wall[order].astype(np.uint32), np.zeros(count), np.zeros((count, 6)),
            short.astype(np.uint8), load[order].copy(), exact_sums(WallSum.COUNT * walls),
        )  # fmt: skip
        carried_out([steps.load_walls(contacts, still, table)], new_ledger())
        rows = wall_rows(table.body)
        for w in range(walls):
            found = [*rows["force"][w], rows["normal_force"][w], *rows["torque"][w]]
            assert found == [fsum(column) for column in load[wall == w].T]
        assert not contacts.sums.any()


# ---- runs

ALL = {**CASES, **CRACKING, **YIELDING}
BUSY = ["dissipative and brittle", "pressed brittle cells", "warming brittle cells", "spheres and walls that turn",
        "softening, dashpots", "non-local, bonds break, contact", "stored, contact", "driven together and touching",
        "crushed between walls", "warming and cracking", "warming"]  # fmt: skip


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("case", ALL)
def test_a_device_records_the_bits_of_the_cpu_whichever_element_is_first(case: str) -> None:
    model, start, _, dt, options = ALL[case]()
    plan = Plan(duration=dt, dt=dt, **options)
    cpu = CoreLoop(model, plan, start(model), dt).record_present()
    for device in (Host, Backwards):
        np.testing.assert_array_equal(DeviceLoop(model, plan, start(model), dt, device()).record_present(), cpu)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("case", BUSY)
def test_energies_have_the_same_bits_on_any_threads_and_in_any_blocks(
    case: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    records = []
    monkeypatch.setattr(core_loop, "SERIAL_BONDS", 0)
    monkeypatch.setattr(core_loop, "_DOMAIN", 8)
    for threads, block in ((1, 4000), (2, 4000), (3, 4000), (1, 7), (3, 16)):
        monkeypatch.setattr(core_loop, "current_threads", lambda threads=threads: threads)
        monkeypatch.setattr(core_loop, "BLOCK", block)
        records.append(carried(ALL[case](), CoreLoop).history.records)
    for other in records[1:]:
        np.testing.assert_array_equal(records[0], other)


def test_the_work_of_each_row_is_its_own_and_the_record_is_their_exact_sum() -> None:
    for case in ("held cells", "pressed cells"):
        run = carried(ALL[case](), CoreLoop)
        work, rows = run.state.work, len(run.state.reaction)
        assert np.count_nonzero(work[:rows]) > 10
        assert run.history.records[-1, HistoryColumn.WORK] == fsum(work)


def test_energies_of_beams_are_the_exact_sums_of_those_of_single_beams() -> None:
    model, dt = bd.Model(crooked((7, 6, 6)), LAWS["Timoshenko"], density=1e3), 1e-5
    state, rng = model.state(), np.random.default_rng(2)
    state.pose[:, :3] += rng.uniform(-0.01, 0.01, state.pose[:, :3].shape)
    state.pose[:, 4:] += rng.uniform(-0.01, 0.01, state.pose[:, 4:].shape)
    state.pose[:, 4:] /= np.linalg.norm(state.pose[:, 4:], axis=1, keepdims=True)
    loop = CoreLoop(model, Plan(duration=dt, dt=dt), state, dt)
    record = loop.record_present()[0, HistoryColumn.NORMAL : HistoryColumn.TWISTING + 1]
    entries = [one for part in loop._parts for one in part.record(HistoryRows(np.zeros((1, loop._width))))]
    moving, beams, _ = next(tables for name, tables in entries if name == "sum_beam_energies")
    single = np.zeros((len(model.layout.i), 4))
    for k, energy in enumerate(single):
        one = Beams(*(values[k : k + 1] for values in beams[:-1]), beams.period)
        run_pass(calls.measure_beam_energies(Poses(moving.pose), one, BeamEnergies(energy)))
    assert record.tolist() == [fsum(mode) for mode in single.T]
    assert (record != np.add.accumulate(single)[-1]).all()  # in the order of the beams


def test_passes_that_add_to_the_energy_balance_have_no_plain_sum() -> None:
    texts = [path.read_text().split("BONDEM_PASS") for path in (SOURCE / "core/passes").rglob("*.cpp")]
    passes = [part.rpartition("\nvoid ")[2] for text in texts for part in text if "Ledger &ledger) {" in part]
    plain = re.compile(r"double (\w+)\S* = (?:0\.0|\{\}).*?\b\1\S* [-+]= ", re.DOTALL)
    assert len(passes) > 20
    assert not [one.split("(")[0] for one in passes if plain.search(one)]
    assert plain.search("double sum[4] = {};\n for (;;) sum[c] += a;")
