"""Neighbour lists of spheres, over which all short-range forces are summed."""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.packing_tables import NeighbourLists, SphereGrid
from bondem._types import Floats, Ints, Vector

# Largest number of grid cells along an axis, and per sphere: more would cost memory only, as where spheres fly apart.
_MOST_CELLS, _EACH = 1024, 8


def neighbours(
    sphere: Floats, lower: Vector, upper: Vector, period: Vector, skin: float, *, threads: int = 1
) -> tuple[Ints, np.ndarray]:
    """List the spheres whose surfaces are at most `skin` apart, each pair for both partners.

    Args:
        sphere: centres and radii [m], shape (n, 4): x, y, z, R.
        lower, upper: corners of the box that contains the centres [m], (3,).
        period: periodic edge lengths [m], (3,), 0 where an axis is not periodic. A periodic edge must exceed four
            times the largest radius plus two skins.
        skin: largest gap [m].
        threads: number of threads.

    Returns:
        Start of the list of each sphere, shape (n + 1,), and the lists one after the other, shape (p,), uint32.
    """
    grid = _unsorted(sphere, lower, upper, period, skin)
    run_pass(calls.sort_and_count_neighbours(grid), threads=threads)
    lists = NeighbourLists(np.empty(grid.start[len(sphere)], np.uint32))
    run_pass(calls.list_neighbours(grid, lists), threads=threads)
    return grid.start, lists.neighbour


def sphere_grid(sphere: Floats, lower: Vector, upper: Vector, period: Vector, skin: float) -> SphereGrid:
    """Sort spheres into the cells of a grid for the search of neighbours; the arguments are those of `neighbours`."""
    grid = _unsorted(sphere, lower, upper, period, skin)
    run_pass(calls.sort_into_cells(grid))
    return grid


def _no_more(cells: Vector, most: int) -> Vector:
    """Round numbers of cells along the axes, (3,), and limit their product to `most`; long axes are reduced most."""
    cells = np.array(cells)
    for left, axis in zip((3, 2, 1), np.argsort(cells), strict=True):
        share = max(most, 1) ** (1.0 / left) + 1e-9
        cells[axis] = np.floor(max(1.0, min(cells[axis], share)))
        most = int(most // cells[axis])
    return cells


def _unsorted(sphere: Floats, lower: Vector, upper: Vector, period: Vector, skin: float) -> SphereGrid:
    n = len(sphere)
    reach = 2.0 * float(sphere[:, 3].max(initial=0.0)) + skin
    extent = np.asarray(upper, dtype=float) - lower
    wanted = np.clip(extent / reach, 1.0, max(1, min(n, _MOST_CELLS)))
    cells = _no_more(wanted, _EACH * n).astype(np.int64)
    return SphereGrid(
        sphere, np.array(lower, dtype=float), extent / cells, np.array(period, dtype=float), cells, float(skin),
        np.empty(n, np.int64), np.empty(int(cells.prod()) + 1, np.int64), np.empty(n, np.uint32),
        np.empty((4, n + 8)), np.empty(n + 1, np.int64),
    )  # fmt: skip
