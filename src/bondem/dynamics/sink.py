"""Interface between a solver and the storage of its results, independent of file formats."""

from typing import Protocol

from bondem.dynamics.history import History
from bondem.model.state import State


class Sink(Protocol):
    """A receiver of checkpoints and snapshots."""

    def checkpoint(self, state: State, history: History) -> None:
        """Store the complete state and the records, from which a restart continues."""
        ...

    def snapshot(self, state: State) -> None:
        """Store the fields of a state that pictures show."""
        ...
