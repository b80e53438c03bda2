"""Beams of the incremental formulation, which store force and moment from step to step."""

from bondem._passes import steps
from bondem._tables.step_tables import Dashpots
from bondem.dynamics.parts.shared_tables import SharedTables
from bondem.interactions.step_part import Part, Passes
from bondem.model.incremental_tables import stored_beam_tables
from bondem.model.model import Model
from bondem.model.state import State


def stored_beams(model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None) -> Part:
    """Return the part of beams that store force and moment, with dashpots beside them or without."""
    moving, cut, portions = shared.moving, shared.cut, shared.portions
    beams, stored = stored_beam_tables(model, state)
    loads: Passes = [steps.add_stored_loads(moving, beams, stored, cut)]
    if dashpots is not None:
        loads.append(steps.add_dashpot_loads(moving, beams, dashpots, cut))

    def keep() -> None:
        if stored.history is not state.history:
            state.history[:] = stored.history[:, : state.history.shape[1]]

    return Part(
        {"loads": loads, "guard": [steps.check_beams(moving, beams, portions)]},
        record=lambda _: [steps.sum_stored_energies(moving, beams, stored, portions)],
        keep=keep,
    )
