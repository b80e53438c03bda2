"""Displacement gradient of the affine field closest to the displacements of points."""

import numpy as np

from bondem._types import PerElement3


def gradient_weights(position: PerElement3) -> PerElement3:
    """Return weights w of points [1/m], (n, 3), with the fitted ∂u_i/∂x_j = Σ w_j u_i over all points."""
    return np.linalg.pinv(position - position.mean(axis=0)).T
