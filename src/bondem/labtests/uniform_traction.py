"""Uniform stress on a body of any shape: E and ν of bodies, such as brackets, that have no tension test."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import choice
from bondem._progress import staged
from bondem._types import Axis, Floats, PerElement6
from bondem.boundary.balanced_forces import balanced_forces
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.faces import specimen_faces
from bondem.labtests.gauge_length import AffineField, at_generators
from bondem.labtests.isotropic import VOIGT, StiffnessResult
from bondem.model.model import Model
from bondem.specimen.lattice import Lattice
from bondem.statics.static import Statics


@dataclass(frozen=True, eq=False)
class UniformStress(StiffnessResult):
    """Elastic moduli of a body of any shape.

    Attributes:
        compliance: symmetric part of the measured matrix of mean strains (rows, engineering shear) under unit
            stresses xx, yy, zz, yz, xz, xy [1/Pa], (6, 6).
        asymmetry: largest difference of the measured matrix from its transpose, over its largest entry [-]. It is 0
            for a uniform material.
    """

    compliance: Floats
    asymmetry: float

    @property
    def stiffness(self) -> Floats:
        """Stiffness matrix, inverse of the compliance [Pa], (6, 6)."""
        return np.asarray(np.linalg.inv(self.compliance), dtype=float)

    def along(self, axis: Axis) -> tuple[float, float]:
        """Return Young's modulus [Pa] and Poisson's ratio [-] in uniaxial tension along "x", "y" or "z".

        Raises:
            InputError: another axis.
        """
        k = "xyz".index(choice("along", "axis", axis, Axis))
        S = self.compliance
        return 1.0 / S[k, k], -0.5 * (S[:3, k].sum() - S[k, k]) / S[k, k]


@staged("uniform stress")
def uniform_stress(lattice: Lattice, law: AnyLaw, *, depth: float = 0.02) -> UniformStress:
    """Apply six unit stress states to the whole surface and measure the mean strain of the body.

    Each unit stress σ acts as the traction σ·n on all faces. The faces are divided into patches of half a mean
    radius, or into the facets of cells. The force of a patch acts on the nearest element of its face, with the moment
    about the element's centre. Residual forces from rounding and curved patches are balanced by the smallest
    additional forces. The mean strain is that of the affine field closest to the displacements of all connected
    elements, so that neither gauges nor ends enter.

    Uniform tractions load the skin of a packing, which is softer than its interior, as much as the interior. The
    moduli are therefore a lower bound of the bulk moduli and approach them from below as elements become smaller
    (Huet, J. Mech. Phys. Solids 38, 1990).

    Args:
        lattice: the specimen, of any shape with walls.
        law: bond law, cell law or non-local law of the specimen.
        depth: depth of the loaded face regions, in mean radii [-].

    Raises:
        InputError: a periodic cell, a shape whose faces cannot be divided into patches, or a value out of range.
        EmptyRegionError: a face has no connected element.
    """
    check("uniform_stress", lattice, faces="", depth=depth)
    if not lattice.particles.envelope.faces:
        raise InputError("uniform_stress: a periodic cell has no surface to load; use bd.bulk_moduli")
    model = Model(lattice, law, 1.0)  # statics do not depend on the density
    statics, joined = Statics(model), model.interaction
    owner, centre, area = specimen_faces(lattice, depth).patches
    moving = np.flatnonzero(lattice.connected)
    strain = np.empty((6, 6))
    for column, (a, b) in enumerate(VOIGT):
        stress = np.zeros((3, 3))
        stress[a, b] = stress[b, a] = 1.0
        load = _nodal(lattice, owner, centre, area @ stress)
        swelling = joined.swelling_load(joined.pressed(np.arange(len(area)), area @ stress))
        motion = statics.response(load + swelling)
        position, moved = at_generators(lattice, motion[:, :3], motion[:, 3:])
        mean = AffineField.fit(position[moving], moved[moving]).strain
        strain[:, column] = [mean[i, j] * (1.0 if i == j else 2.0) for i, j in VOIGT]
    asymmetry = np.abs(strain - strain.T).max() / np.abs(strain).max()
    return UniformStress(0.5 * (strain + strain.T), float(asymmetry))


def _nodal(lattice: Lattice, owner: np.ndarray, centre: Floats, force: Floats) -> PerElement6:
    """Sum up the forces on patches [N], (p, 3), as balanced forces and moments on the elements [N, N·m], (n, 6)."""
    position = lattice.centre
    values = np.hstack([force, np.cross(centre - position[owner], force)])
    load = np.zeros((len(position), 6))
    np.add.at(load, owner, values)
    touched = np.unique(owner)
    arms = position[touched] - position[touched].mean(axis=0)
    excess = load[touched].sum(axis=0)
    excess[3:] += np.cross(arms, load[touched, :3]).sum(axis=0)
    load[touched, :3] -= balanced_forces(arms, excess[:3], excess[3:])
    return load
