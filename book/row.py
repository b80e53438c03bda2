"""A row of the book: one case, what is printed, what we have, and a verdict that is computed from them."""

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import KW_ONLY, dataclass
from enum import Enum

from book.errors import BookError
from book.forms import PLAIN, Form, Said
from book.tolerances import Tolerance


class Verdict(Enum):
    """What a row comes to."""

    MET = "met"
    BY_MEAN = "met by the mean"
    MISSED = "missed"
    EXPLAINED = "missed, explained"

    @property
    def is_miss(self) -> bool:
        """Whether the number is outside: a reason explains a miss and does not undo it."""
        return self in (Verdict.MISSED, Verdict.EXPLAINED)


@dataclass(frozen=True)
class Origin:
    """How a number was come by.

    Attributes:
        command: that measures it.
        kept: the file that holds it, from the root of the project.
        takes: how long, in words.
    """

    command: str
    kept: str
    takes: str = ""


@dataclass(frozen=True)
class Measured:
    """A number that was measured.

    Attributes:
        values: one, or several of one kind, which all have to satisfy the tolerance.
        scatter: standard deviation over packings or runs, if it is known.
        origin: how it was come by.
    """

    values: tuple[float, ...]
    origin: Origin
    scatter: float | None = None

    def __post_init__(self) -> None:
        if not self.values or not all(math.isfinite(value) for value in self.values):
            where = f"{self.values} of {self.origin.kept}"
            raise BookError(f"{where}: not finite numbers; measure again: {self.origin.command}")

    def text(self, form: Form | Said) -> str:
        """Mean ± scatter, or from the least to the largest."""
        texts = list(dict.fromkeys(form.bare(value) for value in (min(self.values), max(self.values))))
        if len(texts) > 1:
            between = " … " if any(sign in "".join(texts) for sign in "+−e") else "–"
            return f"{texts[0]}{between}{form.text(max(self.values))}"
        if self.scatter is None:
            return form.text(self.values[0])
        return f"{texts[0]} ± {form.text(self.scatter, signed=False)}"


@dataclass(frozen=True)
class Row:
    """One case.

    Attributes:
        case: quantity that is compared.
        ours: number computed by bondem.
        tolerance: condition of agreement, or requirement. A number without one is no row.
        form: format of the numbers.
        source: table, figure or equation of the published number.
        paper: published number, or words where it is none.
        printed: published number as the paper prints it, where `form` would add digits.
        reason: cause of a miss of a published number. A requirement of our own has none.
        note: further remark.
    """

    case: str
    ours: Measured
    tolerance: Tolerance
    form: Form | Said = PLAIN
    _: KW_ONLY
    source: str = ""
    paper: float | str | None = None
    printed: str = ""
    reason: str = ""
    note: str = ""

    def __post_init__(self) -> None:
        if self.reason and self.paper is None:
            raise BookError(f"'{self.case}': a reason is for a difference from a paper; say it as a note")

    @property
    def verdict(self) -> Verdict:
        """Computed from the numbers."""
        if not self.tolerance.holds(self.ours.values, self._published):
            return Verdict.EXPLAINED if self.reason else Verdict.MISSED
        spread = self.ours.scatter or 0.0
        ends = [value + way * spread for value in self.ours.values for way in (-1.0, 1.0)]
        return Verdict.MET if not spread or self.tolerance.holds(ends, self._published) else Verdict.BY_MEAN

    @property
    def _published(self) -> float | None:
        return self.paper if isinstance(self.paper, float | int) else None

    @property
    def used(self) -> float | None:
        """The share of the tolerance that the number uses, 1 at the limit; None where a share has no meaning."""
        return self.tolerance.used(self.ours.values, self._published)

    @property
    def remarks(self) -> list[str]:
        """The reason, where the row is missed, and the note."""
        return [self.reason] * (self.verdict is Verdict.EXPLAINED) + [self.note] * bool(self.note)

    @property
    def paper_text(self) -> str:
        """The paper's number in words; "" if there is none."""
        if self.printed or self.paper is None:
            return self.printed
        return self.paper if isinstance(self.paper, str) else self.form.text(self.paper, signed=self.paper < 0.0)


#: Rows of a section, in their order.
Rows = Iterable[Row]


def tally(rows: Rows) -> Counter[Verdict]:
    """How many rows come to each verdict."""
    return Counter(row.verdict for row in rows)
