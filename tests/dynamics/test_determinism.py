"""The same bits whatever the number of threads, and wherever a run pauses."""

import math

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import BONDS_OF_PORTION
from bondem.dynamics.explicit import integrate
from bondem.dynamics.timestep import critical_step
from tests.bits import assert_same_bits, need_two_threads, threads
from tests.models import stirred, time_step
from tests.recording import Record
from tests.scripts import python
from tests.specimens import crooked_block

GAUGES = {
    "end": bd.Gauge(bd.Face("x_max", depth=0.5), "displacement"),
    "grip": bd.Gauge(bd.Face("x_min", depth=0.5), "force", "sum"),
    "fastest": bd.Gauge(bd.Everything(), "velocity", "max_abs"),
    "turned": bd.Gauge(bd.Everything(), "rotation"),
}
DAMPING = bd.LocalDamping(0.1)


def bar(shape: tuple[int, int, int], formulation: str = "total") -> bd.Model:
    """A crooked bar, held at one end, loaded by a ramp at the other and driven in the middle."""
    lattice, count = crooked_block(shape), math.prod(shape)
    law = bd.Timoshenko(E=1e7, nu=0.2, radius_ratio=0.6, formulation=formulation)
    boundary = [
        bd.Fix(bd.Face("x_min", depth=0.5)),
        bd.Drive(bd.Index([count // 2]), vy=bd.Ramp(0.0, 0.4, 0.05), rx=bd.Ramp(0.0, 0.1, 0.03)),
        bd.Load(bd.Face("x_max", depth=0.5), force=(3e4, -1e4, 2e4), schedule=bd.Ramp(0.0, 1.0, 0.02)),
    ]
    density = np.random.default_rng(1).uniform(900.0, 1100.0, count)
    return bd.Model(lattice, law, density=density, boundary=boundary)


def state_of(model: bd.Model) -> bd.State:
    return stirred(model, 0.3, seed=7)


def test_one_and_two_threads_agree_to_the_bit(record: Record) -> None:
    need_two_threads()
    model = bar((12, 10, 10))
    assert len(model.lattice.pairs) > 2 * BONDS_OF_PORTION
    dt = time_step(model, 0.9)
    plan = bd.Plan(duration=230 * dt, dt=dt, damping=DAMPING, gauges=GAUGES, every=20)
    results = []
    for count in (1, 2):
        with threads(count):
            results.append(integrate(model, plan, state=state_of(model)))
    assert_same_bits(*results)
    np.testing.assert_array_equal(results[0].history.records, results[1].history.records)
    assert np.abs(results[0].history["end"][-1]).max() > 1e-3
    assert results[0].history.energy["loss"][-1] > 0.0
    record("same bits", True)


@pytest.mark.parametrize("scheme", [bd.VelocityVerlet(), bd.TchamwaWielgosz(1.2)], ids=["Verlet", "TW"])
@pytest.mark.parametrize("formulation", ["total", "incremental"])
def test_pausing_changes_no_bit(formulation: str, scheme, record: Record) -> None:
    model = bar((5, 2, 3), formulation)
    dt = 0.8 * critical_step(model, scheme)

    def run(
        steps: int, every: int, state: bd.State, history: bd.History | None = None, **options
    ) -> bd.ExplicitResult:
        plan = bd.Plan(
            duration=steps * dt, dt=dt, scheme=scheme, damping=DAMPING, gauges=GAUGES, every=every, **options
        )
        return integrate(model, plan, state=state, history=history)

    with threads(1):
        whole = run(450, 30, state_of(model))
        for every in (0, 1, 7, 450):
            assert_same_bits(whole, run(450, every, state_of(model)))
        saved = run(450, 30, state_of(model), save_every=37)
        assert_same_bits(whole, saved)
        np.testing.assert_array_equal(whole.history.records, saved.history.records)

        part = run(173, 30, state_of(model))
        rest = run(450, 30, part.state.copy(), part.history)
        assert_same_bits(whole, rest)
        np.testing.assert_array_equal(whole.history.records, rest.history.records)
    record("same bits", True)


def test_a_second_stage_may_be_split_too() -> None:
    """Time goes on where the first stage ended, with another step; the schedules must see the same times."""
    model = bar((5, 2, 3))
    dt = time_step(model, 0.8)
    first = integrate(model, bd.Plan(duration=101 * dt, dt=dt, every=0), state=state_of(model)).state
    other = 0.37 * dt

    def go_on(state: bd.State, steps: int) -> bd.ExplicitResult:
        return integrate(
            model, bd.Plan(duration=(101 + steps) * other, dt=other, every=0, damping=DAMPING), state=state
        )

    whole = go_on(first.copy(), 300)
    split = go_on(go_on(go_on(first.copy(), 33).state, 150).state, 300)
    assert_same_bits(whole, split)


MANY_THREADS = """
import hashlib
from tests.models import time_step
from tests.dynamics.test_determinism import DAMPING, bar, bd, integrate, state_of, threads

grip = [bd.Fix(bd.Face("x_min", depth=0.5)), bd.Drive(bd.Index([600]), y=bd.Table((0.0, 1.0, 2.0), (0.0, 0.02, 0.0)))]
pull = [bd.Load(bd.Face("x_max", depth=0.5), force=(3e3, -1e3, 2e3), schedule=bd.Ramp(0.0, 1.0, 0.5))]
model = bar((12, 10, 10)).with_boundary([*grip, *pull])
dt = time_step(model, 0.8, DAMPING)


def slow(model):
    state = state_of(model)
    state.motion[:, :3] *= 0.1
    return state


for count in (1, 2, 4):
    with threads(count):
        run = integrate(model, bd.Plan(duration=1000 * dt, dt=dt, damping=DAMPING, every=100), state=slow(model))
    assert run.steps == 1000, run.message
    bits = b"".join(getattr(run.state, name).tobytes() for name in bd.State.ARRAYS) + run.history.records.tobytes()
    print(hashlib.sha256(bits).hexdigest())
"""


def test_a_thousand_steps_on_more_threads_than_cores(record: Record) -> None:
    """Damped, held, driven and loaded, on 1, 2 and 4 threads; in a process of its own, which may have that many."""
    bits = python(MANY_THREADS)
    assert len(bits) == 3
    assert len(set(bits)) == 1
    record("same bits", True)


POOL = """
import multiprocessing as mp, warnings, bondem as bd
warnings.simplefilter('error')

def work(seed):
    particles = bd.pack(bd.Box((0.2, 0.1, 0.1)), count=300, seed=seed)
    model = bd.Model(bd.connect(particles), bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 2000.0,
                     boundary=[bd.Fix(bd.Face('x_min')), bd.Drive(bd.Face('x_max'), vx=1.0)])
    bd.set_threads(2)
    state = bd.solve_explicit(model, duration=1e-4).state
    return float(state.displacement.sum())

first = [work(1), work(2)]
with mp.get_context('fork').Pool(2) as pool:
    print(pool.map_async(work, [1, 2]).get(90) == first)
"""


def test_a_pool_forked_after_threads_gives_the_same_numbers() -> None:
    """Threads do not survive a fork: workers that relied on them would never return."""
    assert python(POOL) == ["True"]
