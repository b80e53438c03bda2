"""A body of any shape under uniform stress: E and ν where a tension test makes no sense, such as of a bracket."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from bondem._checks import choice
from bondem._progress import staged
from bondem._types import Floats, PerElement6
from bondem.errors import InputError
from bondem.labtests.arguments import AnyLaw, check
from bondem.labtests.gauge_length import AffineField
from bondem.labtests.isotropic import Isotropic
from bondem.model.balance import balanced_forces
from bondem.model.model import Model
from bondem.solve.static import Statics
from bondem.specimen.lattice import Lattice
from bondem.specimen.patches import face_patches
from bondem.specimen.regions import Face

# Voigt order xx, yy, zz, yz, xz, xy.
_VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))

# Size of the patches of the surface, over the mean radius.
_PATCH = 0.5


@dataclass(frozen=True, eq=False)
class UniformStress:
    """Moduli of a body of any shape.

    Attributes:
        compliance: mean strains (rows, engineering shear) under unit stresses xx, yy, zz, yz, xz, xy [1/Pa], (6, 6);
            its symmetric part.
        asymmetry: largest difference of compliance and its transpose, over the largest entry [-]: how far the body
            is from one of a uniform material.
    """

    compliance: Floats
    asymmetry: float

    @property
    def stiffness(self) -> Floats:
        """Inverse of the compliance [Pa], (6, 6)."""
        return np.asarray(np.linalg.inv(self.compliance), dtype=float)

    @property
    def isotropic(self) -> Isotropic:
        """The isotropic (Voigt) average."""
        return Isotropic.average(self.stiffness)

    @property
    def K(self) -> float:
        """Bulk modulus of the isotropic average [Pa]."""
        return self.isotropic.K

    @property
    def G(self) -> float:
        """Shear modulus of the isotropic average [Pa]."""
        return self.isotropic.G

    @property
    def E(self) -> float:
        """Young's modulus of the isotropic average [Pa]."""
        return self.isotropic.E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the isotropic average [-]."""
        return self.isotropic.nu

    def along(self, axis: str) -> tuple[float, float]:
        """E [Pa] and ν [-] of tension along "x", "y" or "z"."""
        k = "xyz".index(choice("along", "axis", axis, ("x", "y", "z")))
        S = self.compliance
        return 1.0 / S[k, k], -0.5 * (S[:3, k].sum() - S[k, k]) / S[k, k]


@staged("uniform stress")
def uniform_stress(lattice: Lattice, law: AnyLaw, *, depth: float = 0.02) -> UniformStress:
    """Six unit stress states σ, each by tractions σ·n on the whole surface, and the mean strain of the body.

    The faces are cut into patches of half a mean radius, or into the facets of cells. Each hands its force to the
    nearest element of its face, with the moment about the element's centre; what rounding and curved patches leave
    unbalanced is taken out by the smallest forces. The mean strain is that of the affine field closest to the
    displacements of all connected elements: no gauge, no ends.

    Equal tractions everywhere load the skin of a packing, which is softer than its inside, as much as the inside: the
    moduli are a lower bound (Huet, J. Mech. Phys. Solids 38, 1990) that the bulk's are reached from below as the
    elements become small; docs/studies.md has numbers.

    Args:
        lattice: the specimen, of any shape with walls.
        law: its bonds.
        depth: of the loaded faces, in mean radii [-].

    Raises:
        InputError: a periodic cell, or a shape whose faces cannot be cut into patches.
        EmptyRegionError: no connected element at a face.
    """
    check("uniform_stress", lattice, depth=depth)
    if not lattice.particles.envelope.faces:
        raise InputError("uniform_stress loads the surface, and a periodic cell has none; use bd.bulk_moduli")
    statics = Statics(Model(lattice, law, 1.0))  # statics do not depend on the density
    owner, centre, area = _surface(lattice, depth)
    moving = np.flatnonzero(lattice.connected)
    position = lattice.centre
    strain = np.empty((6, 6))
    for column, (a, b) in enumerate(_VOIGT):
        stress = np.zeros((3, 3))
        stress[a, b] = stress[b, a] = 1.0
        load = _nodal(lattice, owner, centre, area @ stress)
        facets = area @ stress if statics.model.cells is not None else None
        moved = statics.response(load, facets=facets)[moving, :3]
        mean = AffineField.fit(position[moving], moved).strain
        strain[:, column] = [mean[i, j] * (1.0 if i == j else 2.0) for i, j in _VOIGT]
    asymmetry = np.abs(strain - strain.T).max() / np.abs(strain).max()
    return UniformStress(0.5 * (strain + strain.T), float(asymmetry))


def _surface(lattice: Lattice, depth: float) -> tuple[np.ndarray, Floats, Floats]:
    """The surface in patches: which element has each, centres [m] and areas times outward normals [m²]."""
    if lattice.cells is not None:
        free = lattice.cells.free
        return free.cell, free.centroid, free.area[:, None] * free.normal
    particles = lattice.particles
    owners, centres, areas = [], [], []
    for name in particles.envelope.faces:
        centre, area = face_patches(particles.envelope, name, _PATCH * particles.mean_radius)
        chosen = Face(name, depth).select(lattice)
        owners.append(chosen[KDTree(particles.position[chosen]).query(centre)[1]])
        centres.append(centre)
        areas.append(area)
    return np.concatenate(owners), np.concatenate(centres), np.concatenate(areas)


def _nodal(lattice: Lattice, owner: np.ndarray, centre: Floats, force: Floats) -> PerElement6:
    """Forces and moments of the elements under forces at patches [N, N·m], in balance, (n, 6)."""
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
