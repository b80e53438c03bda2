"""Tolerances: when a number agrees with what it is held against."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

from book.errors import BookError
from book.forms import Form, Said

#: A number that is written down as exactly at a limit is within it.
_ROUNDING = 1.0 + 1e-9


class Tolerance(ABC):
    """A condition on a measured number, and the number of a paper if it refers to one."""

    @abstractmethod
    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        """Whether the condition is met by all values."""

    @abstractmethod
    def words(self, form: Form | Said) -> str:
        """The condition as it stands in a table."""

    def used(self, values: Sequence[float], paper: float | None) -> float | None:
        """The share of the tolerance that the worst value uses, 1 at the limit; None where a share has no meaning."""
        del values, paper
        return None


@final
@dataclass(frozen=True, kw_only=True)
class Near(Tolerance):
    """Not farther from the paper's number, or from `target`, than a share of it or an amount."""

    relative: float | None = None
    absolute: float | None = None
    target: float | None = None

    def __post_init__(self) -> None:
        if (self.relative is None) is (self.absolute is None):
            raise BookError("Near: give relative= or absolute=, one of them")

    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        about = _given(self.target, paper)
        room = self.absolute if self.absolute is not None else (self.relative or 0.0) * abs(about)
        return all(abs(value - about) <= room * _ROUNDING for value in values)

    def used(self, values: Sequence[float], paper: float | None) -> float | None:
        about = _given(self.target, paper)
        room = self.absolute if self.absolute is not None else (self.relative or 0.0) * abs(about)
        return max(abs(value - about) for value in values) / room if room else None

    def words(self, form: Form | Said) -> str:
        about = "" if self.target is None else f"{form.bare(self.target)} "
        if self.absolute is not None:
            return f"{about}± {form.text(self.absolute, signed=False)}"
        return f"{about}± {100.0 * (self.relative or 0.0):g} %"


@final
@dataclass(frozen=True)
class AtMost(Tolerance):
    """Size not above a limit, the paper's number unless given."""

    limit: float | None = None

    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        return max(map(abs, values)) <= abs(_given(self.limit, paper)) * _ROUNDING

    def used(self, values: Sequence[float], paper: float | None) -> float | None:
        limit = abs(_given(self.limit, paper))
        return max(map(abs, values)) / limit if limit else None

    def words(self, form: Form | Said) -> str:
        return "≤ published" if self.limit is None else f"≤ {form.text(self.limit, signed=False)}"


@final
@dataclass(frozen=True)
class AtLeast(Tolerance):
    """Not below a limit, the paper's number unless given."""

    limit: float | None = None

    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        return min(values) * _ROUNDING >= _given(self.limit, paper)

    def used(self, values: Sequence[float], paper: float | None) -> float | None:
        return _given(self.limit, paper) / min(values) if min(values) > 0.0 else None

    def words(self, form: Form | Said) -> str:
        return "≥ published" if self.limit is None else f"≥ {form.text(self.limit, signed=False)}"


@final
@dataclass(frozen=True)
class Between(Tolerance):
    """From one number to another."""

    low: float
    high: float

    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        del paper
        return all(self.low <= value <= self.high for value in values)

    def used(self, values: Sequence[float], paper: float | None) -> float | None:
        del paper
        middle, room = (self.low + self.high) / 2.0, (self.high - self.low) / 2.0
        return max(abs(value - middle) for value in values) / room

    def words(self, form: Form | Said) -> str:
        return f"{form.bare(self.low)}–{form.text(self.high)}"


@final
@dataclass(frozen=True)
class So(Tolerance):
    """What is asked for is so; with False, is not."""

    wanted: bool = True

    def holds(self, values: Sequence[float], paper: float | None) -> bool:
        del paper
        return all(bool(value) is self.wanted for value in values)

    def words(self, form: Form | Said) -> str:
        return form.text(float(self.wanted))


def _given(limit: float | None, paper: float | None) -> float:
    if limit is not None:
        return limit
    if paper is None:
        raise BookError("a tolerance refers to the paper's number and the row has none; give the limit")
    return paper
