"""Fracture energy of bodies that fly apart, at the default time step: over G_f times the broken area.

    rows     a free row of spheres with softening beams, each pair of which parts at 5.3 or 21 m/s, ± 5 % by the seed:
             3.2 and 0.8 steps per last opening 2 G_f / f_t
    blocks   a block of packed spheres whose beams have the same fracture energy in shear; it expands at these speeds
             per 5 mm, with random velocities and spins of 0.3 of them
    balls    a ball of cells that turns, its rim at 253, 405 or 1000 m/s, and bursts
    finer    the ball at 1000 m/s with shorter time steps (`safety`), and of more cells

Reported are the energy of fracture and crushing, 1 for cracks that dissipate what was entered, the largest error of
the energy balance over the kinetic energy at the start, and the number of broken beams or facets. `finer` has the
part of the energy that is crushing too, and whether the run warns that its openings take too few steps.
"""

import warnings
from functools import partial
from itertools import product
from operator import itemgetter
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import UnresolvedOpeningWarning
from validation.frame.record import Record

SEEDS = range(1, 6)
#: Numbers of elements and speeds [m/s]: of a pair of spheres that part, of the rim of a ball.
PARTING = 100.0 / 19.0, 400.0 / 19.0
CASES = {
    "rows": ((20, 40), PARTING), "blocks": ((300, 1000), PARTING), "balls": ((300, 1000), (253.0, 405.0, 1000.0)),
}  # fmt: skip
#: Cells and `safety` of balls whose rim has the largest speed.
FINER = (300, 0.9), (300, 0.4), (300, 0.1), (1000, 0.9), (1000, 0.5), (1000, 0.1), (3000, 0.9), (3000, 0.45)
PITCH, RADIUS, BALL = 5e-3, 2e-3, 10e-3


def row(count: int, seed: int, speed: float) -> tuple[bd.Model, bd.State, float, np.ndarray]:
    """A row of spheres at the start, the duration of its run, and the section of its beams over G_f^-1 [J]."""
    x = np.zeros((count, 3))
    x[:, 0] = PITCH * np.arange(count)
    spheres = bd.connect(bd.Particles(position=x, radius=np.full(count, PITCH / 2)), tolerance=0.05)
    failure = bd.PeripheralStress(tension=5e6, shear=5e6, fracture_energy=50.0)
    model = bd.Model(spheres, bd.EulerBernoulli(E=30e9, nu=0.2, radius=RADIUS), density=2400.0, failure=failure)
    apart = speed * (1.0 + 0.05 * np.random.default_rng(seed).uniform(-1.0, 1.0, count - 1))
    velocity = np.zeros((count, 3))
    velocity[1:, 0] = np.cumsum(apart)
    state = model.state()
    state.set_motion(velocity=velocity - velocity.mean(axis=0))
    return model, state, 2.0 * PITCH / speed, np.full(count - 1, 50.0 * np.pi * RADIUS**2)


def block(count: int, seed: int, speed: float) -> tuple[bd.Model, bd.State, float, np.ndarray]:
    """A block of spheres at the start, the duration of its run, and G_f times the sections of its beams [J]."""
    edge = PITCH * (count / 300.0) ** (1.0 / 3.0)
    body = bd.connect(bd.pack(bd.Box((10.0 * edge, 5.0 * edge, 5.0 * edge)), count=count, seed=seed), tolerance=0.1)
    failure = bd.PeripheralStress(tension=5e6, shear=5e6, fracture_energy=50.0, fracture_energy_shear=50.0)
    law = bd.EulerBernoulli(E=30e9, nu=0.2, radius_ratio=0.5)
    model = bd.Model(body, law, density=2400.0, failure=failure)
    rng, state = np.random.default_rng(seed), model.state()
    apart = body.centre - body.centre.mean(axis=0)
    state.set_motion(
        velocity=speed * (apart / PITCH + 0.3 * rng.normal(size=apart.shape)),
        angular_velocity=0.3 * speed / (0.5 * PITCH) * rng.normal(size=apart.shape),
    )
    radius = 0.25 * body.particles.radius[body.pairs].sum(axis=1)
    return model, state, 8e-3 / speed, 50.0 * np.pi * radius**2


def ball(count: int, seed: int, speed: float) -> tuple[bd.Model, bd.State, float, np.ndarray]:
    """A ball that turns at the start, the duration of its run, and G_f times the areas of its facets [J]."""
    body = bd.connect(bd.pack(bd.Ball(BALL), count=count, method="even", seed=seed), method="laguerre")
    failure = bd.Rankine(tension=20e6, fracture_energy=100.0)
    model = bd.Model(body, bd.CellBond(E=50e9, nu=0.2), density=2500.0, failure=failure)
    turning = np.array([0.0, 0.0, speed / BALL])
    assert body.cells is not None
    assert body.facets is not None
    centre = body.cells.volume @ body.centre / body.cells.volume.sum()
    state = model.state()
    state.set_motion(
        velocity=np.cross(turning, body.centre - centre), angular_velocity=np.broadcast_to(turning, (count, 3))
    )
    return model, state, 60e-6, 100.0 * body.facets.area


def measured(part: str, count: int, seed: int, speed: float, safety: float = 0.9) -> dict[str, Any]:
    """Energy, error of the balance and steps of one run."""
    model, state, duration, cost = {"rows": row, "blocks": block, "balls": ball}[part](count, seed, speed)
    run = bd.solve_explicit(model, duration=duration, every=20, state=state, safety=safety)
    energy, broken = run.history.energy, run.state.bond_integrity == 0.0
    crushing = float(energy["crushing"][-1] / (cost @ broken)) if "crushing" in energy else None
    return {
        "energy": float(run.history.released[-1] / (cost @ broken)), "crushing": crushing,
        "broken": int(broken.sum()), "status": run.status.value,
        "balance": float(np.abs(energy["balance"]).max() / energy["translation"][0]),
    }  # fmt: skip


def finer(count: int, seed: int, speed: float, safety: float) -> dict[str, Any]:
    """A ball with a share of the critical step: the same, its crushing over G_f, and whether the run warns."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = measured("balls", count, seed, speed, safety)
    warned = any(issubclass(one.category, UnresolvedOpeningWarning) for one in caught)
    return found | {"warned": warned}


def measure(
    record: Record, *, name: str = "after", parts: tuple[str, ...] = (*CASES, "finer"),
    seeds: tuple[int, ...] = tuple(SEEDS),
) -> None:  # fmt: skip
    """Measure bodies that fly apart; rows of several versions stand beside each other by `name`."""
    bd.set_threads(1)
    for part in set(CASES).intersection(parts):
        counts, speeds = CASES[part]
        for count, speed, seed in product(counts, speeds, seeds):
            record.add(partial(measured, part, count, seed, speed), "rows", name=name, part=part, count=count,
                       speed=speed, seed=seed)  # fmt: skip
    if "finer" in parts:
        speed = CASES["balls"][1][-1]
        for (count, safety), seed in product(FINER, seeds):
            record.add(partial(finer, count, seed, speed, safety), "finer", count=count, safety=safety, seed=seed)
    record.rows("rows").sort(key=itemgetter("part", "count", "speed", "name", "seed"))
    record.keep()
