"""A free strip of two materials, one of which expands: it bends as Timoshenko (1925) has it."""

from typing import Any

import numpy as np

import bondem as bd
from validation.studies.paths.mirrored import halves
from validation.studies.paths.rows import Row

#: E of both [Pa], ν, expansion of the stiff one [-], size [m], limit [-].
SOFT, STIFF, NU, STRAIN, SIZE, LIMIT = 7e9, 70e9, 0.2, 1e-4, (80e-3, 16e-3, 10e-3), 0.01


def curvature() -> float:
    """Of two layers of equal height h/2: 24 Δε / (h (12 + (1 + n) (1 + 1/n))), n the ratio of their moduli [1/m]."""
    ratio = SOFT / STIFF
    return 24.0 * STRAIN / (SIZE[1] * (12.0 + (1.0 + ratio) * (1.0 + 1.0 / ratio)))


def bimetal(seed: int, count: int) -> list[Row]:
    """Curvature of the middle half over that of theory, of cells mirrored about the interface."""
    found = halves(SIZE, (0.0, 1.0, 0.0), seed, count)
    soft, stiff = bd.CellBond(E=SOFT, nu=NU), bd.CellBond(E=STIFF, nu=NU)
    laws: dict[Any, bd.CellBond] = {bd.Everything(): soft, found.above: stiff}
    model = bd.Model(found.body, laws, 2400.0, boundary=[bd.Eigenstrain(STRAIN, found.above)])
    moved = bd.solve_static(model).displacement
    x, y, _ = found.body.centre.T
    chosen = np.abs(x - 0.5 * SIZE[0]) < 0.25 * SIZE[0]
    # parts that are even along x: the bend, and what expands across
    terms = np.column_stack([x**2, x, np.ones(len(x)), y, y**2, np.maximum(y - 0.5 * SIZE[1], 0.0)])[chosen]
    bend = 2.0 * np.linalg.lstsq(terms, moved[chosen, 1], rcond=None)[0][0]
    return [Row("bimetal", "curvature", abs(bend), curvature(), LIMIT)]
