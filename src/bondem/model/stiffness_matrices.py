"""Matrices of a model at rest: stiffness and mass, in internal order."""

import numpy as np

from bondem._types import Floats
from bondem.interactions.stiffness import Stiffness
from bondem.model.model import Model


def stiffness_matrix(model: Model) -> Stiffness:
    """Return the stiffness K of the unconstrained lattice: 6×6 blocks, (u, θ) per element, internal order.

    It is the second derivative of the energy at rest; for bonds it is the same for both formulations. Of a law that
    has no potential it is that of its springs alone.
    """
    return model.interaction.stiffness()


def mass_diagonal(model: Model) -> Floats:
    """Return the diagonal of the mass matrix: m, m, m, I, I, I per element [kg, kg·m²], internal order, (6 n,)."""
    order = model.layout.order
    return np.stack([model.mass[order]] * 3 + [model.inertia[order]] * 3, axis=1).ravel()
