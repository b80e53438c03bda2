"""Tables of the damage pipeline, as `core/tables/damage_tables.hpp` declares them with types and shapes.

Bonds are beams, facets of cells, or pairs of the non-local law: the m interactions of one kind that may fail.
"""

import numpy as np

from bondem._tables.columns import EventColumn
from bondem._tables.damage_tables import EventLog
from bondem.model.state import State


def new_event_log(state: State) -> EventLog:
    """Return an empty log of a run from a state."""
    room = np.empty((len(state.integrity), EventColumn.COUNT))
    return EventLog(room, np.zeros(2, dtype=np.int64), state.released, state.crushed)
