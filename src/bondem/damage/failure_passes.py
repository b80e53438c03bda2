"""Failure indices of facets under given tractions."""

import numpy as np

from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.damage_tables import FailureIndices, LoadedTractions
from bondem._types import PerBond, PerBond3
from bondem.damage.failure_table import FailureTable


def traction_indices(normal: PerBond3, traction: PerBond3, area: PerBond, table: FailureTable) -> PerBond:
    """Return the failure index of each facet [-], (m,), which is proportional to its traction.

    Normals [-] and tractions [Pa], (m, 3), and areas [m²], (m,), are in internal order.
    """
    found = np.zeros(len(area))
    loaded = LoadedTractions(normal, traction, area)
    run_pass(calls.INDEX_TRACTIONS_BY[table.kind](loaded, table.strengths, FailureIndices(found)))
    return found
