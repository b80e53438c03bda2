"""What a cell's inertia is worth: the first six free frequencies of a beam of cells, three matrices of mass.

The same stiffness with masses at the centres of mass and a third of the trace of each tensor of inertia (what bondem
has), with the full tensor, and with masses at the generators of the tessellation and a third of the trace about
these, which is what an element at its generator would have. A beam 40 × 5 × 5 mm against triquadratic finite
elements; modes of one frequency as a group.
"""

from functools import partial
from itertools import product
from typing import Any

import numpy as np
from scipy.sparse import bsr_array
from scipy.sparse.linalg import eigsh

import bondem as bd
from bondem.statics.linear import System
from validation.frame.record import Record
from validation.measures.bodies import MODES, free_modes
from validation.measures.matching import groups
from validation.studies.cell_bodies import cut

SHAPE = "beam"
#: ω² about which eigenvalues are looked for: far below that of the first mode, for E = ρ = 1 [1/s²].
BELOW = -10.0


def _crossed(arm: np.ndarray) -> np.ndarray:
    """Matrices X with X θ = θ × arm, (n, 3, 3)."""
    return np.cross(arm[:, None], np.eye(3))  # row a is arm × e_a, and e_a · (θ × arm) = θ · (arm × e_a)


def masses(body: bd.Lattice) -> dict[str, np.ndarray]:
    """Matrices of mass, ρ = 1, (u, θ) of the centre of mass of each element, (n, 6, 6)."""
    assert body.cells is not None
    volume, tensor = body.cells.volume, body.cells.inertia
    third = np.trace(tensor, axis1=1, axis2=2)[:, None, None] / 3.0 * np.eye(3)
    arm = body.particles.position - body.centre
    square = (arm**2).sum(axis=1)
    own = np.zeros((len(volume), 6, 6))
    own[:, :3, :3] = volume[:, None, None] * np.eye(3)
    full, moved = own.copy(), own.copy()
    own[:, 3:, 3:], full[:, 3:, 3:] = third, tensor
    # the motion of the generator is u + X θ; the trace about it is larger by 2 m arm²
    X = _crossed(arm)
    about = third + (2.0 / 3.0 * volume * square)[:, None, None] * np.eye(3)
    moved[:, :3, 3:] = volume[:, None, None] * X
    moved[:, 3:, :3] = np.swapaxes(moved[:, :3, 3:], 1, 2)
    moved[:, 3:, 3:] = about + volume[:, None, None] * np.swapaxes(X, 1, 2) @ X
    return {"centre of mass, third of the trace": own, "centre of mass, full tensor": full,
            "generator, third of the trace": moved}  # fmt: skip


def frequencies(model: bd.Model) -> dict[str, np.ndarray]:
    """Free frequencies under each mass, ascending [Hz]."""
    order, stiffness = model.layout.order, System.of(model).matrix.tocsc()
    n = len(order)
    found = {}
    for name, blocks in masses(model.lattice).items():
        M = bsr_array((blocks[order], np.arange(n), np.arange(n + 1)), shape=(6 * n, 6 * n))
        # below all squares, of which the first six are those of rigid motions
        square = eigsh(stiffness, k=6 + MODES, M=M, sigma=BELOW, return_eigenvectors=False)
        found[name] = np.sqrt(np.sort(square)[6:]) / (2.0 * np.pi)
    return found


def errors(found: np.ndarray, theory: np.ndarray) -> list[float]:
    """Of the first six, those of one frequency as a group."""
    rows: list[float] = []
    for group in groups(theory):
        measured, exact = (float(np.sqrt((f[group] ** 2).mean())) for f in (found, theory))
        rows += [measured / exact - 1.0] * len(group)
    return rows[:6]


def measure(
    record: Record, *, counts: tuple[int, ...] = (500, 2500), seeds: tuple[int, ...] = (1, 2),
    nus: tuple[float, ...] = (0.2, 0.4),
) -> None:  # fmt: skip
    """Measure all cases."""
    record.keep(shape=SHAPE)
    for count, seed, nu in product(counts, seeds, nus):
        record.add(partial(measured, count, seed, nu), "rows", count=count, seed=seed, nu=nu)


def measured(count: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """Errors of one body under each mass."""
    model = bd.Model(cut(SHAPE, count, seed), bd.CellBond(E=1.0, nu=nu), 1.0)
    theory = free_modes(SHAPE, nu).frequency
    return [{"inertia": name, "errors": errors(found, theory)} for name, found in frequencies(model).items()]
