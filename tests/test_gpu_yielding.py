"""Cells that yield, and criteria of the stress, on a CUDA device, in the simulator, against the CPU."""

import importlib

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.kernels.crack_tables import FACET, GAMMA, HEAT, ONSET, STATUS
from bondem.kernels.tables import FRACTURE, FRICTION, LOSS, PLASTIC, TRANSLATION, WORK
from tests.gpu_sides import ends_alike, records_alike, three_sides
from tests.test_gpu import only_slowly

# a minute or two in the simulator; test_gpu, test_gpu_failure and test_gpu_cracks are one of each kind
pytestmark = pytest.mark.validate

YIELDING = "coulomb", "cone"
CASES = (*YIELDING, "resumed", only_slowly("paused"), "own", "brittle cone")
FIELDS = (
    "pose", "stress", "motion", "acceleration", "loss", "reaction", "integrity", "released", "facet_force", "plastic",
)  # fmt: skip


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory):
    """The runs on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    return three_sides("cuda_yielding.py", tmp_path_factory.mktemp("yielding"))


def agree(expected: dict, found: dict, case: str, as_case: str) -> None:
    """Assert that a case has cracked in the same facets in the same order, has yielded alike and ended alike."""
    ends_alike(expected, found, case, as_case, FIELDS)
    for column in (FACET, STATUS):
        np.testing.assert_array_equal(expected[f"{as_case}/cracks"][:, column], found[f"{case}/cracks"][:, column])
    one, other = expected[f"{as_case}/plastic"], found[f"{case}/plastic"]
    scale = np.abs(one).max(axis=0, initial=0.0)  # strains are small beside the energies in the same table
    assert (np.abs(one - other) <= 1e-12 * scale).all()


@pytest.mark.parametrize("case", CASES)
def test_simulated_device_yields_and_cracks_alike(outcomes, case: str) -> None:
    cpu, gpu, _ = outcomes
    agree(cpu, gpu, case, case)
    records_alike(cpu, gpu, case)
    for outcome in (cpu, gpu):
        assert (outcome[f"{case}/plastic"].size > 0) is (case not in ("own", "brittle cone"))


def test_cells_yield_in_all_ways(outcomes) -> None:
    """They flow, dissipate, and lose their cohesion, whose facets break, so that leaving one out would be seen."""
    cpu, _, _ = outcomes
    for case in YIELDING:
        plastic, records = cpu[f"{case}/plastic"], cpu[f"{case}/records"]
        assert (plastic[:, GAMMA] > 0.0).sum() > 6
        assert plastic[:, HEAT].min() >= 0.0
        assert records[-1, PLASTIC] > 0.03 * records[-1, WORK]
    assert (cpu["coulomb/cracks"][:, ONSET] == 0.0).any()
    for case in ("own", "brittle cone", *YIELDING):
        assert len(cpu[f"{case}/broken"]) >= 2
        assert len(cpu[f"{case}/cracks"]) > len(cpu[f"{case}/broken"])


def test_facets_that_are_pressed_do_not_crack_on_the_cone(outcomes) -> None:
    """A brittle body that is squeezed beyond its cone splits along the load, in the same facets on both sides."""
    cpu, gpu, _ = outcomes
    one, other = cpu["pressed cone/cracks"], gpu["pressed cone/cracks"]
    assert 3 < len(one) < 0.8 * len(cpu["pressed cone/integrity"])
    np.testing.assert_array_equal(one[:, FACET], other[:, FACET])
    scale = np.abs(cpu["pressed cone/motion"]).max()
    np.testing.assert_allclose(gpu["pressed cone/motion"], cpu["pressed cone/motion"], rtol=0.0, atol=1e-12 * scale)


def test_ledger_closes_through_yielding_as_on_the_cpu(outcomes) -> None:
    cpu, gpu, _ = outcomes
    for case in YIELDING:
        drifts = []
        for outcome in (cpu, gpu):
            records = outcome[f"{case}/records"]
            total = records[:, TRANSLATION:WORK].sum(axis=1) - records[:, WORK]
            total += records[:, [LOSS, FRICTION, FRACTURE, PLASTIC]].sum(axis=1)
            drifts.append((total[-1] - total[0]) / records[:, WORK].max())
        assert abs(drifts[1]) < 0.03
        assert abs(drifts[1] - drifts[0]) < 1e-12


@pytest.mark.parametrize("parted", [only_slowly("paused"), "resumed"])
def test_pausing_changes_no_bit_of_cells_that_yield(outcomes, parted: str) -> None:
    _, gpu, _ = outcomes
    for field in (*FIELDS, "work", "broken", "cracks"):
        np.testing.assert_array_equal(gpu[f"coulomb/{field}"], gpu[f"{parted}/{field}"])


def test_a_body_that_yields_goes_on_on_the_other_side(outcomes) -> None:
    """From the CPU to the device and back."""
    cpu, gpu, back = outcomes
    agree(cpu, gpu, "handed", "coulomb")
    agree(cpu, back, "handed", "coulomb")


def largest(stress, tension):
    """A criterion that CUDA does not compile."""
    return np.linalg.eigvalsh(stress)[2] / tension


def test_a_function_that_cuda_does_not_compile_is_refused_by_name(monkeypatch) -> None:
    pytest.importorskip("numba_cuda", reason="needs numba-cuda: pip install -e '.[gpu]'")
    cracks = importlib.import_module("bondem.solve.cracks_cuda")
    pair = bd.Particles([[0.4, 0.5, 0.5], [1.5, 0.5, 0.5]], 0.3, shape=bd.Box((2, 1, 1)))
    body = bd.connect(pair, method="laguerre")
    failure = bd.StressCriterion(largest, tension=1e5)
    model = bd.Model(body, bd.CellBond(E=1e7, nu=0.2), 1000.0, failure=failure)
    with pytest.raises(InputError, match="cannot compile the function of the criterion for CUDA"):
        cracks.judging_of(model)
    good = bd.Model(body, bd.CellBond(E=1e7, nu=0.2), 1000.0, failure=bd.Hydrostatic(tension=1e5))
    assert cracks.judging_of(good) is not None
