"""Beams that soften on a CUDA device, in the simulator, against the CPU."""

import numpy as np
import pytest

from bondem.kernels.soft_tables import FIRST, LAST, RATE, SOFT_BOND
from bondem.kernels.tables import FRACTURE, TRANSLATION, WORK
from tests.gpu_sides import ends_alike, records_alike, two_and_back
from tests.test_gpu import only_slowly

# a minute or two in the simulator; test_gpu, test_gpu_failure and test_gpu_cracks are one of each kind
pytestmark = pytest.mark.validate

CRITERIA = "peripheral", "mohr coulomb"
CASES = (*CRITERIA, only_slowly("paused"), "resumed", only_slowly("stale"), "alike")
FIELDS = "pose", "motion", "acceleration", "loss", "reaction", "integrity", "released", "softened"


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory):
    """The runs on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    return two_and_back("cuda_soft_beams.py", tmp_path_factory.mktemp("soft"))


def agree(expected: dict, found: dict, case: str, as_case: str) -> None:
    """Assert that the same beams have begun in the same order, and that a case has ended alike."""
    ends_alike(expected, found, case, as_case, FIELDS)
    one, other = expected[f"{as_case}/softened"], found[f"{case}/softened"]
    np.testing.assert_array_equal(one[:, SOFT_BOND], other[:, SOFT_BOND])
    assert (np.abs(one - other) <= 1e-12 * np.abs(one).max(axis=0)).all()


@pytest.mark.parametrize("case", CASES)
def test_simulated_device_softens_the_same_beams(outcomes, case: str) -> None:
    cpu, gpu, _ = outcomes
    agree(cpu, gpu, case, case)
    records_alike(cpu, gpu, case)


def test_beams_begin_soften_and_part_in_these_runs(outcomes) -> None:
    """Some are pressed that are partly or wholly broken, so that leaving out what presses would be seen."""
    cpu, _, _ = outcomes
    for case in (*CRITERIA, "alike"):
        integrity, softened = cpu[f"{case}/integrity"], cpu[f"{case}/softened"]
        assert ((integrity > 0.0) & (integrity < 1.0)).sum() > 20
        assert (integrity == 0.0).sum() == len(cpu[f"{case}/broken"]) >= 5
        assert (softened[:, LAST] > softened[:, FIRST]).all()
        assert (softened[:, RATE] < softened[:, FIRST] ** 2).any()  # unloaded
        assert cpu[f"{case}/records"][-1, FRACTURE] > 0.1 * cpu[f"{case}/records"][0, TRANSLATION]


def test_ledger_closes_through_softening_as_on_the_cpu(outcomes) -> None:
    cpu, gpu, _ = outcomes
    drifts = []
    for outcome in (cpu, gpu):
        records = outcome["alike/records"]
        total = records[:, TRANSLATION:WORK].sum(axis=1) + records[:, FRACTURE]
        drifts.append((total[-1] - total[0]) / total[0])
    assert abs(drifts[1]) < 0.02
    assert abs(drifts[1] - drifts[0]) < 1e-12


@pytest.mark.parametrize("parted", [only_slowly("paused"), "resumed"])
def test_pausing_changes_no_bit_of_beams_that_soften(outcomes, parted: str) -> None:
    _, gpu, _ = outcomes
    for field in (*FIELDS, "work", "broken"):
        np.testing.assert_array_equal(gpu[f"peripheral/{field}"], gpu[f"{parted}/{field}"])


def test_a_run_that_softens_goes_on_on_the_other_side(outcomes) -> None:
    """From the CPU to the device and back."""
    cpu, gpu, back = outcomes
    agree(cpu, gpu, "handed", "peripheral")
    agree(cpu, back, "handed", "peripheral")
