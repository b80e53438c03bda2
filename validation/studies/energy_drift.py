"""Energy of the freely vibrating silica cylinder: its error over a long run, and that it goes with the square of dt.

A free cylinder is set to bend, stretch and twist, and let go. The error of the total energy over that at the start
swings with the vibration, with an amplitude that goes as dt². It may drift, which a symplectic scheme does not, and
it takes the random walk of rounding. The slope is fitted to means over blocks of the run, so that swinging drops out,
and is given with its standard error: a drift is a slope of several errors.
"""

import math
from typing import Any

import numpy as np

import bondem as bd
from bondem.dynamics.timestep import critical_step
from bondem.model.state import State
from validation.frame.record import Record
from validation.measures.jittered_cylinder import cylinder

SILICA = bd.Material("fused silica", E=72.5e9, nu=0.17, rho=2201.0)
LAW = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.5)
SHARES = (0.8, 0.4, 0.2)
BLOCKS = 50


def let_go(model: bd.Model, strain: float) -> State:
    """Smooth velocities that stretch, bend and twist, of a kinetic energy that strains by about `strain`."""
    x, y, z = (model.lattice.particles.position - [20e-3, 0.0, 0.0]).T / 20e-3
    speed = strain * math.sqrt(SILICA.E / SILICA.rho)
    along = np.sin(0.5 * np.pi * x)
    across = np.cos(2.365 * x) + 0.1329 * np.cosh(2.365 * x)  # free-free bending, λ = 4.730
    velocity = speed * np.column_stack([along, across - along * z, along * y])
    state = State(model)
    state.set_motion(velocity=velocity * model.lattice.connected[:, None])
    return state


def error(model: bd.Model, start: State, dt: float, steps: int, every: int) -> tuple[np.ndarray, np.ndarray]:
    """Time over dt, and total energy over that at the start less one."""
    run = bd.solve_explicit(model, duration=steps * dt, dt=dt, every=every, state=start.copy())
    if run.steps != steps:
        raise SystemExit(run.message)
    energy = run.history.energy
    total: Any = sum(energy[name] for name in ("translation", "rotation", "normal", "shear", "bending", "twisting"))
    return run.history.time / dt, total / total[0] - 1.0


def slope(step: np.ndarray, values: np.ndarray) -> tuple[float, float]:
    """Of the means over blocks of the run: change a step, and its standard error."""
    blocks = min(BLOCKS, len(step) // 2)
    x = np.array([part.mean() for part in np.array_split(step, blocks)])
    y = np.array([part.mean() for part in np.array_split(values, blocks)])
    x -= x.mean()
    a = float(x @ y / (x @ x))
    left = y - y.mean() - a * x
    return a, math.sqrt(float(left @ left) / max(blocks - 2, 1) / float(x @ x))


def measure(
    record: Record, *, elements: int = 10_000, steps: int = 1_000_000, order_steps: int = 20_000, records: int = 2000,
    strain: float = 1e-4,
) -> None:  # fmt: skip
    """Measure the order of the error, and its drift over a long run.

    Args:
        elements: of the cylinder.
        steps: of the long run.
        order_steps: of the largest of three time steps.
        records: of the energy in the long run.
        strain: with which the cylinder starts.
    """
    model = bd.Model(cylinder(elements), LAW, density=SILICA.rho)
    critical = critical_step(model, bd.VelocityVerlet())
    start = let_go(model, strain)

    swings = []
    for k, share in enumerate(SHARES):
        some = order_steps * 2**k
        _, values = error(model, start, share * critical, some, max(1, some // 500))
        swings.append(float(np.std(values)))
    orders = np.log2(np.array(swings[:-1]) / swings[1:])

    step, values = error(model, start, SHARES[0] * critical, steps, max(1, steps // records))
    per_step, uncertain = slope(step, values)
    result = {
        "elements": len(model.mass),
        "steps": steps,
        "orders": orders.tolist(),
        "largest error": float(np.abs(values).max()),
        "drift over the run": per_step * steps,
        "drift, in its standard errors": per_step / uncertain,
    }
    record.keep(**result)
