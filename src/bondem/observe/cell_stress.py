"""Mean stress and dilatation of the cells of a body."""

import numpy as np

from bondem._types import Floats, Ints, PerElement
from bondem.model.cell_constants import body_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observe.cell_forces import CellForces, SmallMotion


def cell_stress(model: Model, result: SmallMotion | State) -> Floats:
    """Mean stress tensor of every cell, σ = sym Σ b⊗f / V over its facets [Pa], shape (n, 3, 3).

    f are the forces on its facets, those of its neighbours, of walls that hold it and of loads on the surface, and b
    the arms to them from its centre of mass. In equilibrium Σ V σ over all cells is the moment of what acts on the
    surface, exactly. Tension positive; axes in space.

    Args:
        model: a body of cells under `CellBond`.
        result: its linear static solution, or a state of an explicit run at any rotation. Give a nonlinear static
            solution as a state with its pose.

    Raises:
        InputError: another law, or a result of another model.
    """
    return mean_stress(model, CellForces.of(model, result))


def mean_stress(model: Model, forces: CellForces) -> Floats:
    """The same of forces that are known."""
    body, grips = model.lattice, model.cell_constants.grips
    _, cells = body_of(body)
    i, j = body.pairs.T
    moment = np.zeros((len(cells.volume), 3, 3))
    for owner, arm, force in (
        (i, forces.arm_i, forces.force), (j, forces.arm_j, -forces.force),
        (grips.cell, forces.held_arm, forces.held), (cells.free.cell, forces.load_arm, forces.load),
    ):  # fmt: skip
        _add(moment, owner, arm, force)
    return moment / cells.volume[:, None, None]


def _add(moment: Floats, owner: Ints, arm: Floats, force: Floats) -> None:
    """Add sym Σ b⊗f."""
    for a in range(3):
        for b in range(a, 3):
            part = arm[:, a] * force[:, b]
            if a != b:
                part = 0.5 * (part + arm[:, b] * force[:, a])
            total = np.bincount(owner, weights=part, minlength=len(moment))
            moment[:, a, b] += total
            if a != b:
                moment[:, b, a] += total


def dilatation(model: Model, stress: Floats) -> PerElement:
    """Change of volume over volume of cells under these mean stresses, tr σ / 3K [-], shape (n,)."""
    constants = model.cell_constants
    return np.einsum("nii->n", stress) / (3.0 * constants.lame + 2.0 * constants.G)
