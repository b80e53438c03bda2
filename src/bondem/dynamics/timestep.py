"""Stable time step of a model, from its highest frequency and its dashpots."""

import math
import warnings
from dataclasses import dataclass, replace

import numpy as np

from bondem._names import users_line
from bondem._types import PerBond
from bondem.dynamics.damping import AnyDamping, DampingTerms
from bondem.dynamics.dashpot_rate import fastest_decay
from bondem.dynamics.lagged_timestep import damped_limit, lagged_limits, warn_undamped
from bondem.dynamics.schemes import Scheme
from bondem.errors import StepWarning, UnstableStepError
from bondem.interactions.lagged_interaction import LaggedInteraction
from bondem.model.highest_frequency import highest_frequency
from bondem.model.long_slip import long_slips
from bondem.model.model import Model

# Share of the critical step above which a given step causes a warning: deformation may raise ω_max during a run.
_WARNED = 0.9
# Factor by which dashpots lower the default step before a remark says so, and before a warning does.
_DAMPED, _MUCH = 2.0, 10.0
# Steps in which a collision is resolved. The first step of a contact changes its energy by (ω dt)² (1/6 - x (1 - x)),
# with x its phase within the step: with 20 steps a few parts in a thousand for free elements. Spheres of bodies meet
# one by one, which averages x. Cells of flat faces meet in the same step, and their errors add.
_PER_CONTACT, _PER_FACE = 20, 50


def critical_step(
    model: Model, scheme: Scheme, damping: AnyDamping | tuple[AnyDamping, ...] | None = None, *,
    integrity: PerBond | None = None,
) -> float:  # fmt: skip
    """Return the largest stable time step of a scheme on a model [s]; infinite without bonds and contacts.

    The step is also stable for contacts that form later, because every element is assumed to have as many contacts as
    possible. Local damping multiplies a decelerating force by 1 + γ, and so the effective stiffness and dashpots.
    Dashpots multiply the step by √(1 + ζ²) - ζ, with 2 ζ ω the largest eigenvalue of M⁻¹ C. Mass damping and
    absorbing boundaries do not change it. The step of a law whose stress lags by one step follows from trial steps.

    Args:
        model: model that will move.
        scheme: time integration scheme.
        damping: damping of elements and bonds.
        integrity: present integrity of the bonds (`State.integrity`), (m,); None for intact bonds.

    Raises:
        InputError: A value of `damping` is not damping, or one kind is given twice.
    """
    return _limits(model, scheme, DampingTerms.of(damping), integrity)[0]


def _limits(
    model: Model, scheme: Scheme, terms: DampingTerms, integrity: PerBond | None = None
) -> tuple[float, float]:
    """Return the critical time step, and its value without the dashpots of bonds [s]."""
    raised = math.sqrt(1.0 + terms.gamma)
    bonds, decay = highest_frequency(model, integrity=integrity), 0.0
    for slip in long_slips(model):
        bonds = max(bonds, highest_frequency(model, integrity=integrity, slips=(slip,)))
    if isinstance(model.interaction, LaggedInteraction):
        return lagged_limits(model, model.interaction, scheme, terms, bonds, matters=_DAMPED)
    damped = terms.beta * bonds**2
    if terms.eta > 0.0:
        damped += fastest_decay(model, replace(terms, beta=0.0))
    if model.fails:
        bonds, decay = _with_broken(model, bonds)
    contacts = model.contacts  # motions further than those of bonds, and their dashpots
    motions = ((0.0, 0.0), *contacts.laws.stiffest(model.contact_radius, model.mass, contacts.walls.platens))
    limit = free = math.inf
    for frequency, delay in motions:
        omega = raised * math.hypot(bonds, frequency)
        if omega > 0.0:
            lost = raised**2 * (decay + delay * frequency**2)
            limit = min(limit, damped_limit(scheme, omega, lost + raised**2 * damped))
            free = min(free, damped_limit(scheme, omega, lost))
    return limit, free


def _with_broken(model: Model, highest: float) -> tuple[float, float]:
    """Return bounds of ω_max [rad/s] and of M⁻¹ C of contacts [1/s], valid whichever bonds are broken.

    `highest` is ω_max of the intact bonds. A contact of a broken bond is at most as stiff as the bond along the
    normal. Across it the stiffer of both determines the bound, with the lever arms of the bond.
    """
    contacts = model.contacts
    if contacts.own is None or not len(contacts.own):
        return highest, 0.0
    soft, friction, beta = contacts.of_broken(model.layout)
    decay = _decay_bound(model, contacts.own, beta, soft)
    if not friction.any():
        return highest, decay
    if model.interaction.isotropic_springs:
        return highest * math.sqrt(max(1.0, float(soft.max()))), decay
    sheared = highest_frequency(model, table=model.bonds.sheared(soft * contacts.own))
    return max(highest, sheared), decay


def _decay_bound(model: Model, kn: PerBond, beta: PerBond, soft: PerBond) -> float:
    """Return a bound of the eigenvalues of M⁻¹ C [1/s] if all bonds were contacts with dashpots.

    The square of the velocity of one end against the other at a contact is at most 2 Σ (1/m + b²/I) (m v² + I ω²)
    over both ends, with their levers b. The sum of 2 c (1/m + b²/I) over the contacts of an element is therefore a
    bound of the dissipated power over twice the kinetic energy. The smallest facet would determine the largest c / k.
    """
    layout, radius = model.layout, model.contact_radius[model.layout.order]
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    i, j = layout.i, layout.j
    c = 2.0 * beta * np.sqrt(kn * np.maximum(1.0, soft) * mass[i] * mass[j] / (mass[i] + mass[j]))
    arm = model.bonds.length / (radius[i] + radius[j])
    lost = np.zeros(len(mass))
    for end in (i, j):
        across = np.where(soft > 0.0, (arm * radius[end]) ** 2 / inertia[end], 0.0)
        lost += np.bincount(end, weights=2.0 * c * (1.0 / mass[end] + across), minlength=len(mass))
    return float(lost.max())


@dataclass(frozen=True)
class Step:
    """A time step that was chosen or checked.

    Attributes:
        dt: time step [s].
        remark: remark about the choice for the message of a run; empty for none.
    """

    dt: float
    remark: str = ""


def choose_step(
    model: Model, scheme: Scheme, dt: float | None, *, safety: float,
    damping: AnyDamping | tuple[AnyDamping, ...] | None = None,
) -> Step:  # fmt: skip
    """Return a time step: the given dt [s] after a check, or a chosen one if dt is None.

    The chosen step is the share `safety` [-] of the critical one, or less to resolve short collisions.

    Raises:
        UnstableStepError: dt is not positive or exceeds the critical step, or is None without any stiffness.
        InputError: A value of `damping` is not damping, or one kind is given twice.

    Warns:
        StepWarning: The given dt is above 0.9 of the critical step, or dashpots of bonds make the default step more
            than ten times smaller, or a law whose stress lags is unstable at any step or undamped in a free body.
    """
    terms = DampingTerms.of(damping)
    critical, free = _limits(model, scheme, terms)
    if isinstance(model.interaction, LaggedInteraction):
        warn_undamped(model, terms)
    if dt is None:
        if math.isinf(critical):
            raise UnstableStepError("the lattice has no stiffness to derive a time step from; pass dt= in seconds")
        return _default_step(model, critical, free, safety)
    if not (math.isfinite(dt) and dt > 0.0):
        raise UnstableStepError(f"dt = {dt} s; pass a positive time step, or dt=None for the best stable one")
    if dt > critical:
        raise UnstableStepError(
            f"dt = {dt:.4g} s exceeds the critical {critical:.4g} s of this lattice; pass dt=None or a smaller dt"
        )
    if dt <= _WARNED * critical:
        return Step(dt)
    remark = (
        f"dt = {dt:.4g} s is {dt / critical:.3f} of the critical {critical:.4g} s, which large strains may lower;"
        f" pass dt=None or at most {_WARNED * critical:.4g} s"
    )
    warnings.warn(remark, StepWarning, stacklevel=users_line())
    return Step(dt, remark)


def _default_step(model: Model, critical: float, free: float, safety: float) -> Step:
    """Return the time step of a run without dt=, with a remark if dashpots or collisions determine it.

    Args:
        model: model that will move.
        critical: critical step [s].
        free: critical step without dashpots of bonds [s].
        safety: share of the critical step to use [-].
    """
    step, remark = safety * critical, ""
    if free > _DAMPED * critical:
        remark = (
            f"dashpots of bonds lower the time step to {step:.4g} s from {safety * free:.4g} s;"
            " BondDamping with a smaller eta= or beta= allows a longer one"
        )
        if free > _MUCH * critical:
            warnings.warn(remark, StepWarning, stacklevel=users_line())
    resolved, steps = _resolved_step(model)
    if resolved < step:
        step = resolved
        remark = (
            f"the time step {step:.4g} s resolves the shortest collision of elements or bodies with {steps} steps;"
            f" stability alone allows {safety * critical:.4g} s, as dt="
        )
    return Step(step, remark)


def _resolved_step(model: Model) -> tuple[float, int]:
    """Return the longest step that resolves collisions [s], infinite without any, and the number of steps of each.

    The collisions are those of elements without bonds, and those between several bodies. If cells do not break, only
    cells at the surface can collide.
    """
    contacts, layout, lattice = model.contacts, model.layout, model.lattice
    bonded = np.bincount(layout.i, minlength=len(layout.order)) + np.bincount(layout.j, minlength=len(layout.order))
    free = bonded[layout.rank] == 0
    touching, steps = free, _PER_CONTACT
    if len(lattice.names) > 1:
        if lattice.cells is None:
            touching = np.ones_like(free)
        else:
            steps = _PER_FACE
            touching = free | (lattice.cells.free_area > 0.0) if not model.fails else np.ones_like(free)
    if not touching.any():
        return math.inf, 0
    shortest = contacts.laws.shortest(model.contact_radius, model.mass, touching, contacts.walls.platens)
    return shortest / steps, steps
