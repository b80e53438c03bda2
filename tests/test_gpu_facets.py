"""Facets of cells that break at once on a CUDA device, in the simulator, against the CPU."""

import importlib

import numpy as np
import pytest

from bondem.kernels.tables import BROKEN_STEP, FRACTURE, TRANSLATION, WORK
from tests.gpu_sides import ends_alike, records_alike, three_sides
from tests.test_gpu import only_slowly

CASES = "held", only_slowly("paused"), "resumed", "pressed", "flying"
FIELDS = "pose", "stress", "motion", "acceleration", "loss", "reaction", "integrity", "released"


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory):
    """The runs on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    return three_sides("cuda_facets.py", tmp_path_factory.mktemp("facets"))


@pytest.mark.parametrize("case", CASES)
def test_simulated_device_breaks_the_same_facets(outcomes, case: str) -> None:
    cpu, gpu, _ = outcomes
    ends_alike(cpu, gpu, case, case, FIELDS)
    records_alike(cpu, gpu, case)


def test_facets_break_beside_each_other_and_at_walls(outcomes) -> None:
    """Several break in one step, and some cells lose two in one, so that order, waiting and walls count."""
    cpu, _, _ = outcomes
    for case in ("held", "flying"):
        steps = cpu[f"{case}/broken"][:, BROKEN_STEP]
        assert len(steps) > 1.5 * len(np.unique(steps))
    assert len(cpu["pressed/broken"]) >= 2
    records = cpu["held/records"]
    assert records[-1, FRACTURE] > 0.02 * records[-1, TRANSLATION:WORK].sum()
    assert np.abs(cpu["held/reaction"]).max() > 0.0


def test_what_threads_have_gathered_is_put_in_order() -> None:
    """The simulator gathers in order as it is: so this is shown apart."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    put_in_order = importlib.import_module("bondem.kernels.cuda.breaking").put_in_order
    rng = np.random.default_rng(1)
    for count in (0, 1, 2, 3, 10, 101):
        found = rng.permutation(count + 5)
        expected = np.concatenate([np.sort(found[:count]), found[count:]])
        put_in_order(found, count)
        np.testing.assert_array_equal(found, expected)


def test_ledger_closes_through_breakage_of_facets_as_on_the_cpu(outcomes) -> None:
    """Without walls: all energy there is; half of it goes into breakage, so that it would not close without."""
    cpu, gpu, _ = outcomes
    drifts = []
    for outcome in (cpu, gpu):
        records = outcome["flying/records"]
        total = records[:, TRANSLATION:WORK].sum(axis=1) + records[:, FRACTURE]
        drifts.append((total[-1] - total[0]) / total[0])
        assert records[-1, FRACTURE] > 0.3 * total[0]
    assert abs(drifts[1]) < 0.02
    assert abs(drifts[1] - drifts[0]) < 1e-12


@pytest.mark.parametrize("parted", [only_slowly("paused"), "resumed"])
def test_pausing_changes_no_bit_of_facets_that_break(outcomes, parted: str) -> None:
    _, gpu, _ = outcomes
    for field in (*FIELDS, "work", "broken"):
        np.testing.assert_array_equal(gpu[f"held/{field}"], gpu[f"{parted}/{field}"])


def test_a_body_that_breaks_goes_on_on_the_other_side(outcomes) -> None:
    """From the CPU to the device and back."""
    cpu, gpu, back = outcomes
    ends_alike(cpu, gpu, "handed", "held", FIELDS)
    ends_alike(cpu, back, "handed", "held", FIELDS)
