"""Passes that Python calls, of `core/passes/incremental/stored_beams.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.incremental_tables import LoadsOfEach, StoredLoads
from bondem._tables.step_tables import Beams, Poses


def load_stored_beams(poses: Poses, beams: Beams, stored_loads: StoredLoads, loads_of_each: LoadsOfEach) -> Call:
    """Finds the loads of each beam on its elements in given poses."""
    return Call("load_stored_beams", (poses, beams, stored_loads, loads_of_each))
