"""The non-local law beside the cell law: what comes back of E = 40 GPa and ν, and when its lag diverges."""

import warnings
from typing import Any

import numpy as np

import bondem as bd
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.plan import Plan
from bondem.model.highest_frequency import highest_frequency
from bondem.model.state import State
from validation.frame.record import Record

E = 40e9
RATIOS = (0.0, 0.2, 0.4, 0.45, 0.49)
REACH = 1.3
DAMPING = {
    "none": None, "local 0.3": bd.LocalDamping(0.3), "local 0.7": bd.LocalDamping(0.7),
    "bonds 0.1": bd.BondDamping(eta=0.1), "bonds 0.3": bd.BondDamping(eta=0.3),
}  # fmt: skip


def moduli(lattice: bd.Lattice, law: Any) -> dict:
    """E [GPa] and ν, or what went wrong."""
    try:
        found = bd.bulk_moduli(lattice, law)
    except bd.errors.ConvergenceError as error:
        return {"E": None, "nu": None, "note": str(error)}
    return {"E": found.E / 1e9, "nu": found.nu}


def elastic(body: bd.Lattice, seed: int) -> list[dict]:
    """Moduli that come back, by law and ν."""
    spheres = bd.connect(body.particles, reach=REACH)
    rows = []
    for nu in RATIOS:
        for name, lattice, law in (
            ("facets", body, bd.NonLocal(E=E, nu=nu)),
            ("facets, lever on the line of centres", body, bd.NonLocal(E=E, nu=nu, lever="contact")),
            ("weighted", spheres, bd.NonLocal(E=E, nu=nu, areas="weighted")),
            ("cell law", body, bd.CellBond(E=E, nu=nu)),
        ):
            rows.append({"seed": seed, "law": name, "nu_given": nu, **moduli(lattice, law)})
            print(rows[-1], flush=True)
    return rows


def explicit(body: bd.Lattice, steps: int = 2000) -> list[dict]:
    """Kinetic energy left of random velocities after so many steps, by damping, ν and share of the springs' step."""
    rows = []
    n = len(body.particles)
    velocity = np.random.default_rng(0).standard_normal((n, 3))
    velocity -= velocity.mean(axis=0)
    for nu in RATIOS:
        model = bd.Model(body, bd.NonLocal(E=E, nu=nu), 2400.0)
        critical = 2.0 / highest_frequency(model)
        for name, damping in DAMPING.items():
            for share in (0.5, 0.125):
                state = State(model)
                state.set_motion(velocity=1e-3 * velocity)
                start = float((state.motion[:, :3] ** 2 / state.motion[:, 3:4]).sum())
                dt = share * critical
                loop = CoreLoop(model, Plan(duration=steps * dt, dt=dt, every=0, damping=damping), state, dt)
                _, _, _, sick = loop.run(steps)
                left = float((state.motion[:, :3] ** 2 / state.motion[:, 3:4]).sum()) / start
                stable = not sick and left < 1.0
                rows.append({"nu": nu, "damping": name, "share": share, "stable": stable,
                             "left": left if np.isfinite(left) and left < 1e30 else None})  # fmt: skip
                print(rows[-1], flush=True)
    return rows


def measure(record: Record, *, count: int = 2000, packings: int = 2) -> None:
    """Measure moduli, and runs whose lag diverges."""
    warnings.simplefilter("ignore")
    record.keep(count=count, E=E / 1e9, reach=REACH, elastic=[])
    for seed in range(1, packings + 1):
        particles = bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=count, spread=0.25, seed=seed)
        body = bd.connect(particles, method="laguerre")
        record.keep(elastic=record.rows("elastic") + elastic(body, seed))
    small = bd.pack(bd.Cell((1.0, 1.0, 1.0)), count=200, spread=0.25, seed=1)
    record.keep(explicit=explicit(bd.connect(small, method="laguerre")))
