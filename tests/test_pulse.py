"""What is told about a run while it goes on."""

import numpy as np
import pytest

import bondem as bd
from bondem.cli.terminal import progress_bars
from bondem.solve.pulse import Pulse, heard, listening


def bar() -> bd.Model:
    position = np.column_stack([1e-3 * np.arange(12), np.zeros((12, 2))])
    lattice = bd.connect(bd.Particles(position, 0.5e-3))
    ends = [bd.Fix(bd.Index([0])), bd.Drive(bd.Index([11]), vx=bd.Ramp(0.0, 2.0, 1e-5))]
    law = bd.EulerBernoulli(E=70e9, nu=0.3, radius_ratio=0.5)
    return bd.Model(lattice, law, 2500.0, failure=bd.PeripheralStress(tension=50e6, shear=1e9), boundary=ends)


def test_a_run_tells_how_far_it_is_and_what_broke() -> None:
    told: list[Pulse] = []
    with listening(told.append):
        assert heard()
        run = bd.solve_explicit(bar(), duration=2e-4, every=20, save_every=0, imbalance=None)
    assert not heard()
    last = told[-1]
    assert (last.step, last.steps, last.time) == (run.iterations, run.iterations, run.state.time)
    assert last.broken == len(run.events) > 0
    assert last.balance == pytest.approx(run.history.imbalance, rel=1e-12)
    assert last.left == 0.0
    assert last.rate > 0.0
    bd.solve_explicit(bar(), duration=2e-5, imbalance=None)
    assert told[-1] is last


def test_the_log_has_the_run_beside_the_stage(tmp_path) -> None:
    with progress_bars(tmp_path / "log") as progress:
        bd.solve_explicit(
            bar(), duration=2e-4, every=20, imbalance=None, progress=lambda share: progress("pulled", 0.5 * share)
        )
        progress("pulled", 1.0)
    lines = (tmp_path / "log").read_text().splitlines()
    assert any("pulled 100 %: step" in line and "broken" in line and "steps/s" in line for line in lines)


def test_words_of_a_pulse() -> None:
    pulse = Pulse(1200, 5000, 1.2e-3, 400.0, 7, 1e-6, 1e-2)
    wanted = "step 1200 of 5000, t = 0.0012 s, 400 steps/s, at most 9.5 s left, 7 broken, energy error 1e-04"
    assert pulse.words == wanted
