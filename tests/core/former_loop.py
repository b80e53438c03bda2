"""Numbers of the loops that the core replaced, and their comparison with those of the core.

The files in `former/` hold, for each case of a test, what the loops of commit 7776233a computed that Numba compiled:
on one thread, by the same tests with the former loop in place of the core. Of each array they hold the largest
magnitude, some entries and two weighted sums, in which every entry counts; of whole numbers a digest.

Facets that break have the numbers of a core that agreed with the former loop for 300 steps, of its first 54 steps.

The numbers are of a machine with AVX2. Where NumPy and BLAS use AVX-512 they round otherwise, so that states and time
steps differ in the last bits. Motions, cracks and local damping amplify that, to 2e-8 of spins and 1e-9 of places.
"""

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import HistoryColumn
from bondem.interactions.cells import cell_constants
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.io.older_bodies import with_corrected_normals
from bondem.model.state import State

SAMPLES = 24  #: most entries that are stored of an array
#: Factor of tolerances where NumPy rounds otherwise than where the numbers were computed.
_FOUND = np.show_config(mode="dicts")["SIMD Extensions"]["found"]
_AMPLIFIED = 1e5 if any("512" in name or name == "X86_V4" for name in _FOUND) else 1.0


def digest(*arrays: np.ndarray) -> str:
    """Return a digest of the bits of arrays; both zeros are one number."""
    parts = (np.ascontiguousarray(np.asarray(array, dtype=float) + 0.0).tobytes() for array in arrays)
    return hashlib.sha256(b"".join(parts)).hexdigest()[:24]


def sums(values: np.ndarray) -> np.ndarray:
    """Return two weighted sums along the first axis, which grow by no more than one entry does."""
    k = np.arange(len(values), dtype=float)
    weight = np.array([np.ones(len(k)), np.cos(2.0 * k + 0.5)]) / np.sqrt(max(len(k), 1))
    return weight @ values


def samples(values: np.ndarray) -> np.ndarray:
    """Return entries spread over all of them, and over all columns of a table."""
    return values[np.unique(np.linspace(0, len(values) - 1, SAMPLES).round().astype(int))] if len(values) else values


def movement(state: State) -> dict[str, np.ndarray]:
    """Return what moves in a state by name; each array has one unit, and so one scale."""
    return {
        "displacement": state.pose[:, :3] - state.rest, "cell stress": state.pose[:, 3],
        "orientation": state.pose[:, 4:], "velocity": state.motion[:, :3], "spin": state.motion[:, 4:7],
    }  # fmt: skip


def with_former_law(
    monkeypatch: pytest.MonkeyPatch, body: bd.Lattice, boundary: list[Any] | None = None
) -> bd.Lattice:
    """Return a body with the shares A w M⁻¹n of the former law, whose models lack twist at walls and gradients."""
    monkeypatch.setattr(cell_constants, "twist_at_walls", lambda S, *_: np.zeros_like(S))
    monkeypatch.setattr(GradientConstants, "of", lambda *_: GradientConstants.none())
    return with_corrected_normals(body, boundary or [])


def former_columns(records: np.ndarray) -> np.ndarray:
    """Return records without the column of crushing, which the former loop did not have."""
    return np.delete(records, HistoryColumn.CRUSHING, axis=1)


class FormerLoop:
    """Numbers of the former loop for one case of a test.

    Args:
        subject: name of the file.
        case: name of the case in it.
    """

    def __init__(self, subject: str, case: str) -> None:
        path = Path(__file__).parent / "former" / f"{subject}.json"
        self.numbers: dict[str, Any] = json.loads(path.read_text())[case]

    def assert_same(self, **arrays: np.ndarray) -> None:
        """Assert that arrays are the same to the bit."""
        for name, values in arrays.items():
            assert [len(values), digest(values)] == self.numbers[name], name

    def assert_close(self, within: float, **arrays: np.ndarray) -> None:
        """Assert that arrays differ by at most a share of their largest magnitude."""
        within *= _AMPLIFIED
        for name, values in arrays.items():
            former, flat = self.numbers[name], np.asarray(values, dtype=float).ravel()
            atol = within * max(former["size"], 1e-300)
            for found, key in ((samples(flat), "samples"), (sums(flat), "sums")):
                np.testing.assert_allclose(found, former[key], rtol=0.0, atol=atol, err_msg=f"{name}, {key}")

    def assert_records(self, within: float, records: np.ndarray, *, alike: slice = slice(1, 14)) -> None:
        """Assert that records differ by at most a share of the largest of their column, or of all alike columns.

        Last columns may be left out.
        """
        within *= _AMPLIFIED
        records = former_columns(records)
        former = {key: np.array(values)[..., : records.shape[1]] for key, values in self.numbers["records"].items()}
        scale = former["size"].copy()
        scale[alike] = scale[alike].max(initial=0.0)
        for found, key in ((records[-1], "last"), (sums(records), "sums")):
            share = np.abs(found - former[key]) / (scale + 1e-300)
            assert (share <= within).all(), f"records, {key}: {share.max():.1e}"
