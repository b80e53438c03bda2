"""Criteria on a stress tensor in the layout of the core: built-in criteria, and functions of a user.

`core/tables/damage_tables.hpp` declares types and shapes.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from bondem._core import run_pass
from bondem._core_functions import StressCallback
from bondem._passes import StepEntry, calls, steps
from bondem._tables.columns import BONDS_OF_PORTION
from bondem._tables.damage_tables import StressCandidates, StressFunction
from bondem._types import Floats


def new_stress_candidates(m: int) -> StressCandidates:
    """Return an empty table of candidates among m bonds, whose memory is used only as candidates are written."""
    portions = -(-m // BONDS_OF_PORTION)
    return StressCandidates(
        np.empty(m, dtype=np.int64), np.empty((m, 3, 3)), np.empty(m), np.zeros(portions, dtype=np.int64),
        np.zeros(1, dtype=np.int64),
    )  # fmt: skip


#: Names of the criteria on a stress: two of the core, and "function" for that of a user.
STRESS_CRITERIA = ("mean_stress", "cone", "function")


@dataclass(frozen=True, eq=False)
class StressPasses:
    """Criterion on stresses, with the passes that evaluate it.

    Attributes:
        name: one of `STRESS_CRITERIA`.
        table: address of the function, 0 for a criterion of the core, and parameters.
        callback: Python function at that address, or None.
    """

    name: str
    table: StressFunction
    callback: StressCallback | None = None

    @classmethod
    def of(cls, function: Callable[..., Any] | int | str, parameters: Sequence[float]) -> "StressPasses":
        """Return the passes of a criterion.

        Args:
            function: name of a criterion of the core in `STRESS_CRITERIA`; function of stresses (k, 3, 3) [Pa] and of
                each parameter that returns k indices [-]; or the address of a C function
                `void f(int64_t count, const double *stress, const double *parameter, double *index)`.
            parameters: parameters of the criterion, in order.
        """
        given = np.array(parameters, dtype=float)
        if isinstance(function, str):
            return cls(function, StressFunction(0, given))
        if isinstance(function, int):
            return cls("function", StressFunction(function, given))
        callback = StressCallback(function, len(given))
        return cls("function", StressFunction(callback.address, given), callback)

    def step_pass(self, candidates: StressCandidates) -> StepEntry:
        """Return the pass of a step that evaluates `candidates`, with its tables."""
        return steps.INDEX_CANDIDATES_BY[self.name](candidates, self.table)

    def indices(self, stress: Floats) -> Floats:
        """Return the indices of stresses (k, 3, 3) [Pa], (k,); raise the error that a user's function raises."""
        found = stress_indices(self.name, stress, self.table)
        self.check()
        return found

    def check(self) -> None:
        """Raise the error that a function of Python has raised in a step."""
        if self.callback is not None:
            self.callback.check()


def stress_indices(name: str, stress: Floats, table: StressFunction) -> Floats:
    """Return the indices of symmetric stresses [-], (k,), 0 where a function of Python raises an error.

    Args:
        name: one of `STRESS_CRITERIA`.
        stress: stresses [Pa], (k, 3, 3).
        table: address and parameters of the criterion.
    """
    candidates = new_stress_candidates(len(stress))._replace(stress=np.ascontiguousarray(stress, dtype=float))
    run_pass(calls.INDEX_STRESSES_BY[name](candidates, table))
    return candidates.found
