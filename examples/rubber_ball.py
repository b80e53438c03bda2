"""Press a ball of rubber on all sides: every cell has the pressure, at ν = 0.4999 as well.

Physics: under a uniform pressure p the stress is -p everywhere and the volume shrinks by p / K. With balanced shares
each cell of any packing has this stress to single precision. Expected: each error below 1e-6. Takes about 7 s.

Run it with:  python examples/rubber_ball.py
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd

E, PRESSURE = 3e6, 1e4  # [Pa]


@dataclass(frozen=True)
class Answer:
    """Largest error of a stress component of any cell over p [-], by Poisson's ratio."""

    error: dict[float, float]


def main(count: int = 3000) -> Answer:
    """Press a ball of `count` cells."""
    ball = bd.Ball(radius=0.02)
    body = bd.connect(bd.pack(ball, count=count, method="even", seed=1), method="laguerre")
    error = {}
    for nu in (0.3, 0.49, 0.4999):
        load = [bd.Pressure(bd.Face(face), PRESSURE) for face in ball.faces]
        model = bd.Model(body, bd.CellBond(E=E, nu=nu), density=1100.0, boundary=load)
        stress = bd.cell_stress(model, bd.solve_static(model))
        error[nu] = float(np.abs(stress / PRESSURE + np.eye(3)).max())
        print(f"ν = {nu}: the stress of each of {count} cells is -p within {error[nu]:.1e} p")
    return Answer(error)


if __name__ == "__main__":
    main()
