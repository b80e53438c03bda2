"""Large specimens by repetition of a periodic one, because packing a million spheres takes minutes."""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

import bondem as bd


def tiled(lattice: bd.Lattice, k: int) -> bd.Lattice:
    """Return a periodic lattice repeated k times along each edge: k³ copies of all elements, bonds and facets.

    Args:
        lattice: periodic lattice, whose shape is a Cell.
        k: number of copies along each of x, y and z.

    Returns:
        Lattice in which copy c = (cx k + cy) k + cz of element e is element c n + e.
    """
    base = lattice.particles
    assert base.period is not None, "only a periodic lattice can be repeated"
    n = len(base)
    copies = np.stack(np.meshgrid(*[np.arange(k)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    i, j = lattice.pairs.T
    # number of periods between j and its nearest image
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
    """Return a table of facets or cells, copied like their elements; `moved` returns the copies of points."""
    columns = {}
    for field in fields(table):
        values = getattr(table, field.name)
        if field.name == "centroid":
            columns[field.name] = moved(values)
        elif isinstance(values, np.ndarray):
            columns[field.name] = np.tile(values, (k**3,) + (1,) * (values.ndim - 1))
    return replace(table, **columns)


def specimen(elements: int, *, largest: int = 20_000, seed: int = 1, method: str = "distance") -> bd.Lattice:
    """Return about `elements` bonded spheres of 1 mm in a periodic cell, with κ = 25 % and z = 6.2.

    Args:
        elements: number of elements, up to rounding to a cube of copies.
        largest: largest number of spheres of the repeated packing.
        seed: seed of the packing.
        method: method of `bd.connect`; "laguerre" returns cells instead of bonded spheres.
    """
    k = 1
    while elements > largest * k**3:
        k += 1
    count = round(elements / k**3)
    edge = (count * 4.0 / 3.0 * np.pi * 1e-9 / 0.64) ** (1.0 / 3.0)
    base = bd.connect(bd.pack(bd.Cell(size=(edge, edge, edge)), count=count, spread=0.25, seed=seed), method=method)
    return base if k == 1 else tiled(base, k)
