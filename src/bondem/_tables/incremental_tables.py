"""Tables of `core/tables/incremental_tables.hpp`, written by `python -m tests.core.tables` from the header."""

from typing import NamedTuple

from bondem._types import Floats


class StoredLoads(NamedTuple):
    """Data that m beams store from step to step."""

    kb: Floats  #: bending stiffness [N·m], (m,)
    history: Floats  #: force [N] and moment [N·m] on i at the contact point, (6, m)


class LoadsOfEach(NamedTuple):
    """Force on j and torques on i and j of each beam."""

    found: Floats  #: [N, N·m], (9, m)
