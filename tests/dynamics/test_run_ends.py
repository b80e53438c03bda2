"""The end of a run is its last record, and a run that would take no step says so."""

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import HistoryColumn
from bondem.dynamics.energy_check import EnergyCheck
from bondem.errors import ImbalanceWarning, InputError, UnstableRunWarning
from tests.specimens import two_spheres

DT = 1e-6


def pulled() -> bd.Model:
    law, end = bd.EulerBernoulli(E=1e7, nu=0.2, radius_ratio=0.5), bd.Index([1])
    return bd.Model(two_spheres(0.01), law, 2500.0, [bd.Fix(bd.Index([0])), bd.Load(end, force=(1.0, 0.0, 0.0))])


@pytest.mark.parametrize("steps", [250, 200, 7])
def test_the_last_record_is_the_end_of_the_run_also_when_resumed(steps: int, tmp_path) -> None:
    seen = []

    def look(state: bd.State, record: bd.History) -> None:
        seen.append(state.step)

    gauges = {"end": bd.Gauge(bd.Index([1]), "displacement")}
    model, options = pulled(), {"duration": steps * DT, "dt": DT, "gauges": gauges}
    run = bd.solve_explicit(model, **options, callback=look)
    assert run.history.time[-1] == run.state.time
    assert run.history["end"][-1, 0] == run.state.displacement[1, 0]
    assert seen == [*range(0, steps, 100), steps]

    path = tmp_path / "run.h5"
    bd.solve_explicit(model, **options, out=path, save_every=50, until=bd.AtRest(0.5))
    again = bd.resume(path)
    for other in (bd.solve_explicit(model, **options, out=path, save_every=30), bd.resume(path)):
        assert np.array_equal(other.history.records, run.history.records)
    assert again.history.time[-1] == again.state.time


def test_a_run_stopped_by_its_ledger_ends_with_a_record_of_its_state() -> None:
    def faster(state: bd.State, record: bd.History) -> None:
        state.motion[:, :3] *= 2.0

    with pytest.warns(ImbalanceWarning), pytest.warns(UnstableRunWarning, match="stopped at step"):
        run = bd.solve_explicit(
            pulled(), duration=1e4 * DT, dt=DT, every=1000, callback=faster, imbalance=(1e-12, 1e-11)
        )
    assert run.status is bd.Status.IMBALANCED
    assert run.history.time[-1] == run.state.time


def test_a_duration_below_one_step_is_refused_and_zero_records_the_start() -> None:
    with pytest.raises(InputError, match=r"duration = 4e-07 s is shorter than a step of 1e-06 s.* give a longer"):
        bd.solve_explicit(pulled(), duration=0.4 * DT, dt=DT)
    assert len(bd.solve_explicit(pulled(), duration=0.0, dt=DT).history) == 1


def test_an_energy_that_is_no_number_ends_a_run() -> None:
    model = pulled()
    run = bd.solve_explicit(model, duration=1000 * DT, dt=DT, every=10)
    records = run.history.records.copy()
    check = EnergyCheck(model, model.state(), DT, (0.01, 0.1), records[:1])
    assert not check.examine(records[1:50])
    records[50:, HistoryColumn.RELEASED] = np.nan
    assert "nan J" in check.examine(records[50:])
