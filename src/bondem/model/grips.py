"""Facets of cells that a wall holds: where a body of cells is clamped, driven or pressed between platens.

A condition on a face holds the surface, not the centres of the cells behind it: half a cell lies between. The wall is
joined to each of its facets by the half of a facet that belongs to the cell, in the directions that are prescribed;
in the others the facet stays free.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bondem._types import Floats, Ints, Mask, PerElement, PerElement3, PerElement6
from bondem.kernels.tables import GripTable
from bondem.kernels.turning import turn_vectors
from bondem.model.boundary import BoundaryCondition, Drive, Fix
from bondem.model.layout import Layout
from bondem.model.loads import facet_numbers, is_face
from bondem.model.schedules import Schedule
from bondem.specimen.lattice import Lattice

#: Columns of where walls come from, `State.grips`: offset [m], 3, and the orientation of the cell there, w x y z.
BASE = 7


@dataclass(frozen=True, eq=False)
class Holds:
    """Which free facets of a body are held, along which axes, and how their walls move.

    Attributes:
        facet: numbers in `cells.free`, ascending, shape (g,).
        axes: whether each is held along x, y, z, shape (g, 3).
        drives: schedules of walls that move.
        drive: which of them each facet follows along x, y, z, or -1, shape (g, 3).
        rate: whether each schedule is a velocity, by schedule.
    """

    facet: Ints
    axes: Mask
    drives: tuple[Schedule, ...]
    drive: Ints
    rate: tuple[bool, ...]

    @classmethod
    def of(cls, body: Lattice, boundary: Sequence[BoundaryCondition]) -> "Holds":
        """What the conditions on faces hold."""
        assert body.cells is not None
        count = len(body.cells.free.cell)
        axes, drive = np.zeros((count, 3), dtype=bool), np.full((count, 3), -1)
        drives: list[Schedule] = []
        rate: list[bool] = []
        for condition in boundary:
            if not isinstance(condition, Fix | Drive) or not holds_wall(condition):
                continue
            found = facet_numbers(condition.region, body)
            if isinstance(condition, Fix):
                for axis in condition.components:
                    if axis < 3:
                        axes[found, axis] = True
                continue
            for axis, schedule, is_rate in condition.motion:
                if axis < 3:
                    axes[found, axis], drive[found, axis] = True, len(drives)
                    drives.append(schedule)
                    rate.append(is_rate)
        facet = np.flatnonzero(axes.any(axis=1))
        return cls(facet, axes[facet], tuple(drives), drive[facet], tuple(rate))

    def same(self, other: "Holds") -> bool:
        """Whether these facets are held and moved in the same way."""
        arrays = ((self.facet, other.facet), (self.axes, other.axes), (self.drive, other.drive))
        moved = self.drives == other.drives and self.rate == other.rate
        return moved and all(np.array_equal(*each) for each in arrays)

    def final_motion(self) -> Floats:
        """Displacements of the walls at the end of all schedules [m], shape (g, 3)."""
        last = np.array([schedule.final for schedule in self.drives] + [0.0])
        return np.where(self.axes, last[self.drive], 0.0)


def holds_wall(condition: Fix | Drive) -> bool:
    """Whether a condition holds a wall: one on a face, that prescribes translations."""
    first = condition.components if isinstance(condition, Fix) else [dof for dof, *_ in condition.motion]
    return is_face(condition.region) and min(first) < 3


@dataclass(frozen=True, eq=False)
class Grips:
    """The half facets between cells and the walls that hold them, g of them; elements in the user's order.

    Attributes:
        cell: of each, shape (g,).
        k: 2 G A / d [N/m], shape (g,).
        lever: from the centre of mass of the cell to the centroid of the facet [m], shape (g, 3).
        arm: the same without stress: longer where cells have a stress-free strain [m], shape (g, 3).
        share: A M⁻¹n along the held axes: V θ of the cell is Σ share·δ [m²], shape (g, 3).
        H: resistance to rotation, where the normal is held [N·m], shape (g, 3, 3).
        axes: whether the facet is held along x, y, z, as 0 and 1, shape (g, 3).
        motion: displacement of the wall at the end of all schedules [m], shape (g, 3).
        holds: how the walls move.
        area: of the facets [m²], shape (g,).
        normal: of the facets [-], shape (g, 3).
        way: M⁻¹n [-], shape (g, 3).
        bend: H where the whole normal is held [N·m], shape (g, 3, 3).
    """

    cell: Ints
    k: Floats
    lever: Floats
    arm: Floats
    share: Floats
    H: Floats
    axes: Floats
    motion: Floats
    holds: Holds
    area: Floats
    normal: Floats
    way: Floats
    bend: Floats

    def flatness(self, orientation: Floats) -> Floats:
        """How much of the normal of each facet is held, 0 … 1, with cells of these quaternions (g, 4), shape (g,)."""
        return ((self.axes * turned_rows(orientation, self.normal)) ** 2).sum(axis=1)

    def taken(self, base: Floats) -> "Grips":
        """Return these grips with turned shares and H, for walls that took over cells at the poses `base`, (g, 7)."""
        other = (base[:, 4:] != 0.0).any(axis=1)
        if not other.any():
            return self
        q, share, H = base[other, 3:], self.share.copy(), self.H.copy()
        share[other] = self.area[other, None] * self.axes[other] * turned_rows(q, self.way[other])
        R = np.stack([turned_rows(q, np.tile(axis, (len(q), 1))) for axis in np.eye(3)], axis=2)
        held = self.flatness(base[:, 3:])[other, None, None]
        H[other] = held * (R @ self.bend[other] @ np.swapaxes(R, 1, 2))
        return replace(self, share=share, H=H)

    def grown(self, strain: PerElement) -> "Grips":
        """The same of cells with a stress-free strain [-], user's order, (n,)."""
        return replace(self, arm=self.lever * (1.0 + strain[self.cell, None]))

    def gap(self, displacement: PerElement3, rotation: PerElement3, wall: Floats | None = None) -> Floats:
        """How far walls are from their facets along the held axes, for small motions [m], shape (g, 3).

        Args:
            displacement, rotation: of the elements [m, rad], (n, 3).
            wall: displacement of the walls [m], (g, 3); none when None.
        """
        moved = displacement[self.cell] + np.cross(rotation[self.cell], self.lever)
        return self.axes * ((0.0 if wall is None else wall) - moved)

    def nodal(self, gap: Floats, turn: PerElement3, stress: Floats) -> PerElement6:
        """Force and torque of the walls on their cells [N, N·m], shape (g, 6).

        Args:
            gap: [m], (g, 3).
            turn: rotations of the elements [rad], (n, 3).
            stress: λ θ of all cells [Pa], (n,).
        """
        force = self.k[:, None] * gap + stress[self.cell, None] * self.share
        moment = -np.einsum("gab,gb->ga", self.H, turn[self.cell])
        return np.hstack([force, np.cross(self.lever, force) + moment])

    def constraint(self, motion: Floats) -> Floats:
        """What the walls resist of motions (n, 6, k) of the elements [m], (6 g, k).

        The motion of the held points along the held axes, and √(H/k) θ: a wall that holds the normal of a facet
        holds a plane, which resists a rotation also where no other facet is held.
        """
        own = motion[self.cell]
        moved = own[:, :3] + np.cross(own[:, 3:], self.lever[:, :, None], axis=1)
        size, axis = np.linalg.eigh(self.H / self.k[:, None, None])
        arm = np.sqrt(np.where(size > 1e-9 * size[:, -1:], size, 0.0))
        turned = arm[:, :, None] * (np.swapaxes(axis, 1, 2) @ own[:, 3:])
        held = self.axes[:, :, None] * moved
        return np.concatenate([held, turned]).reshape(-1, motion.shape[-1])

    def blocks(self, lever: Floats | None = None) -> tuple[Floats, Floats]:
        """What the grips add to diagonal blocks [N/m, N, N·m], (g, 6, 6), and to V θ of their cells, (g, 6).

        Args:
            lever: as the cells have turned it [m], (g, 3); that of the reference when None.
        """
        b, P = self.lever if lever is None else lever, self.axes[:, :, None] * np.eye(3)
        cross = np.zeros((len(b), 3, 3))
        for r, c, axis in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            cross[:, r, c], cross[:, c, r] = -b[:, axis], b[:, axis]
        moved = np.concatenate([P, -P @ cross], axis=2)  # P (u + θ × b)
        own = self.k[:, None, None] * np.swapaxes(moved, 1, 2) @ moved
        own[:, 3:, 3:] += self.H
        return own, -np.hstack([self.share, np.cross(b, self.share)])

    def table(self, layout: Layout, row_of: Ints, place: int, base: Floats | None = None) -> GripTable:
        """The grips as kernels take them.

        Args:
            layout: order of the elements.
            row_of: row of the boundary of each element, kernels' order.
            place: of the walls in the list of works.
            base: where the walls come from, (g, 7): the reference when None, or of another number of facets.
        """
        if base is not None and len(base) == len(self.cell):
            return self.taken(base)._table(layout, row_of, place, base)
        return self._table(layout, row_of, place, reference_base(len(self.cell)))

    def _table(self, layout: Layout, row_of: Ints, place: int, base: Floats) -> GripTable:
        cell, count, holds = layout.rank[self.cell], len(self.cell), self.holds
        tables = [schedule.table for schedule in holds.drives]
        return GripTable(
            cell=cell, row=row_of[cell], k=self.k, lever=self.lever, arm=self.arm.copy(),
            share=self.share,
            H=np.ascontiguousarray(self.H.reshape(-1, 9)[:, [0, 4, 8, 1, 2, 5]]), base=base,
            axes=self.axes, drive=holds.drive,
            rate=np.array(holds.rate, dtype=np.uint8), times=np.concatenate([np.zeros(0), *(t for t, _ in tables)]),
            values=np.concatenate([np.zeros(0), *(values for _, values in tables)]),
            start=np.cumsum([0, *(len(t) for t, _ in tables)]).astype(np.int64), place=place,
            wall=base[:, :3].copy(), came=np.zeros((count, 3)), load=np.zeros((count, 6)),
        )  # fmt: skip


def reference_base(count: int) -> Floats:
    """Where walls come from that count from the reference, (g, 7)."""
    base = np.zeros((count, BASE))
    base[:, 3] = 1.0
    return base


def turned_rows(quaternion: Floats, vectors: Floats) -> Floats:
    """Vectors (k, 3), each turned by its unit quaternion, (k, 4)."""
    return turn_vectors(np.ascontiguousarray(quaternion), np.ascontiguousarray(vectors))
