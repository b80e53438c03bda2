"""A ball of glass shatters on a steel plate: the picture of README, by `bondem render`.

12 000 brittle cells, E = 70 GPa, ν = 0.22, 2500 kg/m³, 60 MPa in tension, c = 200 MPa, φ = 35°; radius 20 mm, 30 m/s.
"""

from pathlib import Path

import bondem as bd
from validation.frame.record import Record

RADIUS = 20e-3


COUNT, SPEED, DURATION = 12_000, 30.0, 2.5e-4


def draw(_: Record, folder: Path) -> None:
    """Let the ball fall, and leave its run file for `bondem render`."""
    ball = bd.connect(bd.pack(bd.Ball(RADIUS), count=COUNT, method="even", seed=1), method="laguerre")
    failure = bd.MohrCoulomb(tension=60e6, cohesion=200e6, friction_angle=0.61)
    plate = bd.PlaneWall((0.0, 0.0, -RADIUS), (0.0, 0.0, 1.0), friction=0.3)
    model = bd.Model(
        ball, bd.CellBond(E=70e9, nu=0.22), density=2500.0, failure=failure,
        contact=bd.LinearContact(E=70e9, friction=0.3), walls=[plate],
    )  # fmt: skip
    state = model.state()
    state.velocity = (0.0, 0.0, -SPEED)
    run = bd.solve_explicit(
        model, duration=DURATION, every=20, state=state, out=folder / "ball.h5", snapshot_every=400
    )
    pieces, energy = bd.fragments(ball, run.state), run.history.energy
    print(f"{len(run.events)} of {len(ball.pairs)} facets broken, {len(pieces)} pieces, {run.steps} steps")
    print(f"ledger closes to {run.history.imbalance:.1e}; fracture {energy['fracture'][-1]:.3g} J")
