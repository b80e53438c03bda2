"""Models whose bonds store something from step to step: of the incremental formulation, and of the non-local law."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

import bondem as bd
from bondem.dynamics.damping import AnyDamping
from bondem.dynamics.plan import Plan
from bondem.model.highest_frequency import highest_frequency
from bondem.model.state import State
from tests import lagged_runs
from tests.core.test_steps import GAUGES, HELD, LAWS, crooked
from tests.specimens import crooked_cells

X_MIN, X_MAX = bd.Face("x_min", depth=0.5), bd.Face("x_max", depth=0.5)
GRAVITY = [bd.Fix(X_MIN), bd.BodyForce(acceleration=(0.0, 0.0, -9.81))]


SHEARED = bd.MohrCoulomb(tension=3e5, cohesion=1e5, friction_angle=0.6)
PULLED = bd.Rankine(tension=5e4)
WEAK = bd.MohrCoulomb(tension=1e5, cohesion=4e4, friction_angle=0.6)


def stored(name: str) -> bd.Model:
    """A model of beams of the incremental formulation, of the law of a name."""
    law = replace(LAWS[name], formulation="incremental")
    return bd.Model(crooked((5, 2, 3)), law, density=1e3, boundary=HELD)


def periodic_beams() -> bd.Model:
    """A periodic cell of such beams."""
    cell = bd.Cell((1.0, 1.0, 1.0))
    lattice = bd.connect(bd.pack(cell, count=150, spread=0.25, seed=1), reach=1.1)
    law = bd.Timoshenko(E=1e9, nu=0.2, radius_ratio=0.5, formulation="incremental")
    return bd.Model(lattice, law, density=1e3)


def non_local_cells(failure: bd.Criterion | None = None) -> bd.Model:
    """A box of Laguerre cells with the non-local law, held and loaded."""
    body = crooked_cells((8, 5, 5), edge=0.5)
    return bd.Model(body, bd.NonLocal(E=1e7, nu=0.2), density=1e3, boundary=HELD, failure=failure)


def non_local_spheres(failure: bd.Criterion | None = None) -> bd.Model:
    """A lattice of spheres with weighted areas, under its weight."""
    law = bd.NonLocal(E=1e7, nu=0.25, areas="weighted")
    return bd.Model(crooked((6, 5, 5)), law, density=1e3, boundary=GRAVITY, failure=failure)


def touching_spheres(failure: bd.Criterion | None = None, *, weight: float = 100.0, damping: float = 0.1) -> bd.Model:
    """A lattice of spheres on a plane and below a cylinder, and loose spheres that fall onto it."""
    own = crooked((4, 4, 3)).particles
    return lagged_runs.touching_spheres(own, failure, weight=weight, damping=damping)


def non_local_period(**options) -> bd.Model:
    """A periodic cell of Laguerre cells with the non-local law."""
    body = bd.connect(bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=150, spread=0.25, seed=1), method="laguerre")
    return bd.Model(body, bd.NonLocal(E=40e9, nu=0.2, **options), density=2400.0)


CASES: dict[str, tuple[Callable[[], bd.Model], AnyDamping | None]] = {
    "stored, Timoshenko": (lambda: stored("Timoshenko"), None),
    "stored, Euler–Bernoulli, local damping": (lambda: stored("Euler–Bernoulli"), bd.LocalDamping(0.1)),
    "stored, parallel, bond damping": (lambda: stored("parallel"), bd.BondDamping(eta=0.1)),
    "stored, periodic": (periodic_beams, None),
    "non-local, cells": (non_local_cells, bd.BondDamping(eta=0.1)),
    "non-local, not limited, contact": (
        lambda: non_local_period(limited=False, lever="contact"), bd.LocalDamping(0.2)
    ),
    "non-local, spheres": (non_local_spheres, bd.BondDamping(eta=0.2)),
    "non-local, periodic": (non_local_period, None),
    "non-local, spheres that touch": (touching_spheres, bd.BondDamping(eta=0.1)),
    "non-local, spheres that break and touch": (
        lambda: touching_spheres(WEAK, weight=400.0), bd.BondDamping(eta=0.1)
    ),
    "non-local, cells that break": (lambda: non_local_cells(SHEARED), bd.BondDamping(eta=0.1)),
    "non-local, spheres that break": (lambda: non_local_spheres(PULLED), bd.LocalDamping(0.1)),
}  # fmt: skip


def plan_and_state(
    model: bd.Model, damping: AnyDamping | None, *, steps: int = 240, every: int = 20, share: float = 0.3
) -> tuple[Plan, State]:
    """How a model runs, at a share of the critical step of its springs, and where it begins: in motion."""
    dt = share * 2.0 / highest_frequency(model)
    state, rng = State(model), np.random.default_rng(7)
    speed = 1e-3 * model.lattice.particles.mean_radius / dt
    state.set_motion(velocity=speed * rng.uniform(-1.0, 1.0, (len(state.pose), 3)))
    gauges = GAUGES if len(model.constraints.element) else {}
    return Plan(duration=steps * dt, dt=dt, every=every, damping=damping, gauges=gauges), state
