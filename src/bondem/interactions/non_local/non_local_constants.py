"""Constants of the non-local law on a body of cells or a lattice of spheres."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._tables.non_local_tables import SmallPairs
from bondem._types import Pairs, PerBond, PerBond3, PerElement, PerElement6
from bondem.errors import InputError
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.non_local.contact_areas import weighted_areas
from bondem.interactions.non_local.non_local_law import NonLocal
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class NonLocalConstants:
    """Constants of the forces of `NonLocal`.

    Levers begin at the elements: at the centres of spheres, or at the centres of mass of cells.

    Attributes:
        area: A [m²], shape (m,).
        kn: A E / L [N/m], shape (m,).
        kt: A G / L [N/m], shape (m,).
        normal: normals from i to j [-], shape (m, 3).
        lever_i, lever_j: levers from the elements to the contact point [m], shape (m, 3).
        volume: V by which the stress of an element is divided [m³], shape (n,).
        nu: ν [-].
        limited: True if the extra shear force is limited, as `NonLocal.limited` defines.
    """

    area: PerBond
    kn: PerBond
    kt: PerBond
    normal: PerBond3
    lever_i: PerBond3
    lever_j: PerBond3
    volume: PerElement
    nu: float
    limited: bool

    @classmethod
    def of(cls, lattice: Lattice, law: NonLocal) -> "NonLocalConstants":
        """Return the constants of a body or lattice.

        Raises:
            InputError: Areas of facets are requested without facets, or weighted areas for a body or without bonds.
        """
        build = _of_body if law.areas == "facet" else _of_spheres
        area, span, normal, lever_i, lever_j, volume = build(lattice, law)
        if law.volume == "sphere":
            volume = lattice.particles.volume
        return cls(
            area=area, kn=law.E * area / span, kt=law.G * area / span, normal=normal, lever_i=lever_i,
            lever_j=lever_j, volume=volume, nu=law.nu, limited=law.limited,
        )  # fmt: skip

    def ordered(self, layout: Layout) -> "NonLocalConstants":
        """Return the constants in internal order."""
        bond, back = layout.bond_order, layout.flipped[:, None]
        lever_i, lever_j = self.lever_i[bond], self.lever_j[bond]
        return NonLocalConstants(
            area=self.area[bond], kn=self.kn[bond], kt=self.kt[bond],
            normal=np.where(back, -self.normal[bond], self.normal[bond]),
            lever_i=np.where(back, lever_j, lever_i), lever_j=np.where(back, lever_i, lever_j),
            volume=self.volume[layout.order], nu=self.nu, limited=self.limited,
        )  # fmt: skip

    def small_pairs(self, pairs: Pairs, stress: PerElement6, gap: PerBond3) -> SmallPairs:
        """Return the table of bonds at small strain, with stresses [Pa] and gaps [m] of the previous step."""
        normal = np.ascontiguousarray(self.normal)
        return SmallPairs(pairs, self.area, self.kt, self.nu, self.limited, normal, stress, gap)

    def as_bonds(self, lattice: Lattice) -> BondStiffness:
        """Return stiffnesses of beams that are about as stiff as the bonds, for dashpots and estimates."""
        none = np.zeros_like(self.kn)
        return BondStiffness(
            kn=self.kn, ks=self.kt, kb=none, kt=none.copy(),
            lever=np.clip((self.lever_i * self.normal).sum(axis=1), 0.0, lattice.length),
            radius=np.sqrt(self.area / math.pi),
        )  # fmt: skip


_Parts = tuple[PerBond, PerBond, PerBond3, PerBond3, PerBond3, PerElement]


def _of_body(lattice: Lattice, law: NonLocal) -> _Parts:
    """Return area, span, normal and both levers of the facets, and volumes of the cells."""
    body = lattice.elements.require_cells(
        "NonLocal takes its areas from facets: connect particles with bd.connect(particles, method='laguerre'),"
        " or give areas='weighted' for a lattice of spheres"
    )
    facets, cells = body.facets, body.cells
    i, _ = lattice.pairs.T
    point = facets.centroid
    if law.lever == "contact":
        point = lattice.particles.position[i] + facets.depth_i[:, None] * facets.normal
    arm = point - cells.centroid[i]
    return facets.area, facets.span, facets.normal, arm, arm - lattice.branch, cells.volume


def _of_spheres(lattice: Lattice, law: NonLocal) -> _Parts:
    """Return area A, length, direction and both levers of the bonds, and the volume V of each element.

    V is Σ A l / 3 with the distance l of the radical plane, but at least the volume of the sphere.
    """
    lattice.elements.refuse_cells("areas='weighted' applies to lattices of spheres; leave it out for a body of cells")
    if len(lattice.pairs) == 0:
        raise InputError("NonLocal: the lattice has no bonds; bond it with bd.connect")
    i, j = lattice.pairs.T
    area, length, radius = weighted_areas(lattice), lattice.length, lattice.particles.radius
    normal = lattice.branch / length[:, None]
    arm = 0.5 * (length + (radius[i] ** 2 - radius[j] ** 2) / length)
    n = len(radius)
    volume = np.bincount(i, weights=area * arm, minlength=n) / 3.0
    volume += np.bincount(j, weights=area * (length - arm), minlength=n) / 3.0
    lever_i = arm[:, None] * normal
    return area, length, normal, lever_i, lever_i - lattice.branch, np.maximum(volume, lattice.particles.volume)
