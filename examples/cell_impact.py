"""A ball of concrete, cut into cells, shatters on a wall; its pieces rub on each other.

Physics: a ball of 50 mm radius flies at 20 m/s against a rigid wall. Its material has a tensile strength of 4 MPa, a
cohesion of 14 MPa, an angle of friction of 35° and a fracture energy of 100 J/m²: nothing is calibrated. Facets
soften in tension, cells yield in shear, and where faces of a crack no longer face each other cells touch as spheres.

Expected: nearly half of the energy goes into crushing at the wall (45 %), a tenth into cracks and a sixth into
friction; the parts add up to what came in within a ten-thousandth. Hundreds of pieces; the largest has a twelfth of
the mass. Takes about 3 s of a core.
Run it with:  python examples/cell_impact.py [FOLDER]
"""

import sys
from pathlib import Path

import bondem as bd

RADIUS, SPEED = 50e-3, 20.0  # m, m/s
CONCRETE = bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.61, fracture_energy=100.0)


def main(count: int = 1000, folder: Path | None = None) -> bd.ExplicitResult:
    """The run; into a folder goes the end of it, for ParaView."""
    ball = bd.connect(bd.pack(bd.Ball(RADIUS), count=count, method="even", seed=1), method="laguerre")
    wall = bd.PlaneWall((-RADIUS, 0, 0), (1, 0, 0), friction=0.4)
    model = bd.Model(
        ball, bd.CellBond(E=30e9, nu=0.2), density=2400.0, failure=CONCRETE,
        contact=bd.LinearContact(E=30e9, friction=0.4), walls=[wall],
    )  # fmt: skip
    state = model.state()
    state.set_motion(velocity=[(-SPEED, 0.0, 0.0)] * count)
    run = bd.solve_explicit(model, duration=4e-4, every=5, state=state, gauges={"wall": bd.WallGauge(0, "force")})

    energy, pieces = run.history.energy, bd.fragments(ball, run.state)
    came = energy["translation"][0]
    print(f"{len(run.events)} of {len(ball.pairs)} facets broken; {len(run.state.contacts)} pairs touch in the end")
    print(f"{len(pieces)} pieces, the largest with {pieces.mass[0] / pieces.mass.sum():.0%} of the mass")
    print(f"largest force on the wall {1e-3 * abs(run.history['wall'][:, 0]).max():.0f} kN")
    parts = ("translation", "rotation", "plastic", "fracture", "crushing", "friction")
    print("shares of the energy:", {name: f"{energy[name][-1] / came:.3f}" for name in parts})
    print(f"missing at most {abs(energy['balance']).max() / came:.1e}")
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        moved = run.state.position - ball.centre
        of_cells = {"piece": pieces.label, "displacement": moved, "velocity": run.state.velocity}
        bd.write_vtkhdf(folder / "ball.vtkhdf", ball, elements=of_cells)
    return run


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
