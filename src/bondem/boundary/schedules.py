"""Schedules: values over time. Every schedule is piecewise linear, so that the core needs only one kind."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bondem._checks import array, instance, number, shown
from bondem._types import ArrayLike, Floats
from bondem.errors import InputError


class Schedule(ABC):
    """A quantity over time. The time is that of the state, which continues from run to run."""

    @property
    @abstractmethod
    def table(self) -> tuple[Floats, Floats]:
        """Times [s] and values, both (k,): linear in between, constant beyond, the later value at a jump."""

    @property
    def final(self) -> float:
        """Final value, which static solutions use."""
        return float(self.table[1][-1])

    def at(self, time: float) -> float:
        """Return the value at a time [s]."""
        times, values = self.table
        k = int(np.searchsorted(times, time, side="right"))
        if k in (0, len(times)):
            return float(values[max(k - 1, 0)])
        share = (time - times[k - 1]) / (times[k] - times[k - 1])
        return float(values[k - 1] + (values[k] - values[k - 1]) * share)


@dataclass(frozen=True)
class Constant(Schedule):
    """A value that is the same at all times.

    Attributes:
        value: the value; a value that is not finite raises InputError.
    """

    value: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "value", number("Constant", "value", self.value))

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.zeros(1), np.array([self.value])


@dataclass(frozen=True)
class Ramp(Schedule):
    """A linear change from `start` to `end` over `duration`, beginning at `begin`.

    Attributes:
        start, end: values before and after.
        duration: duration of the change [s]; a value that is not positive raises InputError.
        begin: time at which the change begins [s].
    """

    start: float
    end: float
    duration: float
    begin: float = 0.0

    def __post_init__(self) -> None:
        for name in ("start", "end"):
            object.__setattr__(self, name, number("Ramp", name, getattr(self, name)))
        begin = number("Ramp", "begin", self.begin, unit="s", advice="a finite time")
        duration = number("Ramp", "duration", self.duration, unit="s", above=0.0, advice="a positive time")
        if not begin + duration > begin:
            raise InputError(f"Ramp: duration = {duration} s is lost against begin = {begin} s; give a longer one")
        object.__setattr__(self, "begin", begin)
        object.__setattr__(self, "duration", duration)

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.array([self.begin, self.begin + self.duration]), np.array([self.start, self.end])


@dataclass(frozen=True)
class Table(Schedule):
    """A piecewise linear function of time; two equal times define a jump, of loads or velocities in explicit runs.

    Attributes:
        times: times in non-decreasing order [s], (k,); other lists raise InputError.
        values: values at these times, (k,).
    """

    times: tuple[float, ...]
    values: tuple[float, ...]

    def __init__(self, times: ArrayLike, values: ArrayLike) -> None:
        t = array("Table", "times", times, wanted="times [s], shape (k,)")
        v = array("Table", "values", values, wanted="values, shape (k,)")
        if t.shape != v.shape or t.ndim != 1 or len(t) == 0:
            raise InputError("Table: times and values differ in number or are empty; give as many values as times")
        if not (np.isfinite(t).all() and np.isfinite(v).all()) or (np.diff(t) < 0.0).any():
            raise InputError("Table: times must be finite and not decrease, values must be finite")
        for name, found in (("times", t), ("values", v)):
            number("Table", name, np.abs(found).max())
            object.__setattr__(self, name, tuple(found.tolist()))

    @property
    def table(self) -> tuple[Floats, Floats]:
        return np.array(self.times), np.array(self.values)


def joined_tables(schedules: Sequence[Schedule]) -> dict[str, np.ndarray]:
    """Return `times` [s] and `values` of schedules one after the other; those of schedule k begin at `start`[k]."""
    tables = [schedule.table for schedule in schedules]
    return {
        "start": np.cumsum([0, *(len(times) for times, _ in tables)]).astype(np.int64),
        "times": np.concatenate([np.zeros(0), *(times for times, _ in tables)]),
        "values": np.concatenate([np.zeros(0), *(values for _, values in tables)]),
    }


def as_schedule(owner: str, name: str, value: "float | Schedule") -> Schedule:
    """Return a schedule unchanged, or a number as a constant schedule.

    Raises:
        InputError: The value is neither a schedule nor a finite number.
    """
    if isinstance(value, Schedule):
        return value
    if isinstance(value, str) or not np.isscalar(value):
        instance(owner, name, value, Schedule, "a number, or a schedule such as bd.Ramp(0, 1, duration)")
    return Constant(number(owner, name, value))


def refuse_schedule(owner: str, name: str, value: object) -> None:
    """Raise InputError if the size of a load is a schedule, or contains one."""
    if any(isinstance(one, Schedule) for one in (value if isinstance(value, list | tuple) else (value,))):
        raise InputError(
            f"{owner}: {name} = {shown(value)} changes in time; give numbers, and their factor over time as"
            " schedule=bd.Table(times, factors)"
        )
