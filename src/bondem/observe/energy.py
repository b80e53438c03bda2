"""Elastic energy of the bonds and its parts."""

from dataclasses import dataclass

from bondem._types import PerBond, PerElement3
from bondem.kernels.bond_pass import bond_energies
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observe.bond_strain import BondStrain


@dataclass(frozen=True)
class EnergyParts:
    """Elastic energy stored in all bonds.

    Attributes:
        normal: of elongation [J].
        shear: of slip at the contact point [J]; with `bending` it is what the papers call bending.
        bending: of relative rotation across the bond [J].
        twisting: of relative rotation about the bond [J].
    """

    normal: float
    shear: float
    bending: float
    twisting: float

    @property
    def total(self) -> float:
        """Their sum [J]."""
        return self.normal + self.shear + self.bending + self.twisting


def linear_energy(
    model: Model, displacement: PerElement3, rotation: PerElement3, strain: PerBond | None = None
) -> EnergyParts:
    """Energy of small displacements [m] and rotations [rad] about the reference, user's order, (n, 3) each.

    The parts are ½ kn (δ·X - L ε*)², ½ ks |δ - (δ·X) X|², ½ kb |ρ - (ρ·X) X|², ½ kt (ρ·X)² of `BondStrain`.
    `strain` is ε* of each bond [-], in the kernels' order.
    """
    lattice, k = model.lattice, model.stiffness
    bonds = BondStrain.of(lattice, k.lever, displacement, rotation)
    elongation = bonds.normal.copy()
    if strain is not None:
        elongation[model.layout.bond_order] -= lattice.length[model.layout.bond_order] * strain
    return EnergyParts(
        normal=0.5 * float((k.kn * elongation**2).sum()),
        shear=0.5 * float((k.ks * (bonds.shear**2).sum(axis=1)).sum()),
        bending=0.5 * float((k.kb * (bonds.bend**2).sum(axis=1)).sum()),
        twisting=0.5 * float((k.kt * bonds.twist**2).sum()),
    )


def elastic_energy(model: Model, state: State) -> EnergyParts:
    """Energy of a state under the total formulation, at any rotation."""
    return EnergyParts(*bond_energies(state.pose, model.bonds.rows(model.layout, model.period, state.integrity)))
