"""The rule of the pages: which rows share a line.

Rows of one section that are met for the same published value, tolerance, form, source and command share a line, which
states their range. A miss has a line of its own. A number that is compared with nothing is no row: it stays in
`benchmarks/results`, and in figures.
"""

import re
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass

from book.row import Measured, Row, Verdict

#: More different words than these are abbreviated to the first and the last.
_FEW = 3
_SEPARATOR = re.compile(r"[,:;] (?!\d+(?:[,:;]|$))")


@dataclass(frozen=True)
class Line:
    """A line of a table: one row, or several of one kind that are all met."""

    rows: tuple[Row, ...]

    @property
    def first(self) -> Row:
        """The row whose source, published value, tolerance and command are those of the line."""
        return self.rows[0]

    @property
    def verdict(self) -> Verdict:
        """The verdict, which all rows of the line share."""
        return self.first.verdict

    @property
    def case(self) -> str:
        """The case, or what the cases have in common and how many they are."""
        cases = list(dict.fromkeys(row.case for row in self.rows))
        return cases[0] if len(cases) == 1 else f"{_together(cases)} ({len(self.rows)} cases)"

    @property
    def ours(self) -> str:
        """The number, or the range of all numbers and the largest standard deviation among them."""
        form = self.first.form
        if len(self.rows) == 1:
            return self.first.ours.text(form)
        values = tuple(value for row in self.rows for value in row.ours.values)
        text = Measured(values, self.first.ours.origin).text(form)
        scatter = max((row.ours.scatter or 0.0 for row in self.rows), default=0.0)
        return f"{text} (each ± {form.text(scatter, signed=False)} or less)" if scatter else text

    @property
    def remarks(self) -> list[str]:
        """The remarks of all rows, each once."""
        return list(dict.fromkeys(remark for row in self.rows for remark in row.remarks))


def shown(rows: Iterable[Row]) -> list[Line]:
    """The lines that a page prints of the rows of a section, in their order."""
    lines: list[list[Row]] = []
    for row in rows:
        alike = None if row.verdict.is_miss else next((line for line in lines if _alike(line[0], row)), None)
        if alike is None:
            lines.append([row])
        else:
            alike.append(row)
    return [Line(tuple(line)) for line in lines]


def _alike(one: Row, other: Row) -> bool:
    """Whether two rows share a line: one requirement, and cases that end alike, or begin and are built alike."""
    mine, others = _clauses(one.case), _clauses(other.case)
    alike = mine[-1] == others[-1] or (mine[0] == others[0] and mine[1::2] == others[1::2])
    return _kind(one) == _kind(other) and alike


def _kind(row: Row) -> Hashable:
    return row.verdict, row.tolerance, row.form, row.source, row.paper, row.printed, row.ours.origin


def _clauses(case: str) -> list[str]:
    """Clauses of a case and the separators between them; a list of seeds and what is in parentheses are whole."""
    parts, start = [], 0
    for found in _SEPARATOR.finditer(case):
        if case.count("(", 0, found.start()) == case.count(")", 0, found.start()):
            parts += [case[start : found.start()], found[0]]
            start = found.end()
    return [*parts, case[start:]]


def _together(cases: Sequence[str]) -> str:
    """The clauses of several cases: those in common, and of the others the first to the last."""
    parts = [_clauses(case) for case in cases]
    if len({tuple(part[1::2]) for part in parts}) == 1:
        return "".join(_several(clauses) for clauses in zip(*parts, strict=True))
    head = _common(parts)
    tail = _common([part[len(head) :][::-1] for part in parts])[::-1]
    middle = _several([part[len(head)] for part in parts if len(part) > len(head) + len(tail)])
    rest = "".join(tail)
    return f"{''.join(head)}{middle}, …{rest if rest[:1] in ',:;' else ' ' + rest}".rstrip()


def _common(parts: Sequence[Sequence[str]]) -> list[str]:
    """Clauses, each with the separator behind it, with which all cases begin."""
    found = []
    for same in zip(*parts, strict=False):
        if len(set(same)) > 1:
            break
        found.append(same[0])
    return found[: len(found) // 2 * 2]


def _several(clauses: Sequence[str]) -> str:
    """Different clauses of one place: all if they are few, else the first and the last; common words once."""
    texts = list(dict.fromkeys(clauses))
    words = [text.split(" ") for text in texts]
    shortest = min(len(one) for one in words) - 1
    head = _same(words, shortest)
    tail = _same([one[::-1] for one in words], shortest - head)
    ends = len(texts) - 1 if len(texts) <= _FEW else 1
    kept = range(len(texts)) if len(texts) <= _FEW else (0, len(texts) - 1)
    shorter = [
        " ".join(words[k][head if n else 0 : len(words[k]) - (tail if n < ends else 0)])
        for n, k in enumerate(kept)
    ]  # fmt: skip
    return (" / " if len(texts) <= _FEW else " … ").join(shorter)


def _same(words: Sequence[Sequence[str]], most: int) -> int:
    """How many words without digits all begin with."""
    for k in range(most):
        if len({one[k] for one in words}) > 1 or any(letter.isdecimal() for letter in words[0][k]):
            return k
    return max(most, 0)
