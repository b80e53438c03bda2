"""Deformation of facets and cells by small motions of the elements: gaps, relative rotations, dilatation."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerElement, PerElement3, PerElement6
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.row_sums import row_sums
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class CellStrain:
    """Small deformation of every facet and cell from the reference, user's order.

    Attributes:
        gap: δ = u_j + θ_j × b_j - u_i - θ_i × b_i with levers b, gap between the faces of a facet [m], (m, 3).
        turn: θ_j - θ_i [rad], (m, 3).
        wall_gap: gaps at the facets that walls constrain, along the fixed axes [m], (g, 3).
        rotation: rotations of the elements [rad], (n, 3).
        swelling: V θ of each cell, without the opening of free facets by its own stress [m³], (n,).
    """

    gap: Floats
    turn: Floats
    wall_gap: Floats
    rotation: PerElement3
    swelling: PerElement

    @classmethod
    def of(
        cls, body: Lattice, constants: CellConstants, displacement: PerElement3, rotation: PerElement3, *,
        slip: Floats | float = -0.0, wall: Floats | None = None, pressed: PerElement | None = None,
    ) -> "CellStrain":  # fmt: skip
        """Return the deformation under displacements [m] and rotations [rad], (n, 3) each.

        Args:
            body: the body that deforms.
            constants: constants of its law, user's order.
            displacement, rotation: displacements and rotations of the elements.
            slip: additional opening of every facet [m], (m, 3): that of a macroscopic strain in a periodic cell, or
                minus the stress-free opening.
            wall: displacement of walls that constrain facets [m], (g, 3); None for walls at rest.
            pressed: volume changes V θ by tractions on free facets [m³], (n,); None for none.
        """
        i, j = body.pairs.T
        gap = (
            displacement[j] + np.cross(rotation[j], constants.lever_j)
            - displacement[i] - np.cross(rotation[i], constants.lever_i) + slip
        )  # fmt: skip
        n = len(body.particles)
        swelling = np.zeros(n) if pressed is None else pressed.copy()
        swelling += np.bincount(i, weights=(constants.share_i * gap).sum(axis=1), minlength=n)
        swelling += np.bincount(j, weights=(constants.share_j * gap).sum(axis=1), minlength=n)
        supports = constants.supports
        wall_gap = supports.gap(displacement, rotation, wall)
        swelling += np.bincount(supports.cell, weights=(supports.share * wall_gap).sum(axis=1), minlength=n)
        return cls(gap, rotation[j] - rotation[i], wall_gap, rotation, swelling)

    def stress(self, constants: CellConstants) -> PerElement:
        """Return the stress σ of each cell for its V θ, by `CellConstants.stress_of` [Pa], user's order, (n,)."""
        return constants.stress_of(self.swelling)

    def forces(self, body: Lattice, constants: CellConstants) -> Floats:
        """Return the force of each facet on its element i, tension pointing to j [N], (m, 3)."""
        i, j = body.pairs.T
        stress = self.stress(constants)[:, None]
        return constants.k[:, None] * self.gap + stress[i] * constants.share_i + stress[j] * constants.share_j

    def nodal(self, body: Lattice, constants: CellConstants) -> PerElement6:
        """Return forces and torques of the facets and walls on the elements [N, N·m], (n, 6)."""
        i, j = body.pairs.T
        force = self.forces(body, constants)
        bent, at_wall = constants.gradients.moments(self.turn, self.rotation)
        moment = np.einsum("mab,mb->ma", constants.H, self.turn) + bent
        load = np.zeros((len(body.particles), 6))
        for end, lever, sign in ((i, constants.lever_i, 1.0), (j, constants.lever_j, -1.0)):
            both = sign * np.hstack([force, np.cross(lever, force) + moment])
            load += row_sums(end, both, len(load))
        load[:, 3:] += at_wall
        return load + self.of_walls(len(load), constants)

    def of_walls(self, n: int, constants: CellConstants) -> PerElement6:
        """Return forces and torques of the walls on the elements that they constrain [N, N·m], (n, 6)."""
        supports = constants.supports
        return row_sums(supports.cell, supports.nodal(self.wall_gap, self.rotation, self.stress(constants)), n)

    def work(self, other: "CellStrain", constants: CellConstants) -> float:
        """Return the work of stresses of this deformation on another one [J]; on itself it is twice the energy."""
        supports = constants.supports
        bent = np.einsum("ma,mab,mb->", self.turn, constants.H, other.turn)
        moments, at_wall = constants.gradients.moments(self.turn, self.rotation)
        bent += (moments * other.turn).sum() - (at_wall * other.rotation).sum()
        bent += np.einsum("ga,gab,gb->", self.rotation[supports.cell], supports.H, other.rotation[supports.cell])
        opened = (constants.k[:, None] * self.gap * other.gap).sum()
        opened += (supports.k[:, None] * self.wall_gap * other.wall_gap).sum()
        return float(opened + bent + self.stress(constants) @ other.swelling)
