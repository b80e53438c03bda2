"""The mass matrix of a model, in internal order."""

import numpy as np

from bondem._types import Floats
from bondem.model.model import Model


def mass_diagonal(model: Model) -> Floats:
    """Return the diagonal of the mass matrix: m, m, m, I, I, I per element [kg, kg·m²], internal order, (6 n,)."""
    order = model.layout.order
    return np.stack([model.mass[order]] * 3 + [model.inertia[order]] * 3, axis=1).ravel()
