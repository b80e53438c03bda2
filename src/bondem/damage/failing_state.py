"""Arrays of a state and tables of a run, as failure needs them."""

from typing import Protocol

from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks
from bondem._types import Floats, PerBond


class FailingState(Protocol):
    """Arrays of a `bd.State` that failure reads and writes."""

    pose: Floats
    motion: Floats
    integrity: PerBond
    broken: Floats
    released: Floats
    crushed: Floats
    cracks: Floats
    plastic: Floats
    held_slip: Floats
    softened: Floats
    facet_force: Floats


class StepTables(Protocol):
    """Tables of a run that all parts of a step share."""

    @property
    def moving(self) -> Moving: ...
    @property
    def rows(self) -> Rows: ...
    @property
    def blocks(self) -> StepBlocks: ...
    @property
    def ledger(self) -> Ledger: ...
