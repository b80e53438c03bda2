"""Passes that Python calls, of `core/passes/damage/stress_criteria.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.damage_tables import StressCandidates, StressFunction


def index_stresses_by_cone(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_cone", (stress_candidates, stress_function))


def index_stresses_by_function(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_function", (stress_candidates, stress_function))


def index_stresses_by_mean_stress(stress_candidates: StressCandidates, stress_function: StressFunction) -> Call:
    """Finds the index of each given stress; the counts of portions are not read."""
    return Call("index_stresses_by_mean_stress", (stress_candidates, stress_function))


#: Passes `index_stresses_by_…` by the name of their criterion.
INDEX_STRESSES_BY = {
    "cone": index_stresses_by_cone,
    "function": index_stresses_by_function,
    "mean_stress": index_stresses_by_mean_stress,
}
