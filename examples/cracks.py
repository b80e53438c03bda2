"""A notched plate of glass, pulled until its crack runs through it: pieces, crack surfaces, speed, acoustic emission.

Physics: a plate of 100 × 40 × 2 mm with a notch to its middle is pulled by 1 MPa on its long sides from t = 0 on. The
crack starts once the waves have been there and outruns the load. Many methods are tried on this case, and their crack
branches (E = 32 GPa, ν = 0.2, ρ = 2450 kg/m³, G_c = 3 J/m²; Borden et al. 2012), here with f_t = 3.08 MPa.

Expected: it starts at 16 µs and runs at 966 m/s along x (packings of seeds 1 to 3: 899 to 966; Rayleigh waves have
2125 m/s). It does not branch; side cracks of seeds 2 and 3 stop. Takes about 9 s of a core.
Run it with:  python examples/cracks.py [FOLDER]
"""

import sys
from pathlib import Path

import bondem as bd
from bondem.report.fracture_figures import draw_fracture
from bondem.report.spheres import View

LENGTH, HEIGHT, THICK, SLOT = 100e-3, 40e-3, 2e-3, 1e-3  # m
GLASS = bd.Material("glass of the branching test", E=32e9, nu=0.2, rho=2450.0)
TIP = (0.5 * LENGTH, 0.5 * HEIGHT, 0.0)


def main(count: int = 10_000, folder: Path | None = None, duration: float = 90e-6) -> bd.CrackGrowth:
    """The growth of the crack; into a folder go a figure and the cells with the number of their piece."""
    slot = bd.Box((LENGTH, SLOT, 3.0 * THICK)).moved((-0.5 * LENGTH, 0.5 * (HEIGHT - SLOT), -THICK))
    shape = bd.Box((LENGTH, HEIGHT, THICK)).cut(slot, name="notch")
    plate = bd.connect(bd.pack(shape, count=count, method="even", seed=1), method="laguerre")
    model = bd.Model(
        plate, bd.CellBond(E=GLASS.E, nu=GLASS.nu), GLASS.rho,
        failure=bd.Rankine(tension=3.08e6, fracture_energy=3.0),
        boundary=[bd.Pressure(bd.Face(name), -1e6) for name in ("y_min", "y_max")],
    )  # fmt: skip
    print(bd.explain(model), "\n")
    run = bd.solve_explicit(model, duration=duration, every=20)

    pieces, cracks = bd.fragments(plate, run.state), bd.cracks(plate, run.state)
    growth = bd.crack_speed(run.events, TIP, (1.0, 0.0, 0.0))
    heard = bd.acoustic_emission(run.events, model=model)
    slope = heard.b_value() if len(heard) >= 40 else None
    print(f"{(pieces.size >= 10).sum()} pieces of ten cells and more, {(pieces.size < 10).sum()} crumbs")
    print(f"{1e6 * cracks.area:.0f} mm² of crack, surfaces: {len(cracks.surfaces)}, area over projected area of the"
          f" largest: {cracks.surfaces.roughness[0]:.2f}")  # fmt: skip
    print(f"speed {growth.speed:.0f} m/s, 95 % {growth.interval[0]:.0f} to {growth.interval[1]:.0f}, from"
          f" {1e6 * growth.time[0]:.0f} µs on")  # fmt: skip
    print(f"{len(heard)} emissions of M {heard.magnitude.min():.1f} to {heard.magnitude.max():.1f}")
    if slope is not None:
        print(f"b = {slope.b:.2f}, 95 % {slope.interval[0]:.2f} to {slope.interval[1]:.2f}")
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        draw_fracture(
            folder / "cracks.png", plate, run.state, pieces=pieces, cracks=cracks, growth=growth,
            emission=heard, b_value=slope, view=View(azimuth=0.25, elevation=1.0), reach=60.0,
        )  # fmt: skip
        bd.write_vtkhdf(folder / "plate.vtkhdf", plate, elements={"piece": pieces.label})
    return growth


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
