"""A tensile bar from an STL file: pack it, bond it, pull it.

Physics: a flat dog-bone bar, 60 mm long, with a gauge of 24 x 8 x 6 mm between wider ends (fillets of 12 mm). The
spheres lie inside the triangulated surface, touch its flat ends and follow its fillets. Clamped at one end and
pulled at the other, it lengthens by F/E times the integral of dx/A, so that the gauge strains more than the bar
as a whole by 1/A there over the mean of 1/A.

Expected: 1.27, here 1.21. Takes about 7 s of a core. Run it with:  python examples/dog_bone.py
"""

import tempfile
from pathlib import Path

import numpy as np
import trimesh

import bondem as bd

LENGTH, GAUGE, NARROW, WIDE, THICK, FILLET = 60.0, 24.0, 8.0, 16.0, 6.0, 12.0  # mm


def outline() -> np.ndarray:
    """Half the width along the bar [mm], (n, 2): x and y, from end to end."""
    rise = 0.5 * (WIDE - NARROW)
    x = np.linspace(0.0, np.sqrt(FILLET**2 - (FILLET - rise) ** 2), 25)
    fillet = np.column_stack([0.5 * GAUGE + x, 0.5 * NARROW + FILLET - np.sqrt(FILLET**2 - x**2)])
    right = np.vstack([fillet, [[0.5 * LENGTH, 0.5 * WIDE]]])
    return np.vstack([right[::-1] * [-1.0, 1.0], right])


def write_stl(file: Path) -> Path:
    """The bar as a closed surface: strips above, below, before and behind, and two ends."""
    x, y = outline().T
    ring = np.array([[-1, 0], [1, 0], [1, 1], [-1, 1]])  # side of y, height
    corner = np.array([[[a, s * b, h * THICK] for s, h in ring] for a, b in zip(x, y, strict=True)])
    first, k = 4 * np.arange(len(x) - 1)[:, None], np.arange(4)
    here, there = first + k, first + np.roll(k, -1)
    strips = np.concatenate([np.stack(t, axis=2) for t in ((here, there, there + 4), (here, there + 4, here + 4))])
    ends = np.array([[0, 3, 1], [1, 3, 2]]), np.array([[1, 3, 0], [2, 3, 1]]) + 4 * len(first)
    trimesh.Trimesh(corner.reshape(-1, 3), np.vstack([strips.reshape(-1, 3), *ends])).export(file)
    return file


def main(count: int = 4000) -> tuple[bd.Lattice, float, float]:
    """The bonded bar, and strain of the gauge over that of the whole bar: measured, and by sections [-]."""
    with tempfile.TemporaryDirectory() as folder:
        bar = bd.Surface(write_stl(Path(folder) / "bar.stl"), unit="mm")
    lattice = bd.connect(bd.pack(bar, count=count, spread=0.25, seed=1))
    hold = [bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(100.0, 0.0, 0.0))]
    bonds = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.7)
    u = bd.solve_static(bd.Model(lattice, bonds, 2000.0, boundary=hold)).displacement[:, 0]
    x, ends = lattice.particles.position[:, 0], [bd.Face(name).select(lattice) for name in ("x_min", "x_max")]
    gauge = np.polyfit(x[abs(x) < 0.01], u[abs(x) < 0.01], 1)[0]
    whole = (u[ends[1]].mean() - u[ends[0]].mean()) / (x[ends[1]].mean() - x[ends[0]].mean())
    along = np.linspace(-0.5 * LENGTH, 0.5 * LENGTH, 2001)
    return lattice, float(gauge / whole), float(2.0 / NARROW / np.mean(1.0 / np.interp(along, *outline().T)))


if __name__ == "__main__":
    print("strain of the gauge over that of the bar: {:.3f}, by sections {:.3f}".format(*main()[1:]))
