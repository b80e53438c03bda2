"""A free bar of cells under a linear field of `bd.Eigenstrain`: its curvature and stresses, and those of a moment.

The strain ε* = g z is compatible: a continuum bends by the curvature g, along the bar and across it, without stress.
Reported for each packing, with the strain at the face ε_f = g h / 2, are

    along, across    curvature of the bar along x and y over g
    stress           largest component of the stress of a cell over E ε_f, which should be zero
    turned           curvature along the bar over g if facets have the rest rotation g × (x_j - x_i), which they lack
    moment           curvature under a bending moment over that of beam theory
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import product

import numpy as np

import bondem as bd
from bondem.interactions.cells.cell_interaction import CellInteraction
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.statics.static import StaticResult
from validation.frame.record import Record
from validation.measures.accuracy_problems import cells_of

LENGTH, HEIGHT, E, RHO, SLOPE, MOMENT = 40e-3, 10e-3, 30e9, 2400.0, 2e-2, 1e-2
SEEDS, COUNTS, NUS = (1, 2, 3), (300, 1500), (0.2, 0.45)


@contextmanager
def rest_rotations(gradient: np.ndarray) -> Iterator[None]:
    """Solutions of small motions inside have facets with the rest rotation of a field of this gradient [1/m], (3,).

    Facet c of cells i and j then has the rest gap ε* B + θ* × (c - (x_i + x_j) / 2) with B = x_j - x_i, θ* = g × B.
    """
    plain = CellInteraction.small_strain

    def turned(self: CellInteraction, displacement, rotation, strain, pressed) -> CellStrain:
        own, constants, branch = np.empty(len(strain)), self.by_user, self.lattice.branch
        own[self.layout.bond_order] = strain
        rest = np.cross(gradient, branch) if strain.any() else np.zeros_like(branch)
        slip = -own[:, None] * branch - np.cross(rest, 0.5 * (constants.lever_i + constants.lever_j))
        found = CellStrain.of(self.lattice, constants, displacement, rotation, slip=slip, pressed=pressed)
        return replace(found, turn=found.turn - rest)

    try:
        CellInteraction.small_strain = turned  # type: ignore[method-assign]
        yield
    finally:
        CellInteraction.small_strain = plain  # type: ignore[method-assign]


def curvatures(model: bd.Model) -> tuple[StaticResult, float, float]:
    """A static solution, and -∂²u_z/∂x² and -∂²u_z/∂y² of a parabola through its displacements [1/m]."""
    solved = bd.solve_static(model)
    x, y, z = (model.lattice.centre - model.lattice.centre.mean(axis=0)).T
    terms = np.stack([x * x, y * y, z * z, x * y, x * z, y * z, x, y, z, np.ones_like(x)], axis=1)
    fitted = np.linalg.lstsq(terms, solved.displacement[:, 2], rcond=None)[0]
    return solved, -2.0 * float(fitted[0]), -2.0 * float(fitted[1])


def bent(body: bd.Lattice, nu: float) -> dict[str, float]:
    """Curvatures and stresses of one bar."""
    law = bd.CellBond(E=E, nu=nu)
    field = bd.Eigenstrain(lambda centre: SLOPE * (centre[:, 2] - 0.5 * HEIGHT))
    heated = bd.Model(body, law, RHO, boundary=[field])
    solved, along, across = curvatures(heated)
    with rest_rotations(np.array([0.0, 0.0, SLOPE])):
        turned = curvatures(heated)[1]
    ends = [bd.Load(bd.Face(f"x_{end}"), moment=(0.0, sign * MOMENT, 0.0)) for end, sign in (("max", 1), ("min", -1))]
    theory = 12.0 * MOMENT / (E * HEIGHT**4)
    return {
        "along": along / SLOPE, "across": across / SLOPE,
        "stress": float(np.abs(bd.cell_stress(heated, solved)).max()) / (0.5 * E * SLOPE * HEIGHT),
        "turned": turned / SLOPE, "moment": abs(curvatures(bd.Model(body, law, RHO, boundary=ends))[1]) / theory,
    }  # fmt: skip


def measure(
    record: Record, *, seeds: tuple[int, ...] = SEEDS, counts: tuple[int, ...] = COUNTS, nus: tuple[float, ...] = NUS
) -> None:
    """Measure bars.

    Args:
        seeds: of the packings.
        counts: numbers of cells.
        nus: Poisson's ratios.
    """
    for count, seed in product(counts, seeds):
        body = cells_of(bd.Box((LENGTH, HEIGHT, HEIGHT)), count, seed)
        for nu in nus:
            record.add(partial(bent, body, nu), count=count, seed=seed, nu=nu)
