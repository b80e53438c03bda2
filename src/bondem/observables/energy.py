"""Elastic energy of the bonds under small motions, and its parts."""

import numpy as np

from bondem._types import PerBond, PerElement3
from bondem.interactions.energy_parts import EnergyParts
from bondem.model.model import Model
from bondem.observables.facet_loads import loads_on_facets


def linear_energy(
    model: Model, displacement: PerElement3, rotation: PerElement3, strain: PerBond | None = None
) -> EnergyParts:
    """Compute the energy of small displacements [m] and rotations [rad], user's order, (n, 3) each.

    For beams the parts are ½ kn (δ·X - L ε*)², ½ ks |δ - (δ·X) X|², ½ kb |ρ - (ρ·X) X|², ½ kt (ρ·X)² of `BondStrain`.
    `strain` is ε* of each bond [-], (m,), in internal order; None for zero.
    """
    law = model.interaction
    strain = np.zeros(len(model.lattice.pairs)) if strain is None else strain
    return law.small_energy(displacement, rotation, strain, model.pressed, loads_on_facets(model))
