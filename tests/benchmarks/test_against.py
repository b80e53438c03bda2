"""The comparison with older revisions: its cases can be run, its differences are found, its turns are taken."""

import numpy as np
import pytest

import bondem as bd
from bondem._threads import current_threads
from tests.scripts import scripts

SIZE = 60
pytestmark = pytest.mark.filterwarnings("ignore::bondem.errors.StepWarning")


@pytest.fixture(scope="module")
def benchmarks():
    """The modules beside the scripts."""
    before = current_threads()
    names = {"cases": "bits.cases", "compare": "bits.compare", "runs": "bits.runs"}
    yield scripts("benchmarks", paired="paired", tiled="tiled", **names)
    bd.set_threads(before)  # runs of cases set it


@pytest.mark.validate
def test_every_case_can_start(benchmarks) -> None:
    for name, make in benchmarks["cases"].CASES.items():
        case = make(SIZE)
        assert np.isfinite(case.start(1e-3).motion).all(), name


@pytest.mark.validate
def test_pauses_of_a_case_leave_the_same_bits_and_another_step_does_not(benchmarks, tmp_path) -> None:
    run, differing = benchmarks["runs"].run, benchmarks["compare"].differing
    pauses = ["every 30", "every 7", "two runs"]
    folders = [tmp_path / name for name in ("old", "new", "other")]
    for folder in folders:
        folder.mkdir()
    told = run("alike", SIZE, [1], pauses, 100, str(folders[0]))
    again = run("alike", SIZE, [1], pauses, 100, str(folders[1]), told["dt"])
    run("alike", SIZE, [1], pauses, 100, str(folders[2]), told["dt"] * (1.0 + 1e-9))
    assert told == again
    assert not told["faults"]
    assert told["moved"] > 1e-3
    for pause in pauses:
        old, new, other = (folder / f"{pause}-1.npz" for folder in folders)
        assert differing(old, new, pause) is None
        found = differing(old, other, pause)
        assert found is not None
        assert found.array == "pose"
    found = differing(folders[0] / "every 30-1.npz", folders[1] / "every 7-1.npz", "")
    assert found is not None
    assert found.array == "records"


@pytest.mark.parametrize(
    "change", [{"pose": np.nextafter(1.0, 2.0) * np.ones(3)}, {"pose": np.ones(4)}, {"pose": np.float32([1, 1, 1])},
               {"zero": np.array(-0.0)}, {"status": np.array("UNSTABLE")}, {"more": np.ones(1)}],
    ids=["bit", "shape", "type", "sign", "word", "array"],
)  # fmt: skip
def test_the_smallest_difference_is_found(benchmarks, tmp_path, change) -> None:
    values = {"pose": np.ones(3), "zero": np.array(0.0), "status": np.array("COMPLETED")}
    for name, given in (("a", values), ("b", values), ("c", values | change)):
        np.savez(tmp_path / name, **given)
    differing = benchmarks["compare"].differing
    assert differing(tmp_path / "a.npz", tmp_path / "b.npz", "") is None
    found = differing(tmp_path / "a.npz", tmp_path / "c.npz", "every 30")
    assert found is not None
    assert found.array == next(iter(change))


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
