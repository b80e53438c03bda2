"""Chapters: sections of rows, with what is to be said and seen about them."""

from collections.abc import Iterator
from dataclasses import dataclass

from book.row import Row


@dataclass(frozen=True)
class Figure:
    """A figure in `docs/figures` and what is to be seen on it."""

    name: str
    caption: str


@dataclass(frozen=True, kw_only=True)
class Section:
    """A table under a title.

    Attributes:
        title: of the section.
        rows: of the table; none for a section of words and figures.
        before, after: Markdown around the table; links are from the folder `docs`.
        figures: below it.
    """

    title: str
    rows: tuple[Row, ...] = ()
    before: str = ""
    after: str = ""
    figures: tuple[Figure, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Chapter:
    """A chapter.

    Attributes:
        name: of its page, `docs/validation/NAME.md`.
        title: in the contents.
        summary: what it shows, in a sentence or two.
        misses: what failed, in plain words without numbers; "" where every comparison is met.
        sections: of it.
    """

    name: str
    title: str
    summary: str
    misses: str = ""
    sections: tuple[Section, ...]

    @property
    def rows(self) -> Iterator[Row]:
        for section in self.sections:
            yield from section.rows
