"""Measured numbers beside what they should be, and verdicts computed from tolerances that are in the code."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

MET, MISSED, STATED = "met", "missed", "stated"


@dataclass(frozen=True)
class Row:
    """One measured number of one specimen.

    Attributes:
        case: of the battery, of `CASES`.
        name: what was measured; rows of one name are judged together.
        measured, expected: in the same unit.
        tolerance: largest distance from what is expected, as a share of it, or in its unit where nothing is expected;
            None where the number is stated, and not judged.
        seed, count: of the packing, set by the battery.
        mean: whether the mean of all rows of the name is judged, and not each of them.
        note: what else is to be known of the run.
    """

    case: str
    name: str
    measured: float
    expected: float
    tolerance: float | None
    seed: int = 0
    count: int = 0
    mean: bool = False
    note: str = ""

    @property
    def ratio(self) -> float:
        """Measured over expected [-], or measured where nothing is expected; inf where nothing could be measured."""
        return self.measured / (self.expected or 1.0) if math.isfinite(self.measured) else math.inf

    @property
    def error(self) -> float:
        """How far the ratio is from what it should be."""
        return self.ratio - (1.0 if self.expected else 0.0)

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
        mean: of measured over expected [-], of measured where nothing is expected; None where one was not measured.
        worst: the one of them that is furthest from what it should be.
        tolerance: that was stated [-].
        on: "mean" or "each".
        verdict: "met" or "missed", or "stated" where nothing is judged.
    """

    case: str
    name: str
    rows: int
    mean: float | None
    worst: float | None
    tolerance: float | None
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
    errors, ratios = [row.error for row in rows], [row.ratio for row in rows]
    worst = max(range(len(rows)), key=lambda k: abs(errors[k]))
    judged = sum(errors) / len(errors) if first.mean else errors[worst]
    kept = MET if first.tolerance is not None and abs(judged) <= first.tolerance else MISSED
    return Verdict(
        case=case, name=name, rows=len(rows), mean=_finite(sum(ratios) / len(ratios)), worst=_finite(ratios[worst]),
        tolerance=first.tolerance, on="mean" if first.mean else "each",
        verdict=STATED if first.tolerance is None else kept,
    )  # fmt: skip


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def table(found: Sequence[Verdict], rows: Sequence[Row], before: Sequence[Verdict] = ()) -> str:
    """Verdicts as a Markdown table, with the packings and numbers of cells of each case below it.

    Args:
        found: verdicts.
        rows: they come from.
        before: those of another record, which is shown beside them.
    """
    earlier = {(one.case, one.name): one for one in before}
    beside = ["rows before", "mean before", "furthest before"] if earlier else []
    titles = ["case", "quantity", "rows", "mean", "furthest", *beside, "tolerance", "on", "verdict"]
    lines = [_line(titles), "|---" * len(titles) + "|"]
    for one in found:
        told = [one.case, one.name, str(one.rows), _number(one.mean), _number(one.worst)]
        if earlier:
            then = earlier.get((one.case, one.name))
            told += ["–"] * 3 if then is None else [str(then.rows), _number(then.mean), _number(then.worst)]
        limit = "–" if one.tolerance is None else f"{100 * one.tolerance:g} %"
        lines.append(_line([*told, limit, one.on, one.verdict]))
    judged = [one for one in found if one.verdict != STATED]
    met = sum(one.verdict == MET for one in judged)
    lines += [
        "",
        f"{met} of {len(judged)} quantities met. Numbers are measured over expected; where nothing is expected, "
        "measured, with a tolerance in the same unit.",
        "",
    ]
    for case in dict.fromkeys(row.case for row in rows):
        own = [row for row in rows if row.case == case]
        seeds, counts = ({getattr(row, name) for row in own} for name in ("seed", "count"))
        lines.append(f"- {case}: packings {_listed(seeds)}; {_listed(counts)} cells")
    now = {(one.case, one.name) for one in found}
    gone = [f"{one.case}: {one.name}" for one in before if (one.case, one.name) not in now]
    if gone:
        lines.append(f"- only in the record before, not measured again: {'; '.join(gone)}")
    return "\n".join(lines) + "\n"


def _line(words: Sequence[str]) -> str:
    return "| " + " | ".join(words) + " |"


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.3f}"


def _listed(values: set[int]) -> str:
    return ", ".join(str(value) for value in sorted(values))
