"""Laboratory tests with a run file: a kill and Ctrl-C lose nothing, and the same call continues."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunInterrupted
from tests.bits import assert_same_run
from tests.scripts import ROOT
from tests.specimens import ball, bar, cells

LAW = bd.CellBond(E=30e9, nu=0.2)
CONCRETE = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=20.0)


def split(**options: Any) -> bd.labtests.BrazilianTest:
    """Quasi-static: a disc of 120 cells, whose E is read from strains of its middle."""
    disc = cells(bd.Cylinder(radius=25e-3, length=20e-3), 120)
    return bd.labtests.brazilian(disc, LAW, CONCRETE, traverses=20.0, **options)


def spalled(**options: Any) -> bd.labtests.SpallTest:
    """Dynamic: a bar of 300 cells, which tears."""
    return bd.labtests.spall(
        bar(300, 60e-3, 6e-3), LAW, bd.Rankine(tension=4e6), density=2400.0, pressure=15e6,
        rise=3e-6, fall=3e-6, **options,
    )  # fmt: skip


# The first argument is a test of this file, the second one its run file, the third one the share at which it dies.
KILLED = """
import os, signal, sys
from tests.labtests import test_interrupted_tests as tests

def die(share):
    if share > float(sys.argv[3]):
        os.kill(os.getpid(), signal.SIGKILL)

getattr(tests, sys.argv[1])(out=sys.argv[2], progress=die)
"""


@pytest.mark.parametrize(("test", "share"), [(split, 0.16), (spalled, 0.7)])
def test_a_test_that_is_killed_continues_to_the_same_bits(
    test: Callable[..., Any], share: float, tmp_path: Path
) -> None:
    place = tmp_path / "test.h5"
    words = [sys.executable, "-c", KILLED, test.__name__, str(place), str(share)]
    assert subprocess.run(words, cwd=ROOT, check=False).returncode == -signal.SIGKILL
    kept = bd.read_contents(place)
    assert 0 < kept.step < kept.steps
    assert kept.snapshots > 5
    whole, again = test(), test(out=place)
    one, other = (getattr(found, "test", found).run for found in (whole, again))
    assert_same_run(one, other)
    assert len(one.events) > 0
    assert (whole.peak, getattr(whole, "E", 0.0)) == (again.peak, getattr(again, "E", 0.0))
    # a complete test is evaluated from its file
    written = place.stat().st_mtime_ns
    assert test(out=place).peak == whole.peak
    assert place.stat().st_mtime_ns == written


@pytest.mark.parametrize("kept", [True, False])
def test_an_interrupt_leaves_the_curve_so_far(kept: bool, tmp_path: Path) -> None:
    sent = []

    def interrupt(share: float) -> None:
        if share > 0.16 and not sent:
            sent.append(share)
            os.kill(os.getpid(), signal.SIGINT)

    place = {"out": tmp_path / "split.h5"} if kept else {}
    with pytest.raises(RunInterrupted) as stopped:
        split(progress=interrupt, **place)
    whole, part = split(), stopped.value.result
    count = len(part.curve)
    assert 10 < count < len(whole.curve)
    np.testing.assert_array_equal(part.curve, whole.curve[:count])
    assert part.peak == part.curve[:, 1].max()
    assert ("split.h5" in str(stopped.value)) == kept
    if kept:
        np.testing.assert_array_equal(split(**place).curve, whole.curve)


def test_an_interrupted_path_of_equilibria_leaves_its_curve() -> None:
    beam = bar(80, 80e-3, 20e-3)
    options: dict[str, Any] = {"ripple": 0.3, "together": 0.1, "until": 0.5}
    sent = []

    def interrupt(share: float) -> None:
        if share > 0.1 and not sent:
            sent.append(share)
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(RunInterrupted, match="interrupted after") as stopped:
        bd.labtests.three_point_bending(beam, LAW, CONCRETE, progress=interrupt, **options)
    whole, part = bd.labtests.three_point_bending(beam, LAW, CONCRETE, **options), stopped.value.result
    assert 3 < len(part.curve) < len(whole.curve)
    assert part.path.end == "interrupted"
    np.testing.assert_array_equal(part.curve, whole.curve[: len(part.curve)])


def test_a_file_of_another_test_is_neither_continued_nor_lost(tmp_path: Path) -> None:
    place = tmp_path / "impact.h5"
    thrown = {"density": 2400.0, "duration": 2e-6, "out": place}
    bd.labtests.sphere_impact(ball(30, 10e-3), LAW, velocity=1.0, **thrown)
    before = place.read_bytes()
    with pytest.raises(InputError, match="does not hold this run"):
        bd.labtests.sphere_impact(ball(30, 10e-3), LAW, velocity=(-0.8, 0.6, 0.0), **thrown)
    place.with_name("notes.txt").write_text("mine")
    with pytest.raises(InputError, match="does not hold this run"):
        bd.labtests.sphere_impact(ball(30, 10e-3), LAW, velocity=1.0, **thrown | {"out": tmp_path / "notes.txt"})
    assert place.read_bytes() == before
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_a_run_continues_its_file_only_where_it_can(tmp_path: Path) -> None:
    model = bd.Model(bar(30), LAW, 2400.0, [bd.Fix(bd.Face("x_min"))])
    options: dict[str, Any] = {"duration": 1e-6, "every": 5, "resume": True}
    with pytest.raises(InputError, match="out = None"):
        bd.solve_explicit(model, **options)
    with pytest.raises(InputError, match="callback= remembers"):
        bd.solve_explicit(model, out=tmp_path / "run.h5", callback=lambda state, record: None, **options)
