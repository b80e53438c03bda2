"""Eigenvalues of the stiffness of twenty bodies of cells, and their highest frequencies beside the former law.

A free body has six motions without energy, and no more, at any Poisson's ratio. The matrix is scaled to a unit
diagonal, so that its eigenvalues are pure numbers: the largest of the six, and the least of the others. The largest
frequency sets the time step. It is compared with that of the law before the balanced shares (M⁻¹, no twist at walls
and no gradients of the dilatation) for ν up to 0.49.

Run: python benchmarks/positive_energy.py
It writes benchmarks/results/positive_energy.json.
"""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from scipy.linalg import eigh

import bondem as bd
from bondem.errors import AuxeticWarning, FillingWarning, ThinBodyWarning, UnitWarning
from bondem.interactions.cells import cell_constants
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.io.older_bodies import with_corrected_normals
from bondem.model.highest_frequency import highest_frequency
from bondem.model.stiffness_matrices import stiffness_matrix
from kept import RESULTS, keep, origin

NU = (-0.5, -0.3, 0.0, 0.2, 0.4, 0.49, 0.4999)
NU_OF_STEPS = (0.2, 0.4, 0.45, 0.49)
SEEDS = (41, 42, 43, 44, 45)


def unit_cells(edges: tuple[int, int, int], seed: int) -> bd.Lattice:
    """Unequal cells about the points of a grid of edge 1."""
    grid = np.stack(np.meshgrid(*(np.arange(n) + 0.5 for n in edges), indexing="ij"), axis=-1).reshape(-1, 3)
    grid += np.random.default_rng(seed).uniform(-0.2, 0.2, grid.shape)
    return bd.connect(bd.Particles(grid, 0.25, shape=bd.Box(edges)), method="laguerre")


def bodies() -> Iterator[tuple[str, bd.Lattice]]:
    """Three kinds of packings with five seeds each, layers, a column, random points, and a slotted body."""
    for seed in SEEDS:
        yield f"cube, seed {seed}", cut(bd.Box((1.0, 1.0, 1.0)), seed)
        yield f"cylinder, seed {seed}", cut(bd.Cylinder(radius=0.5, length=2.0), seed)
        yield f"plate, seed {seed}", cut(bd.Box((4.0, 3.0, 1.0)), seed, method="even")
    for seed in SEEDS[:2]:
        yield f"sheet one cell thick, seed {seed}", unit_cells((9, 8, 1), seed)
    yield "column one cell wide", unit_cells((14, 1, 1), SEEDS[0])
    points = np.random.default_rng(SEEDS[0]).uniform(0.02, 0.98, (120, 3))
    yield "random points", bd.connect(bd.Particles(points, 1e-3, shape=bd.Box((1.0, 1.0, 1.0))), method="laguerre")
    slot = bd.Box((10.0, 4.0, 2.0)).cut(bd.Box((6.0, 0.1, 4.0)).moved((0.0, 2.0, -1.0)), name="slot")
    yield "slotted block", cut(slot, SEEDS[0], method="even")


def cut(shape: bd.Shape, seed: int, **options: Any) -> bd.Lattice:
    """A packing of 150 spheres, cut into cells."""
    return bd.connect(bd.pack(shape, count=150, seed=seed, **options), method="laguerre")


@contextmanager
def former_law() -> Iterator[None]:
    """Models made inside have neither twist at free walls nor gradients."""
    twist, gradients = cell_constants.twist_at_walls, GradientConstants.of
    cell_constants.twist_at_walls = lambda S, *_: np.zeros_like(S)
    GradientConstants.of = lambda *_: GradientConstants.none()  # type: ignore[method-assign]
    try:
        yield
    finally:
        cell_constants.twist_at_walls, GradientConstants.of = twist, gradients  # type: ignore[method-assign]


def eigenvalues(body: bd.Lattice, nu: float) -> dict[str, float]:
    """The largest of the six eigenvalues of rigid motions, and the least of the others [-]."""
    K = stiffness_matrix(bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0)).tocsc().toarray()
    scale = 1.0 / np.sqrt(np.diag(K))
    value = eigh(K * scale[:, None] * scale, eigvals_only=True)
    return {"rigid": float(np.abs(value[:6]).max()), "least": float(value[6])}


def frequencies(body: bd.Lattice, nu: float) -> float:
    """Highest frequency over that of the former law."""
    law = bd.CellBond(E=1.0, nu=nu)
    now = highest_frequency(bd.Model(body, law, 1.0))
    with former_law():
        return now / highest_frequency(bd.Model(with_corrected_normals(body, []), law, 1.0))


def main() -> None:
    for expected in (AuxeticWarning, FillingWarning, ThinBodyWarning, UnitWarning):
        warnings.simplefilter("ignore", expected)
    begun, rows = origin(), []
    for name, body in bodies():
        found = {f"{nu:g}": eigenvalues(body, nu) for nu in NU}
        steps = {f"{nu:g}": frequencies(body, nu) for nu in NU_OF_STEPS}
        rows.append({"body": name, "cells": len(body.particles), "eigenvalues": found, "frequency": steps})
        least, rigid = min(one["least"] for one in found.values()), max(one["rigid"] for one in found.values())
        ratios = ", ".join(f"{value:.4f}" for value in steps.values())
        print(f"{name}: rigid {rigid:.0e}, least other {least:.1e}; highest frequency {ratios}", flush=True)
    keep(RESULTS / "positive_energy.json", begun | {"rows": rows})


if __name__ == "__main__":
    main()
