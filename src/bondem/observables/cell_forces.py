"""Forces on the facets of the cells of a body, and their arms, for small motions or in the pose of a state."""

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from bondem._checks import shown
from bondem._types import Floats, Ints, PerBond3, PerElement, PerElement3
from bondem.boundary.wall_constraints import Supports
from bondem.errors import InputError
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.cells.cell_body import body_of
from bondem.interactions.cells.cell_constants import CellConstants
from bondem.interactions.cells.cell_tables import STRESS, place_supports
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.facet_loads import loads_on_facets


class SmallMotion(Protocol):
    """Linear solution, such as a `StaticResult`."""

    @property
    def displacement(self) -> PerElement3:
        """Displacements of the centres [m], (n, 3)."""
        ...

    @property
    def rotation(self) -> PerElement3:
        """Rotation vectors [rad], (n, 3)."""
        ...


@dataclass(frozen=True, eq=False)
class CellForces:
    """Forces on the cells of a body, user's order.

    Arms begin at the centres of mass.

    Attributes:
        force: force of each facet on its cell i, tension pointing to j [N], shape (m, 3).
        arm_i, arm_j: arms to the facet [m], shape (m, 3).
        wall: forces of walls on the facets that they constrain [N], shape (g, 3).
        wall_arm: arms to these facets [m], shape (g, 3).
        load: forces of loads on the free facets [N], in the order of `cells.free`, shape (k, 3).
        load_arm: arms to these facets [m], shape (k, 3).
        stress: λ θ of each cell [Pa], shape (n,).
    """

    force: PerBond3
    arm_i: PerBond3
    arm_j: PerBond3
    wall: Floats
    wall_arm: Floats
    load: Floats
    load_arm: Floats
    stress: PerElement

    @classmethod
    def of(cls, model: Model, result: SmallMotion | State) -> "CellForces":
        """Return the forces in an equilibrium of small rotations, or in a state at any rotation.

        Args:
            model: the body of cells that the result belongs to.
            result: a linear `StaticResult`, or a `State`.

        Raises:
            InputError: The model has another law, the result is of another model, or a state with cracks was changed
                after its last step.
        """
        refusal = "cell_stress: the model has no cells; give a body of cells and bond=bd.CellBond(...)"
        model.interaction.require_facets(refusal)
        moved = getattr(result, "displacement", None)
        if moved is None:
            raise InputError(f"cell_stress: result = {shown(result)}; give what bd.solve_static returned, or a state")
        if len(moved) != len(model.lattice.particles):
            raise InputError(f"cell_stress: the result has {len(moved)} elements; give one of this model")
        return _turned(model, result) if isinstance(result, State) else _small(model, result)


def _small(model: Model, result: SmallMotion) -> CellForces:
    body, constants = model.lattice, model.cell_constants
    strain, supports = model.constraints.final_strain(), constants.supports
    found = model.cell_law.small_strain(result.displacement, result.rotation, strain, model.pressed)
    stress = found.stress(constants)
    _, cells = body_of(body)
    return CellForces(
        force=found.forces(body, constants), arm_i=constants.lever_i, arm_j=constants.lever_j,
        wall=supports.nodal(found.wall_gap, result.rotation, stress)[:, :3], wall_arm=supports.lever,
        load=loads_on_facets(model), load_arm=cells.free.centroid - cells.centroid[cells.free.cell],
        stress=stress,
    )  # fmt: skip


def _turned(model: Model, state: State) -> CellForces:
    body, constants = model.lattice, _grown(model, state)
    _, cells = body_of(body)
    i, j = body.pairs.T
    q, free, supports = state.orientation, cells.free, constants.supports
    a = turned_vectors(q[i], _deformed(state, i, constants.lever_i))
    b = turned_vectors(q[j], _deformed(state, j, constants.lever_j))
    if model.softening is not None and (len(state.cracks) or state.plastic.any()):
        force, stress = _stored(model, state), state.pose[model.layout.rank, STRESS]
    else:
        gap = body.particles.nearest(state.local_position[j] - state.local_position[i]) + b - a
        share_i, share_j = turned_vectors(q[i], constants.share_i), turned_vectors(q[j], constants.share_j)
        whole, n = state.bond_integrity, len(cells.volume)
        constants = constants.damaged(whole, i, j)
        opened = (supports.share * _openings(model, state, supports)).sum(axis=1)
        swelling = constants.pressed_by(loads_on_facets(model, state.time))
        swelling += np.bincount(i, weights=whole * (share_i * gap).sum(axis=1), minlength=n)
        swelling += np.bincount(j, weights=whole * (share_j * gap).sum(axis=1), minlength=n)
        swelling += np.bincount(supports.cell, weights=opened, minlength=n)
        stress = constants.stress_of(swelling)
        force = constants.k[:, None] * gap + stress[i, None] * share_i + stress[j, None] * share_j
        force *= whole[:, None]
    return CellForces(
        force=force, arm_i=a, arm_j=b, wall=wall_forces(model, state, stress), wall_arm=wall_arms(model, state),
        load=loads_on_facets(model, state.time, q),
        load_arm=turned_vectors(q[free.cell], free.centroid - cells.centroid[free.cell]),
        stress=stress,
    )  # fmt: skip


def _stored(model: Model, state: State) -> Floats:
    """Return the facet forces of the last step of a state with cracks or yielded cells, as stored by the run."""
    if state.stale:
        raise InputError("cell_stress: the state has cracks and was changed after its last step; run a step first")
    layout, force = model.layout, np.empty((len(model.lattice.pairs), 3))
    force[layout.bond_order] = np.where(layout.flipped[:, None], -1.0, 1.0) * state.facet_force.T
    return force


def _deformed(state: State, owner: Ints, arm: Floats) -> Floats:
    """Apply the plastic deformation of the owners to arms in their frames [m], (m, 3)."""
    if not state.plastic.any():
        return arm
    return np.einsum("mab,mb->ma", state.plastic_deformation[owner], arm)


def _grown(model: Model, state: State) -> CellConstants:
    """Return the cell constants with the wall supports and the stress-free strain of a state, user's order."""
    constants, layout, strain = model.cell_constants, model.layout, state.rest_strain
    if len(state.grips) == len(constants.supports.cell):
        constants = replace(constants, supports=constants.supports.taken(state.grips))
    if not strain.size:
        return constants
    own = np.empty_like(strain)
    own[layout.bond_order] = strain
    return replace(constants, strain=own, supports=constants.supports.grown(layout.of_elements(strain)))


def wall_arms(model: Model, state: State) -> Floats:
    """Return the arms from the centres of mass to the facets that walls constrain, in a state [m], (g, 3)."""
    supports = _grown(model, state).supports
    return turned_vectors(state.orientation[supports.cell], _deformed(state, supports.cell, supports.arm))


def wall_forces(model: Model, state: State, stress: PerElement | None = None) -> Floats:
    """Return the forces of walls on the facets that they constrain in a state [N], (g, 3).

    λ θ of each cell [Pa], (n,), is `stress`; None for that of the last step.
    """
    supports = _grown(model, state).supports
    stress = state.pose[model.layout.rank, STRESS] if stress is None else stress
    opened = supports.k[:, None] * _openings(model, state, supports)
    return opened + stress[supports.cell, None] * supports.share


def _openings(model: Model, state: State, supports: Supports) -> Floats:
    moved = state.displacement[supports.cell] + wall_arms(model, state) - supports.lever
    return supports.axes * (wall_places(model, state) - moved)


def wall_places(model: Model, state: State, base: Floats | None = None) -> Floats:
    """Return the displacement of the wall of each constrained facet at the time of a state [m], (g, 3).

    Initial poses of the walls are `base`, (g, 7); None for those of the state.
    """
    base = state.grips if base is None else base
    walls = model.interaction.supports.table(model.layout, model.constraints.row_of, base)
    place_supports(walls, state.time)
    return walls.wall
