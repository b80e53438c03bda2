"""Mean stress and dilatation of cells."""

import numpy as np

from bondem._checks import instance
from bondem._types import Floats, PerElement
from bondem.geometry.rotations import add_force_moments
from bondem.interactions.cells.cell_body import body_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import CellForces, SmallMotion
from bondem.observables.element_stress import element_stress

# Indices of the components of a tensor in a row xx, yy, zz, xy, yz, zx.
_OF_TENSOR = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2]])


def cell_stress(model: Model, result: SmallMotion | State) -> Floats:
    """Compute the mean stress tensor of every cell, σ = sym Σ b⊗f / V over its facets [Pa], shape (n, 3, 3).

    For spheres joined by beams σ is the symmetric part of `bd.element_stress`, which also computes couple stresses.

    f are the forces of neighbours, constraining walls and surface loads on the facets. b are the arms from the centre
    of mass of the cell to the facets. In equilibrium Σ V σ over all cells is exactly the moment of the forces on the
    surface. Tension is positive; axes are global.

    Args:
        model: a body of cells under `CellBond`, or another model with bonds.
        result: linear static solution, or a state of an explicit run at any rotation. Give a nonlinear static
            solution as a state with its pose.

    Raises:
        InputError: The result belongs to another model, or a state with cracks was changed after its last step.
    """
    instance("cell_stress", "model", model, Model, "bd.Model(...)")
    found = stress_fields(model, result)
    return found["stress"].reshape(-1, 3, 3) if found else element_stress(model, result).symmetric


def stress_fields(model: Model, result: SmallMotion | State) -> dict[str, Floats]:
    """Return fields of cells by name; the result is empty for a model whose law does not act on facets.

    The fields are "stress", the mean stress σ row by row [Pa], (n, 9), "dilatation", tr σ / (3 λ + 2 G) [-], (n,),
    and "lambda_theta", the λ θ of the law [Pa], (n,).

    Raises:
        InputError: The result belongs to another model, or a state with cracks was changed after its last step.
    """
    if not model.interaction.on_facets:
        return {}
    forces, constants = CellForces.of(model, result), model.cell_constants
    stress = mean_stress(model, forces)
    dilatation = np.einsum("nii->n", stress) / (3.0 * constants.lame + 2.0 * constants.G)
    return {"stress": stress.reshape(-1, 9), "dilatation": dilatation, "lambda_theta": forces.stress}


def lambda_theta(model: Model, result: SmallMotion | State) -> PerElement:
    """Return λ θ of each cell, Lamé's λ times its dilatation [Pa], (n,); zeros if the law does not act on facets."""
    return stress_fields(model, result).get("lambda_theta", np.zeros(len(model.lattice.particles)))


def mean_stress(model: Model, forces: CellForces) -> Floats:
    """Compute the mean stress tensor of every cell from the forces on its facets [Pa], shape (n, 3, 3)."""
    body, supports = model.lattice, model.interaction.supports
    _, cells = body_of(body)
    i, j = body.pairs.T
    moment = np.zeros((len(cells.volume), 6))
    for owner, arm, force, sign in (
        (i, forces.arm_i, forces.force, 1.0), (j, forces.arm_j, forces.force, -1.0),
        (supports.cell, forces.wall_arm, forces.wall, 1.0), (cells.free.cell, forces.load_arm, forces.load, 1.0),
    ):  # fmt: skip
        add_force_moments(moment, owner, arm, force, sign)
    return (moment / cells.volume[:, None])[:, _OF_TENSOR]
