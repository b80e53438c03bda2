"""Interface between a solver and the storage of its results, independent of file formats."""

from typing import Protocol

from bondem.dynamics.history import History
from bondem.model.state import State


class Sink(Protocol):
    """A receiver of checkpoints and snapshots."""

    def checkpoint(self, state: State, history: History) -> None:
        """Store all that is needed to continue from here."""
        ...

    def snapshot(self, state: State) -> None:
        """Store the visible part of a state."""
        ...
