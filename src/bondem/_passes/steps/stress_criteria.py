"""Passes that steps are composed of, of `core/passes/damage/stress_criteria.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.damage_tables import StressCandidates, StressFunction


def index_candidates_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_cone", (stress_candidates, stress_function))


def index_candidates_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_function", (stress_candidates, stress_function))


def index_candidates_by_mean_stress(
    stress_candidates: StressCandidates, stress_function: StressFunction
) -> StepEntry:
    """Finds the index of each candidate by a criterion on its stress.

    Over rows of a table, in the order of the table.
    """
    return StepEntry("index_candidates_by_mean_stress", (stress_candidates, stress_function))


#: Passes `index_candidates_by_…` by the name of their criterion.
INDEX_CANDIDATES_BY = {
    "cone": index_candidates_by_cone,
    "function": index_candidates_by_function,
    "mean_stress": index_candidates_by_mean_stress,
}
