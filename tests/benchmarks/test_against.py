"""The comparison with older revisions: its digests show a bit that differs, its turns are taken."""

import numpy as np
import pytest

import bondem as bd
from bondem._threads import current_threads
from tests.scripts import scripts


@pytest.fixture(scope="module")
def benchmarks():
    """The modules beside the scripts."""
    before = current_threads()
    yield scripts("benchmarks", paired="paired", levels="levels")
    bd.set_threads(before)


@pytest.mark.validate
def test_digests_of_a_run_repeat_on_any_threads_and_differ_where_a_bit_does(benchmarks) -> None:
    levels = benchmarks["levels"]
    found = levels.runs([300])
    assert {name.partition(", ")[2] for name in found} >= set(levels.SMALL)
    for name in ("bar, device_runs", "cells, softening, 300 elements"):
        digests = set()
        for count in (1, 2):
            bd.set_threads(count)
            digests.add(levels.digest(found[name]()))
        assert len(digests) == 1, name
        run = found[name]()
        run.state.pose[0, 0] = np.nextafter(run.state.pose[0, 0], 9.0)
        assert levels.digest(run) not in digests, name


@pytest.mark.validate
def test_sides_import_the_bondem_they_are_given_and_take_turns(benchmarks, tmp_path) -> None:
    paired = benchmarks["paired"]
    path = str(tmp_path / "specimen.npz")
    with paired.Worker(paired.SOURCE, cores=1) as first, paired.Worker(paired.SOURCE, cores=1) as second:
        assert first.ask("specimen", elements=300, largest=300, path=path)["elements"] == 300
        bonds = {worker.ask("load", path=path)["bonds"] for worker in (first, second)}
        assert len(bonds) == 1
        pairs = paired.in_turns(first, second, bonds.pop(), threads=1, repeat=3, steps=20)
        with pytest.raises(RuntimeError, match="no_such_task"):
            second.ask("no_such_task")
    assert len(pairs.first) == len(pairs.second) == 3
    assert pairs.report(("old", "new"))["old"]["min"] > 0.0


def test_gain_is_the_median_of_quiet_pairs(benchmarks) -> None:
    sample = benchmarks["paired"].Sample
    quiet, busy = (lambda rate: sample(rate, 0.01, rate)), (lambda rate: sample(rate, 0.5, rate))
    first = (quiet(1.0), quiet(2.0), quiet(4.0), quiet(1.0))
    pairs = benchmarks["paired"].Pairs(first, (quiet(2.0), quiet(6.0), quiet(8.0), busy(100.0)))
    assert pairs.quiet == [0, 1, 2]
    assert pairs.gain == 2.0
    assert benchmarks["paired"].Pairs(first, (busy(1.0),) * 4).quiet == [0, 1, 2, 3]
