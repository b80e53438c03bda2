"""Criteria that are functions of a stress: those of the core, and functions of a user."""

import ctypes

import numpy as np
import pytest

import bondem as bd
from bondem._core_steps import Composer
from bondem.damage.stress_passes import StressPasses, new_stress_candidates


def stresses(count: int) -> np.ndarray:
    half = np.random.default_rng(4).uniform(-1e6, 1e6, (count, 3, 3))
    return half + half.transpose(0, 2, 1)


def largest(stress: np.ndarray, tension: float) -> np.ndarray:
    return np.linalg.eigvalsh(stress)[:, 2] / tension


def mean_index(stress: np.ndarray, tension: float) -> np.ndarray:
    return (stress[:, 0, 0] + stress[:, 1, 1] + stress[:, 2, 2]) / (3.0 * tension)


def cone_index(stress: np.ndarray, slope: float, strength: float, pulled: float) -> np.ndarray:
    trace = stress[:, 0, 0] + stress[:, 1, 1] + stress[:, 2, 2]
    p = trace / 3.0
    a, b, c = stress[:, 0, 0] - p, stress[:, 1, 1] - p, stress[:, 2, 2] - p
    shear = stress[:, 0, 1] ** 2 + stress[:, 0, 2] ** 2 + stress[:, 1, 2] ** 2
    index = (np.sqrt(0.5 * (a * a + b * b + c * c) + shear) + slope * trace) / strength
    return np.where(trace <= 0.0, 0.0, index) if pulled != 0.0 else index


@pytest.mark.parametrize(
    ("name", "parameters", "index"),
    [
        ("mean_stress", (2e6,), mean_index),
        ("cone", (0.2, 3e6, 0.0), cone_index),
        ("cone", (0.2, 3e6, 1.0), cone_index),
    ],
    ids=["mean stress", "cone", "cone in tension"],
)
def test_criteria_of_the_core_are_closed_forms(name, parameters, index):
    some = stresses(50)
    found = StressPasses.of(name, parameters).indices(some)
    np.testing.assert_allclose(found, index(some, *parameters), rtol=1e-14, atol=1e-15)
    if name == "cone" and parameters[2]:
        assert (found[np.trace(some, axis1=1, axis2=2) <= 0.0] == 0.0).all()


def test_a_function_of_python_sees_all_stresses_at_once():
    calls = []

    def watched(stress: np.ndarray, tension: float) -> np.ndarray:
        calls.append(stress.shape)
        return largest(stress, tension)

    some = stresses(40)
    found = StressPasses.of(watched, (2e6,)).indices(some)
    np.testing.assert_array_equal(found, largest(some, 2e6))
    assert calls == [(40, 3, 3)]


def test_a_c_function_is_called_by_its_address():
    numbers = ctypes.POINTER(ctypes.c_double)
    kind = ctypes.CFUNCTYPE(None, ctypes.c_int64, numbers, numbers, numbers)

    @kind
    def trace(count, stress, parameter, index):
        for k in range(count):
            index[k] = (stress[9 * k] + stress[9 * k + 4] + stress[9 * k + 8]) / parameter[0]

    some = stresses(10)
    address = ctypes.cast(trace, ctypes.c_void_p).value
    assert address is not None
    found = StressPasses.of(address, (3.0,)).indices(some)
    np.testing.assert_allclose(found, np.trace(some, axis1=1, axis2=2) / 3.0, rtol=1e-14)
    own = bd.StressCriterion(address, scale=3.0)
    assert own.parameters == {"scale": 3.0}
    assert own.softening.tension == pytest.approx(3.0, rel=1e-6)
    assert own.name == f"the C function at {address:#x}"


def test_errors_of_a_function_are_raised_once():
    def wrong(stress: np.ndarray) -> np.ndarray:
        raise ZeroDivisionError(f"{len(stress)} stresses")

    passes = StressPasses.of(wrong, ())
    with pytest.raises(ZeroDivisionError, match="3 stresses"):
        passes.indices(stresses(3))
    passes.check()


def test_a_function_of_another_shape_is_an_error():
    with pytest.raises(ValueError, match="broadcast"):
        StressPasses.of(lambda stress: stress[:2, 0, 0], ()).indices(stresses(3))


def test_candidates_of_portions_are_moved_together():
    """A step evaluates the candidates of all portions of bonds in one call, in the order of the bonds."""
    m, calls = 5000, []
    candidates = new_stress_candidates(m)
    some = stresses(4)
    for place, bond, stress in zip((0, 1, 2048, 4096), (7, 30, 2100, 4999), some, strict=True):
        candidates.bond[place], candidates.stress[place] = bond, stress
    candidates.number[:] = 2, 1, 1

    def index(stress: np.ndarray) -> np.ndarray:
        calls.append(len(stress))
        return stress[:, 0, 0]

    composer = Composer()
    passes = StressPasses.of(index, ())
    entries = composer([passes.step_pass(candidates)])
    call_once(entries[0])
    assert calls == [4]
    assert candidates.total.tolist() == [4]
    assert candidates.bond[:4].tolist() == [7, 30, 2100, 4999]
    np.testing.assert_array_equal(candidates.found[:4], some[:, 0, 0])
    candidates.number[:] = 0
    call_once(entries[0])
    assert calls == [4]  # no call without candidates


def call_once(entry: np.ndarray) -> None:
    """Call a pass of rows, which does not read the turn it is called at."""
    function = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(int(entry[0]))
    turn = np.zeros(16, dtype=np.int64)
    function(turn.ctypes.data, entry[2:].ctypes.data)
