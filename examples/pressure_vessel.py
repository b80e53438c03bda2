"""Pressure in the hole of a part from CAD: faces by place and direction, and how far a thick tube widens.

Physics: a steel tube (hole of 20 mm, outside of 40 mm, 10 mm long) held along its axis at both ends carries 10 MPa
in its hole. Its triangles come from trimesh, as they would from an STL, OBJ or 3MF file. Between sharp edges the
surface has four patches: outside, hole and two ends; `tube.plot("tube.png")` shows their names.

Expected: Lamé's displacement in plane strain, u = p a² (1 + ν) / (E (b² - a²)) ((1 - 2 ν) r + b² / r), in all cells;
with 3000 cells the ratio to it is 1.004. Takes 7 s of a core. Run it with:  python examples/pressure_vessel.py
"""

import numpy as np
import trimesh

import bondem as bd

INNER, OUTER, LENGTH = 10e-3, 20e-3, 10e-3  # radii and length [m]
PRESSURE = 10e6  # Pa
STEEL = bd.Material("steel", E=210e9, nu=0.3, rho=7850.0)


def lame(r: np.ndarray) -> np.ndarray:
    """Displacement of a tube under pressure [m] at radii r [m], (n,), in plane strain."""
    factor = PRESSURE * INNER**2 * (1.0 + STEEL.nu) / (STEEL.E * (OUTER**2 - INNER**2))
    return factor * ((1.0 - 2.0 * STEEL.nu) * r + OUTER**2 / r)


def main(count: int = 3000) -> tuple[float, float]:
    """Force on one half of the hole over p times its width times length [-], and widening over Lamé's [-]."""
    mesh = trimesh.creation.annulus(1e3 * INNER, 1e3 * OUTER, 1e3 * LENGTH, sections=128)
    tube = bd.Surface(mesh, unit="mm")
    hole = bd.Face(tube.patch(near=(INNER, 0.0, 0.0)).name)
    ends = [bd.Face(tube.patch(normal=(0.0, 0.0, side)).name) for side in (-1.0, 1.0)]
    body = bd.connect(bd.pack(tube, count=count, method="even", seed=1), method="laguerre")

    held = [bd.Fix(end, translation="z", rotation="") for end in ends]
    held += [bd.Fix(bd.Index(0), translation="xy", rotation="z")]  # the tube does not drift or turn
    loaded = bd.Pressure(hole, PRESSURE)
    model = bd.Model(body, bd.CellBond(STEEL), density=STEEL.rho, boundary=[*held, loaded])
    moved = bd.solve_static(model).displacement

    facets, force = loaded.on_facets(body)
    right = body.cells.free.normal[facets, 0] < 0.0  # these facets face the axis
    half = force[right, 0].sum() / (PRESSURE * 2.0 * INNER * LENGTH)
    # the cell that is held moved too: its motion and turn are fitted with the share of Lamé's displacement
    x, y, _ = body.centre.T
    r, zero, one = np.hypot(x, y), np.zeros(count), np.ones(count)
    shares = [np.column_stack([one, zero, -y, x / r * lame(r)]), np.column_stack([zero, one, x, y / r * lame(r)])]
    fitted = np.linalg.lstsq(np.vstack(shares), moved[:, :2].T.ravel(), rcond=None)[0]
    return float(half), float(fitted[3])


if __name__ == "__main__":
    half, widening = main()
    print(f"force on one half of the hole over p · width · length: {half:.4f}")
    print(f"widening over that of Lamé: {widening:.4f}")
