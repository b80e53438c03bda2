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
    if len(model.lattice.pairs) == 0:
        return 0.0
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
    """The largest stable time step of a scheme on a model [s]; infinite without bonds and contacts.

    Local damping raises a force that decelerates by 1 + γ, and with it the effective stiffness; dashpots of contacts
    lower the limit by √(1 + ζ²) - ζ, with ζ = ω c / 2 k.
    """
    raised = 1.0 if damping is None else math.sqrt(1.0 + damping.gamma)
    bonds = highest_frequency(model)
    motions = [(0.0, 0.0)]  # further ones than those of bonds, and their dashpots
    if model.contacts is not None:
        motions += model.contacts.law.stiffest(
            model.lattice.particles.radius, model.mass, model.contacts.walls.servo_mass
        )
    limits = [math.inf]
    for frequency, delay in motions:
        omega = raised * math.hypot(bonds, frequency)
        if omega > 0.0:
            zeta = 0.5 * omega * delay
            limits.append(scheme.critical / omega * (math.sqrt(1.0 + zeta * zeta) - zeta))
    return min(limits)


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
