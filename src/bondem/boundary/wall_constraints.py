"""Constraints on facets of cells, where a face of a body is clamped, driven or pressed by a platen.

A condition on a face constrains the surface, not the centres of the cells, which lie half a cell behind it. A half
facet, the spring between facet and centre of the cell, joins each cell to a rigid wall in the prescribed directions.
In the other directions the facet stays free.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import shown
from bondem._tables.cell_tables import WallConstraints
from bondem._types import Floats, Ints, Mask, PerElement, PerElement3, PerElement6
from bondem.boundary.conditions import DRIVEN_TWICE, FIXED_AND_DRIVEN, MOTIONS, BoundaryCondition, Drive, Fix
from bondem.boundary.loads import facet_numbers, is_face, is_mixed
from bondem.boundary.schedules import Schedule, joined_tables
from bondem.errors import InputError
from bondem.geometry.rotations import cross_matrices, turned_vectors
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

#: Columns of `State.grips`, the origin of each wall's motion: offset [m] (3), quaternion w x y z of its cell (4).
BASE = 7


@dataclass(frozen=True, eq=False)
class FixedFacets:
    """Boundary facets that walls constrain, g of them, with their fixed axes and the motion of the walls.

    Attributes:
        facet: indices into `cells.free`, ascending, shape (g,).
        axes: mask of fixed axes x, y, z of each facet, shape (g, 3).
        drives: schedules of walls that move.
        drive: index in `drives` that each facet follows along x, y, z, or -1, shape (g, 3).
        rate: True for each schedule that is a velocity.
        friction: μ of the platen on which a facet may slide across `across` [-], shape (g,); NaN where it cannot
            slide. All axes of a facet that may slide are fixed.
        across: axis along which a platen presses, 0, 1 or 2, shape (g,).
    """

    facet: Ints
    axes: Mask
    drives: tuple[Schedule, ...]
    drive: Ints
    rate: tuple[bool, ...]
    friction: Floats
    across: Ints

    @classmethod
    def none(cls) -> "FixedFacets":
        """Return an empty table of facets."""
        no, none = np.zeros((0, 3)), np.zeros(0, dtype=np.int64)
        return cls(none, no > 0.0, (), no.astype(np.int64), (), no[:, 0], none)

    @property
    def clamped(self) -> Mask:
        """Mask of the facets that are fixed along all axes and cannot slide, shape (g,)."""
        return self.axes.all(axis=1) & np.isnan(self.friction)

    @classmethod
    def of(cls, body: Lattice, boundary: Sequence[BoundaryCondition]) -> "FixedFacets":
        """Return the facets of a body that its conditions on faces constrain.

        Raises:
            InputError: A facet is driven twice or both fixed and driven along an axis, or has two platens.
        """
        count = len(body.elements.require_cells().cells.free.cell)
        axes, drive = np.zeros((count, 3), dtype=bool), np.full((count, 3), -1)
        held = np.zeros((count, 3), dtype=bool)
        friction, across = np.full(count, np.nan), np.zeros(count, dtype=np.int64)
        drives: list[Schedule] = []
        rate: list[bool] = []
        for condition in boundary:
            if not isinstance(condition, Fix | Drive) or not supports_facets(condition):
                continue
            found = facet_numbers(condition.region, body)
            if condition.friction is not None:
                other = (friction[found] != condition.friction) | (across[found] != condition.across)
                if other[~np.isnan(friction[found])].any():
                    raise InputError(f"{shown(condition.region)} has two platens with friction; remove one of them")
                axes[found], friction[found], across[found] = True, condition.friction, condition.across
            if isinstance(condition, Fix):
                for axis in condition.components:
                    if axis < 3:
                        axes[found, axis] = held[found, axis] = True
                continue
            for axis, schedule, is_rate in condition.motion:
                if axis < 3:
                    if (drive[found, axis] >= 0).any():
                        raise InputError(DRIVEN_TWICE.format(shown(condition.region)))
                    axes[found, axis], drive[found, axis] = True, len(drives)
                    drives.append(schedule)
                    rate.append(is_rate)
        if (held & (drive >= 0)).any():
            raise InputError(FIXED_AND_DRIVEN)
        facet = np.flatnonzero(axes.any(axis=1))
        return cls(facet, axes[facet], tuple(drives), drive[facet], tuple(rate), friction[facet], across[facet])

    def flat(self, normal: Floats) -> Ints:
        """Return the facets fixed mainly along their normal; `normal` (k, 3) are the normals of `cells.free`."""
        return self.facet[((self.axes * normal[self.facet]) ** 2).sum(axis=1) > 0.5]

    def same(self, other: "FixedFacets") -> bool:
        """Return True if both tables fix and move the same facets in the same way, with the same friction."""
        arrays = ((self.facet, other.facet), (self.axes, other.axes), (self.drive, other.drive))
        moved = self.drives == other.drives and self.rate == other.rate
        same_friction = np.array_equal(self.friction, other.friction, equal_nan=True)
        return moved and same_friction and all(np.array_equal(*each) for each in arrays)

    def final_motion(self) -> Floats:
        """Return displacements of the walls at the end of all schedules [m], shape (g, 3)."""
        last = np.array([schedule.final for schedule in self.drives] + [0.0])
        return np.where(self.axes, last[self.drive], 0.0)


def on_centres(condition: BoundaryCondition) -> list[BoundaryCondition]:
    """Return what a condition does to the centres of cells: itself, or its rotations if it constrains facets."""
    if not isinstance(condition, Fix | Drive) or not supports_facets(condition):
        return [condition]
    if isinstance(condition, Fix):
        return [Fix(condition.region, "", condition.rotation)] if condition.rotation else []
    turns = {name: schedule for name, schedule in condition.arguments.items() if MOTIONS[name][0] > 2}
    return [Drive(condition.region, friction=None, **turns)] if turns else []


def supports_facets(condition: Fix | Drive) -> bool:
    """Return True if a condition constrains facets by a wall: if it prescribes translations on a face.

    Translations of a union of a face and other cells raise InputError.
    """
    first = condition.components if isinstance(condition, Fix) else [dof for dof, *_ in condition.motion]
    if min(first) < 3 and is_mixed(condition.region):
        where = shown(condition.region)
        raise InputError(f"{where} joins a face, held by its facets, with other cells; give one condition for each")
    return is_face(condition.region) and min(first) < 3


@dataclass(frozen=True, eq=False)
class Supports:
    """Half facets that join cells to the walls that constrain them, g of them; elements in the user's order.

    Attributes:
        cell: cell of each, shape (g,).
        k: stiffness 2 G A / d, d the distance of the facet from the centre of its cell [N/m], shape (g,).
        lever: lever from the centre of mass of the cell to the centroid of the facet [m], shape (g, 3).
        arm: lever without stress, longer for cells with a stress-free strain [m], shape (g, 3).
        share: A m (see `way`) along the fixed axes; a jump δ adds share·δ to V θ of the cell [m²], shape (g, 3).
        H: resistance to rotation, times the share of the normal that is fixed [N·m], shape (g, 3, 3).
        axes: 1 for fixed and 0 for free axes x, y, z, shape (g, 3).
        motion: displacement of the wall at the end of all schedules [m], shape (g, 3).
        fixed: facets that walls constrain, and the motion of the walls.
        area: areas of the facets [m²], shape (g,).
        normal: normals of the facets [-], shape (g, 3).
        way: vector m by which a jump across the facet enters the dilatation, near the normal [-], shape (g, 3).
        bend: H for a normal that is wholly fixed [N·m], shape (g, 3, 3).
    """

    cell: Ints
    k: Floats
    lever: Floats
    arm: Floats
    share: Floats
    H: Floats
    axes: Floats
    motion: Floats
    fixed: FixedFacets
    area: Floats
    normal: Floats
    way: Floats
    bend: Floats

    @classmethod
    def none(cls) -> "Supports":
        """Return an empty table of half facets."""
        no, square, fixed = np.zeros((0, 3)), np.zeros((0, 3, 3)), FixedFacets.none()
        return cls(fixed.facet, no[:, 0], no, no, no, square, no, no, fixed, no[:, 0], no, no, square)

    def flatness(self, orientation: Floats) -> Floats:
        """Return the fixed share of each normal, 0 … 1, (g,), in cells with orientations as quaternions, (g, 4)."""
        return ((self.axes * turned_vectors(orientation, self.normal)) ** 2).sum(axis=1)

    def taken(self, base: Floats) -> "Supports":
        """Return the half facets with `share` and `H` rotated to the quaternions, columns 3 … 6, of `base` (g, 7)."""
        other = (base[:, 4:] != 0.0).any(axis=1)
        if not other.any():
            return self
        q, share, H = base[other, 3:], self.share.copy(), self.H.copy()
        share[other] = self.area[other, None] * self.axes[other] * turned_vectors(q, self.way[other])
        R = np.stack([turned_vectors(q, np.tile(axis, (len(q), 1))) for axis in np.eye(3)], axis=2)
        fixed = self.flatness(base[:, 3:])[other, None, None]
        H[other] = fixed * (R @ self.bend[other] @ np.swapaxes(R, 1, 2))
        return replace(self, share=share, H=H)

    def grown(self, strain: PerElement) -> "Supports":
        """Return the half facets with arms stretched by a stress-free strain of the cells [-], user's order, (n,)."""
        return replace(self, arm=self.lever * (1.0 + strain[self.cell, None]))

    def gap(self, displacement: PerElement3, rotation: PerElement3, wall: Floats | None = None) -> Floats:
        """Return the gaps between walls and their facets along the fixed axes, for small motions [m], shape (g, 3).

        Args:
            displacement, rotation: motions of the elements [m, rad], (n, 3).
            wall: displacement of the walls [m], (g, 3); None for none.
        """
        moved = displacement[self.cell] + np.cross(rotation[self.cell], self.lever)
        return self.axes * ((0.0 if wall is None else wall) - moved)

    def nodal(self, gap: Floats, turn: PerElement3, stress: Floats) -> PerElement6:
        """Return force and torque of the walls on their cells [N, N·m], shape (g, 6).

        Args:
            gap: gaps [m], (g, 3).
            turn: rotations of the elements [rad], (n, 3).
            stress: λ θ of all cells [Pa], (n,).
        """
        force = self.k[:, None] * gap + stress[self.cell, None] * self.share
        moment = -np.einsum("gab,gb->ga", self.H, turn[self.cell])
        return np.hstack([force, np.cross(self.lever, force) + moment])

    def constraint(self, motion: Floats) -> Floats:
        """Return the constrained motions [m], (6 g, k), for motions (n, 6, k) of the elements [m, rad].

        The constrained motions are the displacements of the facets along fixed axes, and their rotations times
        √(H/k). A facet whose normal is fixed stays in the plane of its wall, so that it resists rotation even if it
        is the only fixed facet.
        """
        own = motion[self.cell]
        moved = own[:, :3] + np.cross(own[:, 3:], self.lever[:, :, None], axis=1)
        size, axis = np.linalg.eigh(self.H / self.k[:, None, None])
        arm = np.sqrt(np.where(size > 1e-9 * size[:, -1:], size, 0.0))
        turned = arm[:, :, None] * (np.swapaxes(axis, 1, 2) @ own[:, 3:])
        fixed = self.axes[:, :, None] * moved
        return np.concatenate([fixed, turned]).reshape(-1, motion.shape[-1])

    def blocks(self, lever: Floats | None = None) -> tuple[Floats, Floats]:
        """Return contributions of half facets to diagonal blocks of stiffness, (g, 6, 6), and to dilatation, (g, 6).

        A row (6,) times the motion of its cell [m, rad] is the contribution to the volume change V θ [m³].

        Args:
            lever: levers as rotated by the cells [m], (g, 3); None for those of the reference.
        """
        b, P = self.lever if lever is None else lever, self.axes[:, :, None] * np.eye(3)
        moved = np.concatenate([P, -P @ cross_matrices(b)], axis=2)  # P (u + θ × b)
        own = self.k[:, None, None] * np.swapaxes(moved, 1, 2) @ moved
        own[:, 3:, 3:] += self.H
        return own, -np.hstack([self.share, np.cross(b, self.share)])

    def table(self, layout: Layout, row_of: Ints, base: Floats | None = None) -> WallConstraints:
        """Return the half facets as the table of the core, with new arrays for all that changes in a run.

        Args:
            layout: order of the elements.
            row_of: `Constraints.row_of`, the row of boundary conditions of each element, internal order, (n,).
            base: origins of the motions of the walls, (g, 7); the reference if None or of another number of rows.
        """
        if base is not None and len(base) == len(self.cell):
            return self.taken(base)._table(layout, row_of, base)
        return self._table(layout, row_of, reference_base(len(self.cell)))

    def _table(self, layout: Layout, row_of: Ints, base: Floats) -> WallConstraints:
        cell, count, fixed = layout.rank[self.cell], len(self.cell), self.fixed
        inward = np.eye(3)[fixed.across]
        inward *= -np.sign((inward * self.normal).sum(axis=1, keepdims=True))
        return WallConstraints(
            cell=cell, row=row_of[cell], k=self.k, lever=self.lever, arm=self.arm.copy(),
            share=self.share,
            H=np.ascontiguousarray(self.H.reshape(-1, 9)[:, [0, 4, 8, 1, 2, 5]]), base=base,
            axes=self.axes, drive=fixed.drive,
            rate=np.array(fixed.rate, dtype=np.uint8), **joined_tables(fixed.drives),
            wall=base[:, :3].copy(), increment=np.zeros((count, 3)), load=np.zeros((count, 6)),
            friction=fixed.friction, inward=inward,
        )  # fmt: skip


def reference_base(count: int) -> Floats:
    """Return origins of the motions of walls measured from the reference: offsets 0 and quaternions 1, (count, 7)."""
    base = np.zeros((count, BASE))
    base[:, 3] = 1.0
    return base
