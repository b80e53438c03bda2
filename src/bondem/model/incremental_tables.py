"""Beams of the incremental formulation as the core takes them beside `Beams`.

`core/tables/incremental_tables.hpp` declares types and shapes.
"""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.incremental_tables import LoadsOfEach, StoredLoads
from bondem._tables.step_tables import Beams, Poses
from bondem._types import Floats
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.beams.bond_table import with_zeros
from bondem.model.model import Model
from bondem.model.state import State


def stored_beam_tables(model: Model, state: State) -> tuple[Beams, StoredLoads]:
    """Return beams of the incremental formulation and their stored loads, which share their array with the state.

    Where the model has fewer beams than a group, the array is a longer copy, made by
    `bondem.interactions.beams.bond_table.with_zeros`.
    """
    beams, _ = beam_tables(model.bonds, model.layout, model.period, state.integrity, may_share=False)
    return beams, StoredLoads(np.ascontiguousarray(with_zeros(model.bonds.kb)), with_zeros(state.history))


def loads_of_stored(model: Model, state: State) -> Floats:
    """Return force on j, torque on i and torque on j of each beam in the pose of a state [N, N·m], (m, 9)."""
    beams, stored = stored_beam_tables(model, state)
    loads = LoadsOfEach(np.empty((9, len(beams.i))))
    run_pass(calls.load_stored_beams(Poses(state.pose), beams, stored, loads))
    return loads.found[:, : len(state.integrity)].T
