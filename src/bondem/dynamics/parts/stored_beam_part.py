"""Beams of the incremental formulation, which store force and moment from step to step."""

from bondem._core_steps import StepPass
from bondem._tables.incremental_tables import StoredLoads
from bondem._tables.step_tables import Beams, Dashpots, Moving, Portions, StepCut
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.incremental_tables import stored_beam_tables
from bondem.model.model import Model
from bondem.model.state import State

_add_stored_loads = StepPass("add_stored_loads", Moving, Beams, StoredLoads, StepCut)
_add_dashpot_loads = StepPass("add_dashpot_loads", Moving, Beams, Dashpots, StepCut)
_check_beams = StepPass("check_beams", Moving, Beams, Portions)
_sum_stored_energies = StepPass("sum_stored_energies", Moving, Beams, StoredLoads, Portions)


def stored_beams(model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None) -> Part:
    """Return the part of beams that store force and moment, with dashpots beside them or without."""
    moving, cut, portions = shared.moving, shared.cut, shared.portions
    beams, stored = stored_beam_tables(model, state)
    loads: Passes = [(_add_stored_loads, moving, beams, stored, cut)]
    if dashpots is not None:
        loads.append((_add_dashpot_loads, moving, beams, dashpots, cut))

    def keep() -> None:
        if stored.history is not state.history:
            state.history[:] = stored.history[:, : state.history.shape[1]]

    return Part(
        {"loads": loads, "guard": [(_check_beams, moving, beams, portions)]},
        record=lambda _: [(_sum_stored_energies, moving, beams, stored, portions)],
        keep=keep,
    )
