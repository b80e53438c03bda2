"""A cantilever of eleven bonded spheres, bent by a force at its tip (Chen et al. 2022, case 1).

Physics: a beam of length 4 m and radius 0.2 m, E = 200 GPa, ν = 0.3, carries 100 kN at its tip. Timoshenko
bonds give the exact deflection of Timoshenko's beam at every sphere, Euler–Bernoulli bonds that of a beam
without shear, and parallel bonds something in between. Then the same by explicit dynamics: a ramp, local
damping, and the end when nothing moves any more.

Expected: 8.534, 8.488 and 8.508 mm; the paper's runs gave 8.537, 8.489 and 8.508 mm.
Run time: about one second of a core.

    python examples/chen_cantilever.py
"""

import numpy as np

import bondem as bd

E, NU, RADIUS, FORCE = 200e9, 0.3, 0.2, 100e3
SCALE = 0.01  # small rotations in the explicit run


def specimen() -> bd.Lattice:
    """Eleven touching spheres of radius 0.2 m along x."""
    x = np.linspace(0.0, 4.0, 11)
    return bd.connect(bd.Particles(np.column_stack([x, 0 * x, 0 * x]), np.full(11, 0.2)))


def tip(result) -> float:
    """Deflection of the last sphere [m]."""
    return float(result.displacement[-1, 1])


def main() -> dict[str, float]:
    lattice = specimen()
    deflection = {}
    for law in (bd.Timoshenko, bd.EulerBernoulli, bd.ParallelBond):
        load = bd.Load(bd.Index([10]), force=(0.0, FORCE, 0.0))
        held = bd.Model(lattice, law(E=E, nu=NU, radius=RADIUS), 7800.0, boundary=[bd.Fix(bd.Index([0])), load])
        deflection[law.__name__] = tip(bd.solve_static(held))

    ramp = bd.Load(bd.Index([10]), force=(0.0, SCALE * FORCE, 0.0), schedule=bd.Ramp(0.0, 1.0, duration=0.1))
    beam = bd.Timoshenko(E=E, nu=NU, radius=RADIUS)
    moving = bd.Model(lattice, beam, 7800.0, boundary=[bd.Fix(bd.Index([0])), ramp])
    rest = bd.AtRest(1e-9, after=0.1)
    run = bd.solve_explicit(moving, duration=10.0, damping=bd.LocalDamping(0.5), until=(rest,))
    deflection["Timoshenko, explicit"] = tip(run.state) / SCALE
    return deflection


if __name__ == "__main__":
    for name, value in main().items():
        print(f"{name:22} {1e3 * value:.3f} mm")
