"""Chapters as files: NAME.md, a text with places for numbers and tables, beside NAME.py, which has the rows.

An expression of the text sees what the module and `book/forms.py` define: `{{ WAVES.at("count")|spaced }}` is a
number of a record, and `{{ table(waves()) }}` the table of the rows that `waves` gives, one per section. The text has
the form of its page, one sentence a line: the title, a summary, what failed, and sections with figures at their
ends.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from book import forms
from book.chapter import Chapter, Figure, Section
from book.dates import date
from book.quoting import rendered
from book.results import Measurement
from book.row import Row, Rows

_TABLE = "<!-- table {} -->"
_FIGURE = re.compile(r"^!\[(.*)\]\((.*)\)$", re.MULTILINE)
_FAILED = "What failed: "


@dataclass(frozen=True)
class ChapterFile:
    """A chapter of `book/chapters`, by the module with its rows."""

    module: ModuleType

    @property
    def measurements(self) -> tuple[Measurement, ...]:
        """Measurements whose results the chapter shows."""
        return self.module.MEASUREMENTS

    def chapter(self) -> Chapter:
        """The chapter, read from its results.

        Raises:
            BookError: a number is missing, or the text names what the module does not define.
        """
        tables: list[tuple[Row, ...]] = []

        def table(rows: Rows) -> str:
            tables.append(tuple(rows))
            return _TABLE.format(len(tables) - 1)

        name = self.module.__name__.rpartition(".")[2]
        names = {**vars(forms), "date": date, **vars(self.module), "table": table}
        text = rendered(Path(__file__).parent / "chapters" / f"{name}.md", names)
        head, *parts = re.split("^## ", text, flags=re.MULTILINE)
        title, summary, *failed = re.split("\n\n+", head.strip())
        return Chapter(
            name=name, title=title.removeprefix("# "), summary=summary,
            misses="".join(failed).removeprefix(_FAILED), sections=tuple(_section(part, tables) for part in parts),
        )  # fmt: skip


def _section(text: str, tables: list[tuple[Row, ...]]) -> Section:
    """A section of a text, whose table has a number in its place."""
    title, _, body = text.partition("\n")
    figures = tuple(Figure(name, caption) for caption, name in _FIGURE.findall(body))
    before, number, after = [*re.split(_TABLE.format(r"(\d+)"), _FIGURE.sub("", body)), "", ""][:3]
    rows = tables[int(number)] if number else ()
    return Section(title=title, rows=rows, before=before.strip(), after=after.strip(), figures=figures)
