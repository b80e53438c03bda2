"""Energy of gradients of the dilatation θ: between cells, and across layers one cell thick.

A cell p has one dilatation θ_p and the stress σ_p = λ_p θ_p. The energy ½ λ j |∇θ|² per volume of a gradient within
the cell is therefore missing. j is the mean of z² over cells, with z the distance from the centre. Two terms add it.

- Between cells of one material: U = Σ ½ c (σ_i - σ_j)² over facets of area A between centres L apart. The difference
  between cells stands for the gradient within. c = A L κ / (λ² L̄²), κ = λ j and L̄² = Σ A L³ / Σ A L. In κ, λ is
  at most 2 G, the stiffness of facets. A larger κ would raise the highest frequency, and stiffen plates near ν = 0.4.
- Across a layer of normal a: a relative rotation ρ opens a facet by ρ × a per height. The curvature χ follows from
  V χ = Σ ρ·(a × s) over the facets within the layer, with their shares s. Its energy is U = ½ J λ_p χ² with
  J = ∫ (a·(x - x_p))² dV. A column has two such directions a.

Both terms are for λ ≥ 0. Models whose facets may fail have neither, because a facet that fails would change the
stress of the neighbours of its cells.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.sparse import bsr_array, coo_array, csr_array

from bondem._types import Floats, Ints, PerBond, PerElement
from bondem.boundary.wall_constraints import Supports
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.free_walls import FreeWalls
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout, Reversed

Springs = tuple[np.ndarray, np.ndarray, PerBond]
# Lamé's λ over G beyond which the gradient term between cells stays constant.
_STIFFEST = 2.0
# Squared cosine of the angle between the normals of two cells within which they are one layer.
_PARALLEL = 0.5


@dataclass(frozen=True, eq=False)
class GradientConstants:
    """Constants of the energy of gradients of the dilatation, between cells and across layers one cell thick.

    Attributes:
        springs: function that returns cells i and j of facets with a spring, int32, and its c [m³/Pa], (k,) each.
        a, b: cells of the facets within layers, shape (l,).
        facet: numbers of these facets, shape (l,).
        way_a, way_b: n × s of both cells, with directions n across their layer and shares s of the facet [m²], shape
            (l, 2, 3): V χ is Σ ρ·(n × s), with ρ = θ_b - θ_a.
        wall: rows of `CellConstants.supports` with walls that constrain cells of layers, shape (h,).
        wall_cell: cells that these walls constrain, shape (h,).
        wall_way: n × s of these walls [m²], shape (h, 2, 3): they add -θ·(n × s) to V χ.
        weight: J λ_p / V² of each cell and direction, J its second moment [Pa/m], (n, 2), or (0, 2) without layers.
    """

    springs: Callable[[], Springs]
    a: Ints
    b: Ints
    facet: Ints
    way_a: Floats
    way_b: Floats
    wall: Ints
    wall_cell: Ints
    wall_way: Floats
    weight: Floats

    @classmethod
    def none(cls) -> "GradientConstants":
        """Return constants without terms."""
        no, ways = np.zeros(0, dtype=np.int64), np.zeros((0, 2, 3))
        return cls(_no_springs, no, no, no, ways, ways, no, no, ways, np.zeros((0, 2)))

    @classmethod
    def of(
        cls, body: Lattice, G: PerElement, lame: PerElement, layered: PerElement, walls: FreeWalls,
        shares: tuple[Floats, Floats], supports: Supports,
    ) -> "GradientConstants":  # fmt: skip
        """Return the constants of a body.

        Args:
            body: a lattice with facets and cells.
            G, lame: shear modulus and Lamé's λ of each cell [Pa], (n,).
            layered: λ_p of each cell, which its free facets reduce [Pa], (n,).
            walls: directions across which the cells are free.
            shares: shares of the facets in both cells [m²], (m, 3) each.
            supports: walls that constrain facets.
        """
        _, cells = body_of(body)
        i, j = body.pairs.T
        layer = walls.layer
        parallel = (np.einsum("mxa,mya->mxy", layer[i], layer[j]) ** 2).sum(axis=2) > _PARALLEL
        back = (np.einsum("mxa,mya->mxy", layer[j], layer[i]) ** 2).sum(axis=2) > _PARALLEL
        facet = np.flatnonzero((parallel | back).any(axis=1))
        way_a = np.cross(layer[i], shares[0][:, None]) * parallel[:, :, None]
        way_b = np.cross(layer[j], shares[1][:, None]) * back[:, :, None]
        inertia = 0.5 * np.einsum("naa->n", cells.inertia)[:, None]
        second = inertia - np.einsum("nxa,nab,nxb->nx", layer, cells.inertia, layer)
        weight = second * np.maximum(layered / cells.volume**2, 0.0)[:, None] * layer.any(axis=2)
        wall_way = np.cross(layer[supports.cell], supports.share[:, None])
        wall = np.flatnonzero(wall_way.any(axis=(1, 2)))
        if not len(facet) or not weight.any():
            facet, wall, weight = facet[:0], wall[:0], weight[:0]
        return cls(
            partial(_springs, body, G, lame), i[facet], j[facet], facet, way_a[facet], way_b[facet], wall,
            supports.cell[wall], wall_way[wall], weight,
        )  # fmt: skip

    def ordered(self, layout: Layout | Reversed) -> "GradientConstants":
        """Return the constants in the order of a layout, internal or reversed."""
        place = np.empty(len(layout.bond_order), dtype=np.int64)
        place[layout.bond_order] = np.arange(len(place))
        weight = self.weight[layout.order] if len(self.weight) else self.weight
        rank = layout.rank
        return GradientConstants(
            partial(_ranked, self.springs, rank), rank[self.a], rank[self.b], place[self.facet], self.way_a,
            self.way_b, self.wall, rank[self.wall_cell], self.wall_way, weight,
        )  # fmt: skip

    def differences(self, stress: PerElement) -> PerElement:
        """Return Σ c (σ_p - σ_q) over the springs c of each cell p to cells q [m³], for stresses λ θ [Pa], (n,)."""
        (i, j, spring), n = self.springs(), len(stress)
        force = spring * (stress[i] - stress[j])
        return np.asarray(np.bincount(i, force, n) - np.bincount(j, force, n), dtype=float)

    def bends(self, turn: Floats, rotation: Floats) -> Floats:
        """Return V χ [m²], (n, 2): volume times curvature of each cell across layers that are one cell thick.

        A cell of a column has two such directions. Other entries are zero. Without layers the shape is (0, 2).

        Args:
            turn: relative rotations of all facets [rad], (m, 3).
            rotation: rotations of the cells [rad], (n, 3).
        """
        found = np.zeros_like(self.weight)
        np.add.at(found, self.a, np.einsum("la,lxa->lx", turn[self.facet], self.way_a))
        np.add.at(found, self.b, np.einsum("la,lxa->lx", turn[self.facet], self.way_b))
        np.add.at(found, self.wall_cell, -np.einsum("ha,hxa->hx", rotation[self.wall_cell], self.wall_way))
        return found

    def moments(self, turn: Floats, rotation: Floats) -> tuple[Floats, Floats]:
        """Return the moments of bent layers on cells i of facets, (m, 3), and those by walls on cells, (n, 3) [N·m].

        Layers are one cell thick. The arguments are those of `bends`. Cell j of a facet has the opposite moment.
        """
        moment, wall = np.zeros_like(turn), np.zeros_like(rotation)
        if len(self.facet):
            bent = self.weight * self.bends(turn, rotation)
            moment[self.facet] = np.einsum("lx,lxa->la", bent[self.a], self.way_a)
            moment[self.facet] += np.einsum("lx,lxa->la", bent[self.b], self.way_b)
            np.add.at(wall, self.wall_cell, np.einsum("hx,hxa->ha", bent[self.wall_cell], self.wall_way))
        return moment, wall

    def coupling(self, weight: PerElement) -> csr_array | None:
        """Return W L W, (n, n), of the diagonal `weight` W [Pa/m³] and the Laplacian L of springs, or None."""
        i, j, spring = self.springs()
        if not len(spring):
            return None
        n, value = len(weight), spring * weight[i] * weight[j]
        between = coo_array((value, (i, j)), shape=(n, n))
        own = np.bincount(i, spring, n) + np.bincount(j, spring, n)
        own_part = coo_array((own * weight**2, (np.arange(n), np.arange(n))), shape=(n, n))
        return csr_array(own_part - between - between.T)

    def turns(self, ways: tuple[Floats, Floats, Floats], n: int) -> bsr_array | None:
        """Return the matrix T of `Stiffness`: √weight times `bends` of unit motions, (2 n, 6 n); None without layers.

        Args:
            ways: `way_a` and `way_b`, (l, 2, 3) each, and `wall_way`, (h, 2, 3), turned to the present pose [m²].
            n: number of cells.
        """
        if not len(self.facet):
            return None
        root = np.sqrt(self.weight)
        row, column, value = [], [], []
        for own, way in ((self.a, ways[0]), (self.b, ways[1])):  # the relative rotation of a facet is θ_b - θ_a
            for slot in range(2):
                for end, sign in ((self.a, -1.0), (self.b, 1.0)):
                    row.append(2 * own + slot)
                    column.append(end)
                    value.append(sign * root[own, slot, None] * way[:, slot])
        for slot in range(2):
            row.append(2 * self.wall_cell + slot)
            column.append(self.wall_cell)
            value.append(-root[self.wall_cell, slot, None] * ways[2][:, slot])
        blocks = np.concatenate(value)
        rows = np.repeat(np.concatenate(row), 3)
        columns = (6 * np.concatenate(column)[:, None] + np.arange(3, 6)).ravel()
        found = coo_array((blocks.ravel(), (rows, columns)), shape=(2 * n, 6 * n))
        return bsr_array(csr_array(found), blocksize=(1, 6))


def _springs(body: Lattice, G: PerElement, lame: PerElement) -> Springs:
    facets, _ = body_of(body)
    i, j = body.pairs.T
    inner = np.flatnonzero((lame[i] == lame[j]) & (G[i] == G[j]) & (lame[i] > 0.0))
    i, j = i[inner].astype(np.int32), j[inner].astype(np.int32)
    soft = gradient_stiffness(body, G, lame)[i] / lame[i] ** 2
    return i, j, (facets.area * facets.span)[inner] * soft / mean_square_span(body)


def _no_springs() -> Springs:
    return np.zeros(0, dtype=np.int32), np.zeros(0, dtype=np.int32), np.zeros(0)


def _ranked(springs: Callable[[], Springs], rank: Ints) -> Springs:
    i, j, spring = springs()
    return rank[i].astype(np.int32), rank[j].astype(np.int32), spring


def gradient_stiffness(body: Lattice, G: PerElement, lame: PerElement) -> PerElement:
    """Return κ = min(λ, 2 G) j of each cell [N], 0 for λ < 0, (n,); j is Σ ∫ z² dV / Σ V of the body [m²]."""
    _, cells = body_of(body)
    spread = np.einsum("naa->", cells.inertia) / 6.0 / cells.volume.sum()
    return np.asarray(np.clip(lame, 0.0, _STIFFEST * G) * spread, dtype=float)


def mean_square_span(body: Lattice) -> float:
    """Return L̄² = Σ A L³ / Σ A L over facets of area A between centres L apart [m²]; 0 for a single cell."""
    facets, _ = body_of(body)
    weight = facets.area * facets.span
    return float((weight * facets.span**2).sum() / weight.sum()) if len(weight) else 0.0
