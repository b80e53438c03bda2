"""Deformation of bonds by small motions of the elements: elongation, slip, bending and twist."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats, PerBond, PerElement3
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class BondStrain:
    """Small deformation of every bond from the reference, user's order.

    With X the direction of a bond and a, b the distances of its contact point from both centres, its slip there is
    δ = u_j - u_i + X × (a θ_i + b θ_j) and its relative rotation ρ = θ_j - θ_i.

    Attributes:
        direction: X, from i to j [-], (m, 3).
        normal: elongation δ·X [m], (m,).
        shear: slip δ - (δ·X) X [m], (m, 3).
        bend: bending rotation ρ - (ρ·X) X [rad], (m, 3).
        twist: twist ρ·X [rad], (m,).
    """

    direction: Floats
    normal: PerBond
    shear: Floats
    bend: Floats
    twist: PerBond

    @classmethod
    def of(
        cls, lattice: Lattice, lever: PerBond, displacement: PerElement3, rotation: PerElement3, *,
        slip: Floats | float = -0.0,
    ) -> "BondStrain":  # fmt: skip
        """Return the deformation under displacements [m] and rotations [rad], (n, 3) each.

        Args:
            lattice: elements and bonds.
            lever: distance a of the contact points from centres i [m], (m,).
            displacement, rotation: displacements and rotations of the elements.
            slip: additional slip of every bond [m], (m, 3): that of a macroscopic strain in a periodic cell;
                -0.0 adds nothing to any number.
        """
        i, j = lattice.pairs.T
        direction = lattice.branch / lattice.length[:, None]
        a = lever[:, None]
        b = lattice.length[:, None] - a
        moved = displacement[j] - displacement[i] + np.cross(direction, a * rotation[i] + b * rotation[j]) + slip
        turned = rotation[j] - rotation[i]
        normal = (moved * direction).sum(axis=1)
        twist = (turned * direction).sum(axis=1)
        shear, bend = moved - normal[:, None] * direction, turned - twist[:, None] * direction
        return cls(direction, normal, shear, bend, twist)

    def forces(self, k: BondStiffness) -> Floats:
        """Return the force of each bond on its element i, tension pointing to j [N], (m, 3)."""
        return (k.kn * self.normal)[:, None] * self.direction + k.ks[:, None] * self.shear

    def products(self, other: "BondStrain") -> Floats:
        """Return the factors of kn, ks, kb and kt of each bond in the work on another deformation, (4, m)."""
        sheared = np.einsum("mi,mi->m", self.shear, other.shear)
        bent = np.einsum("mi,mi->m", self.bend, other.bend)
        return np.stack([self.normal * other.normal, sheared, bent, self.twist * other.twist])
