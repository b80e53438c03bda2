"""Dashpot coefficients of bonds, from their stiffness and the damping of the run."""

import numpy as np

from bondem._types import Floats
from bondem.dynamics.damping import DampingTerms
from bondem.model.model import Model


def bond_dashpots(model: Model, terms: DampingTerms) -> Floats:
    """Return dashpot coefficients cn, cs [N·s/m], cb, ct [N·m·s] of each bond, internal order, shape (4, m)."""
    layout, bonds = model.layout, model.bonds
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    m, I = (1.0 / (1.0 / v[layout.i] + 1.0 / v[layout.j]) for v in (mass, inertia))
    stiffness = np.array([bonds.kn, bonds.ks, bonds.kb, bonds.kt])
    return 2.0 * terms.eta * np.sqrt(stiffness * np.array([m, m, I, I])) + terms.beta * stiffness
