"""Assertions that runs have the same bits, on any number of threads and where a run is cut off and resumed."""

import hashlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem._threads import most_threads as most_threads
from bondem._threads import threads as threads
from tests.models import time_step
from tests.specimens import FOUR_CENTRES, FOUR_RADII


def need_two_threads() -> None:
    """Skip a test where one thread only may be used."""
    if most_threads() < 2:
        pytest.skip("one thread only may be used (BONDEM_NUM_THREADS)")


def assert_same_state(one: bd.State, other: bd.State) -> None:
    """Assert that two states agree to the bit in every array."""
    for name in bd.State.ARRAYS:
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)


def assert_same_bits(first: bd.ExplicitResult, second: bd.ExplicitResult) -> None:
    """Assert that two runs agree to the bit in status, step and every array of the state."""
    assert first.status is second.status
    assert first.state.step == second.state.step
    assert_same_state(first.state, second.state)


def assert_same_run(first: bd.ExplicitResult, second: bd.ExplicitResult) -> None:
    """Assert that two runs agree to the bit in status, step, state and records."""
    assert_same_bits(first, second)
    np.testing.assert_array_equal(first.history.records, second.history.records)


def assert_same_fracture(one: bd.State, other: bd.State) -> None:
    """Assert that two states agree to the bit in places, motions, damage and what has broken."""
    for name in ("pose", "motion", "integrity", "cracks", "plastic", "broken"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)


def same_spheres(particles: bd.Particles, centre=FOUR_CENTRES, radius=FOUR_RADII) -> bool:
    """Assert that particles are the four of `tests.specimens`, or others, to the bit."""
    np.testing.assert_array_equal(particles.position, centre)
    np.testing.assert_array_equal(particles.radius, radius)
    return True


def flying_apart(model: bd.Model) -> Callable[..., bd.ExplicitResult]:
    """Runs of 1200 steps of a block of 14³ spheres that fly away from its middle: `run(threads, every, ...)`."""
    damping = bd.LocalDamping(0.05)
    state = model.state()
    state.set_motion(velocity=1.0 * (model.lattice.particles.position - 6.5))
    dt = time_step(model, 0.5, damping)

    def run(count: int, every: int, **options) -> bd.ExplicitResult:
        with threads(count):
            return bd.solve_explicit(
                model, duration=1200 * dt, dt=dt, every=every, damping=damping, state=state, **options
            )

    return run


def digest(run: bd.ExplicitResult) -> str:
    """Status, step and every array of the state, as one hash."""
    parts = (getattr(run.state, name).tobytes() for name in bd.State.ARRAYS)
    return f"{run.status.value} {run.state.step} {hashlib.sha256(b''.join(parts)).hexdigest()}"


class EnoughError(Exception):
    """Cuts a run off."""


def assert_resumes_to(whole: bd.ExplicitResult, run: Callable[..., object], place: Path, share: float) -> None:
    """A run that is cut off at a share of it, amid what breaks, and resumed from its file, ends as the whole one.

    Args:
        whole: run through.
        run: the same with `out` and `progress`, and with `save_every`.
        place: its file.
        share: of the run, in (0, 1).
    """

    def stop(done: float) -> None:
        if done > share:
            raise EnoughError

    with pytest.raises(EnoughError):
        run(out=place, progress=stop)
    assert 0 < len(bd.read_run(place).state.broken) < len(whole.events)
    resumed = bd.resume(place)
    assert_same_bits(whole, resumed)
    np.testing.assert_array_equal(whole.history.records, resumed.history.records)
    np.testing.assert_array_equal(whole.events.bond, resumed.events.bond)
