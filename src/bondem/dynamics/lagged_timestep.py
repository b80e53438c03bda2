"""Stable time step of laws whose forces lag one step behind, found by trial steps of small motions.

ω_max of the springs is no bound, because a stress that is one step old drives the fastest motions, the more so the
larger ν is. Undamped, the lag adds energy at any step; dashpots or local damping remove it, up to some ν.
"""

import math
import warnings
from dataclasses import replace

import numpy as np
from scipy.sparse import diags_array

from bondem._names import users_line
from bondem._types import PerBond
from bondem.dynamics.damping import DampingTerms
from bondem.dynamics.dashpot_rate import largest_eigenvalue
from bondem.dynamics.schemes import Scheme
from bondem.errors import StepWarning
from bondem.interactions.lagged_interaction import LaggedInteraction
from bondem.model.model import Model

#: Shares of the critical step of the springs that are tried.
SHARES = (1.0, 0.5, 0.25, 0.125, 0.0625)
# Steps of a trial, and largest growth of its motion over the last half of them that counts as stable.
_STEPS, _GROWTH = 400, 1.2
# Energy over that of the first step from which on the growth of a motion counts as infinite.
_BEYOND = 1e30


def lagged_limits(
    model: Model, law: LaggedInteraction, scheme: Scheme, terms: DampingTerms, springs: float, *, matters: float
) -> tuple[float, float]:
    """Return the critical step of a law whose stress lags by one step, and its value without dashpots of bonds [s].

    The critical step is the smaller of two. One is that of springs and contacts with the dashpots of contacts. The
    other is the largest share of the step of springs and contacts at which lagged trial steps, with dashpots of
    bonds, are stable. For dashpots of contacts a bound of the eigenvalues of M⁻¹ C counts, and not the largest
    c / k, which the smallest facet would determine.

    Args:
        model: model that will move.
        law: law of its bonds.
        scheme: time integration scheme.
        terms: coefficients of damping.
        springs: ω_max of all bonds [rad/s].
        matters: factor over the critical step [-]. Only longer steps are tried without dashpots; if none of these is
            stable, the critical step is returned twice.

    Warns:
        StepWarning: Trial steps are unstable at all tried shares of the step; the least share is used.
    """
    highest, bound = _of_springs(model, law, scheme, terms, springs)
    if springs == 0.0:
        return bound, bound
    share = next((one for one in SHARES if growth(model, law, one * highest, terms) <= _GROWTH), 0.0)
    if share == 0.0:
        warnings.warn(
            f"the lagged stress of the {law.title} is unstable at any time step; give damping=, or lower nu=",
            StepWarning, stacklevel=users_line(),
        )  # fmt: skip
    limit = min((share or SHARES[-1]) * highest, bound)
    if terms.eta == terms.beta == 0.0:
        return limit, limit
    undamped = replace(terms, eta=0.0, beta=0.0)
    longer = [one * highest for one in SHARES if min(one * highest, bound) > matters * limit]
    return limit, min(bound, next((dt for dt in longer if growth(model, law, dt, undamped) <= _GROWTH), limit))


def warn_undamped(model: Model, terms: DampingTerms) -> None:
    """Issue a warning for a free undamped body, to which the lag of the stress adds energy as the body rotates.

    Warns:
        StepWarning: No element is fixed or driven, and neither local nor bond damping acts.
    """
    if not (terms.gamma or terms.eta or terms.beta or model.constraints.fixed.any()):
        warnings.warn(
            f"the lagged stress of the {model.interaction.title} adds energy to a free body that turns, which becomes"
            " unstable within some thousand steps; give damping=, such as bd.BondDamping(0.1)",
            StepWarning, stacklevel=users_line(),
        )  # fmt: skip


def _of_springs(
    model: Model, law: LaggedInteraction, scheme: Scheme, terms: DampingTerms, springs: float
) -> tuple[float, float]:
    """Return the critical step of springs and contacts, and that with the dashpots of contacts [s]."""
    raised, decay = math.sqrt(1.0 + terms.gamma), 0.0
    contacts = model.contacts
    motions = ((0.0, 0.0), *contacts.laws.stiffest(model.contact_radius, model.mass, contacts.walls.platens))
    if model.fails and contacts.own is not None:
        soft, _, beta = contacts.of_broken(model.layout)
        springs *= math.sqrt(max(1.0, float(soft.max()) * law.normal_over_shear))
        decay = _fastest_decay(model, law, contacts.own, beta, soft)
    fastest = raised * max(math.hypot(springs, frequency) for frequency, _ in motions)
    if fastest == 0.0:
        return math.inf, math.inf
    limit = math.inf
    for frequency, delay in motions:
        omega = raised * math.hypot(springs, frequency)
        if omega > 0.0:
            limit = min(limit, damped_limit(scheme, omega, raised**2 * (decay + delay * frequency**2)))
    return scheme.critical / fastest, limit


def damped_limit(scheme: Scheme, omega: float, decay: float) -> float:
    """Return the critical step [s] for an angular frequency ω [rad/s] and an eigenvalue `decay` of M⁻¹ C [1/s]."""
    zeta = 0.5 * decay / omega
    return scheme.critical / omega * (math.sqrt(1.0 + zeta * zeta) - zeta)


def _fastest_decay(model: Model, law: LaggedInteraction, kn: PerBond, beta: PerBond, soft: PerBond) -> float:
    """Return an upper bound of the largest eigenvalue of M⁻¹ C [1/s], if all bonds were contacts with dashpots."""
    if not beta.any():
        return 0.0
    layout = model.layout
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    pair = mass[layout.i] * mass[layout.j] / (mass[layout.i] + mass[layout.j])
    along = 2.0 * beta * np.sqrt(kn * pair)
    matrix = law.springs(along, np.sqrt(soft) * along)
    root = diags_array(1.0 / np.sqrt(np.repeat(np.column_stack([mass, inertia]), 3, axis=1).ravel()))
    return largest_eigenvalue(root @ matrix @ root, np.random.default_rng(0).standard_normal(6 * len(mass)))


def growth(model: Model, law: LaggedInteraction, dt: float, terms: DampingTerms) -> float:
    """Return the growth of small motions in trial steps of `dt` [s], the ratio of two values of Σ m v².

    The values are the largest of the last and of the second quarter of the steps. The ratio is infinite if motions
    overflow. Local and bond damping act. The motions start from a fixed random field, and no element is constrained.
    """
    weight = np.repeat(np.column_stack([model.mass, model.inertia]), 3, axis=1)
    speed = np.random.default_rng(0).standard_normal(weight.shape) / np.sqrt(weight)
    speed -= speed.mean(axis=0)
    i, j = model.lattice.pairs.T
    pair = model.mass[i] * model.mass[j] / (model.mass[i] + model.mass[j])  # dashpots in the form of `BondDamping`
    cn, cs = (2.0 * terms.eta * np.sqrt(k * pair) + terms.beta * k for k in (law.bonds.kn, law.bonds.ks))
    sizes = law.small_steps(speed, weight, cn, cs, dt, terms.gamma, _STEPS)
    if not sizes[-1] < _BEYOND * max(sizes[0], 1e-300):
        return math.inf
    quarter = _STEPS // 4
    middle, end = float(sizes[quarter : 2 * quarter].max()), float(sizes[3 * quarter :].max())
    return end / middle if middle > 0.0 else 0.0
