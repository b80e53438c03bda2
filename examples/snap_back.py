"""A notched bar of concrete that snaps back: cracks without inertia, by load factors, and a slow explicit test.

Physics: the bar is longer than 2 E G_f / f_t², so that it stores more energy at its strength than a crack dissipates.
Pulled by platens it breaks at once where its path of equilibria turns back to smaller elongations.
`bd.solve_quasistatic` follows that path, one event of failing facets after the other.

Expected: peaks of both within 2 %; the path turns back; its work over the ligament is G_f within 5 %.
About 20 s of a core. Run it with:  python examples/snap_back.py [FOLDER]
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt

import bondem as bd

LENGTH, SIDE, NOTCH = 0.2, 20e-3, (2e-3, 6e-3)  # m
LAW, FAILURE = bd.CellBond(E=40e9, nu=0.2), bd.Rankine(tension=4e6, fracture_energy=20.0)
LIGAMENT = SIDE * (SIDE - NOTCH[1])  # m²


def main(count: int = 1200, folder: Path | None = None) -> tuple[bd.QuasistaticResult, float]:
    """The path of equilibria, and the largest load of the explicit test [N]."""
    slot = bd.Box((*NOTCH, 2.0 * SIDE)).moved((0.5 * (LENGTH - NOTCH[0]), -1e-6, -0.5 * SIDE))
    shape = bd.Box((LENGTH, SIDE, SIDE)).cut(slot, name="notch")
    bar = bd.connect(bd.pack(shape, count=count, method="even", seed=1), method="laguerre")
    ends = [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=1e-6)]
    model = bd.Model(bar, LAW, density=2400.0, failure=FAILURE, boundary=ends)
    path = bd.solve_quasistatic(model, bd.Face("x_max"))
    slow = bd.labtests.direct_tension(bar, LAW, FAILURE)
    load = slow.curve[:, 1] * LIGAMENT

    print(f"{len(path.load)} events, {len(path.bond)} losses of integrity in {len(set(path.bond.tolist()))} facets")
    print(f"peak {path.peak:.0f} N by load factors, {load.max():.0f} N in a slow explicit test")
    print(f"elongation at the peak {1e6 * path.displacement[path.load.argmax()]:.2f} µm,"
          f" at half of it {1e6 * path.displacement[path.load > 0.5 * path.peak][-1]:.2f} µm")  # fmt: skip
    print(f"work over the ligament {path.work[-1] / LIGAMENT:.1f} J/m², G_f = {FAILURE.fracture_energy:.0f} J/m²")
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        figure, axes = plt.subplots(figsize=(6.0, 4.0), layout="constrained")
        axes.plot(1e6 * path.displacement, path.load, lw=0.9, label="load factors, no inertia")
        axes.plot(1e6 * slow.curve[:, 0] * LENGTH, load, lw=1.2, label="explicit, slow and damped")
        axes.set(xlabel="elongation [µm]", ylabel="load [N]", xlim=(0.0, None), ylim=(0.0, None))
        axes.legend(frameon=False)
        figure.savefig(folder / "snap_back.png", dpi=150)
    return path, float(load.max())


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
