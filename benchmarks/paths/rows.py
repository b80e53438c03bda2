"""Measured numbers beside what they should be, and verdicts computed from tolerances that are in the code."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

MET, MISSED = "met", "missed"


@dataclass(frozen=True)
class Row:
    """One measured number of one specimen.

    Attributes:
        case: of the battery, of `CASES`.
        name: what was measured; rows of one name are judged together.
        measured, expected: in the same unit.
        tolerance: largest distance from what is expected, as a share of it [-].
        seed, count: of the packing.
        mean: whether the mean of all rows of the name is judged, and not each of them.
        note: what else is to be known of the run.
    """

    case: str
    name: str
    measured: float
    expected: float
    tolerance: float
    seed: int
    count: int
    mean: bool = False
    note: str = ""

    @property
    def error(self) -> float:
        """Measured over expected, less 1 [-]; inf where nothing could be measured."""
        return self.measured / self.expected - 1.0 if math.isfinite(self.measured) else math.inf

    def as_json(self) -> dict[str, Any]:
        """All of it, with null for what could not be measured."""
        found = asdict(self)
        return found | {"measured": self.measured if math.isfinite(self.measured) else None}

    @classmethod
    def from_json(cls, found: dict[str, Any]) -> "Row":
        """The row of a result file."""
        given = math.nan if found["measured"] is None else found["measured"]
        values: dict[str, Any] = found | {"measured": given}
        return cls(**values)


#: A case: packing and number of cells in, rows out.
CaseFunction = Callable[[int, int], list[Row]]


@dataclass(frozen=True)
class Verdict:
    """What the rows of one name come to.

    Attributes:
        case, name: of the rows.
        rows: number of them.
        mean: of measured over expected [-].
        worst: the ratio that is furthest from 1 [-].
        tolerance: that was stated [-].
        on: "mean" or "each".
        verdict: "met" or "missed".
    """

    case: str
    name: str
    rows: int
    mean: float
    worst: float
    tolerance: float
    on: str
    verdict: str


def verdicts(rows: Iterable[Row]) -> list[Verdict]:
    """A verdict for each name, in the order of the rows: a tolerance is on each row, or on the mean of all."""
    groups: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        groups.setdefault((row.case, row.name), []).append(row)
    return [_verdict(case, name, found) for (case, name), found in groups.items()]


def _verdict(case: str, name: str, rows: Sequence[Row]) -> Verdict:
    first = rows[0]
    if any((row.tolerance, row.mean) != (first.tolerance, first.mean) for row in rows):
        raise ValueError(f"{case}, {name}: rows of one name must have one tolerance")
    errors = [row.error for row in rows]
    mean, worst = sum(errors) / len(errors), max(errors, key=abs)
    judged = mean if first.mean else worst
    return Verdict(
        case=case, name=name, rows=len(rows), mean=1.0 + mean, worst=1.0 + worst, tolerance=first.tolerance,
        on="mean" if first.mean else "each", verdict=MET if abs(judged) <= first.tolerance else MISSED,
    )  # fmt: skip


def table(found: Sequence[Verdict], rows: Sequence[Row]) -> str:
    """Verdicts as a Markdown table, with the packings and numbers of cells of each case below it."""
    lines = ["| case | quantity | rows | mean | furthest | tolerance | on | verdict |", "|---" * 8 + "|"]
    for one in found:
        lines.append(
            f"| {one.case} | {one.name} | {one.rows} | {one.mean:.3f} | {one.worst:.3f} | {100 * one.tolerance:g} % |"
            f" {one.on} | {one.verdict} |"
        )
    met = sum(one.verdict == MET for one in found)
    lines += ["", f"{met} of {len(found)} quantities met; all ratios are measured over expected.", ""]
    for case in dict.fromkeys(row.case for row in rows):
        own = [row for row in rows if row.case == case]
        seeds, counts = ({getattr(row, name) for row in own} for name in ("seed", "count"))
        lines.append(f"- {case}: packings {_listed(seeds)}; {_listed(counts)} cells")
    return "\n".join(lines) + "\n"


def _listed(values: set[int]) -> str:
    return ", ".join(str(value) for value in sorted(values))
