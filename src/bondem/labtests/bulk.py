"""Elastic moduli of a periodic cell, free of effects of walls, ends and gauges."""

from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import instance
from bondem._progress import staged
from bondem._types import Floats
from bondem.errors import InputError
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.interactions.lagged_interaction import LaggedInteraction
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.isotropic import VOIGT, StiffnessResult
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.statics.lagged_statics import LaggedStatics
from bondem.statics.linear import System
from bondem.statics.static import Statics

# Relative tolerance of the motions. C is stationary in them, so that its error is of second order in theirs.
_RTOL = 1e-8


@dataclass(frozen=True, eq=False)
class BulkModuli(StiffnessResult):
    """Elastic moduli of a periodic cell.

    Attributes:
        stiffness: C of σ = C ε, in the order xx, yy, zz, yz, xz, xy with engineering shear strains [Pa], (6, 6).
        strains: deformation of the bonds under each of the six unit strains; empty for cells and the non-local law.
        motions: displacements [m] and rotations [rad] in addition to the uniform strains, six arrays (n, 6).
        volume: volume of the periodic cell [m³].
    """

    stiffness: Floats
    strains: tuple[BondStrain, ...]
    motions: tuple[Floats, ...]
    volume: float

    def stiffness_of(self, k: Floats) -> Floats:
        """Return the stiffness C [Pa], (6, 6), of bonds with given stiffnesses at the deformations of this result.

        With the derivatives of the bond stiffnesses with respect to a parameter, the result is the derivative of C.
        Without bonds, for cells and the non-local law, it is zero.

        Args:
            k: kn and ks [N/m], kb and kt [N·m/rad] of each bond, (4, m).
        """
        C = np.zeros((6, 6))
        for s, one in enumerate(self.strains):
            for t in range(s, 6):
                C[s, t] = C[t, s] = np.vdot(k, one.products(self.strains[t])) / self.volume
        return C


@staged("bulk moduli")
def bulk_moduli(lattice: Lattice, law: AnyLaw, *, guess: BulkModuli | None = None) -> BulkModuli:
    """Compute the stiffness tensor of a periodic lattice.

    Six macroscopic strains ε are imposed. Each bond is stretched by ε times its branch vector to the nearest image.
    The elements then move and rotate to equilibrium, equally in all images of the cell: u = ε x + v. C follows from
    the energy of the bonds, V C_st = Σ kn δn_s δn_t + ks δs_s·δs_t + …. As this energy is stationary in v, the
    derivative of C with respect to a bond parameter is the sum with the derivatives of the stiffnesses.

    Args:
        lattice: bonded elements of a `Cell`, or of particles with a `period`.
        law: bond law, cell law, or laws by region, or the non-local law.
        guess: moduli of the same lattice with similar bonds, as an initial guess for bonds of spheres, or None.

    Raises:
        InputError: the lattice is not periodic or has no bonds.
    """
    instance("bulk_moduli", "lattice", lattice, Lattice, "a periodic lattice, from bd.connect")
    if not len(lattice.pairs):
        raise InputError("bulk_moduli: the lattice has no bonds; connect it with bd.connect")
    if guess is not None:
        instance("bulk_moduli", "guess", guess, BulkModuli, "the moduli of the same lattice with similar bonds")
    period = lattice.particles.period
    if period is None:
        raise InputError(
            "bulk_moduli: the lattice is not periodic; pack a bd.Cell, or give Particles their period= [m]"
        )
    model = Model(lattice, law, 1.0)  # statics do not depend on the density
    if isinstance(model.interaction, LaggedInteraction):
        return _of_lagged(model, model.interaction)
    statics = Statics(model)
    if model.interaction.on_facets:
        return _of_cells(statics)
    k = statics.model.stiffness
    moving = lattice.connected[lattice.pairs[:, 0], None]
    still = np.zeros((len(lattice.particles), 3))
    strains: list[BondStrain] = []
    motions: list[Floats] = []
    for slip, start in zip(_slips(lattice.branch), guess.motions if guess is not None else [None] * 6, strict=True):
        slip = np.where(moving, slip, 0.0)
        force = BondStrain.of(lattice, k.lever, still, still, slip=slip).forces(k)
        load = _nodal(statics.model, force)
        # in a crystal the load is zero but for rounding
        if np.linalg.norm(load[:, :3]) <= 1e-12 * np.linalg.norm(force):
            load[:] = 0.0
        motion = statics.response(load, guess=start, rtol=_RTOL)
        strains.append(BondStrain.of(lattice, k.lever, motion[:, :3], motion[:, 3:], slip=slip))
        motions.append(motion)
    moduli = BulkModuli(np.empty((6, 6)), tuple(strains), tuple(motions), float(period.prod()))
    return replace(moduli, stiffness=moduli.stiffness_of(np.stack([k.kn, k.ks, k.kb, k.kt])))


def _of_cells(statics: Statics) -> BulkModuli:
    """Compute the stiffness tensor of a periodic body of cells."""
    model = statics.model
    body, constants = model.lattice, model.cell_constants
    still = np.zeros((len(body.particles), 3))
    strains: list[CellStrain] = []
    motions: list[Floats] = []
    for slip in _slips(body.branch):
        load = CellStrain.of(body, constants, still, still, slip=slip).nodal(body, constants)
        motion = statics.response(load, rtol=_RTOL)
        strains.append(CellStrain.of(body, constants, motion[:, :3], motion[:, 3:], slip=slip))
        motions.append(motion)
    assert body.particles.period is not None
    volume = float(body.particles.period.prod())
    C = np.array([[one.work(other, constants) for other in strains] for one in strains]) / volume
    return BulkModuli(C, (), tuple(motions), volume)


def _of_lagged(model: Model, law: LaggedInteraction) -> BulkModuli:
    """Compute the stiffness tensor under a non-local law, from the mean stress Σ branch ⊗ force / volume."""
    lattice = model.lattice
    assert lattice.particles.period is not None
    volume = float(lattice.particles.period.prod())
    slips = _slips(lattice.branch)
    statics = LaggedStatics(law, System.of(model))
    rest = np.zeros((len(lattice.particles), 6))
    found = [statics.settle(rest, slip=slip) for slip in slips]
    C = np.array([[np.vdot(slip, one.strain.force) for one in found] for slip in slips]) / volume
    return BulkModuli(C, (), tuple(one.motion for one in found), volume)


def _slips(branch: Floats) -> Floats:
    """Compute the slips ε · branch of each bond for six unit strains [m], shape (6, m, 3)."""
    slip = np.zeros((6, len(branch), 3))
    for s, (a, b) in enumerate(VOIGT):
        if a == b:
            slip[s, :, a] = branch[:, a]
        else:
            slip[s, :, a] = 0.5 * branch[:, b]
            slip[s, :, b] = 0.5 * branch[:, a]
    return slip


def _nodal(model: Model, force: Floats) -> Floats:
    """Sum up the forces and moments on the elements [N, N·m], (n, 6), from the forces F of bonds [N], (m, 3).

    A bond acts on element i with F and on element j with -F. The moments about both centres have equal signs, as the
    force acts at the contact point between them.
    """
    lattice = model.lattice
    i, j = lattice.pairs.T
    arm = np.cross(lattice.branch / lattice.length[:, None], force)
    a = model.stiffness.lever[:, None]
    b = lattice.length[:, None] - a
    load = np.zeros((len(lattice.particles), 6))
    np.add.at(load[:, :3], i, force)
    np.add.at(load[:, :3], j, -force)
    np.add.at(load[:, 3:], i, a * arm)
    np.add.at(load[:, 3:], j, b * arm)
    return load
