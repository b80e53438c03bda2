"""Damping of the elements' own motion."""

import math
from dataclasses import dataclass

from bondem._compile import device
from bondem.errors import InputError


@dataclass(frozen=True)
class LocalDamping:
    """Each component of force and torque is reduced against the motion: F_i - γ |F_i| sign(v_i).

    It vanishes in equilibrium and where the net force does, and does not depend on the mass; it has no
    counterpart in a real material. Reference: Chen et al. (2022) eqs (11), (12), whose printed F U/U is F.

    Attributes:
        gamma: damping coefficient γ [-], in [0, 1).
    """

    gamma: float

    def __post_init__(self) -> None:
        if not 0.0 <= self.gamma < 1.0:
            raise InputError(f"LocalDamping: gamma = {self.gamma}; give a coefficient in [0, 1)")


@device
def local_damping(force, velocity, gamma):
    """One component of force [N] or torque [N·m], damped."""
    if velocity > 0.0:
        return force - gamma * math.fabs(force)
    if velocity < 0.0:
        return force + gamma * math.fabs(force)
    return force
