"""A bar of glass torn apart: cells, Mohr–Coulomb with a tension cut-off, strengths that scatter after Weibull.

Physics: the ends of a bar move apart at 4 m/s. Stress waves of ρ c v = 50 MPa run to the middle and add up there;
where the strength of a facet is reached it breaks, brittle. Every break is an event with its time, place, mode and
energy; the pieces are what unbroken facets join.

Expected: the bar breaks in its middle part, in tension, into two large pieces and crumbs along the cracks; what was
stored, set free and moves adds up to the work of the walls. Takes about 2 s of a core.
Run it with:  python examples/breaking_bar.py [FOLDER]
"""

import sys
from pathlib import Path

import numpy as np

import bondem as bd

GLASS = bd.materials.soda_lime_glass
LENGTH, SIDE, SPEED = 40e-3, 8e-3, 4.0  # m, m, m/s
STRENGTH = bd.MohrCoulomb(
    tension=70e6, cohesion=200e6, friction_angle=0.6, scatter=bd.Weibull(modulus=10.0, volume=1e-9)
)


def main(count: int = 3000, folder: Path | None = None) -> bd.State:
    """The bar in the end; into a folder go the cells with the number of their piece, for ParaView."""
    centres = bd.pack(bd.Box((LENGTH, SIDE, SIDE)), count=count, method="even", seed=1)
    bar = bd.connect(centres, method="laguerre")
    apart = [bd.Drive(bd.Face(name), vx=v) for name, v in (("x_min", -SPEED), ("x_max", SPEED))]
    model = bd.Model(bar, bd.CellBond(E=GLASS.E, nu=GLASS.nu), GLASS.rho, failure=STRENGTH, boundary=apart)
    run = bd.solve_explicit(model, duration=20e-6, every=20)

    events, pieces = run.events, bd.fragments(bar, run.state)
    print(f"{len(events)} of {len(bar.pairs)} facets broken, the first at {1e6 * events.time[0]:.1f} µs")
    where = np.percentile(events.position[:, 0], [10, 50, 90])
    print("places along the bar, 10 %, half and 90 % of them:", np.round(1e3 * where, 1), "mm")
    print(f"{len(pieces)} pieces; shares of the mass:", np.round(pieces.mass[:5] / pieces.mass.sum(), 3))
    print(f"set free by cracks {1e3 * events.energy.sum():.2f} mJ; residual of the ledger {run.residual:.1e}")
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        moved = run.state.position - bar.centre
        of_cells = {"piece": pieces.label, "displacement": moved, "velocity": run.state.velocity}
        bd.write_vtkhdf(folder / "bar.vtkhdf", bar, elements=of_cells)
    return run.state


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
