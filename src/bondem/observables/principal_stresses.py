"""Principal stresses and the stress of von Mises."""

import numpy as np

from bondem._checks import array
from bondem._types import ArrayLike, Floats
from bondem.errors import InputError


def principal_stresses(stress: ArrayLike) -> Floats:
    """Compute the principal stresses σ1 ≥ σ2 ≥ σ3, tension positive [Pa], shape (…, 3).

    Args:
        stress: symmetric stress tensors [Pa], (…, 3, 3), such as `StaticResult.stress` or those of `bd.cell_stress`.

    Raises:
        InputError: The tensors have another shape, are not symmetric, or are not finite.
    """
    return np.asarray(np.linalg.eigvalsh(_symmetric("principal_stresses", stress))[..., ::-1], dtype=float)


def von_mises_stress(stress: ArrayLike) -> Floats:
    """Compute the stress of von Mises, √(3/2 s:s) with the deviator s of σ [Pa], shape (…,).

    Args:
        stress: symmetric stress tensors [Pa], (…, 3, 3).

    Raises:
        InputError: The tensors have another shape, are not symmetric, or are not finite.
    """
    given = _symmetric("von_mises_stress", stress)
    deviator = given - np.trace(given, axis1=-2, axis2=-1)[..., None, None] / 3.0 * np.eye(3)
    return np.sqrt(1.5 * (deviator**2).sum(axis=(-2, -1)))


def _symmetric(owner: str, stress: ArrayLike) -> Floats:
    given = array(owner, "stress", stress, wanted="stress tensors of shape (n, 3, 3) in Pa")
    if given.shape[-2:] != (3, 3):
        raise InputError(f"{owner}: stress has shape {given.shape}; give tensors of shape (n, 3, 3)")
    if not np.isfinite(given).all():
        raise InputError(f"{owner}: stress has values that are not finite; give those of an equilibrium")
    turned = np.swapaxes(given, -1, -2)
    if np.abs(given - turned).max(initial=0.0) > 1e-6 * np.abs(given).max(initial=0.0):
        raise InputError(f"{owner}: stress is not symmetric; give ElementStress.symmetric, or (σ + σᵀ) / 2")
    return 0.5 * (given + turned)
