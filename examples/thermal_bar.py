"""Heat a bar: free it grows without stress, clamped between two walls it presses with E α ΔT.

Physics: every bond has the rest length L (1 + α ΔT). Expected: free growth of α ΔT = 1e-3 to rounding, and a clamped
stress within 3 % of E α ΔT of the same bar (the end elements are held at their centres). Takes about 2 s.

Run it with:  python examples/thermal_bar.py
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd

EXPANSION, HEATING = 1e-5, 100.0


@dataclass(frozen=True)
class Answer:
    """Growth of the free bar over its length [-], and stress of the clamped one over E α ΔT [-]."""

    growth: float
    stress: float


def main(count: int = 3000) -> Answer:
    """Heat a cylinder of `count` spheres, free and clamped."""
    shape = bd.Cylinder(radius=5e-3, length=40e-3)
    lattice = bd.connect(bd.pack(shape, count=count, spread=0.25, seed=1))
    law = bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71)
    heat = bd.Eigenstrain(EXPANSION * HEATING)

    free = bd.solve_static(bd.Model(lattice, law, 1000.0, boundary=[heat]))
    x, u = lattice.particles.position[lattice.connected, 0], free.displacement[lattice.connected, 0]
    growth = float(np.polyfit(x, u, 1)[0])
    print(f"free: strain {growth:.6g}, elastic energy {free.energy.total:.2g} J")

    ends = [bd.Face("x_min"), bd.Face("x_max")]
    walls = [bd.Fix(end, translation="x", rotation="") for end in ends]
    steady = bd.Fix(bd.Index(ends[0].select(lattice)[:2]), translation="yz", rotation="")
    clamped = bd.solve_static(bd.Model(lattice, law, 1000.0, boundary=[heat, steady, *walls]))
    E = bd.labtests.static_tension(lattice, law).E
    thrust = clamped.reaction[ends[0].select(lattice), 0].sum()
    stress = float(thrust / shape.section() / (E * EXPANSION * HEATING))
    print(f"clamped: stress {stress:.3f} of E α ΔT, E = {E / 1e9:.1f} GPa")
    return Answer(growth, stress)


if __name__ == "__main__":
    main()
