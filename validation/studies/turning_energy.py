"""Energy of a free bar of cells that turns, vibrates and breaks, with this and a former version of the cell law.

A bar of 24 by 5 by 5 cells, E = ρ = 1, turns about an inclined axis, and stretches and bends. Its tips turn at 10⁻³
of the celerity √(E/ρ), as fast as they vibrate, or at a tenth of it. Steps are of 0.9 of the critical one, and with
the first packing of half that too. Reported are, of the balance of the energy ledger (kinetic + elastic + fracture),

    largest     its largest magnitude over the energy at the start
    linear      change of linear momentum over Σ m |v| at the start
    angular     change of angular momentum over its magnitude at the start

and the number of facets that broke and began to soften. Kinds are elastic, brittle (`bd.Rankine`), softening (with a
fracture energy) and corrected (elastic, dispersion-corrected mass matrix).
"""

from functools import partial
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from validation.frame.record import Record

KINDS = "elastic", "brittle", "softening", "corrected"
SIZE, COUNT = (24.0, 5.0, 5.0), 600
AXIS = np.array([0.2, 0.4, 1.0]) / np.linalg.norm([0.2, 0.4, 1.0])
#: Speeds of the tips and strengths of facets; speed of the vibration.
TURNING = {1e-3: 1.6e-3, 0.1: 1e-2}
VIBRATING = 1e-3
SAFETIES = 0.9, 0.45
STEPS = {"elastic": 20_000, "brittle": 4000, "softening": 4000, "corrected": 20_000}
RECORDS = 1000


def start(model: bd.Model, turning: float) -> bd.State:
    """The bar turns as a whole, stretches and bends."""
    x = model.lattice.centre - model.mass @ model.lattice.centre / model.mass.sum()
    omega = turning / (0.5 * SIZE[0]) * AXIS
    along = x[:, 0] / (0.5 * SIZE[0])
    velocity = np.cross(omega, x)
    velocity[:, 0] += VIBRATING * np.sin(0.5 * np.pi * along)
    velocity[:, 1] += VIBRATING * (np.cos(2.365 * along) + 0.1329 * np.cosh(2.365 * along))
    state = model.state()
    state.set_motion(velocity=velocity, angular_velocity=np.broadcast_to(omega, x.shape))
    return state


def momenta(model: bd.Model, state: bd.State) -> tuple[np.ndarray, np.ndarray]:
    """Linear and angular momentum about the origin, (3,) each."""
    linear = model.mass[:, None] * state.velocity
    own = model.inertia[:, None] * state.angular_velocity
    return linear.sum(axis=0), (np.cross(state.position, linear) + own).sum(axis=0)


def model_of(body: bd.Lattice, nu: float, kind: str, turning: float) -> bd.Model:
    """The bar; cells of less than 2 E G_f / f_t² = 3 do not snap back."""
    strength = TURNING[turning]
    failure = {
        "brittle": bd.Rankine(tension=strength),
        "softening": bd.Rankine(tension=strength, fracture_energy=1.5 * strength**2),
    }
    options: dict[str, Any] = {"mass_matrix": "dispersion-corrected"} if kind == "corrected" else {}
    return bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, failure=failure.get(kind), **options)


def measured(model: bd.Model, turning: float, safety: float, steps: int) -> dict[str, float]:
    """Errors of one run."""
    begun = start(model, turning)
    dt = bd.solve_explicit(model, duration=0.0, safety=safety).dt
    run = bd.solve_explicit(
        model, duration=steps * dt, dt=dt, every=max(1, steps // RECORDS), state=begun, imbalance=None
    )
    if run.steps != steps:
        raise SystemExit(run.message)
    energy = run.history.energy
    balance = energy["balance"]
    whole = float(energy["translation"][0] + energy["rotation"][0])
    (p, L), (q, K) = momenta(model, begun), momenta(model, run.state)
    return {
        "largest": float(np.abs(balance).max()) / whole,
        "linear": float(np.linalg.norm(q - p) / (model.mass @ np.linalg.norm(begun.velocity, axis=1))),
        "angular": float(np.linalg.norm(K - L) / np.linalg.norm(L)),
        "broken": len(run.events), "begun": len(run.state.cracks),
    }  # fmt: skip


def measure(
    record: Record, *, name: str = "now", kinds: tuple[str, ...] = KINDS, seeds: tuple[int, ...] = (1, 2, 3),
    nus: tuple[float, ...] = (0.2, 0.4), steps: int = 0,
) -> None:  # fmt: skip
    """Measure bars; rows of several versions stand beside each other.

    Args:
        name: of the version.
        kinds: of bars.
        seeds: of the packings.
        nus: Poisson's ratios.
        steps: in place of those of each kind, unless 0.
    """
    record.keep(runs=record.data.get("runs", {}) | {" ".join([name, *kinds]): record.origin})
    for seed in seeds:
        body = bd.connect(bd.pack(bd.Box(SIZE), count=COUNT, method="even", seed=seed), method="laguerre")
        safeties = SAFETIES if seed == seeds[0] else SAFETIES[:1]
        for kind, nu, turning, safety in product(kinds, nus, TURNING, safeties):
            model = model_of(body, nu, kind, turning)
            record.add(partial(measured, model, turning, safety, steps or STEPS[kind]), "rows", name=name, kind=kind,
                       nu=nu, turning=turning, safety=safety, seed=seed)  # fmt: skip
