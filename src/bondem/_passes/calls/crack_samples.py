"""Passes that Python calls, of `core/passes/cracks/crack_samples.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.crack_sample_tables import CrackSamples, SofteningSamples, StressBoundSamples, YieldSamples


def evaluate_cracks(crack_samples: CrackSamples) -> Call:
    """Evaluates the law of cracks in samples, by single numbers or by lanes."""
    return Call("evaluate_cracks", (crack_samples,))


def evaluate_softening(softening_samples: SofteningSamples) -> Call:
    """Evaluates the softening of facets in samples, by single numbers or by lanes."""
    return Call("evaluate_softening", (softening_samples,))


def evaluate_stress_bounds(stress_bound_samples: StressBoundSamples) -> Call:
    """Evaluates bounds of principal stresses in samples, by single numbers or by lanes."""
    return Call("evaluate_stress_bounds", (stress_bound_samples,))


def evaluate_yielding(yield_samples: YieldSamples) -> Call:
    """Evaluates the flow of yielding cells in samples, by single numbers or by lanes."""
    return Call("evaluate_yielding", (yield_samples,))
