"""Free surfaces at each cell of a body: those of layers and columns one cell thick, and single ones."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, Mask, PerElement3
from bondem.interactions.cells.cell_body import body_of, sums_of_normals
from bondem.specimen.lattice import Lattice

# Share of free facets along an axis above which a cell belongs to a layer: 1 in a plate one cell thick (at least 0.83
# with uneven cells), 1/2 at a flat surface. Least share of all cells, and least number of them, that make a layer.
_THIN, _PART, _FEW = 0.75, 0.1, 8
# Share of free facets along an axis above which they are a free surface of the cell.
_WALL = 0.2


@dataclass(frozen=True, eq=False)
class FreeWalls:
    """Directions across which cells are free, user's order.

    Attributes:
        layer: directions in which the body is one cell thick at each cell, the thinnest first [-], shape (n, 2, 3);
            zero where it is thicker. Both are set in a column.
        wall: normal of the free surface of each cell that has a single one, or of its layer [-], shape (n, 3);
            zero elsewhere.
    """

    layer: Floats
    wall: PerElement3

    @classmethod
    def of(cls, body: Lattice, fixed: Ints | None = None) -> "FreeWalls":
        """Return the directions across which the cells of a body are free.

        Args:
            body: a lattice with facets and cells.
            fixed: indices into `cells.free` of facets whose normal displacement is constrained, not counted; or None.
        """
        share, axis = _free_axes(body, fixed)
        thin = share > _THIN
        layer = np.zeros((len(share), 2, 3))
        for place, column in enumerate((2, 1)):
            if is_layer(thin[:, column]):
                layer[:, place] = np.where(thin[:, column, None], axis[:, :, column], 0.0)
        one = (share[:, 2] > _WALL) & (share[:, 1] < _WALL)
        wall = np.where(one[:, None], axis[:, :, 2], 0.0)
        return cls(layer, np.where((layer[:, 0] ** 2).sum(axis=1, keepdims=True) > 0.0, layer[:, 0], wall))

    @property
    def column(self) -> Mask:
        """Mask of the cells of columns one cell wide, shape (n,)."""
        return np.asarray(self.layer[:, 1].any(axis=1))


def is_layer(thin: Mask) -> bool:
    """Return True if cells without neighbours on opposite sides are numerous enough to be a layer."""
    return int(thin.sum()) >= max(_FEW, _PART * len(thin))


def thin_ways(body: Lattice) -> Ints:
    """Return the number of axes along which each cell has no neighbours on opposite sides, shape (n,)."""
    return np.asarray((_free_axes(body, None)[0] > _THIN).sum(axis=1))


def _free_axes(body: Lattice, fixed: Ints | None) -> tuple[Floats, Floats]:
    """Return the shares of free facets in Σ A d n⊗n, (n, 3), ascending, and the axes of free surfaces, (n, 3, 3).

    The axes are columns in the order of the shares: principal axes of Σ A d n⊗n of the free facets alone.
    """
    facets, cells = body_of(body)
    n, free = len(cells.volume), cells.free
    outer = free.area * free.depth
    whole = sums_of_normals(free.cell, outer, free.normal, n)
    whole += sums_of_normals(body.pairs[:, 0], facets.area * facets.depth_i, facets.normal, n)
    whole += sums_of_normals(body.pairs[:, 1], facets.area * facets.depth_j, facets.normal, n)
    if fixed is not None:
        outer = outer.copy()
        outer[fixed] = 0.0
    open_part = sums_of_normals(free.cell, outer, free.normal, n)
    root = np.linalg.inv(np.linalg.cholesky(whole))
    share = np.linalg.eigvalsh(root @ open_part @ np.swapaxes(root, 1, 2))
    return np.asarray(share, dtype=float), np.asarray(np.linalg.eigh(open_part)[1], dtype=float)
