"""A ball of bonded grains hits a wall, breaks, and its pieces rub on each other and on the wall.

Physics: a ball of Euler-Bernoulli beams, 20 mm in radius, flies at 8 m/s against a rigid wall with friction. Beams
break by their peripheral stress; a pair whose beam breaks under pressure stays in contact, and slides with friction.

Expected: a third of the bonds break near the impact and grains spray off; the largest fragment has most of the mass.
A quarter of the energy goes into friction, a twentieth into bonds, and all parts add up to what came in, to a
thousandth. Takes about 2 s of a core.
Run it with:  python examples/ball_impact.py [FOLDER]
"""

import sys
from pathlib import Path

import bondem as bd

RADIUS, SPEED = 20e-3, 8.0  # m, m/s
LAW = bd.EulerBernoulli(E=5e9, nu=0.3, radius_ratio=0.6)
STRENGTH = bd.PeripheralStress(tension=30e6, shear=60e6, scatter=bd.Weibull(modulus=10.0, volume=1e-9))
CONTACT = bd.LinearContact(E=2e9, friction=0.4, damping=0.05)


def main(count: int = 3000, folder: Path | None = None) -> bd.ExplicitResult:
    """The run; into a folder goes the end of it, for ParaView."""
    ball = bd.connect(bd.pack(bd.Ball(RADIUS), count=count, seed=1))
    wall = bd.PlaneWall((-RADIUS, 0, 0), (1, 0, 0), friction=0.4)
    model = bd.Model(ball, LAW, density=2500.0, failure=STRENGTH, contact=CONTACT, walls=[wall])
    state = model.state()
    state.set_motion(velocity=[(-SPEED, 0.0, 0.0)] * count)
    force = {"wall": bd.WallGauge(0, "force")}
    run = bd.solve_explicit(model, duration=2e-4, every=20, state=state, gauges=force)

    energy, pieces = run.history.energy, bd.fragments(ball, run.state)
    came = energy["translation"][0]
    print(f"{len(run.events)} of {len(ball.pairs)} bonds broken; {len(run.state.contacts)} pairs touch in the end")
    print(f"{len(pieces)} pieces, the largest with {pieces.mass[0] / pieces.mass.sum():.0%} of the mass")
    print(f"largest force on the wall {1e-3 * abs(run.history['wall'][:, 0]).max():.1f} kN")
    parts = ("translation", "rotation", "fracture", "friction", "loss")
    print("shares of the energy:", {name: f"{energy[name][-1] / came:.3f}" for name in parts})
    print(f"missing at most {abs(energy['balance']).max() / came:.1e}")
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        moved = run.state.position - ball.centre
        of_grains = {"piece": pieces.label, "displacement": moved, "velocity": run.state.velocity}
        bd.write_vtkhdf(folder / "ball.vtkhdf", ball, elements=of_grains)
    return run


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
