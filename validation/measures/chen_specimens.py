"""Chen et al. (2022), Table 3: the cantilevers of cases 1 to 5, and what each bond law should give for them.

E_b = 200 GPa, ν_b = 0.3, F = 100 kN. The density is not printed in the paper; here it is 7800 kg/m³.
"""

import math
from typing import Any

import numpy as np

import bondem as bd
from bondem.interactions.beams.bond_law import BondLaw
from bondem.report.style import BLUE, GREEN, ORANGE, PURPLE

E, NU, RHO, FORCE = 200e9, 0.3, 7800.0, 100e3
G = E / (2.0 * (1.0 + NU))
LAWS = {"TBBM": bd.Timoshenko, "EBBM": bd.EulerBernoulli, "PBM": bd.ParallelBond, "Obermayr": bd.Obermayr}
MARKS = {"TBBM": (GREEN, "o"), "EBBM": (BLUE, "s"), "PBM": (ORANGE, "^"), "Obermayr": (PURPLE, "D")}


def row(length: float, radii: np.ndarray) -> bd.Lattice:
    """Equally spaced elements along x, each bonded to the next."""
    x = np.linspace(0.0, length, len(radii))
    pairs = np.column_stack([np.arange(len(x) - 1), np.arange(1, len(x))])
    return bd.Lattice(bd.Particles(np.column_stack([x, 0 * x, 0 * x]), radii), pairs)


# Table 3; case → parameter → (specimen, bond radius, κ of the parallel bond)
CASES: dict[str, dict[float, tuple[bd.Lattice, float, float | None]]] = {
    "1": {10: (row(4.0, np.full(11, 0.2)), 0.2, None)},
    "2": {n: (row(0.4 * n, np.full(n + 1, 0.2)), 0.2, None) for n in range(1, 11)},
    "3": {n: (row(4.0, np.full(n + 1, 0.2)), 0.2, None) for n in (1, 2, 4, 6, 8, 10)},
    "4": {n: (row(4.0, np.full(n + 1, 2.0 / n)), 0.1, None) for n in (1, 2, 4, 5, 10)},
    "5": {d: (row(4.0, np.array([0.2, r, 0.2])), 0.2, 100.0 / 3.0) for d, r in ((0.0, 0.2), (0.75, 0.4), (1.5, 0.8))},
}


def bond(law: str, radius: float, kappa: float | None = None) -> BondLaw:
    own: dict[str, Any] = {"kappa": kappa} if law == "PBM" else {}
    return LAWS[law](E=E, nu=NU, radius=radius, **own)


def cantilever(lattice: bd.Lattice, law: BondLaw, force: float, ramp: float | None = None) -> bd.Model:
    tip = bd.Index([len(lattice.particles) - 1])
    schedule = bd.Constant(1.0) if ramp is None else bd.Ramp(0.0, 1.0, ramp)
    load = bd.Load(tip, force=(0.0, force, 0.0), schedule=schedule)
    return bd.Model(lattice, law, RHO, boundary=[bd.Fix(bd.Index([0])), load])


def beam(x: np.ndarray, L: float, r: float, F: float = FORCE, *, shear: bool) -> np.ndarray:
    """Deflection along the beam [m]: eq (28)."""
    A, I = math.pi * r**2, math.pi * r**4 / 4.0
    return F * x**2 * (3.0 * L - x) / (6.0 * E * I) + (10.0 * F * x / (9.0 * G * A) if shear else 0.0)


def exact(
    law: str, lattice: bd.Lattice, r: float, kappa: float | None, F: float = FORCE, *, more: np.ndarray | float = 0.0
) -> np.ndarray:
    """What a law should give at its elements [m]: the beam, or the chain of shear and bending springs.

    `more` is a shear stiffness beside that of each bond of a chain [N/m].
    """
    x, R = lattice.particles.position[:, 0], lattice.particles.radius
    if law in ("EBBM", "TBBM"):
        return beam(x, x[-1], r, F, shear=law == "TBBM")
    l = np.diff(x)
    A, I = math.pi * r**2, math.pi * r**4 / 4.0
    if law == "PBM":
        ks, c = E * A / l / (kappa or 2.0 * (1.0 + NU)), x[:-1] + 0.5 * (l + R[:-1] - R[1:])
    else:
        ks, c = 0.9 * G * A / l, x[:-1] + 0.5 * l
    lift = F / (ks + more) + F * (x[-1] - c) * l / (E * I) * np.maximum(x[:, None] - c, 0.0)
    return np.where(x[:, None] > c, lift, 0.0).sum(axis=1)
