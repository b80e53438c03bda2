"""A ball of glass shatters on a steel plate: the picture of README, by `bondem render`.

12 000 brittle cells, E = 70 GPa, ν = 0.22, 2500 kg/m³, 60 MPa in tension, c = 200 MPa, φ = 35°; radius 20 mm, 30 m/s.

Run: python benchmarks/shattering.py DIR [--count 12000] [--speed 30] [--duration 2.5e-4]
     bondem render DIR/ball.h5 --field fragment --no-axes --no-walls --size 940 940 --out docs/figures/shattering.png
"""

import argparse
from pathlib import Path

import bondem as bd

RADIUS = 20e-3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--count", type=int, default=12_000)
    parser.add_argument("--speed", type=float, default=30.0)
    parser.add_argument("--duration", type=float, default=2.5e-4)
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    ball = bd.connect(bd.pack(bd.Ball(RADIUS), count=given.count, method="even", seed=1), method="laguerre")
    failure = bd.MohrCoulomb(tension=60e6, cohesion=200e6, friction_angle=0.61)
    plate = bd.PlaneWall((0.0, 0.0, -RADIUS), (0.0, 0.0, 1.0), friction=0.3)
    model = bd.Model(
        ball, bd.CellBond(E=70e9, nu=0.22), density=2500.0, failure=failure,
        contact=bd.LinearContact(E=70e9, friction=0.3), walls=[plate],
    )  # fmt: skip
    state = model.state()
    state.set_motion(velocity=[(0.0, 0.0, -given.speed)] * given.count)
    run = bd.solve_explicit(
        model, duration=given.duration, every=20, state=state, out=given.out / "ball.h5", snapshot_every=400
    )
    pieces, energy = bd.fragments(ball, run.state), run.history.energy
    print(f"{len(run.events)} of {len(ball.pairs)} facets broken, {len(pieces)} pieces, {run.steps} steps")
    print(f"ledger closes to {run.history.imbalance:.1e}; fracture {energy['fracture'][-1]:.3g} J")


if __name__ == "__main__":
    main()
