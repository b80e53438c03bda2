"""Mean stress and couple stress of the elements of any bond law."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, vector
from bondem._types import Floats, Mask, PerElement, PerElement3
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.bond_forces import bond_forces
from bondem.observables.cell_forces import SmallMotion
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Region, as_region


@dataclass(frozen=True, eq=False)
class ElementStress:
    """Mean stress and couple stress of every element, user's order, global axes, tension positive.

    With c the point where a bond acts, f its force and m its moment there,

        σ = Σ (c - x) ⊗ f / V,   μ = Σ (c - x) ⊗ (m + (c - x) × f) / V

    over the bonds of an element of volume V about its centre x. The first index is the direction of the arm. In
    equilibrium, Σ V σ over all elements of a body that is not periodic is Σ x ⊗ F of the external forces F on them,
    and the antisymmetric part of σ balances the couples on an element. Without couples this part is zero.

    Attributes:
        lattice: the elements.
        stress: σ [Pa], shape (n, 3, 3).
        couple_stress: μ about the centre of each element [N/m], shape (n, 3, 3).
        volume: V [m³], shape (n,): volumes of cells, or parts of the volume of the shape in proportion to spheres.
        centre: x [m], shape (n, 3).

    Reference: Eliáš and Cusatis (2024), arXiv 2412.12616; the stress is that of Love and Weber.
    """

    lattice: Lattice
    stress: Floats
    couple_stress: Floats
    volume: PerElement
    centre: PerElement3

    @property
    def symmetric(self) -> Floats:
        """Symmetric part of the stress [Pa], shape (n, 3, 3)."""
        return 0.5 * (self.stress + np.swapaxes(self.stress, 1, 2))

    def mean(self, region: Region) -> Floats:
        """Mean stress of the elements of a region, such as a measurement sphere [Pa], shape (3, 3).

        Args:
            region: elements to average over, weighted with their volumes; `bd.Within(bd.Ball(r).moved(at))`.

        Raises:
            InputError: `region` is no region.
            EmptyRegionError: The region has no element.
        """
        chosen, share = self._shares("mean", region)
        return np.einsum("n,nab->ab", share, self.stress[chosen])

    def mean_couple(self, region: Region, about: Sequence[float] | None = None) -> Floats:
        """Mean couple stress of the elements of a region about a point [N/m], shape (3, 3).

        The mean is μ = Σ V (μ_p + σ_p × (x_p - X)) / Σ V, with the cross product on the second index of σ_p.

        Args:
            region: elements to average over.
            about: point X [m], (3,); the centre of volume of the elements unless given.

        Raises:
            InputError: `region` is no region, or `about` is not three finite components.
            EmptyRegionError: The region has no element.
        """
        chosen, share = self._shares("mean_couple", region)
        point = share @ self.centre[chosen] if about is None else np.array(vector("mean_couple", "about", about))
        arm = (self.centre[chosen] - point)[:, None, :]
        return np.einsum("n,nab->ab", share, self.couple_stress[chosen] + np.cross(arm, self.stress[chosen]))

    def _shares(self, owner: str, region: Region) -> tuple[Mask, Floats]:
        chosen = as_region(owner, region).with_rattlers(self.lattice)
        return chosen, self.volume[chosen] / self.volume[chosen].sum()


def element_stress(model: Model, result: SmallMotion | State) -> ElementStress:
    """Compute mean stress and couple stress of every element from the forces and moments of its bonds.

    Contacts and dashpots are not included. Loads act at the centres of spheres and make no contribution.

    Args:
        model: model of beams or of the non-local law; bodies of cells have `bd.cell_stress`.
        result: result that `bd.bond_forces` accepts.

    Returns:
        Stresses [Pa] and couple stresses [N/m] of the elements, with their volumes and centres.

    Raises:
        InputError: The model has cells, or `bd.bond_forces` rejects the result.
    """
    instance("element_stress", "model", model, Model, "bd.Model(...)")
    model.interaction.refuse_facets("element_stress: elements of this model are cells; give it to bd.cell_stress")
    found, lattice = bond_forces(model, result), model.lattice
    centre = result.position if isinstance(result, State) else lattice.centre
    i, j = lattice.pairs.T
    between = lattice.particles.nearest(centre[j] - centre[i])
    share = (model.stiffness.lever / lattice.length)[:, None]
    volume = lattice.elements.tributary_volume
    stress, couple = np.zeros((len(volume), 3, 3)), np.zeros((len(volume), 3, 3))
    for end, arm, force, moment in (
        (i, share * between, -found.force, found.moment_i), (j, (share - 1.0) * between, found.force, found.moment_j),
    ):  # fmt: skip
        np.add.at(stress, end, arm[:, :, None] * force[:, None, :])
        np.add.at(couple, end, arm[:, :, None] * moment[:, None, :])
    return ElementStress(
        lattice, stress / volume[:, None, None], couple / volume[:, None, None], volume, np.array(centre)
    )
