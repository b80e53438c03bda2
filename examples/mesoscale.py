"""Concrete as mortar, stones and what joins them: three materials in one body, pulled until it breaks.

Physics: stones of 6 to 16 mm by a sieve curve, a quarter of the volume; cells end on their surfaces. Mortar, stones
and the interface between them have strengths and fracture energies of their own; the interface is half as strong as
mortar. Platens hold the ends along x only; the crack goes round the stones.

Expected: 3.52 MPa, between the strengths of the interface and of mortar; no crack in stones. Two minutes of a
core. Run it with:  python examples/mesoscale.py [FOLDER]
"""

import sys
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.fracture.lost_area import lost_area
from bondem.report.mesoscale_figure import draw_mesoscale

SIDE, FRACTION = 40e-3, 0.25  # m, -
SIEVE = bd.Sieve(diameters=(6e-3, 8e-3, 12e-3, 16e-3), mass_passing=(0.0, 0.25, 0.6, 1.0))
MORTAR, STONE = bd.CellBond(E=25e9, nu=0.2), bd.CellBond(E=70e9, nu=0.2)
STRONG = bd.Rankine(tension=12e6, fracture_energy=100.0)
PLAIN, WEAK = bd.Rankine(tension=4e6, fracture_energy=60.0), bd.Rankine(tension=2e6, fracture_energy=30.0)
SPEED, TIME = 0.02, 1.9e-3  # m/s, s


def main(size: float = 2e-3, folder: Path | None = None) -> tuple[float, dict[str, float]]:
    """Strength [Pa], and how much of the crack surface is in mortar, along stones and through them [-]."""
    box = bd.Box((1.5 * SIDE, SIDE, SIDE))
    stones = bd.aggregates(box, SIEVE, fraction=FRACTION, gap=1.2 * size, seed=1)
    body = bd.connect(bd.pack(box, size=size, method="even", around=stones, seed=1), method="laguerre")
    model = bd.Model(
        body, {bd.Everything(): MORTAR, stones: STONE}, density=2400.0,
        failure={bd.Everything(): PLAIN, stones: STRONG, (stones, stones.matrix): WEAK},
        boundary=[bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
                  bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, SPEED, 0.1 * TIME))],
    )  # fmt: skip
    run = bd.solve_explicit(
        model, duration=TIME, every=50, damping=bd.MassDamping(2e4),
        gauges={"end": bd.Gauge(bd.Face("x_max"), "force")},
    )  # fmt: skip
    stress = run.history["end"][:, 0] / SIDE**2
    lost = lost_area(body, run.state, stones)
    share = {part: area / sum(lost.values()) for part, area in lost.items()}
    print(f"{len(body.particles)} cells, {len(stones)} stones with {stones.volume / box.volume:.3f} of the volume")
    print(f"strength {1e-6 * stress.max():.2f} MPa (mortar 4, interface 2); ledger {run.residual:.1e}")
    print("lost area: " + ", ".join(f"{100 * part:.0f} % {name}" for name, part in share.items()))
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        late = np.maximum(run.history.time - 0.1 * TIME, 0.0)  # since the platen has its speed
        moved = SPEED * (0.5 * (run.history.time - late) ** 2 / (0.1 * TIME) + late)
        draw_mesoscale(folder / "mesoscale.png", body, run.state, stones, np.column_stack([moved, stress]))
        bd.write_vtkhdf(folder / "mesoscale.vtkhdf", body, elements={"stone": stones.mask(body).astype(float)})
    return float(stress.max()), share


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
