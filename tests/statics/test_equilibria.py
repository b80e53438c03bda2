"""Equilibria that are not found: a path is kept, and a preconditioner is made anew."""

from dataclasses import replace

import numpy as np
import pytest

from bondem.errors import ConvergenceError
from bondem.statics.linear import Iteration, System
from bondem.statics.quasistatic.damaged_body import DamagedBody
from bondem.statics.quasistatic.equilibrium import Eliminated, Iterated
from tests.models import follow, pulled
from tests.specimens import uneven_bar


def test_a_body_without_equilibrium_keeps_its_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """What was found before is given back; a body that never had an equilibrium is an error."""
    whole = follow(pulled(uneven_bar(60)), most=12)
    solve, left = Eliminated.solve, [8]

    def sometimes(self: Eliminated, right: np.ndarray, guess: np.ndarray, energy: float = 0.0) -> np.ndarray:
        left[0] -= 1
        if left[0] < 0:
            raise ConvergenceError("it did not converge")
        return solve(self, right, guess)

    monkeypatch.setattr(Eliminated, "solve", sometimes)
    found = follow(pulled(uneven_bar(60)), most=12)
    assert found.end == "loose"
    assert 4 <= len(found.load) <= 8
    np.testing.assert_array_equal(found.load, whole.load[: len(found.load)])
    with pytest.raises(ConvergenceError):
        follow(pulled(uneven_bar(60)))


def test_a_stale_preconditioner_is_made_anew() -> None:
    """One that is good for nothing is thrown away, and the next one finds the equilibrium."""
    model = pulled(uneven_bar(200))
    system = System.of(replace(model, failure=None))
    begun = Iteration(system)
    body = DamagedBody(model, system, begun.root)
    equilibrium = Iterated(body.system, body.matrix, begun, body.integrity)
    still = np.zeros(6 * len(model.layout.order))
    right = body.right - body.pull
    first = equilibrium.solve(right, still)
    begun.coarse = lambda residual: -3.0 * residual  # type: ignore[assignment]
    again = equilibrium.solve(right, still)
    # both to a residual of 1e-6 only
    np.testing.assert_allclose(again, first, atol=2e-3 * np.abs(first).max())
