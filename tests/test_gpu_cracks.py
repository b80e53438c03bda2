"""Facets of cells that crack and soften on a CUDA device, in the simulator, against the CPU."""

import numpy as np
import pytest

from bondem.kernels.crack_tables import ACTIVE, FACET, PARTED, RATE, RESTING, SPENT, STATUS
from bondem.kernels.tables import BROKEN_BOND, BROKEN_STEP, FRACTURE, FRICTION, LOSS, TRANSLATION, WORK
from tests.gpu_sides import apart, ends_alike, records_alike, three_sides
from tests.test_gpu import only_slowly

CASES = "soft", only_slowly("paused"), "resumed", only_slowly("stale"), "brittle", "flying"
FIELDS = "pose", "stress", "motion", "acceleration", "loss", "reaction", "integrity", "released", "facet_force"


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory):
    """The runs on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    return three_sides("cuda_cracks.py", tmp_path_factory.mktemp("cracks"))


def agree(expected: dict, found: dict, case: str, as_case: str) -> None:
    """Assert that a case has cracked in the same facets in the same order, and ended alike."""
    ends_alike(expected, found, case, as_case, FIELDS)
    one, other = expected[f"{as_case}/cracks"], found[f"{case}/cracks"]
    for column in (FACET, STATUS):
        np.testing.assert_array_equal(one[:, column], other[:, column])
    for column in range(one.shape[1]):
        known = np.isfinite(one[:, column])  # of parted cracks the force at which they would wake is infinite
        if column == RATE:  # used only of cracks that may soften further
            integrity = expected[f"{as_case}/integrity"][one[:, FACET].astype(int)]
            known &= (one[:, STATUS] == ACTIVE) & (integrity > 0.0)
        assert apart(one[known, column], other[known, column]) < 1e-12
        np.testing.assert_array_equal(np.isfinite(one[:, column]), np.isfinite(other[:, column]))


@pytest.mark.parametrize("case", CASES)
def test_simulated_device_cracks_in_the_same_facets(outcomes, case: str) -> None:
    cpu, gpu, _ = outcomes
    agree(cpu, gpu, case, case)
    records_alike(cpu, gpu, case)


def test_cracks_do_all_that_a_device_knows(outcomes) -> None:
    """They open, rest, wake, close, rub and part in these runs, so that leaving one out would be seen."""
    cpu, _, _ = outcomes
    for case in ("soft", "flying"):
        status = cpu[f"{case}/cracks"][:, STATUS]
        assert all((status == kind).any() for kind in (ACTIVE, RESTING, PARTED))
        assert cpu[f"{case}/records"][-1, FRICTION] > 0.0
        assert len(cpu[f"{case}/broken"]) > 10
    assert len(cpu["brittle/broken"]) > 3
    integrity = cpu["soft/integrity"]
    assert ((integrity > 0.0) & (integrity < 1.0)).any()
    half, whole = cpu["soft/half_cracks"], cpu["soft/cracks"]
    assert len(whole) >= len(half) > 0
    rested = np.flatnonzero(half[:, STATUS] == RESTING)  # half way; some of them have woken since
    assert (whole[rested, STATUS] == ACTIVE).any()


def test_closed_cracks_bear_pressure_on_the_device(outcomes) -> None:
    """What has broken bears as much as anything where it is pressed, and its part in the energy is not lost."""
    _, gpu, _ = outcomes
    for case in ("soft", "flying"):
        force = np.linalg.norm(gpu[f"{case}/facet_force"], axis=0)
        assert force[gpu[f"{case}/integrity"] == 0.0].max() > 0.1 * force.max()


def test_ledger_closes_through_cracks_as_on_the_cpu(outcomes) -> None:
    cpu, gpu, _ = outcomes
    for case in ("soft", "flying"):
        drifts = []
        for outcome in (cpu, gpu):
            records = outcome[f"{case}/records"]
            total = records[:, TRANSLATION:WORK].sum(axis=1) - records[:, WORK]
            total += records[:, [LOSS, FRICTION, FRACTURE]].sum(axis=1)
            whole = max(records[:, WORK].max(), records[0, TRANSLATION:WORK].sum())
            drifts.append((total[-1] - total[0]) / whole)
            assert records[-1, FRACTURE] > 0.03 * whole
        assert abs(drifts[1]) < 0.02
        assert abs(drifts[1] - drifts[0]) < 1e-12


def test_the_log_has_each_broken_facet_once(outcomes) -> None:
    """In time, and within a step in the order of the cracks; what cracks have spent is what is released."""
    _, gpu, _ = outcomes
    for case in ("soft", "flying", "brittle"):
        log, cracks = gpu[f"{case}/broken"], gpu[f"{case}/cracks"]
        place = np.zeros(int(cracks[:, FACET].max()) + 1)
        place[cracks[:, FACET].astype(int)] = np.arange(len(cracks))
        order = np.lexsort((place[log[:, BROKEN_BOND].astype(int)], log[:, BROKEN_STEP]))
        np.testing.assert_array_equal(order, np.arange(len(log)))
        assert len(np.unique(log[:, BROKEN_BOND])) == len(log)
        broken = gpu[f"{case}/integrity"][cracks[:, FACET].astype(int)] == 0.0
        assert broken.sum() == len(log)
        # parted faces let go what pressed them together, which no crack has spent
        assert gpu[f"{case}/released"][0] == pytest.approx(cracks[:, SPENT].sum(), rel=0.05)


@pytest.mark.parametrize("parted", [only_slowly("paused"), "resumed"])
def test_pausing_changes_no_bit_of_cracks(outcomes, parted: str) -> None:
    _, gpu, _ = outcomes
    for field in (*FIELDS, "work", "broken", "cracks"):
        np.testing.assert_array_equal(gpu[f"soft/{field}"], gpu[f"{parted}/{field}"])


def test_a_run_that_goes_on_begins_with_the_energies_it_left_off_with(outcomes) -> None:
    """Those of its cracks, too, of which the state keeps no geometry."""
    for outcome in outcomes[:2]:
        left, begun = outcome["soft/records"][1], outcome["resumed/records"][0]
        np.testing.assert_allclose(begun, left, rtol=0.0, atol=1e-12 * np.abs(left).max())


def test_a_cracked_body_goes_on_on_the_other_side(outcomes) -> None:
    """From the CPU to the device and back."""
    cpu, gpu, back = outcomes
    agree(cpu, gpu, "handed", "soft")
    agree(cpu, back, "handed", "soft")
