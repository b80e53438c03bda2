"""Constants of the energy of the cell law, per facet and cell of a body."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from bondem._types import Floats, Ints, PerBond, PerBond3, PerElement, PerElement3
from bondem.boundary.wall_constraints import FixedFacets, Supports
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.interactions.cells.facet_resistance import resistance, twist_at_walls
from bondem.interactions.cells.free_walls import FreeWalls
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout, Reversed
from bondem.specimen.regions import Region, as_region
from bondem.specimen.tessellation.facets import Cells, Facets, FreeFacets
from bondem.specimen.tessellation.raster import LEVER_BITS, on_raster, pitch
from bondem.specimen.tessellation.symmetric_columns import NINE, SIX

CellAssignment = CellBond | Mapping[Region, CellBond]

# Least 1 + c_p λ/2G. A centre behind the plane of a facet, as beside a slot, has d < 0, and this could be negative.
_LEAST_SLACK = 0.1
# Depth of a centre behind the plane of a facet, over its distance from the centroid, that counts as none.
_FLAT = 1e-6


@dataclass(frozen=True, eq=False)
class CellConstants:
    """Constants of the energy of `CellBond`.

    The levers begin at the centre of mass of a cell, which is the position of the element. All other lengths refer to
    the centres of the tessellation.

    Shares and H have single precision and levers are whole multiples of `pitch`, so that sums of their products are
    exact and passes read half as many bytes. `lever_i`, `share_i`, `normal` and `H` convert them on access.

    Attributes:
        k: 2 G A / L; between different materials, of two halves in series [N/m], shape (m,).
        levers: levers from the centres of mass to the centroid of the facet [pitch], of both sides, int32, (2, 3, m).
        strain: stress-free strain ε*, which multiplies the levers by 1 + ε* [-], (m,), or (0,) for none.
        bend: resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], float32, (6, m).
        shares: A w_p m, balanced shares of the facet: V θ of each side is Σ share·δ [m²], float32, (2, 3, m).
        volume: V [m³], shape (n,).
        weight: factor from V_p θ_p without the openings of free facets to the stress λ_p θ_p [Pa/m³], shape (n,).
        direction: normals of the facets, from i to j [-], shape (3, m).
        G, lame: shear modulus and Lamé's λ of each cell [Pa], shape (n,); λ is at least -2 G / q, q of `compliance`.
        supports: facets that walls constrain; their cells in the user's order.
        softness: d / 2 G of each free facet, its opening per traction [m/Pa], shape (k,); d is its distance from g.
        way: (c - g) / d along the free axes of each free facet, with its centroid c and the centre g of its cell [-],
            shape (k, 3). A force F on the facet adds softness · F·way to V θ, and the stress of the cell moves the
            facet by -softness · stress · way. The part in the plane makes tractions along the surface exact.
        free_cell: cell of each free facet, user's order, shape (k,).
        pressed: contribution of tractions on its free facets to V θ of each cell [m³], shape (n,).
        pitch: unit of the levers along x, y, z [m], shape (3,).
        gradients: constants of the gradients of the dilatation.
        slack: function that returns the increase of 1 / weight of the cell on each side if the facet breaks, A d |m|²
            / 2G [m³/Pa], (2, m).
    """

    k: PerBond
    levers: np.ndarray
    strain: PerBond
    bend: np.ndarray
    shares: np.ndarray
    volume: PerElement
    weight: PerElement
    direction: Floats
    G: PerElement
    lame: PerElement
    supports: Supports
    softness: Floats
    way: Floats
    free_cell: Ints
    pressed: PerElement
    pitch: Floats
    gradients: GradientConstants
    slack: Callable[[], Floats]

    @classmethod
    def of(
        cls, body: Lattice, bond: CellAssignment, fixed: FixedFacets, *, may_fail: bool = False
    ) -> "CellConstants":
        """Return the constants of a body.

        Args:
            body: a lattice with facets and cells.
            bond: law of all cells, or laws by region.
            fixed: free facets that walls constrain.
            may_fail: True for facets that may fail, whose cells have no gradients of the dilatation.

        Raises:
            InputError: The lattice has no cells, a cell follows no law, a key is no region, or the laws differ in
                `facet_rotation`.
        """
        facets, cells = body_of(body)
        G, lame, rotation = _materials(body, bond)
        i, j = body.pairs.T
        normal, area = facets.normal, facets.area
        # compliance of each half over the area, and its share of the opening
        half_i, half_j = facets.depth_i / (2.0 * G[i]), facets.depth_j / (2.0 * G[j])
        k = area / (half_i + half_j)
        w_i, w_j = half_i / (half_i + half_j), half_j / (half_i + half_j)
        way_i, way_j = ways(facets)
        free = cells.free
        n_free = free.share / free.area[:, None]
        open_axes = np.ones((len(free.cell), 3))
        open_axes[fixed.facet] -= fixed.axes
        soft = free.area * free.depth * (open_axes * n_free**2).sum(axis=1)
        lame = np.maximum(lame, -2.0 * G / compliance(body))
        slack = 1.0 + np.bincount(free.cell, weights=soft, minlength=len(G)) / cells.volume * lame / (2.0 * G)
        slack = np.maximum(slack, _LEAST_SLACK)
        share_i, share_j = _single((area * w_i)[:, None] * way_i), _single((area * w_j)[:, None] * way_j)
        walls = FreeWalls.of(body, fixed.flat(free.normal))
        supports = _supports(cells, fixed, G, n_free, rotation, walls)
        gradients = GradientConstants.none()
        if not may_fail and rotation == "bending":
            gradients = GradientConstants.of(body, G, lame, lame / slack, walls, (share_i, share_j), supports)
        H = resistance(facets.moment, normal, k / area, rotation)
        if rotation == "bending":
            H += twist_at_walls(facets.moment, area, normal, k / area, walls, (i, j))
        arm = facets.centroid - cells.centroid[i]
        other = arm - body.branch
        grid = pitch(float(np.abs([arm, other]).max(initial=0.0)) or 1.0, body.particles.period, LEVER_BITS)
        arm = on_raster(arm, grid)
        levers = np.rint(arm / grid), np.rint((arm - body.branch) / grid)
        return cls(
            k=k, levers=np.array([each.T for each in levers], dtype=np.int32), strain=np.zeros(0),
            bend=H.reshape(-1, 9).T[SIX].astype(np.float32), direction=normal.T,
            shares=np.array([share_i.T, share_j.T], dtype=np.float32), volume=cells.volume,
            weight=lame / slack / cells.volume, G=G, lame=lame, supports=supports,
            softness=free.depth / (2.0 * G[free.cell]),
            way=open_axes * (n_free + _along_facets(free, body.particles.position)), free_cell=free.cell,
            pressed=np.zeros(len(cells.volume)), pitch=grid, gradients=gradients,
            slack=partial(_slack, body, G),
        )  # fmt: skip

    @property
    def modulus(self) -> PerElement:
        """Young's modulus of each cell [Pa], (n,)."""
        return self.G * (3.0 * self.lame + 2.0 * self.G) / (self.lame + self.G)

    def stress_of(self, swelling: PerElement) -> PerElement:
        """Return the stress of each cell [Pa], (n,), for V θ without the openings of free facets [m³], (n,).

        The stress is λ θ plus, with gradients of the dilatation θ, that of the springs between cells.
        """
        stress = self.weight * swelling
        return np.asarray(stress + self.weight * self.gradients.differences(stress), dtype=float)

    def pressed_by(self, force: Floats) -> PerElement:
        """Return the volume changes V θ of cells [m³], (n,), by forces on their free facets [N], (k, 3)."""
        opened = self.softness * (self.way * force).sum(axis=1)
        return np.bincount(self.free_cell, weights=opened, minlength=len(self.pressed)).astype(float)

    def ordered(self, layout: Layout | Reversed) -> "CellConstants":
        """Return the constants in the order of a layout: internal, or the user's for a reversed layout."""
        bond, element, back = layout.bond_order, layout.order, layout.flipped
        shares, direction = _of_sides(self.shares, layout), self.direction.take(bond, axis=-1)
        np.negative(shares, out=shares, where=back)
        np.negative(direction, out=direction, where=back)
        return replace(
            self, k=self.k[bond], levers=_of_sides(self.levers, layout), bend=self.bend.take(bond, axis=-1),
            shares=shares, strain=self.strain[bond] if self.strain.size else self.strain, direction=direction,
            volume=self.volume[element], weight=self.weight[element], G=self.G[element],
            lame=self.lame[element], pressed=self.pressed[element], gradients=self.gradients.ordered(layout),
            slack=partial(_ordered_slack, self.slack, layout),
        )  # fmt: skip

    @property
    def lever_i(self) -> PerBond3:
        """Levers from the centres of mass of cells i to the centroids of the facets [m], shape (m, 3)."""
        return self._lever(0)

    @property
    def lever_j(self) -> PerBond3:
        """Levers from the centres of mass of cells j to the centroids of the facets [m], shape (m, 3)."""
        return self._lever(1)

    def _lever(self, side: int) -> PerBond3:
        lever = _rows(self.levers[side]) * self.pitch
        return lever * (1.0 + self.strain[:, None]) if self.strain.size else lever

    @property
    def share_i(self) -> PerBond3:
        """Shares of the facets in the volume changes V θ of cells i [m²], shape (m, 3)."""
        return _rows(self.shares[0])

    @property
    def share_j(self) -> PerBond3:
        """Shares of the facets in the volume changes V θ of cells j [m²], shape (m, 3)."""
        return _rows(self.shares[1])

    @property
    def normal(self) -> PerBond3:
        """Normals of the facets, from i to j [-], shape (m, 3)."""
        return _rows(self.direction)

    @property
    def H(self) -> Floats:
        """Resistance to relative rotation [N·m], shape (m, 3, 3)."""
        return _rows(self.bend[NINE]).reshape(-1, 3, 3)

    def stretched(self, strain: PerBond, layout: Layout) -> "CellConstants":
        """Return the constants with levers multiplied by 1 + ε* of stress-free strains ε*.

        The levers to walls grow by the mean strain of the facets of their cell.

        Args:
            strain: ε* of the facets [-], internal order like the constants, shape (m,), or (0,) for none.
            layout: order of elements and bonds.
        """
        if strain.size == 0:
            return self
        return replace(self, strain=strain, supports=self.supports.grown(layout.of_elements(strain)))

    def damaged(self, integrity: PerBond, i: Ints, j: Ints) -> "CellConstants":
        """Return the constants with facets of integrity s; the missing part 1 - s acts as free facets of both cells.

        Args:
            integrity: integrity of the facets, shape (m,); their cells are i and j.
            i, j: cells of the facets, (m,).
        """
        if (integrity == 1.0).all():
            return self
        n, open_share, (slack_i, slack_j) = len(self.weight), 1.0 - integrity, self.slack()
        slack = np.bincount(j, open_share * slack_j, n) + np.bincount(i, open_share * slack_i, n)
        return replace(self, weight=self.weight / (1.0 + self.weight * slack))

    def as_bonds(self, body: Lattice) -> BondStiffness:
        """Return beams about as stiff as the facets, for dashpots and estimates; user's order."""
        facets, _ = body_of(body)
        bend = np.einsum("mii->m", self.H) * 0.5
        return BondStiffness(
            kn=self.k, ks=self.k, kb=bend, kt=0.5 * bend, lever=facets.depth_i / facets.span * body.length,
            radius=np.sqrt(facets.area / np.pi),
        )  # fmt: skip


def _rows(columns: np.ndarray) -> Floats:
    """Return columns (…, m) as rows of double precision, (m, …)."""
    return np.ascontiguousarray(columns.T, dtype=float)


def _of_sides(columns: np.ndarray, layout: Layout | Reversed) -> np.ndarray:
    """Return columns of both sides of the facets, (2, …, m), in the order of a layout, which may swap the sides."""
    taken = columns.take(layout.bond_order, axis=-1)
    return np.where(layout.flipped, taken[::-1], taken)


def _slack(body: Lattice, G: PerElement) -> Floats:
    facets, _ = body_of(body)
    sides = zip(body.pairs.T, (facets.depth_i, facets.depth_j), ways(facets), strict=True)
    halves = [(depth / (2.0 * G[cell]), way) for cell, depth, way in sides]
    return np.array([facets.area * half * (way**2).sum(axis=1) for half, way in halves])


def _ordered_slack(slack: Callable[[], Floats], layout: Layout | Reversed) -> Floats:
    return _of_sides(slack(), layout)


def _single(values: Floats) -> Floats:
    """Return the nearest numbers of single precision."""
    return values.astype(np.float32).astype(float)


def _materials(body: Lattice, bond: CellAssignment) -> tuple[Floats, Floats, str]:
    """Return G and λ of each cell [Pa], (n,), and the part of a relative rotation that facets resist."""
    n = len(body.particles)
    if not isinstance(bond, Mapping):
        return np.full(n, bond.G), np.full(n, bond.lame), bond.facet_rotation
    G, lame = np.full(n, np.nan), np.full(n, np.nan)
    for where, law in bond.items():
        if isinstance(where, tuple):
            raise InputError("CellBond applies to cells; give {region: law}, not laws between two regions")
        chosen = as_region("bond=", where).with_rattlers(body)
        G[chosen], lame[chosen] = law.G, law.lame
    bare = int(np.isnan(G).sum())
    if bare:
        raise InputError(f"{bare} cells follow no law; add an entry for bd.Everything() before the others")
    rotations = {law.facet_rotation for law in bond.values()}
    if len(rotations) > 1:
        raise InputError("bond= has laws with different facet_rotation=; give all laws of a body the same")
    return G, lame, rotations.pop()


def ways(facets: Facets) -> tuple[PerBond3, PerBond3]:
    """Return m of both sides of each facet [-], (m, 3) each: the opening δ_p on side p adds A m·δ_p to V_p θ_p."""
    per_depth = facets.span / facets.area
    return (
        facets.share_i * (per_depth / facets.depth_i)[:, None], facets.share_j * (per_depth / facets.depth_j)[:, None]
    )  # fmt: skip


def _along_facets(free: FreeFacets, position: PerElement3) -> Floats:
    """Return τ / d of free facets [-], (k, 3): τ is c - g, from cell centre to centroid, less its normal part d n.

    A uniform strain ε adds A n·ε (c - g) to V θ, and opens the facet by d ε n. The difference under a traction t
    along the surface is A n·ε τ = A t·τ / 2 G. The result is zero for shares other than A n, such as those of older
    files.
    """
    span = free.centroid - position[free.cell]
    far = np.abs(free.depth) > _FLAT * np.linalg.norm(span, axis=1)
    along = np.where(far[:, None], span / np.where(far, free.depth, 1.0)[:, None] - free.normal, 0.0)
    plain = np.abs(free.share - free.area[:, None] * free.normal).max(axis=1) <= 1e-9 * free.area
    return np.where(plain[:, None], along, 0.0)


def compliance(body: Lattice) -> PerElement:
    """Return q of each cell [-], (n,): the energy of the cell is positive for every motion if λ > -2 G / q.

    q = Σ A d |m|² / V over the facets of a cell, with area A, depth d of the centre below the facet, and m of `ways`;
    q = 3 if m is the normal. V θ² ≤ q Σ A |δ_p|² / d for any openings δ_p of its facets on the side of the cell.
    """
    facets, cells = body_of(body)
    free, n = cells.free, len(cells.volume)
    way_i, way_j = ways(facets)
    total = np.zeros(n)  # counts of no facets are whole numbers
    total += np.bincount(body.pairs[:, 0], facets.area * facets.depth_i * (way_i**2).sum(axis=1), n)
    total += np.bincount(body.pairs[:, 1], facets.area * facets.depth_j * (way_j**2).sum(axis=1), n)
    total += np.bincount(free.cell, free.depth / free.area * (free.share**2).sum(axis=1), n)
    return np.asarray(total / cells.volume, dtype=float)


def _supports(
    cells: Cells, fixed: FixedFacets, G: PerElement, n_free: Floats, rotation: str, walls: FreeWalls
) -> Supports:
    """Return the table of the free facets that walls constrain, each with the spring from its wall to its cell."""
    free, facet = cells.free, fixed.facet
    cell, normal, axes = free.cell[facet], free.normal[facet], fixed.axes.astype(float)
    stiffness = 2.0 * G[cell] / free.depth[facet]
    # a wall that holds the normal keeps the facet plane
    flat = ((axes * normal) ** 2).sum(axis=1)
    H = resistance(free.moment[facet], normal, stiffness * flat, rotation)
    whole = resistance(free.moment[facet], normal, stiffness, rotation)
    if rotation == "full":  # a wall that only keeps the facet plane lets it turn in its plane
        bent = resistance(free.moment[facet], normal, stiffness * flat, "bending")
        every = fixed.clamped[:, None, None]
        H = np.where(every, H, bent)
        whole = np.where(every, whole, resistance(free.moment[facet], normal, stiffness, "bending"))
    if rotation == "bending":
        clamped = stiffness * fixed.clamped
        twist = twist_at_walls(free.moment[facet], free.area[facet], normal, clamped, walls, (cell, cell))
        H, whole = H + twist, whole + twist
    lever = free.centroid[facet] - cells.centroid[cell]
    return Supports(
        cell=cell, k=stiffness * free.area[facet], lever=lever, arm=lever,
        share=axes * free.area[facet, None] * n_free[facet], H=H, axes=axes, motion=fixed.final_motion(),
        fixed=fixed, area=free.area[facet], normal=normal, way=n_free[facet], bend=whole,
    )  # fmt: skip
