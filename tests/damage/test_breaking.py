"""Bonds that break in a body: a ledger that closes, and the same bits however run (single ones: `test_strengths`)."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from tests.bits import assert_resumes_to, assert_same_bits, flying_apart, need_two_threads
from tests.models import crooked_beams, momenta, moving, time_step
from tests.recording import Record

WEAK = bd.PeripheralStress(tension=2e5, shear=3e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))
PULL = (bd.Fix(bd.Face("x_min", depth=0.5)), bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 5.0, 0.02)))


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # pieces without contact
def test_the_ledger_is_second_order_through_breakage(one_thread: None, record: Record) -> None:
    """Halving the step quarters what the ledger misses, though a hundred bonds break."""
    model = crooked_beams(5, WEAK, boundary=PULL)
    dt = time_step(model, 0.4)
    missed, broken = [], []
    for halvings in range(4):
        count = 2**halvings
        run = bd.solve_explicit(model, duration=600 * dt, dt=dt / count, every=count)
        missed.append(np.sqrt((run.history.energy["balance"] ** 2).mean()))
        broken.append(len(run.events))
        assert run.history.energy["fracture"][-1] == pytest.approx(run.events.energy.sum(), rel=1e-12)
        assert (run.events.energy > 0.0).all()
    assert min(broken) > 50
    order = np.log2(missed[0] / missed[-1]) / 3.0
    assert order > 1.7
    record("order", order)


def test_momentum_is_kept_through_breakage(one_thread: None) -> None:
    model = crooked_beams(5, WEAK)
    outwards = model.lattice.centre - model.lattice.centre.mean(axis=0)
    state = moving(model, 8.0 * outwards + np.cross((0.0, 0.0, 5.0), outwards))
    dt = time_step(model, 0.3)
    scale = np.abs(model.mass[:, None] * state.velocity).sum() * 5.0
    run = bd.solve_explicit(model, duration=800 * dt, dt=dt, state=state)
    assert len(run.events) > 100
    change = np.subtract(momenta(model, run.state), momenta(model, state))
    assert np.abs(change).max() < 1e-13 * scale


@pytest.mark.validate
@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # pieces without contact
def test_same_bits_after_thousands_of_breaks(tmp_path: Path, record: Record) -> None:
    """On one and two threads, recorded often or never, and saved and resumed, with damping and dashpots."""
    need_two_threads()
    failure = bd.PeripheralStress(tension=4e5, shear=6.4e5, scatter=bd.Weibull(modulus=5.0, volume=0.1))
    drive = bd.Drive(bd.Face("x_max", depth=0.5), vx=bd.Ramp(0.0, 20.0, 0.02), wx=2.0)
    model = crooked_beams(14, failure, boundary=(PULL[0], drive))
    run = flying_apart(model)
    whole = run(1, 100)
    assert len(whole.events) > 2000
    for count, every in ((2, 7), (2, 0)):
        assert_same_bits(whole, run(count, every))
    assert_resumes_to(whole, functools.partial(run, 2, 100, save_every=19), tmp_path / "run.h5", 20 / 1200)
    record("same bits", True)


@pytest.mark.filterwarnings("ignore::bondem.errors.ContactWarning")  # pieces without contact
def test_events_name_what_broke(one_thread: None) -> None:
    model = crooked_beams(5, WEAK, boundary=PULL)
    dt = time_step(model, 0.4)
    position = {}

    def look(state: bd.State, record: bd.History) -> None:
        position[state.step] = state.position

    run = bd.solve_explicit(model, duration=600 * dt, dt=dt, every=1, callback=look)
    events = run.events
    assert sorted(events.bond) == np.flatnonzero(run.state.bond_integrity == 0.0).tolist()
    assert (np.diff(events.step) >= 0).all()
    np.testing.assert_allclose(events.time, events.step * dt, rtol=1e-12)
    # where the contact point was at that instant, and by how much the bond was longer, though pieces fly
    (i, j), length = model.lattice.pairs[events.bond].T, model.lattice.length[events.bond]
    first, second = (np.stack([position[s][p] for s, p in zip(events.step, ends, strict=True)]) for ends in (i, j))
    share = (model.stiffness.lever[events.bond] / length)[:, None]
    np.testing.assert_allclose(events.position, first + share * (second - first), rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(events.gap, np.linalg.norm(second - first, axis=1) - length, rtol=0.0, atol=1e-12)
    assert set(events.mode) == {"tension"}  # pulled apart; the other modes: closed forms in test_strengths
    # a second stage brings them along, and counts its energies anew
    more = bd.solve_explicit(model, duration=10 * dt, dt=dt, state=run.state, every=1)
    np.testing.assert_array_equal(more.events.bond[: len(events)], events.bond)
    assert more.history.energy["fracture"][0] == 0.0


def test_strength_scatters_as_it_should() -> None:
    volume = np.full(200_000, 3e-6)
    weibull = bd.Weibull(modulus=8.0, volume=1e-6, seed=3)
    found = weibull.factors(volume)
    assert found.mean() == pytest.approx(3.0 ** (-1 / 8) * math.gamma(1 + 1 / 8), rel=2e-3)
    assert (found < 3.0 ** (-1 / 8)).mean() == pytest.approx(1 - math.exp(-1), abs=5e-3)
    normal = bd.Normal(deviation=0.2, seed=4).factors(volume)
    assert normal.mean() == pytest.approx(1.0, abs=2e-3)
    assert normal.std() == pytest.approx(0.2, rel=0.02)
    # by the number of the bond, whatever comes after it
    np.testing.assert_array_equal(weibull.factors(volume[:10]), found[:10])
    assert (weibull.factors(volume[:10]) != bd.Weibull(modulus=8.0, volume=1e-6, seed=4).factors(volume[:10])).all()
