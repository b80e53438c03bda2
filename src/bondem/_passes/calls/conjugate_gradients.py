"""Passes that Python calls, of `core/passes/quasistatic/conjugate_gradients.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.quasistatic_tables import ClumpCorrection, ConjugateGradients, ScaledMatrix


def conjugate_gradients(
    scaled_matrix: ScaledMatrix, clump_correction: ClumpCorrection, conjugate_gradients: ConjugateGradients
) -> Call:
    """Solves Sᵀ K S x = f by conjugate gradients from a guess, preconditioned by clumps; returns 0 if converged,
    else 1.
    """
    return Call("conjugate_gradients", (scaled_matrix, clump_correction, conjugate_gradients))
