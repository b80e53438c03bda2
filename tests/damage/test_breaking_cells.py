"""Facets of cells that break: at the material's own strength, with a ledger that closes and forces that are right."""

import functools
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.errors import InputError
from tests.bits import assert_resumes_to, assert_same_bits, need_two_threads, threads
from tests.elastic_energy import elastic_energy
from tests.models import time_step
from tests.recording import Record
from tests.specimens import bar, cubes

E, RHO = 40e9, 2500.0
FAILURE = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61)
PULL = (bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 0.8, 1e-5)))


def model_of(count: int, nu: float = 0.2, failure: bd.Criterion | None = FAILURE, boundary=PULL) -> bd.Model:
    return bd.Model(bar(count, 8e-3), bd.CellBond(E=E, nu=nu), density=RHO, failure=failure, boundary=boundary)


def accelerations(model: bd.Model, state: bd.State, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """Those a state holds, and those found anew."""
    again = state.copy()
    again.stale = True
    CoreLoop(model, bd.Plan(duration=1.0, dt=dt, every=0), again, dt).record_present()
    return state.acceleration, again.acceleration


def test_a_row_of_cells_bears_its_tensile_strength() -> None:
    """Facets across a bar: the index is the mean stress over the strength, to rounding."""
    count, size = 6, 1e-3
    row = cubes((count, 1, 1), size)
    assert len(row.pairs) == count - 1
    law = bd.CellBond(E=E, nu=0.2, facet_rotation="full")  # facets on one axis do not resist its twist else
    pull = [bd.Load(bd.Face("x_max"), force=(3.0, 0.0, 0.0)), bd.Load(bd.Face("x_min"), force=(-3.0, 0.0, 0.0))]
    static = bd.solve_static(bd.Model(row, law, density=RHO, boundary=pull))
    failing = bd.Model(row, law, density=RHO, boundary=pull, failure=FAILURE)
    state = failing.state()
    state.set_pose(position=row.centre + static.displacement)
    np.testing.assert_allclose(bd.failure_index(failing, state), 3.0 / size**2 / 4e6, rtol=1e-9)


@pytest.mark.parametrize("nu", [-0.2, 0.0, 0.2, 0.4])
def test_forces_and_energies_through_breakage(nu: float, one_thread: None) -> None:
    """Neighbours get the forces a fresh look finds; every facet gives energy, which the potential has lost."""
    model = model_of(150, nu)
    dt = time_step(model, 0.5)
    run = bd.solve_explicit(model, duration=500 * dt, dt=dt, every=1)
    assert len(run.events) > 30
    assert (run.events.energy > 0.0).all()
    assert run.residual < 5e-3
    stored = run.history
    parts = sum(stored.energy[part][-1] for part in ("normal", "shear", "bending", "twisting"))
    assert elastic_energy(model, run.state).total == pytest.approx(parts, rel=1e-10)
    # just when something has broken
    step = int(run.events.step[len(run.events) // 2])
    part = bd.solve_explicit(model, duration=step * dt, dt=dt, every=0)
    assert part.events.step[-1] == step
    held, fresh = accelerations(model, part.state, dt)
    assert np.abs(held - fresh).max() < 1e-10 * np.abs(fresh).max()


def test_energy_of_a_facet_is_what_the_potential_loses(one_thread: None) -> None:
    model = model_of(150)
    dt = time_step(model, 0.5)
    first = int(bd.solve_explicit(model, duration=300 * dt, dt=dt, every=0).events.step[0])
    run = bd.solve_explicit(model, duration=first * dt, dt=dt, every=0)
    whole = run.state.copy()
    whole.integrity[:] = 1.0
    lost = elastic_energy(model, whole).total - elastic_energy(model, run.state).total
    assert run.events.energy.sum() == pytest.approx(lost, rel=1e-7)
    index = bd.failure_index(model, whole)
    assert set(np.flatnonzero(index >= 1.0)) == set(run.events.bond)


def test_the_ledger_of_cells_is_second_order(one_thread: None, record: Record) -> None:
    model = model_of(150)
    dt = time_step(model, 0.5)
    missed = []
    for halvings in range(4):
        count = 2**halvings
        run = bd.solve_explicit(model, duration=400 * dt, dt=dt / count, every=count)
        assert len(run.events) > 30
        missed.append(np.sqrt((run.history.energy["balance"] ** 2).mean()))
    order = np.log2(missed[0] / missed[-1]) / 3.0
    assert order > 1.7
    record("order", order)


@pytest.mark.validate
def test_same_bits_of_cells_after_a_thousand_breaks(tmp_path: Path, record: Record) -> None:
    need_two_threads()
    model = model_of(1200)
    dt = time_step(model, 0.4)

    def run(count: int, every: int, **options) -> bd.ExplicitResult:
        with threads(count):
            return bd.solve_explicit(model, duration=600 * dt, dt=dt, every=every, **options)

    whole = run(1, 50)
    assert len(whole.events) > 1000
    for count, every in ((1, 7), (2, 1), (2, 0)):
        assert_same_bits(whole, run(count, every))
    assert_resumes_to(whole, functools.partial(run, 2, 50, save_every=97), tmp_path / "run.h5", 0.6)
    record("same bits", True)


def test_beams_are_not_judged_in_cells() -> None:
    with pytest.raises(InputError, match="not to facets of cells"):
        model_of(150, failure=bd.PeripheralStress(tension=1e6, shear=1e6))
