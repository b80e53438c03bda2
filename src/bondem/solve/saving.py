"""What a solver asks of whoever keeps its results; it knows no file format."""

from typing import Protocol

from bondem.model.state import State
from bondem.solve.history import History


class Sink(Protocol):
    """Takes snapshots."""

    def checkpoint(self, state: State, history: History) -> None:
        """Keep all that is needed to go on from here."""
        ...

    def snapshot(self, state: State) -> None:
        """Keep what is shown of a state."""
        ...
