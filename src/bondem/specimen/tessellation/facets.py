"""Tables of a tessellation: facets between cells, free facets on the walls, and the cells themselves."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from bondem._types import Floats, Ints, PerBond, PerBond3, PerElement, PerElement3
from bondem.specimen.particles import freeze
from bondem.specimen.tessellation.symmetric_columns import SymmetricColumn

T = TypeVar("T", "Facets", "FreeFacets", "Cells")

#: Columns of the tables that rotate with their body as points, vectors and tensors; the others do not change.
_POINTS, _VECTORS, _TENSORS = {"centroid"}, {"normal", "share", "share_i", "share_j"}, {"moment", "inertia"}


def _placed(table: T, turn: Floats, by: Floats) -> T:
    """Return a table of a body that was rotated by a matrix (3, 3) about the origin and then moved by (3,) [m]."""
    new: dict[str, Any] = {}
    for item in fields(table):
        old = getattr(table, item.name)
        if item.name in _POINTS:
            new[item.name] = freeze(old @ turn.T + by)
        elif item.name in _VECTORS:
            new[item.name] = freeze(old @ turn.T)
        elif item.name in _TENSORS:
            new[item.name] = freeze(turn @ old @ turn.T)
    return replace(table, **new)


def _stacked(kind: type[T], tables: Sequence[T], **given: Any) -> T:
    """Concatenate the tables of several bodies; `given` columns are taken as they are."""
    rows: dict[str, Any] = {
        item.name: freeze(np.concatenate([getattr(table, item.name) for table in tables]))
        for item in fields(kind) if item.name not in given
    }  # fmt: skip
    return kind(**rows, **given)


@dataclass(frozen=True, eq=False)
class Facets:
    """Facets between cells, one per pair, in the order of `Lattice.pairs`.

    Attributes:
        area: areas A [m²], shape (m,).
        normal: unit vectors from cell i to cell j [-], shape (m, 3).
        centroid: centroids, in the periodic image next to centre i [m], shape (m, 3).
        moment: second moments of area about the centroid, ∫ r⊗r dA [m⁴], shape (m, 3, 3).
        depth_i, depth_j: distances of centres i and j from the plane, positive on their own sides [m], shape (m,).
        share_i, share_j: shares of the facet in the dilatation θ of cells i and j [m²], (m, 3). V θ is Σ share·δ
            over the facets of a cell, with δ the jumps across them (`bondem.specimen.tessellation.balanced_shares`).
    """

    area: PerBond
    normal: PerBond3
    centroid: PerBond3
    moment: Floats
    depth_i: PerBond
    depth_j: PerBond
    share_i: PerBond3
    share_j: PerBond3

    @property
    def span(self) -> PerBond:
        """Distance of the two centres along the normal, L = d_i + d_j [m], shape (m,)."""
        return self.depth_i + self.depth_j

    def placed(self, turn: Floats, by: Floats) -> "Facets":
        """Return the facets of the body rotated by a matrix (3, 3) about the origin, then moved by (3,) [m]."""
        return _placed(self, turn, by)

    @classmethod
    def of_all(cls, bodies: Sequence["Facets"]) -> "Facets":
        """Return the facets of several bodies, one body after the other."""
        return _stacked(cls, bodies)


@dataclass(frozen=True, eq=False)
class FreeFacets:
    """Facets on the walls of the shape, k of them, sorted by cell.

    Attributes:
        cell: cell of each facet, shape (k,).
        area: areas [m²], shape (k,).
        normal: outward unit vectors [-], shape (k, 3).
        centroid: centroids [m], shape (k, 3).
        moment: second moments of area about the centroid, ∫ r⊗r dA [m⁴], shape (k, 3, 3).
        depth: distance of the cell's centre from the plane of the facet, positive inside [m], shape (k,).
        face: index of the face in `Shape.faces`, or -1 for walls that belong to none, shape (k,).
        share: share of the facet in the dilatation of its cell, A n for balanced shares [m²], shape (k, 3).
    """

    cell: Ints
    area: Floats
    normal: Floats
    centroid: Floats
    moment: Floats
    depth: Floats
    face: Ints
    share: Floats


SymmetricColumn("moment", Facets, FreeFacets)


@dataclass(frozen=True, eq=False)
class Cells:
    """Volumes, moments and free facets of cells, one cell per element, in the order of the elements.

    Attributes:
        volume: volumes V [m³], shape (n,).
        centroid: centre of mass [m], shape (n, 3); in a periodic cell in the image next to the centre.
        inertia: tensor of inertia about the centroid at density 1 [m⁵], shape (n, 3, 3).
        remainder: error of the dilatation under a unit uniform strain that the shares leave [-], shape (n,); below
            1e-7, except where a cell has too few facets to satisfy all six equations.
        free: facets on the surface of the body.
    """

    volume: PerElement
    centroid: PerElement3
    inertia: Floats
    remainder: PerElement
    free: FreeFacets

    @cached_property
    def spread(self) -> PerElement3:
        """Mean square distance of each cell's volume from its centroid along x, y and z [m²], shape (n, 3)."""
        own = np.einsum("naa->na", self.inertia)
        return freeze((0.5 * own.sum(axis=1)[:, None] - own) / self.volume[:, None])

    @cached_property
    def free_area(self) -> PerElement:
        """Wall area of each cell [m²], shape (n,)."""
        return freeze(np.bincount(self.free.cell, weights=self.free.area, minlength=len(self.volume)))

    def placed(self, turn: Floats, by: Floats) -> "Cells":
        """Return the cells of the body rotated by a matrix (3, 3) about the origin, then moved by (3,) [m]."""
        return replace(_placed(self, turn, by), free=_placed(self.free, turn, by))

    @classmethod
    def of_all(cls, bodies: Sequence["Cells"]) -> "Cells":
        """Return the cells of several bodies, one body after the other."""
        first = np.cumsum([0, *(len(one.volume) for one in bodies)])
        cell = freeze(np.concatenate([one.free.cell + k for one, k in zip(bodies, first, strict=False)]))
        return _stacked(cls, bodies, free=_stacked(FreeFacets, [one.free for one in bodies], cell=cell))
