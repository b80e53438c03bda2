"""Large specimens by repeating a periodic one: packing a million spheres takes minutes, copying them a moment."""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

import bondem as bd


def tiled(lattice: bd.Lattice, k: int) -> bd.Lattice:
    """A periodic lattice k times along each edge: k³ as many elements, each with the bonds, or facets, it had.

    Args:
        lattice: with a period; its shape is a Cell.
        k: copies along x, y and z.

    Returns:
        Copy c = (cx k + cy) k + cz of element e is element c n + e.
    """
    base = lattice.particles
    assert base.period is not None, "only a periodic lattice can be repeated"
    n = len(base)
    copies = np.stack(np.meshgrid(*[np.arange(k)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    i, j = lattice.pairs.T
    # how many cells away the nearest image of j is
    image = -np.rint((lattice.centre[j] - lattice.centre[i]) / base.period).astype(np.int64)
    beyond = (copies[:, None] + image) % k @ (k * k, k, 1)
    pairs = np.stack([np.arange(k**3)[:, None] * n + i, beyond * n + j], axis=-1).reshape(-1, 2)
    size = k * base.period

    def moved(points: np.ndarray) -> np.ndarray:
        return (points + copies[:, None] * base.period).reshape(-1, 3)

    particles = bd.Particles(
        moved(base.position), np.tile(base.radius, k**3), size, bd.Cell(size=tuple(size))
    )  # fmt: skip
    if lattice.facets is None or lattice.cells is None:
        return bd.Lattice(particles, np.sort(pairs, axis=1))
    assert len(lattice.cells.free.cell) == 0
    return bd.Lattice(
        particles, pairs, facets=_repeated(lattice.facets, moved, k), cells=_repeated(lattice.cells, moved, k)
    )  # fmt: skip


def _repeated(table: Any, moved: Callable[[np.ndarray], np.ndarray], k: int) -> Any:
    """Facets or cells without walls, copied like their elements."""
    columns = {}
    for field in fields(table):
        values = getattr(table, field.name)
        if field.name == "centroid":
            columns[field.name] = moved(values)
        elif isinstance(values, np.ndarray):
            columns[field.name] = np.tile(values, (k**3,) + (1,) * (values.ndim - 1))
    return replace(table, **columns)


def specimen(elements: int, *, largest: int = 20_000, seed: int = 1, method: str = "distance") -> bd.Lattice:
    """About `elements` spheres of 1 mm in a periodic cell, κ = 25 %, z = 6.2, bonded at their contacts.

    Args:
        elements: as many, up to rounding to a cube of copies.
        largest: spheres of the packing that is repeated, at most.
        seed: of the packing.
        method: of `bd.connect`: "laguerre" cuts them into cells instead.
    """
    k = 1
    while elements > largest * k**3:
        k += 1
    count = round(elements / k**3)
    edge = (count * 4.0 / 3.0 * np.pi * 1e-9 / 0.64) ** (1.0 / 3.0)
    base = bd.connect(bd.pack(bd.Cell(size=(edge, edge, edge)), count=count, spread=0.25, seed=seed), method=method)
    return base if k == 1 else tiled(base, k)
