"""What small motions of the elements of a body do to its facets and cells: gaps, relative rotations, dilatation."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerElement, PerElement3, PerElement6
from bondem.model.cell_constants import CellConstants
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class CellStrain:
    """Small deformation of every facet and cell about the reference, user's order.

    Attributes:
        gap: δ = u_j + θ_j × b_j - u_i - θ_i × b_i, of the faces of each facet [m], (m, 3).
        turn: θ_j - θ_i [rad], (m, 3).
        held: of the facets that walls hold, along the held axes [m], (g, 3).
        rotation: of the elements [rad], (n, 3).
        swelling: V θ of each cell, but for what its own stress opens of free facets [m³], (n,).
    """

    gap: Floats
    turn: Floats
    held: Floats
    rotation: PerElement3
    swelling: PerElement

    @classmethod
    def of(
        cls,
        body: Lattice,
        constants: CellConstants,
        displacement: PerElement3,
        rotation: PerElement3,
        *,
        slip: Floats | None = None,
        wall: Floats | None = None,
        pressed: PerElement | None = None,
    ) -> "CellStrain":
        """The deformation under displacements [m] and rotations [rad], (n, 3) each.

        Args:
            body: what deforms.
            constants: of its law, user's order.
            displacement, rotation: of the elements.
            slip: what every facet opens besides [m], (m, 3): by a macroscopic strain in a periodic cell, or less
                what it opens without stress.
            wall: displacement of walls that hold facets [m], (g, 3); none when None.
            pressed: what tractions on free facets add to V θ [m³], (n,); none when None.
        """
        i, j = body.pairs.T
        gap = (
            displacement[j] + np.cross(rotation[j], constants.lever_j)
            - displacement[i] - np.cross(rotation[i], constants.lever_i)
        )  # fmt: skip
        if slip is not None:
            gap = gap + slip
        n = len(body.particles)
        swelling = np.zeros(n) if pressed is None else pressed.copy()
        swelling += np.bincount(i, weights=(constants.share_i * gap).sum(axis=1), minlength=n)
        swelling += np.bincount(j, weights=(constants.share_j * gap).sum(axis=1), minlength=n)
        grips = constants.grips
        held = grips.gap(displacement, rotation, wall)
        swelling += np.bincount(grips.cell, weights=(grips.share * held).sum(axis=1), minlength=n)
        return cls(gap, rotation[j] - rotation[i], held, rotation, swelling)

    def stress(self, constants: CellConstants) -> PerElement:
        """λ_p θ_p of each cell [Pa], (n,)."""
        return constants.weight * self.swelling

    def forces(self, body: Lattice, constants: CellConstants) -> Floats:
        """Force of each facet on its element i, tension pointing to j [N], (m, 3)."""
        i, j = body.pairs.T
        stress = self.stress(constants)[:, None]
        return constants.k[:, None] * self.gap + stress[i] * constants.share_i + stress[j] * constants.share_j

    def nodal(self, body: Lattice, constants: CellConstants) -> PerElement6:
        """What the facets do to the elements [N, N·m], (n, 6)."""
        i, j = body.pairs.T
        force = self.forces(body, constants)
        moment = np.einsum("mab,mb->ma", constants.H, self.turn)
        load = np.zeros((len(body.particles), 6))
        for end, lever, sign in ((i, constants.lever_i, 1.0), (j, constants.lever_j, -1.0)):
            both = sign * np.hstack([force, np.cross(lever, force) + moment])
            for d in range(6):
                load[:, d] += np.bincount(end, weights=both[:, d], minlength=len(load))
        return load + self.of_walls(len(load), constants)

    def of_walls(self, n: int, constants: CellConstants) -> PerElement6:
        """What the walls do to the elements that they hold [N, N·m], (n, 6)."""
        grips = constants.grips
        values = grips.nodal(self.held, self.rotation, self.stress(constants))
        parts = [np.bincount(grips.cell, weights=column, minlength=n) for column in values.T]
        return np.stack(parts, axis=1).astype(float)

    def work(self, other: "CellStrain", constants: CellConstants) -> float:
        """What the stresses of one deformation do on another, twice the energy where both are the same [J]."""
        grips = constants.grips
        bent = np.einsum("ma,mab,mb->", self.turn, constants.H, other.turn)
        bent += np.einsum("ga,gab,gb->", self.rotation[grips.cell], grips.H, other.rotation[grips.cell])
        opened = (constants.k[:, None] * self.gap * other.gap).sum()
        opened += (grips.k[:, None] * self.held * other.held).sum()
        return float(opened + bent + (constants.weight * self.swelling * other.swelling).sum())
