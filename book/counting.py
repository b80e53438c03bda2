"""`python -m book --rows`: rows before and after the rule of `book/shown.py`, and whether every miss is printed."""

import re
from collections import Counter
from collections.abc import Sequence

from book.chapter import Chapter
from book.front import missed
from book.pages import DOCS
from book.row import Verdict, tally
from book.shown import shown


def counted(chapters: Sequence[Chapter]) -> tuple[list[str], list[str]]:
    """A table of rows by verdict, before and after the rule, and the misses that no page prints."""
    before = tally(row for chapter in chapters for row in chapter.rows)
    after: Counter[Verdict] = Counter()
    for section in (section for chapter in chapters for section in chapter.sections):
        after.update(line.verdict for line in shown(section.rows))
    lines = [f"{'verdict':20} {'before':>7} {'after':>7}"]
    lines += [f"{verdict.value:20} {before[verdict]:7} {after[verdict]:7}" for verdict in Verdict]
    lines.append(f"{'all':20} {sum(before.values()):7} {sum(after.values()):7}")
    return lines, [one for chapter in chapters for one in _lost(chapter)]


def _lost(chapter: Chapter) -> list[str]:
    """Misses that are not rows of the chapter's page, or not in the list of the first page."""
    text = (DOCS / "validation" / f"{chapter.name}.md").read_text(encoding="utf-8")
    rows = Counter(found[1] for found in re.finditer(r"^\| (.*?) \|.*\*\*missed", text, re.MULTILINE))
    front = (DOCS / "validation.md").read_text(encoding="utf-8")
    wanted = Counter(row.case for _, row in missed(chapter))
    lost = [f"{chapter.name}: '{case}' is not a missed row of its page" for case in (wanted - rows)]
    unlisted = [case for case in wanted if f"- [{case}](" not in front]
    return lost + [f"{chapter.name}: '{case}' is not on the first page" for case in unlisted]
