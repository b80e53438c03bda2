"""Deformation of bonds of the non-local law by small motions of the elements: gaps, forces, stresses."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.non_local_tables import ExtraForces
from bondem._types import Floats, PerBond3, PerElement6
from bondem.interactions.energy_parts import EnergyParts
from bondem.interactions.non_local.non_local_constants import NonLocalConstants
from bondem.interactions.row_sums import row_sums, symmetric_products
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class NonLocalStrain:
    """Small deformation of every bond from the reference, user's order.

    Attributes:
        lattice: the elements and bonds.
        constants: constants of the law, user's order.
        gap: δ = u_j + θ_j × b_j - u_i - θ_i × b_i of each bond, with its levers b [m], (m, 3).
        extra: extra force e of each bond [N], (m, 3).
    """

    lattice: Lattice
    constants: NonLocalConstants
    gap: PerBond3
    extra: PerBond3

    def moved(self, motion: PerElement6, slip: Floats | float = -0.0) -> "NonLocalStrain":
        """Return a strain with the gaps of motions (u, θ) [m, rad], (n, 6), and the present extra forces.

        Args:
            motion: motion of the elements from the reference.
            slip: additional opening of every bond [m], (m, 3): that of a macroscopic strain in a periodic cell;
                -0.0 adds nothing to any number.
        """
        i, j = self.lattice.pairs.T
        c, u, turn = self.constants, motion[:, :3], motion[:, 3:]
        gap = u[j] + np.cross(turn[j], c.lever_j) - u[i] - np.cross(turn[i], c.lever_i) + slip
        return NonLocalStrain(self.lattice, c, gap, self.extra)

    def lagged(self) -> "NonLocalStrain":
        """Return a strain of the same gaps, with the extra forces that follow from the present stresses and gaps."""
        c, found = self.constants, ExtraForces(np.empty_like(self.gap))
        pairs = c.small_pairs(self.lattice.pairs, self.stress, self.gap)
        run_pass(calls.find_small_extra_forces(pairs, found))
        return self.carrying(found.force)

    def carrying(self, extra: PerBond3) -> "NonLocalStrain":
        """Return a strain of the same gaps, with other extra forces [N], (m, 3)."""
        return replace(self, extra=extra)

    @property
    def spring(self) -> PerBond3:
        """Return kn δ_n n + kt δ_t, the spring force on the element i, tension pointing to j [N], (m, 3)."""
        c = self.constants
        along = (c.kn - c.kt) * (self.gap * c.normal).sum(axis=1)
        return c.kt[:, None] * self.gap + along[:, None] * c.normal

    @property
    def force(self) -> PerBond3:
        """Return the sum of spring force and extra force [N], (m, 3)."""
        return self.spring + self.extra

    @property
    def stress(self) -> Floats:
        """Return stresses, the symmetric part of Σ lever ⊗ force / volume: xx, yy, zz, xy, xz, yz [Pa], (n, 6)."""
        i, j = self.lattice.pairs.T
        c, force, n = self.constants, self.force, len(self.lattice.particles)
        found = row_sums(i, symmetric_products(c.lever_i, force), n)
        found -= row_sums(j, symmetric_products(c.lever_j, force), n)
        return found / c.volume[:, None]

    @property
    def energy(self) -> EnergyParts:
        """Return the energy of the springs alone, because the energy of extra forces depends on the path."""
        c = self.constants
        along = (self.gap * c.normal).sum(axis=1) ** 2
        across = (self.gap**2).sum(axis=1) - along
        return EnergyParts(
            normal=0.5 * float((c.kn * along).sum()), shear=0.5 * float((c.kt * across).sum()),
            bending=0.0, twisting=0.0,
        )  # fmt: skip

    def nodal(self, force: PerBond3) -> PerElement6:
        """Return forces and torques on the elements by forces of the bonds [N, N·m], (n, 6)."""
        i, j = self.lattice.pairs.T
        c = self.constants
        load = np.zeros((len(self.lattice.particles), 6))
        for end, lever, sign in ((i, c.lever_i, 1.0), (j, c.lever_j, -1.0)):
            both = sign * np.hstack([force, np.cross(lever, force)])
            load += row_sums(end, both, len(load))
        return load
