"""Events: when to stop a run before its end."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._checks import number
from bondem.model.state import State


class Event(ABC):
    """A condition looked at whenever a record is written."""

    @abstractmethod
    def happened(self, state: State) -> bool:
        """Whether to stop now."""


@dataclass(frozen=True)
class AtRest(Event):
    """All elements are slower than `speed`.

    Attributes:
        speed: [m/s].
        after: not before this time [s], so that a run that starts from rest gets going.
    """

    speed: float
    after: float = 0.0

    def __post_init__(self) -> None:
        number("AtRest", "speed", self.speed, unit="m/s", above=0.0, advice="a positive speed")
        number("AtRest", "after", self.after, unit="s", advice="a finite time")

    def happened(self, state: State) -> bool:
        fastest = np.sqrt((state.motion[:, :3] ** 2).sum(axis=1).max())
        return state.time >= self.after and bool(fastest < self.speed)
