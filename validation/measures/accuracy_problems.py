"""Problems of time_to_accuracy.py: each method of each, from nothing to its error.

An `Attempt` makes a body (packs and cuts it, bonds and calibrates it, or meshes it), solves, and returns the error.
Packings are made anew: none is read from disk.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from time import process_time
from typing import Any

import numpy as np
from scipy.sparse import csc_matrix
from scipy.special import erf
from skfem import Basis, ElementHex2, ElementVector, MeshHex

import bondem as bd
from validation.measures.continuum import Continuum, _factor

#: Numbers of elements along the edges.
Mesh = tuple[int, int, int]
SEEDS = (1, 2)
SILICA = bd.materials.fused_silica
#: Number of frequencies compared.
COUNT = 6


#: Error over the exact value [-], and seconds of the processors for a mesh and its matrices, an interpreted loop over
#: shape functions.
Found = tuple[float, float]


@dataclass(frozen=True)
class Attempt:
    """One method with one size.

    Attributes:
        method: name of the method.
        size: number of cells, or elements along the edges.
        seed: of the packing; None for a mesh.
        run: does all of it.
    """

    method: str
    size: int | str
    seed: int | None
    run: Callable[[], Found]


@dataclass(frozen=True)
class Problem:
    """A problem with an exact solution, or one by a finer mesh.

    Attributes:
        error: what the error is.
        attempts: by method, from coarse to fine.
        warm: attempts that compile and load what the others use.
        exact: values to compare with, where a mesh gave them.
    """

    error: str
    attempts: list[Attempt]
    warm: list[Attempt]
    exact: list[float] | None = None


def cells_of(shape: bd.Shape, count: int, seed: int) -> bd.Lattice:
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed, cache=False), method="laguerre")


def hexahedra(size: Sequence[float], numbers: Mesh) -> Continuum:
    """A box from the origin, cut into equal triquadratic hexahedra."""
    lines = [np.linspace(0.0, edge, n + 1) for edge, n in zip(size, numbers, strict=True)]
    return Continuum(Basis(MeshHex.init_tensor(*lines), ElementVector(ElementHex2()), intorder=4))


def per_seed(method: str, sizes: Sequence[int], run: Callable[[int, int], Found]) -> list[Attempt]:
    return [Attempt(method, size, seed, partial(run, size, seed)) for size, seed in product(sizes, SEEDS)]


def per_mesh(method: str, meshes: Sequence[Mesh], run: Callable[[Mesh], Found]) -> list[Attempt]:
    return [Attempt(method, " × ".join(map(str, mesh)), None, partial(run, mesh)) for mesh in meshes]


# Frequencies of free bodies


def worst(frequency: np.ndarray, exact: np.ndarray) -> float:
    return float(np.abs(np.sort(frequency)[:COUNT] / exact - 1.0).max())


def mesh_frequency(size: Sequence[float], mesh: Mesh) -> tuple[np.ndarray, float]:
    """Frequencies [Hz], and the seconds of the processors for the assembly."""
    began = process_time()
    body = hexahedra(size, mesh)
    body.stiffness(SILICA.E, SILICA.nu)
    assembly = process_time() - began
    return np.sort(body.vibration(SILICA.E, SILICA.nu, SILICA.rho, count=COUNT).frequency), assembly


def frequencies(
    size: tuple[float, float, float],
    counts: Sequence[int],
    meshes: Sequence[Mesh],
    finest: Mesh,
    beams: Sequence[int] = (),
) -> Problem:
    """First six frequencies of a free box of fused silica."""
    exact, _ = mesh_frequency(size, finest)

    def of_cells(count: int, seed: int) -> Found:
        model = bd.Model(cells_of(bd.Box(size), count, seed), bd.CellBond(E=SILICA.E, nu=SILICA.nu), SILICA.rho)
        return worst(bd.solve_modes(model, count=COUNT).frequency, exact), 0.0

    def of_beams(count: int, seed: int) -> Found:
        lattice = bd.connect(bd.pack(bd.Box(size), count=count, spread=0.25, seed=seed, cache=False))
        fit = bd.calibrate(lattice, SILICA)
        return worst(bd.solve_modes(bd.Model(lattice, fit.law, fit.density), count=COUNT).frequency, exact), 0.0

    def of_mesh(mesh: Mesh) -> Found:
        frequency, assembly = mesh_frequency(size, mesh)
        return worst(frequency, exact), assembly

    cells, bonds = per_seed("cells", counts, of_cells), per_seed("beams", beams, of_beams)
    attempts = [*cells, *bonds, *per_mesh("mesh", meshes, of_mesh)]
    return Problem("largest of six frequencies", attempts, cells[:1] + bonds[:1], exact.tolist())


def beam() -> Problem:
    """Free beam."""
    counts, bonds = (150, 300, 600, 1200, 2500, 5000, 10_000), (1200, 2500, 5000, 10_000)
    meshes = ((4, 1, 1), (6, 1, 1), (8, 1, 1), (8, 2, 2), (16, 2, 2), (24, 3, 3))
    return frequencies((40e-3, 5e-3, 5e-3), counts, meshes, (32, 4, 4), bonds)


def plate() -> Problem:
    """Free plate."""
    meshes = ((2, 2, 1), (3, 3, 1), (4, 4, 1), (6, 6, 1), (8, 8, 1), (10, 10, 1), (8, 8, 2))
    return frequencies((20e-3, 20e-3, 2.5e-3), (60, 125, 250, 500, 1000, 2000), meshes, (18, 18, 3))


# Pulse

#: Period and section of the bar, standard deviation of the Gaussian, and its velocity.
LENGTH, WIDTH, DEVIATION, SPEED = 8.0, 1.0, 0.7, 1e-6
MEDIUM = bd.CellBond(E=1.0, nu=0.2)
CELERITY = float(np.sqrt(MEDIUM.lame + 2.0 * MEDIUM.G))
SECTIONS = 32
#: Numbers of cells, with lumped masses and with the dispersion-corrected mass matrix.
LUMPED, CORRECTED = (1000, 2000, 4000, 8000, 16_000), (300, 500, 1000, 2000, 4000)
#: Steps of the mesh during the time of the run.
STEPS = 250


def images(x: np.ndarray) -> np.ndarray:
    """Distance from the centres of the pulse, in the middle of the period and of its neighbours, over σ √2."""
    return np.stack([x % LENGTH - (0.5 + shift) * LENGTH for shift in (-1, 0, 1)]) / (np.sqrt(2.0) * DEVIATION)


def velocity_of(x: np.ndarray) -> np.ndarray:
    """Gaussian in every period; at a later time that of x - c t, by d'Alembert."""
    return SPEED * np.exp(-(images(x) ** 2)).sum(axis=0)


def displacement_of(x: np.ndarray) -> np.ndarray:
    """Displacement of a pulse that runs along +x alone: -∫ (v - mean v) dx / c, of the same period."""
    total = SPEED * DEVIATION * np.sqrt(2.0 * np.pi) / CELERITY
    return total * (x % LENGTH / LENGTH - 0.5 * erf(images(x)).sum(axis=0))


def pulse_of_cells(mass: Any, safety: float, count: int, seed: int) -> Found:
    """Error of means of sections."""
    body = cells_of(bd.Cell((LENGTH, WIDTH, WIDTH)), count, seed)
    model = bd.Model(body, MEDIUM, 1.0, mass_matrix=mass)
    assert body.cells is not None
    x, volume = body.centre[:, 0], body.cells.volume
    state = model.state()
    state.set_motion(velocity=velocity_of(x)[:, None] * [1.0, 0.0, 0.0])
    state.displacement = displacement_of(x)[:, None] * [1.0, 0.0, 0.0]
    end = bd.solve_explicit(model, duration=LENGTH / CELERITY, safety=safety, every=0, state=state).state
    section = np.floor(x / LENGTH * SECTIONS).astype(int) % SECTIONS
    exact = velocity_of(x - CELERITY * end.time)

    def mean(value: np.ndarray) -> np.ndarray:
        return np.bincount(section, volume * value, SECTIONS) / np.bincount(section, volume, SECTIONS)

    return float(np.linalg.norm(mean(end.velocity[:, 0] - exact)) / np.linalg.norm(mean(exact))), 0.0


def pulse_of_mesh(mesh: Mesh) -> Found:
    """Rollers on the sides, periodic along x, consistent masses, central differences; error at integration points."""
    began = process_time()
    body = hexahedra((LENGTH, WIDTH, WIDTH), mesh)
    basis, K = body.basis, body.stiffness(MEDIUM.E, MEDIUM.nu)
    assembly = process_time() - began
    axis, place = np.empty(basis.N, dtype=int), basis.doflocs
    for table in (basis.nodal_dofs, basis.edge_dofs, basis.facet_dofs, basis.interior_dofs):
        axis[table] = (np.arange(len(table)) % 3)[:, None]
    across = np.where(axis == 0, 0.5 * WIDTH, place[axis, np.arange(basis.N)])
    kept = np.flatnonzero(np.abs(across - 0.5 * WIDTH) < 0.499 * WIDTH)
    keys = np.column_stack((place[:, kept].T, axis[kept]))
    keys[:, 0] %= LENGTH
    _, first, alike = np.unique(keys.round(6), axis=0, return_index=True, return_inverse=True)
    tied = csc_matrix((np.ones(len(kept)), (kept, alike.ravel())), shape=(basis.N, len(first)))
    M, K = (tied.T @ body.mass @ tied).tocsc(), (tied.T @ K @ tied).tocsr()
    inverse = _factor(M)
    one = kept[first]
    velocity, u = (np.where(axis[one] == 0, of(place[0, one]), 0.0) for of in (velocity_of, displacement_of))
    dt = LENGTH / CELERITY / STEPS
    acceleration = inverse.solve(-(K @ u))
    for _ in range(STEPS):
        velocity += 0.5 * dt * acceleration
        u += dt * velocity
        acceleration = inverse.solve(-(K @ u))
        velocity += 0.5 * dt * acceleration
    exact = velocity_of(np.asarray(basis.global_coordinates())[0] - CELERITY * STEPS * dt)
    miss = np.asarray(basis.interpolate(tied @ velocity)) - exact * np.array([1.0, 0.0, 0.0])[:, None, None]
    return float(np.sqrt((miss**2 * basis.dx).sum() / (exact**2 * basis.dx).sum())), assembly


def pulse() -> Problem:
    """Plane P pulse in a periodic bar: it travels through the whole period once."""
    kinds = {
        "cells, lumped": ("lumped", 0.9, LUMPED),
        "cells, lumped, half the step": ("lumped", 0.45, LUMPED),
        "cells, corrected": ("dispersion-corrected", 0.9, CORRECTED),
        "cells, corrected, half the step": ("dispersion-corrected", 0.45, CORRECTED),
    }
    cells, warm = [], []
    for name, (mass, safety, counts) in kinds.items():
        cells += per_seed(name, counts, partial(pulse_of_cells, mass, safety))
        warm += per_seed(name, CORRECTED[:1], partial(pulse_of_cells, mass, safety))[:1]
    cubes = per_mesh("mesh", ((8, 1, 1), (16, 2, 2), (24, 3, 3)), pulse_of_mesh)
    lines = per_mesh("mesh, one across", ((8, 1, 1), (12, 1, 1), (16, 1, 1), (20, 1, 1), (24, 1, 1)), pulse_of_mesh)
    return Problem("velocity, L2 norm over that of the exact one", cells + cubes + lines, warm + cubes[:1])


PROBLEMS = {"beam": beam, "plate": plate, "pulse": pulse}
