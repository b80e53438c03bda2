"""Indices, 1 at crack initiation of facets and at yielding of cells, from the stress of the cells."""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.crack_sample_tables import YieldSamples
from bondem._tables.stress_onset_tables import LoadedFacets
from bondem._types import PerBond, PerElement
from bondem.damage.proportional_onset import agreed_stresses, onset_factors
from bondem.damage.softening_table import SlipTable, SofteningTable
from bondem.geometry.rotations import turned_vectors
from bondem.interactions.cells.cell_body import body_of
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_forces import CellForces, SmallMotion
from bondem.observables.cell_stress import mean_stress

# Indices of xx, yy, zz, xy, xz and yz in a tensor stored row by row.
_COMPONENTS = [0, 4, 8, 1, 2, 5]


def crack_index(
    model: Model, table: SofteningTable, state: State, motion: SmallMotion | State
) -> PerBond:
    """Compute the index of the criterion of each facet at the stress σ* (see `bd.Rankine`).

    Broken facets have index 0, softening ones 1. For `bd.Rankine` and `bd.MohrCoulomb` the index is the least of

    - the largest principal stress of σ* over the strength,
    - the largest ratio of opening traction to strength among the principal directions of the mean stress,
    - the index of the traction alone, if the facet is in compression.

    A material plane is a joint between two regions, which only these criteria describe; the index of its facets is
    that of their traction. For other criteria the index is that of σ*, and 0 for facets in compression.

    Args:
        model: model whose facets may crack.
        table: strengths of the facets.
        state: state of this model.
        motion: small motion of which `state` is the pose, or `state` itself.

    Returns:
        Index [-], user's order, shape (m,).

    Raises:
        InputError: The model has no cells, `motion` is of another model, or a state with cracks was changed after its
            last step.
    """
    body = model.lattice
    facets, _ = body_of(body)
    i, j = body.pairs.T
    forces = CellForces.of(model, motion)
    n = facets.normal
    if isinstance(motion, State):
        n = turned_vectors(motion.orientation[i], n)
    order, traction = model.layout.bond_order, forces.force / facets.area[:, None]
    stress = mean_stress(model, forces).reshape(-1, 9)[:, _COMPONENTS]
    # facets in internal order, which is that of the strengths
    loaded = LoadedFacets(
        i[order], j[order], n[order], traction[order], _bending(model, state)[order], np.ascontiguousarray(stress)
    )
    if table.judge is None:
        found = 1.0 / onset_factors(loaded, table.strengths(), np.arange(len(order)))
    else:
        agreed = agreed_stresses(loaded)
        found = table.judge.indices(agreed * (table.tension / table.strength)[:, None, None])
        pulled = np.einsum("ma,mab,mb->m", loaded.normal, agreed, loaded.normal)
        found = np.where(pulled > 0.0, np.maximum(found, 0.0), 0.0)
    index = np.empty(len(order))
    index[order] = found
    whole = state.bond_integrity
    return np.where(whole == 1.0, index, np.where(whole > 0.0, 1.0, 0.0))


def yield_index(model: Model, state: State) -> PerElement:
    """Compute the yield index of each cell, (σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ over c cos φ with its present cohesion c.

    For the cone of Drucker and Prager the index is √J2 + α I1 over k, and 0 if the mean stress is tensile. Cells that
    have lost their cohesion have index 1. All indices are 0 if the model has no yielding. A state of yielded cells
    that was changed after its last step raises InputError.

    Returns:
        Index [-], user's order, shape (n,).
    """
    index = np.zeros(len(model.lattice.particles))
    for slip in model.yielding:
        index = _yield_index(model, state, slip)
    return index


def _yield_index(model: Model, state: State, slip: SlipTable) -> PerElement:
    stress = mean_stress(model, CellForces.of(model, state)).reshape(-1, 9)[:, _COMPONENTS].T
    rank, given, found = model.layout.rank, np.ones((5, stress.shape[1])), np.empty((13, stress.shape[1]))
    given[1] = slip.slope[rank]
    bears = slip.strength[rank] * (1.0 - slip.spent(state.slipped[model.layout.order])[rank])
    run_pass(calls.evaluate_yielding(YieldSamples(np.ascontiguousarray(stress), given, slip.cone, True, found)))
    return np.where(bears > 0.0, np.maximum(found[-1], 0.0) / np.where(bears > 0.0, bears, 1.0), 1.0)


def _bending(model: Model, state: State) -> PerBond:
    """Return T_b, the rms of the tractions that bending causes on each facet [Pa], user's order, (m,)."""
    facets, _ = body_of(model.lattice)
    constants, turns = model.cell_constants, state.orientation[model.lattice.pairs]
    p, q = turns[:, 0], turns[:, 1]
    v = p[:, :1] * q[:, 1:] - q[:, :1] * p[:, 1:] - np.cross(p[:, 1:], q[:, 1:])
    resisted = np.einsum("ma,mab,mb->m", v, constants.H, v)
    return np.sqrt(np.maximum(4.0 * constants.k / facets.area**2 * resisted, 0.0))
