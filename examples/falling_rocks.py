"""Rocks that fall into a box and break: 24 bodies of bonded spheres at random places.

Physics: all rocks fall at one speed. What they hit breaks their bonds, and fragments hit each other, the floor and
smooth walls. Nothing else acts along z, so that the impulse of the floor is the change of momentum and the weight
over time. The energy that can break bonds grows with the square of the speed; below a threshold none break.

Expected: the impulse of the floor within 0.5 %, and five to eight times as many broken bonds at twice the speed.
Takes 4 s.
Run it with:  python examples/falling_rocks.py [PICTURE.png]
"""

import sys
from typing import NamedTuple

import numpy as np

import bondem as bd

EDGE, COUNT, SIZE = 40e-3, 24, 40  # m, rocks, spheres of a rock
E, RHO, STRENGTH = 0.1e9, 2500.0, 1.5e6  # Pa, kg/m³, Pa: so soft that a step is half a microsecond


class Fall(NamedTuple):
    """What a fall leaves."""

    run: bd.ExplicitResult
    broken: float  #: share of the bonds [-]
    impulse: float  #: of the floor [N·s]
    expected: float  #: the same by momentum and weight [N·s]


def fall(speed: float, duration: float = 10e-3, seed: int = 1) -> Fall:
    """Let the rocks fall at a speed [m/s]."""
    rock = bd.connect(bd.pack(bd.Ball(radius=5e-3), count=SIZE, seed=1), tolerance=0.01)
    scene = bd.strew(rock, bd.Box((EDGE, EDGE, EDGE)), COUNT, seed=seed, name="rock")
    walls = [bd.PlaneWall((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))]
    for toward in np.eye(3)[:2]:
        walls += [bd.PlaneWall((0.0, 0.0, 0.0), toward, friction=0.0)]
        walls += [bd.PlaneWall(EDGE * toward, -toward, friction=0.0)]
    model = bd.Model(
        scene, bd.EulerBernoulli(E=E, nu=0.2, radius_ratio=0.6), RHO, boundary=[bd.Gravity()], walls=walls,
        contact=bd.LinearContact(E=E, friction=0.5, damping=0.2),
        failure=bd.PeripheralStress(tension=STRENGTH, shear=2.0 * STRENGTH),
    )  # fmt: skip
    state = model.state()
    state.set_velocity(bd.Body("rock"), (0.0, 0.0, -speed))
    floor = {"floor": bd.WallGauge(0, "force")}
    run = bd.solve_explicit(model, duration=duration, state=state, every=10, gauges=floor)
    mass, velocity = model.mass, run.state.velocity[:, 2]
    impulse = -np.trapezoid(run.history["floor"][:, 2], run.history.time)
    expected = mass @ (velocity + speed) + 9.81 * mass.sum() * run.state.time
    return Fall(run, float((run.state.bond_integrity <= 0.0).mean()), float(impulse), float(expected))


if __name__ == "__main__":
    for speed in (1.0, 2.0):
        found = fall(speed)
        print(f"{speed} m/s: {found.broken:.1%} broken, floor {found.impulse:.4g} of {found.expected:.4g} N·s")
    if len(sys.argv) > 1:
        found.run.plot(sys.argv[1], reach=1.0)
