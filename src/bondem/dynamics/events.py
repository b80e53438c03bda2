"""Events that end a run early."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._checks import number
from bondem.model.state import State


class Event(ABC):
    """A condition that ends a run when it occurs.

    The run evaluates the condition at each record. Subclasses define `happened`.
    """

    @abstractmethod
    def happened(self, state: State) -> bool:
        """Return True to end the run now."""


@dataclass(frozen=True)
class AtRest(Event):
    """An event that occurs when all elements are slower than `speed`.

    Attributes:
        speed: limit of the speed [m/s].
        after: earliest time of the event [s], so that a run from rest can start.
    """

    speed: float
    after: float = 0.0

    def __post_init__(self) -> None:
        number("AtRest", "speed", self.speed, unit="m/s", above=0.0, advice="a positive speed")
        number("AtRest", "after", self.after, unit="s", advice="a finite time")

    def happened(self, state: State) -> bool:
        fastest = np.sqrt((state.motion[:, :3] ** 2).sum(axis=1).max())
        return state.time >= self.after and bool(fastest < self.speed)
