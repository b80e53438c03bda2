"""Stiffness that slip by the size of a facet on material planes adds, for the critical time step."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, Ints, PerBond
from bondem.model.model import Model


@dataclass(frozen=True, eq=False)
class LongSlip:
    """Linearised effect of slip s = √A, the size of a facet, on closed cracks with friction on material planes.

    The normal n rotates with the mean of both cells and the slip with cell i. With δ the relative displacement of the
    faces, t the direction of the slip and b = n×t, a rotation changes the opening n·δ by ½ s b·(θ_i + θ_j), and the
    stretch b·δ of the friction spring by -s n·θ_i. A change y of either quantity x adds the energy
    ½ k [(x + y)² - x²], and a change y of the opening adds λ A² y² / 2 V by the volume strains of the cells.

    Attributes:
        i, j: cells of the facets, internal order, (f,).
        slip: s [m], (f,).
        k, swollen: stiffness of facets, and λ A² / V [N/m], (f,).
        normal, across: n and b [-], (f, 3).
        arm_i, arm_j: arms from the centres to the facets [m], (f, 3).
    """

    i: Ints
    j: Ints
    slip: PerBond
    k: PerBond
    swollen: PerBond
    normal: Floats
    across: Floats
    arm_i: Floats
    arm_j: Floats

    def resistance(self, n: int) -> Floats:
        """Return the approximate stiffness of each cell against rotation [N·m], (n,)."""
        stiff = (self.k + self.swollen) * self.slip**2
        found = np.zeros(n)
        np.add.at(found, self.i, stiff)
        np.add.at(found, self.j, stiff)
        return found

    def forces(self, motion: Floats) -> Floats:
        """Return the loads [N, N·m], (n, 6), that slip adds to those of motions [m, rad], (n, 6), without slip."""
        i, j, n, b = self.i, self.j, self.normal, self.across
        u, turn = motion[:, :3], motion[:, 3:]
        opening = u[j] - u[i] + np.cross(turn[j], self.arm_j) - np.cross(turn[i], self.arm_i)
        one = 0.5 * self.slip * _dot(b, turn[i] + turn[j])
        two = -self.slip * _dot(n, turn[i])
        force = (self.k * one)[:, None] * n + (self.k * two)[:, None] * b
        first = 0.5 * self.slip * (self.k * (_dot(n, opening) + one) + self.swollen * one)
        second = -self.slip * self.k * (_dot(b, opening) + two)
        found = np.zeros(motion.shape)
        on_j = np.hstack([force, np.cross(self.arm_j, force) + first[:, None] * b])
        on_i = np.hstack([-force, first[:, None] * b + second[:, None] * n - np.cross(self.arm_i, force)])
        np.add.at(found, j, on_j)
        np.add.at(found, i, on_i)
        return found


def long_slips(model: Model) -> tuple[LongSlip, ...]:
    """Return slips in two directions and their opposites on all material planes of a model; empty without planes.

    A material plane is an entry of `failure=` for a pair of regions. All facets of a plane can slip by their size at
    once. Within a region only few facets of a cell do. The safety factor of the default time step covers this.
    """
    table, layout = model.softening, model.layout
    if table is None or not isinstance(model.failure, Mapping):
        return ()
    cells, pairs = model.cell_law.constants, zip(model.failure, model.failure_parts, strict=True)
    plane = np.zeros(len(layout.i), dtype=bool)
    for where, part in pairs:
        if isinstance(where, tuple):
            plane |= np.isin(layout.bond_order, part.bonds)
    f = np.flatnonzero(plane)
    if not len(f):
        return ()
    i, j, A, normal = layout.i[f].astype(np.int64), layout.j[f].astype(np.int64), table.area[f], cells.normal[f]
    axis = np.eye(3)[np.argmin(np.abs(normal).sum(axis=0))]  # so that all facets of a flat plane have one direction
    first = np.cross(normal, axis)
    lost = np.linalg.norm(first, axis=1) < 1e-3
    first[lost] = np.cross(normal[lost], np.roll(axis, 1))
    first /= np.linalg.norm(first, axis=1)[:, None]
    second: Floats = np.cross(normal, first).real
    directions = first, -first, second, -second
    swollen = np.maximum(cells.weight[i], cells.weight[j]) * A**2
    return tuple(
        LongSlip(i, j, np.sqrt(A), cells.k[f], swollen, normal, across, cells.lever_i[f], cells.lever_j[f])
        for across in directions
    )


def _dot(a: Floats, b: Floats) -> PerBond:
    return np.einsum("fk,fk->f", a, b)
