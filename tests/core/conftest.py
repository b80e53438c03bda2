"""The time steps of the loops that the core replaced."""

import json
from pathlib import Path

import numpy as np
import pytest

from bondem._types import PerElement
from bondem.model import highest_frequency
from bondem.model.model import Model


@pytest.fixture(autouse=True)
def former_frequencies(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Give tests of the former loop its ω²: of products by differences, which were 1e-6 off (decision 0067)."""
    if not hasattr(request.module, "FormerLoop") and not hasattr(request.module, "former_columns"):
        return
    former = np.array(json.loads((Path(__file__).parent / "former" / "frequencies.json").read_text()))
    exact = highest_frequency.stiffest

    def stiffest(model: Model, mass: PerElement, inertia: PerElement, **options: object) -> float:
        found = exact(model, mass, inertia, **options)  # type: ignore[arg-type]
        near = former[np.abs(former - found).argmin()]
        return float(near) if abs(near - found) <= 1e-4 * found else found

    monkeypatch.setattr(highest_frequency, "stiffest", stiffest)
