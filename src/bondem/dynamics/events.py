"""Events that end a run early."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bondem._checks import instance, number, vector
from bondem._types import Floats
from bondem.dynamics.history import History
from bondem.model.state import State


class Event(ABC):
    """A condition that ends a run when it occurs.

    The run evaluates the condition at each record. Subclasses define `happened`. A condition that depends on the past
    reads it from the records, so that a resumed run ends where an uninterrupted one does.
    """

    @abstractmethod
    def happened(self, state: State, history: History) -> bool:
        """Return True to end the run now; `history` has all records so far."""


@dataclass(frozen=True)
class AtRest(Event):
    """An event that occurs when all elements are slower than `speed`; invalid values raise InputError.

    Attributes:
        speed: limit of the speed [m/s], positive.
        after: earliest time of the event [s], so that a run from rest can start.
    """

    speed: float
    after: float = 0.0

    def __post_init__(self) -> None:
        number("AtRest", "speed", self.speed, unit="m/s", above=0.0, advice="a positive speed")
        number("AtRest", "after", self.after, unit="s", advice="a finite time")

    def happened(self, state: State, history: History) -> bool:
        fastest = np.sqrt((state.motion[:, :3] ** 2).sum(axis=1).max())
        return state.time >= self.after and bool(fastest < self.speed)


@dataclass(frozen=True)
class LoadDrop(Event):
    """An event that occurs when a load drops below a share of its largest so far; invalid values raise InputError.

    Attributes:
        load: factors of the three components of gauges, by the name of the gauge [-]; the load is their weighted sum.
            {"end": (1.0, 0.0, 0.0)} is the component along x of the gauge "end".
        share: share of the largest load so far below which the event occurs [-], in [0, 1).
        least: load that the largest load so far must have exceeded [N], zero or more.
    """

    load: Mapping[str, tuple[float, float, float]]
    share: float
    least: float = 0.0

    def __post_init__(self) -> None:
        wanted = 'factors of gauges by name, such as {"end": (1.0, 0.0, 0.0)}'
        load = instance("LoadDrop", "load", self.load, Mapping, wanted)
        for name, factors in load.items():
            instance("LoadDrop: load", "a name", name, str, "the name of a gauge, as text")
            vector("LoadDrop: load", name, factors, advice="three finite factors")
        number("LoadDrop", "share", self.share, least=0.0, below=1.0)
        number("LoadDrop", "least", self.least, least=0.0, unit="N")

    def value(self, history: History) -> Floats:
        """Return the load in each record [N], (s,); an unknown gauge raises InputError."""
        return np.sum([history[name] @ np.array(factors) for name, factors in self.load.items()], axis=0)

    def happened(self, state: State, history: History) -> bool:
        load = self.value(history)
        peak = float(load.max(initial=0.0))
        return peak > self.least and float(load[-1]) < self.share * peak


@dataclass(frozen=True)
class ContactEnd(Event):
    """An event that occurs when a touched wall has had no contact for some time; invalid values raise InputError.

    Attributes:
        gauge: name of the gauge of the force of the elements on the wall.
        direction: direction of pressure on the wall, into it, (3,).
        quiet: time without contact [s], positive.
    """

    gauge: str
    direction: tuple[float, float, float]
    quiet: float

    def __post_init__(self) -> None:
        instance("ContactEnd", "gauge", self.gauge, str, "the name of a gauge, as text")
        vector("ContactEnd", "direction", self.direction)
        number("ContactEnd", "quiet", self.quiet, above=0.0, unit="s")

    def happened(self, state: State, history: History) -> bool:
        pressed = np.flatnonzero(history[self.gauge] @ np.array(self.direction) > 0.0)
        return len(pressed) > 0 and state.time - float(history.time[pressed[-1]]) > self.quiet
