"""Runs of cells that fail, on the CPU and in the simulator of a device, and how far they are apart."""

from pathlib import Path

import numpy as np

from bondem.kernels.tables import BROKEN_BOND, BROKEN_MODE, BROKEN_STEP, BROKEN_TIME, FRACTURE
from tests.test_gpu import SIMULATOR, run

Arrays = dict[str, np.ndarray]
# Of the largest value: what sums in another order leave.
_CLOSE = 1e-12


def apart(expected: np.ndarray, found: np.ndarray) -> float:
    """The largest difference over the largest value."""
    assert expected.shape == found.shape
    largest = np.abs(expected).max(initial=0.0)
    return float(np.abs(found - expected).max(initial=0.0) / (largest or 1.0))


def same_breaks(log: np.ndarray, other: np.ndarray) -> list[float]:
    """Assert that the same has broken at the same time; how far each column is apart.

    Within a step the order of events has no meaning: the core has that of the facets, the device that of the cracks.
    """
    assert len(log) >= 2
    log, other = (rows[np.lexsort((rows[:, BROKEN_BOND], rows[:, BROKEN_STEP]))] for rows in (log, other))
    for column in (BROKEN_STEP, BROKEN_BOND, BROKEN_MODE, BROKEN_TIME):
        np.testing.assert_array_equal(log[:, column], other[:, column])
    return [apart(log[:, c], other[:, c]) for c in range(log.shape[1])]


def three_sides(script: str, folder: Path) -> tuple[Arrays, Arrays, Arrays]:
    """What a script leaves on the CPU, in the simulator, and on the CPU from half a run of the simulator."""
    cpu, gpu, back, bodies = (str(folder / name) for name in ("cpu", "gpu", "back", "bodies"))
    run(script, "cpu", f"{cpu}.npz", bodies, "", f"{cpu}.pkl")
    run(script, "gpu", f"{gpu}.npz", bodies, f"{cpu}.pkl", f"{gpu}.pkl", **SIMULATOR)
    run(script, "cpu", f"{back}.npz", bodies, f"{gpu}.pkl", f"{back}.pkl")
    with np.load(f"{cpu}.npz") as one, np.load(f"{gpu}.npz") as other, np.load(f"{back}.npz") as third:
        return dict(one), dict(other), dict(third)


def two_and_back(script: str, folder: Path) -> tuple[Arrays, Arrays, Arrays]:
    """The same of a script of beams, which needs no bodies."""
    cpu, gpu, back = (str(folder / name) for name in ("cpu", "gpu", "back"))
    run(script, "cpu", f"{cpu}.npz", "", f"{cpu}.pkl")
    run(script, "gpu", f"{gpu}.npz", f"{cpu}.pkl", f"{gpu}.pkl", **SIMULATOR)
    run(script, "cpu", f"{back}.npz", f"{gpu}.pkl", f"{back}.pkl")
    with np.load(f"{cpu}.npz") as one, np.load(f"{gpu}.npz") as other, np.load(f"{back}.npz") as third:
        return dict(one), dict(other), dict(third)


def ends_alike(expected: Arrays, found: Arrays, case: str, as_case: str, fields: tuple[str, ...]) -> None:
    """Assert that a case has broken the same facets at the same times as another, and ended alike."""
    assert expected[f"{as_case}/end"].tolist() == found[f"{case}/end"].tolist()
    missed = same_breaks(expected[f"{as_case}/broken"], found[f"{case}/broken"])
    missed += [apart(expected[f"{as_case}/{field}"], found[f"{case}/{field}"]) for field in fields]
    # the work of walls is booked with the rows of their cells
    missed.append(apart(expected[f"{as_case}/work"].sum(), found[f"{case}/work"].sum()))
    assert max(missed) < _CLOSE


def records_alike(expected: Arrays, found: Arrays, case: str) -> None:
    """Assert that the energies and readings of a case are those of the other side."""
    records, others = expected[f"{case}/records"], found[f"{case}/records"]
    scale = np.abs(records).max(axis=0, initial=0.0)
    scale[1 : FRACTURE + 1] = scale[1 : FRACTURE + 1].max(initial=0.0)
    assert np.abs((others - records) / np.where(scale, scale, 1.0)).max(initial=0.0) < _CLOSE
