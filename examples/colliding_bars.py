"""Two bars that collide: bodies of cells, face to face, one of which moves.

Physics: a compressive wave of σ = ρ c v / 2 runs through both bars from the face where they meet, and returns from
their ends as tension, which opens the contact after 2 L / c. Equal bars then have exchanged their velocities
(Saint-Venant 1867). With ν = 0 waves are plane, and c = √(E / ρ); the contact is one of spheres, which scatter them.

Expected: velocities within 2 % and the time of contact within 5 % of theory. Takes 2 s.
Run it with:  python examples/colliding_bars.py [PICTURE.png]
"""

import math
import sys
from typing import NamedTuple

import numpy as np

import bondem as bd

LENGTH, SIDE = 0.1, 0.01  # m
E, RHO, SPEED = 10e9, 2500.0, 2.0  # Pa, kg/m³, m/s
CELERITY = math.sqrt(E / RHO)


class Impact(NamedTuple):
    """What a collision leaves."""

    run: bd.ExplicitResult
    velocity: tuple[float, float]  #: of the bars, along x [m/s]
    contact: float  #: time of contact [s]


def collide(count: int = 250) -> Impact:
    """Let two bars of `count` cells each collide."""
    box = bd.Box((LENGTH, SIDE, SIDE))
    left, right = (
        bd.connect(bd.pack(box, count=count, method="even", seed=seed), method="laguerre") for seed in (1, 2)
    )
    scene = bd.join(left, right.moved((LENGTH, 0.0, 0.0)), names=("left", "right"))
    model = bd.Model(scene, bd.CellBond(E=E, nu=0.0), RHO, contact=bd.LinearContact(E=E))
    state = model.state()
    state.set_velocity(bd.Body("left"), (SPEED, 0.0, 0.0))
    gauges = {name: bd.Gauge(bd.Body(name), "velocity") for name in scene.names}
    run = bd.solve_explicit(model, duration=3.0 * LENGTH / CELERITY, state=state, every=5, gauges=gauges)
    energy = run.history.energy["contact"]
    touching = run.history.time[energy > 1e-9 * energy.max()]
    ends = tuple(float(run.history[name][-1, 0]) for name in scene.names)
    return Impact(run, ends, float(np.ptp(touching)))


if __name__ == "__main__":
    found = collide()
    print(f"after the collision {found.velocity[0]:.3f} and {found.velocity[1]:.3f} m/s, of 0 and {SPEED}")
    print(f"contact {1e6 * found.contact:.1f} µs, 2 L / c is {2e6 * LENGTH / CELERITY:.1f} µs")
    if len(sys.argv) > 1:
        found.run.plot(sys.argv[1], reach=200.0)
