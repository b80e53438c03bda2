"""Moments of loads on regions, carried by forces that rotate with the regions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._tables.step_tables import CoupleTable
from bondem._types import Floats, Ints, PerElement6
from bondem.boundary.balanced_forces import balanced_forces
from bondem.geometry.rotations import cross_matrices, turned_vectors


@dataclass(frozen=True, eq=False)
class Couple:
    """A moment of constant direction on a region, applied by forces at k points, which rotate with the points.

    Attributes:
        element: element of each point, internal order, shape (k,).
        centre: centre of that element, in the reference [m], shape (k, 3).
        arm: arm from its centre to the point, in the reference [m], shape (k, 3).
        share: share of each point, of sum 1, shape (k,).
        moment: moment at full load [N·m], shape (3,).
        schedule: number of the schedule of the moment.
    """

    element: Ints
    centre: Floats
    arm: Floats
    share: Floats
    moment: Floats
    schedule: int

    def places(self, pose: Floats | None) -> tuple[Floats, Floats]:
        """Return arms, and points from their weighted centroid [m], (k, 3) each, in a pose (n, 8), or at rest."""
        arm, centre = self.arm, self.centre
        if pose is not None:
            arm, centre = turned_vectors(pose[self.element, 4:], self.arm), pose[self.element, :3]
        place = centre - centre.mean(axis=0) + arm
        return arm, place - self.share @ place

    def forces(self, pose: Floats | None) -> tuple[Floats, Floats, Floats]:
        """Return force [N], torque [N·m] and arm [m] of each point in a pose, at full load, (k, 3) each."""
        arm, place = self.places(pose)
        force = balanced_forces(place, np.zeros(3), self.moment, self.share)
        rest = self.moment - np.cross(place, force).sum(axis=0)
        return force, self.share[:, None] * rest, arm

    def add_to(self, load: PerElement6, pose: Floats | None, amplitude: float) -> None:
        """Add the moment times `amplitude` [-] to the forces and torques on all elements, internal order, (n, 6)."""
        force, torque, arm = self.forces(pose)
        np.add.at(load, self.element, amplitude * np.hstack([force, torque + np.cross(arm, force)]))

    def turning(self, pose: Floats) -> tuple[Floats, Floats]:
        """Linearise the forces at full load in the rotation of their region, which is considered rigid.

        Returns:
            Derivatives of forces and torques with respect to the rotation of the region, (k, 6, 3), and of this
            rotation with respect to the motions of the elements, (3, k, 6).
        """
        force, _, arm = self.forces(pose)
        _, place = self.places(pose)
        inertia = np.einsum("k,ka,kb->ab", self.share, place, place)
        inverse = np.linalg.pinv(np.trace(inertia) * np.eye(3) - inertia, rcond=1e-9, hermitian=True)
        share, a = self.share[:, None, None], cross_matrices(arm)
        # f_p = w (J⁻¹ M) × s: it turns with the region, while M stays
        by_moment = -share * cross_matrices(place) @ inverse
        moved = by_moment @ cross_matrices(self.moment[None])[0] - cross_matrices(force)
        lost = cross_matrices(force) @ a
        given = np.concatenate([moved, lost + a @ moved], axis=1)
        seen = share * inverse @ cross_matrices(place)
        return given, np.concatenate([seen, -seen @ a], axis=2).transpose(1, 0, 2)


def couple_table(couples: Sequence[Couple], row_of: Ints) -> CoupleTable:
    """Return couples as the table of the core; `row_of` is that of `Constraints`, internal order, (n,)."""
    element = np.concatenate([np.zeros(0, dtype=np.int64), *(one.element for one in couples)])
    return CoupleTable(
        start=np.cumsum([0, *(len(one.element) for one in couples)]).astype(np.int64),
        schedule=np.array([one.schedule for one in couples], dtype=np.int64),
        moment=np.array([one.moment for one in couples], dtype=float).reshape(-1, 3),
        element=element, row=row_of[element].astype(np.int64),
        arm=np.concatenate([np.zeros((0, 3)), *(one.arm for one in couples)]),
        share=np.concatenate([np.zeros(0), *(one.share for one in couples)]),
    )  # fmt: skip
