"""The stable time step of the non-local law, found by trial steps of its lagged operator.

ω_max of the springs is not a bound: a stress that is one step old drives the fastest motions, the more so the larger
ν is. Undamped, the lag adds energy at any step; dashpots or local damping remove it, up to some ν.
"""

import math

import numpy as np

from bondem._types import Floats
from bondem.dynamics.damping import DampingTerms
from bondem.model.model import Model
from bondem.observables.non_local_strain import NonLocalStrain

#: Shares of the critical step of the springs that are tried.
SHARES = (1.0, 0.5, 0.25, 0.125, 0.0625)
# Steps of a trial, and the growth of its motion over the last half of them that is taken for stable.
_STEPS, _GROWTH = 400, 1.2


def stable_share(model: Model, critical: float, terms: DampingTerms) -> float:
    """Return the largest of `SHARES` of a step [s] at which small motions do not grow; 0 if there is none."""
    for share in SHARES:
        if growth(model, share * critical, terms) <= _GROWTH:
            return share
    return 0.0


def growth(model: Model, dt: float, terms: DampingTerms, *, steps: int = _STEPS) -> float:
    """Return the growth of small motions over the last half of a number of steps [-], infinite beyond numbers.

    Local and bond damping act; the motions start from a fixed random field and nothing is held.
    """
    lattice, n = model.lattice, len(model.lattice.particles)
    constants = model.non_local_constants
    weight = np.repeat(np.column_stack([model.mass, model.inertia]), 3, axis=1)
    motion = np.zeros((n, 6))
    speed = np.random.default_rng(0).standard_normal((n, 6)) / np.sqrt(weight)
    speed -= speed.mean(axis=0)
    along, across = _dashpots(model, terms)
    now = NonLocalStrain.none(lattice, constants)
    sizes: list[float] = []
    for k in range(steps):
        motion = motion + dt * speed
        extra = now.lagged().extra if k else now.extra
        now = NonLocalStrain(lattice, constants, now.gap, extra).moved(motion)
        force = now.force
        if terms.eta > 0.0 or terms.beta > 0.0:
            rate = now.moved(speed).gap
            inward = (rate * constants.normal).sum(axis=1)[:, None] * constants.normal
            force = force + along[:, None] * inward + across[:, None] * (rate - inward)
        load = now.nodal(force)
        load -= terms.gamma * np.abs(load) * np.sign(speed)
        speed = speed + dt * load / weight
        sizes.append(float((weight * speed**2).sum()))
        if not sizes[-1] < 1e30 * max(sizes[0], 1e-300):
            return math.inf
    quarter = steps // 4
    middle, end = max(sizes[quarter : 2 * quarter]), max(sizes[3 * quarter :])
    return end / middle if middle > 0.0 else 0.0


def _dashpots(model: Model, terms: DampingTerms) -> tuple[Floats, Floats]:
    """Return cn and cs of the bonds [N·s/m], in the form of `BondDamping`."""
    i, j = model.lattice.pairs.T
    c, mass = model.non_local_constants, model.mass
    pair = mass[i] * mass[j] / (mass[i] + mass[j])
    cn, cs = (2.0 * terms.eta * np.sqrt(k * pair) + terms.beta * k for k in (c.kn, c.kt))
    return cn, cs
