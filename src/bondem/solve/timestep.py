"""The stable time step, from the highest frequency of the assembled lattice."""

import math
from typing import Any

import numpy as np
from scipy.sparse import diags_array
from scipy.sparse.linalg import aslinearoperator, eigsh

from bondem.errors import UnstableStepError
from bondem.laws.damping import LocalDamping
from bondem.model.matrices import mass_diagonal, stiffness_matrix
from bondem.model.model import Model
from bondem.solve.schemes import Scheme

# Lanczos approaches ω_max from below; its answer is raised by this much.
_TOLERANCE = 1e-3


def highest_frequency(model: Model) -> float:
    """ω_max of the unconstrained lattice at rest [rad/s]: a bound for every set of supports.

    Lanczos on M^-½ K M^-½, started from a fixed vector.
    """
    scale = 1.0 / np.sqrt(mass_diagonal(model))
    K = stiffness_matrix(model)
    n = len(scale)
    if n <= 120:
        dense = K.toarray() * scale[:, None] * scale
        return math.sqrt(np.linalg.eigvalsh(dense)[-1])
    operator = aslinearoperator(diags_array(scale)) @ aslinearoperator(K) @ aslinearoperator(diags_array(scale))
    start = np.random.default_rng(0).standard_normal(n)
    tolerance: Any = _TOLERANCE  # the stubs of SciPy take it for an integer
    top = eigsh(operator, k=1, which="LM", v0=start, tol=tolerance, return_eigenvectors=False)
    return math.sqrt((1.0 + 2.0 * _TOLERANCE) * float(top[0]))


def critical_step(model: Model, scheme: Scheme, damping: LocalDamping | None = None) -> float:
    """The largest stable time step of a scheme on a model [s]; infinite without bonds.

    Local damping raises a force that decelerates by 1 + γ, and with it the effective stiffness.
    """
    frequency = highest_frequency(model)
    if damping is not None:
        frequency *= math.sqrt(1.0 + damping.gamma)
    return scheme.critical / frequency if frequency > 0.0 else math.inf


def choose_step(
    model: Model, scheme: Scheme, dt: float | None, *, safety: float, damping: LocalDamping | None = None
) -> float:
    """The time step to use [s]: the given one if it is stable, else `safety` times the critical one.

    Raises:
        UnstableStepError: dt is not positive or above the critical step.
    """
    critical = critical_step(model, scheme, damping)
    if dt is None:
        if math.isinf(critical):
            raise UnstableStepError("the lattice has no stiffness to derive a time step from; pass dt= in seconds")
        return safety * critical
    if not (math.isfinite(dt) and dt > 0.0):
        raise UnstableStepError(f"dt = {dt} s; pass a positive time step, or dt=None for the best stable one")
    if dt > critical:
        raise UnstableStepError(
            f"dt = {dt:.4g} s exceeds the critical {critical:.4g} s of this lattice; pass dt=None or a smaller dt"
        )
    return dt
