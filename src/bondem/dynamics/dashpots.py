"""Dashpot coefficients of bonds, from their stiffness and the damping of the run."""

import numpy as np

from bondem._types import Floats
from bondem.dynamics.damping import DampingTerms
from bondem.model.model import Model


def bond_dashpots(model: Model, terms: DampingTerms) -> Floats:
    """Return dashpot coefficients cn, cs [N·s/m], cb, ct [N·m·s] of each bond, internal order, shape (4, m)."""
    stiffness, inert = _stiffness(model)
    return 2.0 * terms.eta * np.sqrt(stiffness * inert) + terms.beta * stiffness


def _stiffness(model: Model) -> tuple[Floats, Floats]:
    """Return kn, ks, kb, kt and the reduced masses and moments of inertia of bonds, internal order, (4, m) each."""
    layout, bonds = model.layout, model.bonds
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    m, I = (1.0 / (1.0 / v[layout.i] + 1.0 / v[layout.j]) for v in (mass, inertia))
    return np.array([bonds.kn, bonds.ks, bonds.kb, bonds.kt]), np.array([m, m, I, I])
