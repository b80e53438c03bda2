"""Bonds that break on a CUDA device, in the simulator, against the CPU."""

import numpy as np
import pytest

from bondem.kernels.tables import BROKEN_BOND, BROKEN_MODE, BROKEN_STEP, BROKEN_TIME, FRACTURE, TRANSLATION, WORK
from tests.test_gpu import SIMULATOR, only_slowly, run

CRITERIA = "peripheral", "mohr coulomb", "linear", "elliptic"
CASES = (*CRITERIA, only_slowly("paused"), "dissipative", "alike", "resumed")
FIELDS = "pose", "motion", "acceleration", "loss", "work", "reaction", "integrity", "released"


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory):
    """The runs on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    folder = tmp_path_factory.mktemp("breaking")
    cpu, gpu, back = (str(folder / name) for name in ("cpu", "gpu", "back"))
    run("cuda_breaking.py", "cpu", f"{cpu}.npz", "", f"{cpu}.pkl")
    run("cuda_breaking.py", "gpu", f"{gpu}.npz", f"{cpu}.pkl", f"{gpu}.pkl", **SIMULATOR)
    run("cuda_breaking.py", "cpu", f"{back}.npz", f"{gpu}.pkl", f"{back}.pkl")
    with np.load(f"{cpu}.npz") as one, np.load(f"{gpu}.npz") as other, np.load(f"{back}.npz") as third:
        return dict(one), dict(other), dict(third)


def apart(expected: np.ndarray, found: np.ndarray) -> float:
    """The largest difference over the largest value."""
    assert expected.shape == found.shape
    largest = np.abs(expected).max(initial=0.0)
    return float(np.abs(found - expected).max(initial=0.0) / (largest or 1.0))


def same_breaks(log: np.ndarray, other: np.ndarray) -> list[float]:
    """Assert that the same has broken at the same time; how far each column is apart."""
    assert len(log) >= 2
    for column in (BROKEN_STEP, BROKEN_BOND, BROKEN_MODE, BROKEN_TIME):
        np.testing.assert_array_equal(log[:, column], other[:, column])
    return [apart(log[:, c], other[:, c]) for c in range(log.shape[1])]


def agree(expected: dict, found: dict, case: str, as_case: str) -> None:
    """Assert that a case has broken the same bonds at the same times, and ended alike."""
    assert expected[f"{as_case}/end"].tolist() == found[f"{case}/end"].tolist()
    missed = same_breaks(expected[f"{as_case}/broken"], found[f"{case}/broken"])
    missed += [apart(expected[f"{as_case}/{field}"], found[f"{case}/{field}"]) for field in FIELDS]
    assert max(missed) < 1e-12


@pytest.mark.parametrize("case", CASES)
def test_simulated_device_breaks_the_same_bonds(outcomes, case: str) -> None:
    cpu, gpu, _ = outcomes
    agree(cpu, gpu, case, case)
    records, found = cpu[f"{case}/records"], gpu[f"{case}/records"].copy()
    scale = np.abs(records).max(axis=0, initial=0.0)
    scale[1 : FRACTURE + 1] = scale[1 : FRACTURE + 1].max(initial=0.0)
    difference = np.abs((found - records) / np.where(scale, scale, 1.0)).max(initial=0.0)
    assert difference < 1e-12


def test_breakage_is_spread_over_bonds_and_steps(outcomes) -> None:
    """Several break in one step, and neighbours do, so that order and waiting count."""
    cpu, _, _ = outcomes
    for case in CRITERIA:
        log = cpu[f"{case}/broken"]
        assert len(np.unique(log[:, BROKEN_STEP])) >= 2
        assert cpu[f"{case}/records"][-1, FRACTURE] > 0.0
    steps = cpu["alike/broken"][:, BROKEN_STEP]
    assert len(steps) > 1.5 * len(np.unique(steps))
    assert (cpu["alike/integrity"] > 0.0).any()


def test_ledger_closes_through_breakage_as_on_the_cpu(outcomes) -> None:
    """All energy there is, less work: its drift is that of the CPU, and without what broke it would not close."""
    cpu, gpu, _ = outcomes
    drifts = []
    for outcome in (cpu, gpu):
        records = outcome["alike/records"]
        total = records[:, TRANSLATION:WORK].sum(axis=1) + records[:, FRACTURE]
        drifts.append((total[-1] - total[0]) / total[0])
        assert records[-1, FRACTURE] > 0.1 * total[0]
    assert abs(drifts[1]) < 0.02
    assert abs(drifts[1] - drifts[0]) < 1e-12


@pytest.mark.parametrize("parted", [only_slowly("paused"), "resumed"])
def test_pausing_changes_no_bit_of_what_breaks(outcomes, parted: str) -> None:
    _, gpu, _ = outcomes
    for field in (*FIELDS, "broken"):
        np.testing.assert_array_equal(gpu[f"peripheral/{field}"], gpu[f"{parted}/{field}"])


def test_a_run_goes_on_on_the_other_side(outcomes) -> None:
    """From the CPU to the device and back: half the bonds have broken there, half here."""
    cpu, gpu, back = outcomes
    agree(cpu, gpu, "handed", "peripheral")
    agree(cpu, back, "handed", "peripheral")
