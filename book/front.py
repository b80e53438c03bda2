"""The first page: what is claimed, how it was measured, what failed."""

import re
from collections.abc import Sequence
from pathlib import Path

from book.chapter import Chapter, Section
from book.errors import BookError
from book.markdown import GENERATED, address, counts, mark, notes, required, sentence
from book.questions import by_question
from book.quoting import rendered
from book.row import Row, Verdict, tally
from book.shown import shown

_TEXT = Path(__file__).parent / "front.md"


def front(chapters: Sequence[Chapter], older: str = "") -> str:
    """`docs/validation.md`: the text with its claims.

    Args:
        chapters: all chapters.
        older: the results that are older than a change of the code, as an item of a list; "" where there are none.
    """
    known, held = {chapter.name: chapter for chapter in chapters}, []

    def claim(name: str, place: str, says: str, measured: str) -> str:
        """A claim that a referee would check first, and its result; "" where the chapter is not there."""
        if name not in known:
            return ""
        section, rows = _deciding(known[name], place)
        held.append(not any(row.verdict.is_miss for row in rows))
        (row, *others) = rows
        why = f"\n  {sentence(row.reason)}" if row.verdict is Verdict.EXPLAINED and not others else ""
        result = f"{_result(rows)} ([{section.title}]({address(known[name], section)}))"
        verdict = "Held" if held[-1] else "**Missed**"
        return f"- {verdict}: {says}.\n  Measured: {measured}.\n  Result: {result}.{why}"

    def verdicts() -> str:
        return f"Of {len(held)} claims, {sum(held)} hold and {len(held) - sum(held)} fail in part or fully."

    names = {
        "claim": claim, "verdicts": verdicts, "older": older, "chapters": chapters, "missed": missed, "notes": notes,
        "reference": _reference, "line": _line, "miss": _miss, "remarks": _remarks,
        "ordered": [chapter for some in by_question(chapters).values() for chapter in some],
        "rows": [row for chapter in chapters for row in chapter.rows],
        "printed": sum(len(shown(section.rows)) for chapter in chapters for section in chapter.sections),
    }  # fmt: skip
    return re.sub("\n\n\n+", "\n\n", f"{GENERATED}{rendered(_TEXT, names)}").rstrip() + "\n"


def _deciding(chapter: Chapter, place: str) -> tuple[Section, Sequence[Row]]:
    """The section of a title and its rows, or the row of a case.

    Raises:
        BookError: no section and no case of this name, or more than one.
    """
    found: list[tuple[Section, Sequence[Row]]] = [(one, one.rows) for one in chapter.sections if one.title == place]
    found += [(one, (row,)) for one in chapter.sections for row in one.rows if row.case == place]
    if len(found) != 1:
        raise BookError(f"{len(found)} times '{place}' in '{chapter.name}', not once")
    return found[0]


def missed(chapter: Chapter) -> list[tuple[Section, Row]]:
    """The missed rows of a chapter, each with its section."""
    return [(section, row) for section in chapter.sections for row in section.rows if row.verdict.is_miss]


def _result(rows: Sequence[Row]) -> str:
    if len(rows) > 1:
        return counts(rows)
    (row,) = rows
    asked = required(row)
    published = f", published {row.paper_text}" if row.paper_text else ""
    return f"{row.ours.text(row.form)}{published}, required {asked}: {row.verdict.value}"


def _line(title: str, rows: Sequence[Row]) -> str:
    found = tally(rows)
    number = sum(many for verdict, many in found.items() if verdict.is_miss)
    cells = [str(many or "") for many in (found[Verdict.MET], found[Verdict.BY_MEAN], number,
                                          found[Verdict.EXPLAINED])]  # fmt: skip
    if number:
        cells[2] = f"**{number}**"
    return f"| {title} | {len(rows)} | {' | '.join(cells)} |"


def _remarks(chapter: Chapter) -> list[str]:
    """The remarks of all misses, each once."""
    return list(dict.fromkeys(remark for _, row in missed(chapter) for remark in row.remarks))


def _miss(chapter: Chapter, section: Section, row: Row) -> str:
    published = f", published {row.paper_text}" if row.paper_text else ""
    marks = "".join(mark(_remarks(chapter), remark) for remark in row.remarks)
    ours = f"**{row.ours.text(row.form)}**{published}, required {required(row)}{marks}"
    return f"[{row.case}]({address(chapter, section)}): {ours}"


def _reference(chapter: Chapter) -> str:
    return f"[{chapter.title}]({address(chapter)})"
