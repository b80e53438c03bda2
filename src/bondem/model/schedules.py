"""Schedules: how much over time. Every schedule is piecewise linear, so that kernels need only one."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError


class Schedule(ABC):
    """A quantity over time."""

    @property
    @abstractmethod
    def table(self) -> tuple[Floats, Floats]:
        """Times [s] and values, both (k,): linear in between, constant beyond, the later value at a jump."""

    @property
    def final(self) -> float:
        """The value it ends at; static solutions use it."""
        return float(self.table[1][-1])


@dataclass(frozen=True)
class Constant(Schedule):
    """The same value at all times."""

    value: float

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.zeros(1), np.array([self.value], dtype=float)


@dataclass(frozen=True)
class Ramp(Schedule):
    """From `start` to `end`, linearly over `duration`, beginning at `begin`.

    Attributes:
        start, end: values before and after.
        duration: time it takes [s].
        begin: when it starts [s].
    """

    start: float
    end: float
    duration: float
    begin: float = 0.0

    def __post_init__(self) -> None:
        if not self.duration > 0.0:
            raise InputError(f"Ramp: duration = {self.duration} s; give a positive time")

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.array([self.begin, self.begin + self.duration]), np.array([self.start, self.end], dtype=float)


@dataclass(frozen=True)
class Table(Schedule):
    """Given times and values; a time given twice is a jump.

    Attributes:
        times: not decreasing [s], (k,).
        values: (k,).
    """

    times: tuple[float, ...]
    values: tuple[float, ...]

    def __post_init__(self) -> None:
        times, values = np.asarray(self.times, dtype=float), np.asarray(self.values, dtype=float)
        if times.shape != values.shape or times.ndim != 1 or len(times) == 0:
            raise InputError("Table: give as many values as times, at least one")
        if (np.diff(times) < 0.0).any() or not (np.isfinite(times).all() and np.isfinite(values).all()):
            raise InputError("Table: times must be finite and not decrease, values must be finite")
        object.__setattr__(self, "times", tuple(times.tolist()))
        object.__setattr__(self, "values", tuple(values.tolist()))

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.array(self.times), np.array(self.values)


def as_schedule(value: "float | Schedule") -> Schedule:
    """A number as a constant schedule; a schedule as it is."""
    return value if isinstance(value, Schedule) else Constant(float(value))
