"""Bonds of the non-local law and stresses of their elements as the core takes them beside `Beams`.

`core/tables/non_local_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._cache_lines import lines
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.damage_tables import FailureIndices
from bondem._tables.non_local_tables import ExtraForces, LaggedStresses, NonLocalBonds, SmallPairs
from bondem._tables.step_tables import Beams, Poses
from bondem._types import Floats, PerBond
from bondem.damage.failure_passes import strengths_of
from bondem.damage.failure_table import FailureTable
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.beams.bond_table import with_twins, with_zeros
from bondem.interactions.non_local.non_local_constants import NonLocalConstants
from bondem.model.model import Model
from bondem.model.state import State


def non_local_tables(model: Model, state: State) -> tuple[Beams, NonLocalBonds]:
    """Return bonds of the non-local law, whose stored data are the state's own array.

    Where the model has fewer bonds than a group, the array is a longer copy, made by
    `bondem.interactions.beams.bond_table.with_zeros`.
    """
    constants = model.non_local
    assert constants is not None
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity, may_share=False)

    def columns(each: Floats) -> Floats:
        return np.ascontiguousarray(with_zeros(each.T))

    return beams, NonLocalBonds(
        area=with_zeros(constants.area), kn=with_zeros(constants.kn), kt=with_zeros(constants.kt),
        normal=columns(constants.normal), lever_i=columns(constants.lever_i), lever_j=columns(constants.lever_j),
        nu=constants.nu, limited=constants.limited, history=with_zeros(state.history),
        output=with_zeros(np.zeros((_OUTPUT_ROWS, len(constants.area)))),
    )  # fmt: skip


def lagged_stresses(model: Model, state: State, to_i: np.ndarray, more: int) -> LaggedStresses:
    """Return stresses of the elements, which are the state's own array.

    Args:
        model: model of the non-local law.
        state: state of the model.
        to_i: row of the moment that each bond adds to for its element i, uint32, (m,).
        more: number of rows of moments behind those of the elements.
    """
    constants, n = model.non_local, len(state.stress)
    assert constants is not None
    return LaggedStresses(1.0 / constants.volume, state.stress, lines(n), lines(n + more), with_twins(to_i))


def lagged_extra_forces(pairs: np.ndarray, constants: NonLocalConstants, stress: Floats, gap: Floats) -> Floats:
    """Return extra forces (m, 3) at small strain, from stresses (n, 6) and gaps (m, 3) of the iteration before."""
    c, extra = constants, ExtraForces(np.empty_like(gap))
    run_pass(calls.find_small_extra_forces(
        SmallPairs(pairs, c.area, c.kt, c.nu, c.limited, np.ascontiguousarray(c.normal), stress, gap), extra
    ))
    return extra.force


def loads_of_non_local(model: Model, state: State) -> Floats:
    """Return force on j, torque on i and torque on j of each bond in the pose of a state [N, N·m], (m, 9)."""
    beams, bonds = non_local_tables(model, state)
    run_pass(calls.load_non_local_bonds(Poses(state.pose), beams, bonds))
    own = bonds.output[:, : len(state.integrity)].T
    return np.hstack([-own[:, :3], own[:, 3:6], -own[:, 6:]])


def indices_of_pairs(model: Model, state: State, table: FailureTable) -> PerBond:
    """Return the index of each bond by the stresses of a state [-], 0 where broken, internal order, (m,)."""
    beams, _ = non_local_tables(model, state)
    stresses = lagged_stresses(model, state, model.layout.i, 0)
    run_pass(calls.turn_all_stresses(Poses(state.pose), stresses))
    found = FailureIndices(np.zeros(len(beams.i)))
    run_pass(calls.index_pairs(beams, stresses, strengths_of(table), found))
    return found.index[: len(state.integrity)]


# Rows of the present loads of bonds.
_OUTPUT_ROWS = 9
