"""Elastic moduli of a periodic cell: no wall, no end, no gauge."""

from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.model.assignment import BondAssignment
from bondem.model.model import Model
from bondem.solve.linear import System, solver
from bondem.solve.threads import one_blas_thread
from bondem.specimen.lattice import Lattice

# Voigt order xx, yy, zz, yz, xz, xy, with engineering shear strains.
_VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))


@dataclass(frozen=True, eq=False)
class BulkModuli:
    """Moduli of a periodic cell.

    Attributes:
        stiffness: C, σ = C ε in the order xx, yy, zz, yz, xz, xy with engineering shear strains [Pa], (6, 6).
    """

    stiffness: Floats

    @property
    def K(self) -> float:
        """Bulk modulus of the isotropic (Voigt) average [Pa]."""
        C = self.stiffness
        return float(C[:3, :3].sum()) / 9.0

    @property
    def G(self) -> float:
        """Shear modulus of the isotropic (Voigt) average [Pa]."""
        C = self.stiffness
        longitudinal, lateral = np.trace(C[:3, :3]), C[0, 1] + C[0, 2] + C[1, 2]
        return float(longitudinal - lateral + 3.0 * np.trace(C[3:, 3:])) / 15.0

    @property
    def E(self) -> float:
        """Young's modulus of the isotropic average [Pa]."""
        return 9.0 * self.K * self.G / (3.0 * self.K + self.G)

    @property
    def nu(self) -> float:
        """Poisson's ratio of the isotropic average [-]."""
        return (3.0 * self.K - 2.0 * self.G) / (2.0 * (3.0 * self.K + self.G))


@one_blas_thread
def bulk_moduli(lattice: Lattice, law: BondAssignment) -> BulkModuli:
    """Stiffness tensor of a periodic lattice.

    Six macroscopic strains ε are imposed. Every bond is stretched by ε times its branch vector, taken over
    the nearest image, and the elements then move and turn, the same in every image of the cell, until they
    rest: u = ε x + v. With the slips g of the bonds under ε alone and k their stiffness, C is the energy of
    that motion: V C = gᵀ k g - fᵀ v, where K v = f balances the forces of ε.

    Args:
        lattice: bonded elements of a `Cell`, or of particles with a `period`.
        law: a bond law, or laws by region.

    Raises:
        InputError: the lattice is not periodic.
    """
    period = lattice.particles.period
    if period is None:
        raise InputError(
            "bulk_moduli needs a periodic cell: pack a bd.Cell, or give Particles their period= [m]"
        )
    model = Model(lattice, law)
    system = System.of(model)
    slip = _slips(lattice.branch)
    direction = lattice.branch / lattice.length[:, None]
    k = model.stiffness
    along = np.einsum("mi,mis->ms", direction, slip)
    force = k.ks[:, None, None] * slip + ((k.kn - k.ks)[:, None] * along)[:, None, :] * direction[:, :, None]
    moving = (lattice.connected[lattice.pairs[:, 0]])[:, None, None]
    load = _nodal(model, np.where(moving, force, 0.0))
    # in a crystal nothing moves but by rounding
    load[:, np.linalg.norm(load, axis=0) <= 1e-12 * np.linalg.norm(force)] = 0.0
    solve = solver(system).solve
    fluctuation = np.stack([solve(column) for column in load.T.copy()], axis=1)
    affine = np.einsum("mis,mit->st", np.where(moving, slip, 0.0), force)
    stiffness = (affine - load.T @ fluctuation) / period.prod()
    return BulkModuli(0.5 * (stiffness + stiffness.T))


def _slips(branch: Floats) -> Floats:
    """ε · branch of each bond for six unit strains [m], shape (m, 3, 6)."""
    slip = np.zeros((len(branch), 3, 6))
    for s, (a, b) in enumerate(_VOIGT):
        if a == b:
            slip[:, a, s] = branch[:, a]
        else:
            slip[:, a, s] = 0.5 * branch[:, b]
            slip[:, b, s] = 0.5 * branch[:, a]
    return slip


def _nodal(model: Model, force: Floats) -> Floats:
    """What bonds with these forces on their far ends (m, 3, s) do to the elements, (6 n, s), internal order.

    The bond pulls i by +F and j by -F, and turns both the same way, by the levers of its contact point.
    """
    lattice = model.lattice
    n = len(lattice.particles)
    i, j = lattice.pairs.T
    direction = lattice.branch / lattice.length[:, None]
    arm = np.cross(direction[:, :, None], force, axis=1)
    a = model.stiffness.lever[:, None, None]
    b = lattice.length[:, None, None] - a
    load = np.zeros((n, 6, force.shape[2]))
    np.add.at(load[:, :3], i, force)
    np.add.at(load[:, :3], j, -force)
    np.add.at(load[:, 3:], i, a * arm)
    np.add.at(load[:, 3:], j, b * arm)
    return load[model.layout.order].reshape(6 * n, -1)
