"""Cracks of a state: joints of their cells, and quantities that the parts of cracking bodies need."""

import numpy as np

from bondem._tables.columns import CrackStatus
from bondem._types import Floats, PerBond
from bondem.boundary.conditions import Load
from bondem.boundary.loads import Pressure, is_face
from bondem.damage.crack_columns import FACET, STATUS, TOP
from bondem.interactions.cells.cell_body import body_of
from bondem.model.model import Model
from bondem.model.state import State

# What breaks at once loses this share of its integrity, at most, in the time 1/ω in which the facet between its two
# cells swings by itself, and in a step: the energy balance closes, better with a shorter step.
LOSS = 0.1


def joints(model: Model, state: State, integrity: PerBond) -> tuple[PerBond, PerBond]:
    """Return the joints of the elements of bonds, 0 for none, and contact distances without them [m], (m,) each.

    Cracked facets join two cells as long as their faces face each other.

    Args:
        model: model of the bonds.
        state: state with the present cracks.
        integrity: integrity of the bonds in the form of the loop over them; at least (m,).
    """
    apart = model.bonds.stretched(state.rest_strain).length.copy()
    if model.softening is None:
        return integrity, apart
    joined = (state.integrity > 0.0).astype(float)
    facet, parted = state.cracks[:, FACET].astype(np.int64), state.cracks[:, STATUS] == CrackStatus.PARTED
    joined[facet] = np.where(parted, 0.0, 1.0)
    apart[facet[parted]] = np.minimum(apart[facet[parted]], state.cracks[parted, TOP])
    return joined, apart


def pressed_moments(model: Model) -> Floats:
    """Return b⊗F of loads on free facets, xx, yy, zz, xy, xz, yz, in internal order [J], (l, n, 6)."""
    _, cells = body_of(model.lattice)
    free, found = cells.free, []
    for condition in model.boundary:
        if isinstance(condition, Load | Pressure) and is_face(condition.region):
            numbers, force = condition.on_facets(model.lattice)
            cell, moment = free.cell[numbers], np.zeros((len(cells.volume), 6))
            arm = free.centroid[numbers] - cells.centroid[cell]
            for column, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
                part = 0.5 * (arm[:, a] * force[:, b] + arm[:, b] * force[:, a])
                moment[:, column] = np.bincount(cell, part, len(moment))
            found.append(moment[model.layout.order])
    return np.array(found).reshape(len(found), len(cells.volume), 6)
