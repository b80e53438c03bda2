"""A wall of bricks that a steel ball hits: 22 bodies of bonded spheres, laid dry in running bond.

Physics: bricks touch each other and the floor with friction only. The ball flies freely; what it loses, bricks and
floor gain. It knocks bricks out of the middle, some break; those at the ends hardly move.

Expected: momentum that the ball loses equals that which bricks and the friction of the floor gain, within 1 %.
Takes 30 s. Run it with:  python examples/brick_wall.py [PICTURE.png]
"""

import sys

import numpy as np

import bondem as bd

BRICK = (20e-3, 10e-3, 10e-3)  # m
E, RHO, STRENGTH = 0.05e9, 2000.0, 1e6  # Pa, kg/m³, Pa
SPEED, MASS, RADIUS = 8.0, 30e-3, 9e-3  # m/s, kg, m


def wall(courses: int, across: int, count: int = 200) -> bd.Lattice:
    """Bricks laid in running bond, with halves at the ends of every second course."""
    whole = bd.connect(bd.pack(bd.Box(BRICK), count=count, seed=1), tolerance=0.01)
    half = bd.connect(bd.pack(bd.Box((10e-3, *BRICK[1:])), count=120, seed=1), tolerance=0.01)
    bricks = []
    for course in range(courses):
        z, odd = course * BRICK[2], course % 2
        bricks += [whole.moved(((k + 0.5 * odd) * BRICK[0], 0.0, z)) for k in range(across - odd)]
        if odd:
            bricks += [half.moved((x, 0.0, z)) for x in (0.0, (across - 0.5) * BRICK[0])]
    return bd.join(*bricks)


def shot(courses: int = 5, across: int = 4, duration: float = 6e-3) -> tuple[bd.ExplicitResult, float, float]:
    """Return the run, the momentum that the ball loses, and that which bricks and floor gain [N·s]."""
    scene = wall(courses, across)
    middle = 0.5 * (scene.particles.position.min(axis=0) + scene.particles.position.max(axis=0))
    start = (middle[0], -RADIUS - 1e-3, middle[2])
    ball = bd.SphereWall(RADIUS, start, motion=bd.Free(MASS, velocity=(0.0, SPEED, 0.0)))
    model = bd.Model(
        scene, bd.EulerBernoulli(E=E, nu=0.2, radius_ratio=0.6), RHO, boundary=[bd.Gravity()],
        walls=[bd.PlaneWall((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)), ball],
        contact=bd.LinearContact(E=E, friction=0.6, damping=0.2),
        failure=bd.PeripheralStress(tension=STRENGTH, shear=2.0 * STRENGTH),
    )  # fmt: skip
    gauges = {"floor": bd.WallGauge(0, "force"), "ball": bd.WallGauge(1, "velocity")}
    run = bd.solve_explicit(model, duration=duration, every=5, gauges=gauges)
    lost = MASS * (SPEED - run.history["ball"][-1, 1])
    rubbed = np.trapezoid(run.history["floor"][:, 1], run.history.time)
    return run, float(lost), float(model.mass @ run.state.velocity[:, 1] + rubbed)


if __name__ == "__main__":
    run, lost, gained = shot()
    scene = run.state.model.lattice
    pieces = bd.fragments(scene, run.state)
    print(f"the ball loses {lost:.4g} N·s, bricks and floor gain {gained:.4g}")
    print(f"{len(scene.names)} bricks, {len(pieces)} pieces")
    if len(sys.argv) > 1:
        run.plot(sys.argv[1], reach=1.0)
