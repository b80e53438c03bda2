"""Bond forces by the rates as the papers print them, in NumPy: Chen et al. (2022), eqs (1) to (7), Tables 1, 2 and 6.

A step of dt adds (Ω × F + k v) dt, with the velocities over the step, and the axis, length and contact point at its
end. The papers say neither at which instant of a step these are taken nor how stored forces follow the bond; this is
what one writes down first.
"""

from itertools import pairwise

import numpy as np

import bondem as bd
from bondem.interactions.beams.bond_law import BondLaw


class Printed:
    """A lattice whose elements are moved along given paths.

    Args:
        lattice, bond: as of a model.
        ends: elements whose force is wanted.

    Attributes:
        place: where the elements are [m], (n, 3).
    """

    def __init__(self, lattice: bd.Lattice, bond: BondLaw, ends: np.ndarray) -> None:
        model = bd.Model(lattice, bond, density=1.0)
        self.pairs, self.stiffness, self.ends = lattice.pairs.T, model.stiffness, ends
        self.place = lattice.particles.position.copy()
        self.share = (model.stiffness.lever / lattice.length)[:, None]
        self.force, self.moment = np.zeros((2, len(lattice.pairs), 3))

    def go(self, path: np.ndarray, rate: np.ndarray, dt: float) -> tuple[float, np.ndarray]:
        """Along positions (k + 1, n, 3) [m], one a step, at angular velocities (n, 3) [rad/s]; energy, end force."""
        (i, j), k = self.pairs, self.stiffness
        turned = dt * rate
        twist = turned[j] - turned[i]
        n = np.zeros((len(i), 3))
        for old, new in pairwise(path):
            d = new[j] - new[i]
            l = np.linalg.norm(d, axis=1)[:, None]
            n = d / l
            v = d - (old[j] - old[i])
            turn = np.cross(n, v) / l + 0.5 * along(turned[i] + turned[j], n)
            slip = v - np.cross(l * (self.share * turned[i] + (1.0 - self.share) * turned[j]), n)
            self.force = self.force + np.cross(turn, self.force) + scaled(slip, n, k.kn, k.ks)
            self.moment = self.moment + np.cross(turn, self.moment) + scaled(twist, n, k.kt, k.kb)
        self.place = path[-1]
        on = np.zeros_like(self.place)
        np.add.at(on, i, -self.force)
        np.add.at(on, j, self.force)
        energy = (self.force * scaled(self.force, n, 1.0 / k.kn, 1.0 / k.ks)).sum()
        energy += (self.moment * scaled(self.moment, n, 1.0 / k.kt, 1.0 / k.kb)).sum()
        return 0.5 * float(energy), on[self.ends].sum(axis=0)


def along(vector: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Part along unit vectors, (m, 3)."""
    return (vector * n).sum(axis=1)[:, None] * n


def scaled(vector: np.ndarray, n: np.ndarray, stiff: np.ndarray, soft: np.ndarray) -> np.ndarray:
    """The part along n times `stiff`, the rest times `soft`."""
    return soft[:, None] * vector + (stiff - soft)[:, None] * along(vector, n)
