"""The study of Brazilian discs reads the strength at the first maximum, from forces of both flats."""

import math
from typing import Any, cast

import numpy as np
import pytest

import bondem as bd
from validation.cases import flattened_disc
from validation.studies import brazilian


class Ran:
    """A run whose solver was replaced: forces of both flats [N] and what a study reads beside them."""

    def __init__(self, top: np.ndarray, bottom: np.ndarray) -> None:
        self.history = {"top": _along_y(-top), "bottom": _along_y(bottom)}
        self.residual, self.events, self.status = 0.0, [], bd.Status.COMPLETED
        self.state = type("State", (), {"slipped": np.zeros(3), "cracks": ()})


def _along_y(force: np.ndarray) -> np.ndarray:
    return np.stack([np.full_like(force, np.nan), force, np.full_like(force, np.nan)], axis=1)


def test_strength_is_the_mean_of_both_flats_at_the_peak(monkeypatch) -> None:
    top, bottom = np.array([0.0, 4e3, 6e3, 5e3]), np.array([0.0, 3e3, 5e3, 5e3])
    monkeypatch.setattr(brazilian, "pressed", lambda body, failure: Ran(top, bottom))
    found = brazilian.measured(cast(bd.Lattice, None), 20.0)
    assert found["peak"] == 5.5e3
    assert found["strength"] == pytest.approx(5.5e3 / brazilian.EXPECTED)
    assert found["asymmetry"] == pytest.approx(1.0 / 5.5)


def test_a_run_ends_behind_the_first_maximum_that_the_load_leaves_by_a_tenth(monkeypatch) -> None:
    """A load that recovers from a fall by less is no maximum; one far below the expected load neither."""
    given: dict[str, Any] = {}
    monkeypatch.setattr(bd, "Model", lambda *args, **more: None)
    monkeypatch.setattr(bd, "solve_explicit", lambda model, **more: given.update(more))
    brazilian.pressed(cast(bd.Lattice, None), bd.Rankine(tension=4e6))
    steps = np.array([0.4, 0.3, 1.0, 0.91, 1.1, 0.98, 1.3])
    ended = [
        given["callback"](None, {"top": _along_y(-brazilian.EXPECTED * steps[: n + 1])}) for n in range(len(steps))
    ]
    assert ended == [False, False, False, False, False, True, False]


def test_stress_at_the_centre_of_a_flattened_disc_is_that_of_a_whole_one_without_flats(monkeypatch) -> None:
    monkeypatch.setattr(flattened_disc, "HALF", 1e-6)
    assert brazilian.DISC.factor == pytest.approx(1.0)
    monkeypatch.setattr(flattened_disc, "HALF", math.radians(10.0))
    assert brazilian.DISC.factor == pytest.approx(0.960, abs=5e-4)
