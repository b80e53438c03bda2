"""Forces and moments of the bonds in a static solution or a state."""

from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, shown
from bondem._tables.columns import SoftColumn
from bondem._types import Floats, PerBond, PerBond3
from bondem.errors import InputError
from bondem.model.model import Model
from bondem.model.state import State
from bondem.model.state_compatibility import difference
from bondem.observables.cell_forces import SmallMotion

# Columns of the loads of a bond: force on j, torque on i, torque on j.
ON_J, TURN_I, TURN_J, COLUMNS = 0, 3, 6, 9


@dataclass(frozen=True, eq=False)
class BondForces:
    """Forces and moments of bonds on their elements, user's order, global axes; zero for broken bonds.

    The force on element i is the opposite of that on j. Moments act on the elements, at their centres. A bond in
    tension pulls j towards i, so that `force` points against `axis`. With branch vectors l and external forces F at
    centres x, the Love–Weber sum is therefore -Σ f ⊗ l = Σ F ⊗ x. In a test this sum contains the distance between
    loaded and fixed centres, which is shorter than the specimen. `bd.element_stress` computes local stresses.

    Attributes:
        force: force of the bond on element j [N], shape (m, 3).
        moment_i: moment on element i [N·m], shape (m, 3).
        moment_j: moment on element j [N·m], shape (m, 3).
        axis: unit vector from centre i to centre j in the present pose [-], shape (m, 3).
    """

    force: PerBond3
    moment_i: PerBond3
    moment_j: PerBond3
    axis: PerBond3

    @property
    def normal(self) -> PerBond:
        """Axial force [N], tension positive, shape (m,)."""
        return -(self.force * self.axis).sum(axis=1)

    @property
    def shear(self) -> PerBond:
        """Magnitude of the shear force [N], shape (m,)."""
        return np.linalg.norm(np.cross(self.force, self.axis), axis=1)

    @property
    def bending(self) -> PerBond:
        """Larger of the bending moments at both ends, as a magnitude [N·m], shape (m,)."""
        ends = [np.linalg.norm(np.cross(moment, self.axis), axis=1) for moment in (self.moment_i, self.moment_j)]
        return np.maximum(*ends)

    @property
    def twisting(self) -> PerBond:
        """Magnitude of the twisting moment [N·m], shape (m,)."""
        return np.abs((self.moment_i * self.axis).sum(axis=1))


def bond_forces(model: Model, result: SmallMotion | State) -> BondForces:
    """Compute forces and moments of the bonds in a static solution or a state, without those of dashpots.

    Args:
        model: model of beams or of the non-local law; bodies of cells have stresses instead (`bd.cell_stress`).
        result: linear solution of this model, such as that of `bd.solve_static`; or a state of a run, or
            `model.state()`. Give a solution of large rotations as a state with its pose.

    Returns:
        Forces and moments, user's order.

    Raises:
        InputError: The model has cells, the result is of another model, or a static solution of the non-local law.
    """
    instance("bond_forces", "model", model, Model, "bd.Model(...)")
    if isinstance(result, State):
        other = difference(result.model, model)
        if other:
            raise InputError(f"bond_forces: the state belongs to another {other}; give one of this model")
        return _of_state(model, result)
    moved, turned = getattr(result, "displacement", None), getattr(result, "rotation", None)
    if moved is None or turned is None:
        raise InputError(f"bond_forces: result = {shown(result)}; give what bd.solve_static returned, or a state")
    if len(moved) != len(model.lattice.particles):
        raise InputError(f"bond_forces: the result has {len(moved)} elements; give one of this model")
    strain = np.empty(len(model.lattice.pairs))
    strain[model.layout.bond_order] = model.constraints.final_strain()
    found = model.interaction.small_loads(moved, turned, strain)
    axis = model.lattice.branch / model.lattice.length[:, None]
    return BondForces(found[:, ON_J : ON_J + 3], found[:, TURN_I : TURN_I + 3], found[:, TURN_J : TURN_J + 3], axis)


def _of_state(model: Model, state: State) -> BondForces:
    """Compute the forces in the pose of a state."""
    layout, pairs = model.layout, model.lattice.pairs
    m = len(pairs)
    found = np.zeros((m, COLUMNS))
    if m:
        found[:] = model.interaction.loads(state.pose, state.of_law)
    own, back = np.empty_like(found), np.empty(m, dtype=bool)
    own[layout.bond_order], back[layout.bond_order] = found, layout.flipped
    sign, turned = np.where(back, -1.0, 1.0)[:, None], back[:, None]
    one, other_end = own[:, TURN_I : TURN_I + 3], own[:, TURN_J : TURN_J + 3]
    position = state.local_position
    between = model.lattice.particles.nearest(position[pairs[:, 1]] - position[pairs[:, 0]])
    length = np.linalg.norm(between, axis=1)
    axis = between / length[:, None]
    force = sign * own[:, ON_J : ON_J + 3] + _pressed(model, state, length)[:, None] * axis
    return BondForces(force, np.where(turned, other_end, one), np.where(turned, one, other_end), axis)


def _pressed(model: Model, state: State, length: Floats) -> PerBond:
    """Return (1 - integrity) times the elastic compressive force of softening beams [N], user's order, (m,)."""
    push = np.zeros(len(length))
    softening = state.softened[:, SoftColumn.BOND].astype(np.int64)
    softening = softening[state.integrity[softening] > 0.0]
    if len(softening):
        bond = model.layout.bond_order[softening]
        rest = model.bonds.stretched(state.rest_strain).length[softening]
        shortened = np.maximum(rest - length[bond], 0.0)
        push[bond] = (1.0 - state.integrity[softening]) * model.bonds.kn[softening] * shortened
    return push
