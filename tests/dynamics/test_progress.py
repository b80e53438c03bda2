"""What is reported about a run while it goes on."""

import pytest

import bondem as bd
from bondem.cli.terminal import progress_bars
from bondem.dynamics.progress import RunProgress, has_listener, listening
from tests.models import torn_row


def test_a_run_tells_how_far_it_is_and_what_broke() -> None:
    reports: list[RunProgress] = []
    with listening(reports.append):
        assert has_listener()
        run = bd.solve_explicit(torn_row(), duration=2e-4, every=20, save_every=0, imbalance=None)
    assert not has_listener()
    last = reports[-1]
    assert (last.step, last.steps, last.time) == (run.iterations, run.iterations, run.state.time)
    assert last.broken == len(run.events) > 0
    assert last.balance == pytest.approx(run.history.imbalance, rel=1e-12)
    assert last.left == 0.0
    assert last.rate > 0.0
    bd.solve_explicit(torn_row(), duration=2e-5, imbalance=None)
    assert reports[-1] is last


def test_the_log_has_the_run_beside_the_stage(tmp_path) -> None:
    with progress_bars(tmp_path / "log") as progress:
        bd.solve_explicit(
            torn_row(),
            duration=2e-4,
            every=20,
            imbalance=None,
            progress=lambda share: progress("pulled", 0.5 * share),
        )
        progress("pulled", 1.0)
    lines = (tmp_path / "log").read_text().splitlines()
    assert any("pulled 100 %: step" in line and "broken" in line and "steps/s" in line for line in lines)


def test_words_of_a_pulse() -> None:
    progress = RunProgress(1200, 5000, 1.2e-3, 400.0, 7, 1e-6, 1e-2)
    wanted = "step 1200 of 5000, t = 0.0012 s, 400 steps/s, at most 9.5 s left, 7 broken, energy error 1e-04"
    assert progress.words == wanted
