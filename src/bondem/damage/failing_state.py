"""Interfaces of the state and of the tables of a run that failure uses."""

from typing import Protocol

from bondem._tables.step_tables import Ledger, Moving, Rows, StepBlocks
from bondem._types import Floats, PerBond


class FailingState(Protocol):
    """Interface of the arrays of a `bd.State` that failure reads and writes."""

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
    """Interface of the tables of a run that all parts of a step share."""

    @property
    def moving(self) -> Moving: ...
    @property
    def rows(self) -> Rows: ...
    @property
    def blocks(self) -> StepBlocks: ...
    @property
    def ledger(self) -> Ledger: ...
