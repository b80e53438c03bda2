"""The pages of the book: what they should hold, and whether they do."""

from collections.abc import Iterator
from pathlib import Path

from book.chapter import Chapter
from book.chapters import FILES
from book.chart import chart
from book.errors import BookError
from book.front import front
from book.markdown import page
from book.numbers import numbers
from book.printed import pages as with_code
from book.printed import with_output
from book.prose import older, words
from book.quoted import quoted
from book.quoting import target, templates, written
from book.results import ROOT
from book.studies_page import filled

DOCS = ROOT / "docs"
#: A figure beyond this is not for a repository.
LARGEST_FIGURE = 1_000_000


def chapters() -> list[Chapter]:
    """All chapters in their order.

    Raises:
        BookError: a row lacks its number; or a comparison is missed and no words say what failed, or the reverse.
    """
    found = [file.chapter() for file in FILES]
    for chapter in found:
        if any(row.verdict.is_miss for row in chapter.rows) is not bool(chapter.misses):
            raise BookError(f"'{chapter.name}': misses= says in plain words what failed, if something did; else ''")
    return found


def rendered(book: list[Chapter]) -> dict[Path, str]:
    """Every page that the book writes, and its text."""
    pages = {DOCS / "validation.md": front(book, older(book)), DOCS / "studies.md": filled(DOCS / "studies.md")}
    pages |= {DOCS / "validation" / f"{one.name}.md": page(one, file.measurements)
              for one, file in zip(book, FILES, strict=True)}  # fmt: skip
    return _prose(book) | pages | {DOCS / "figures" / "tolerances.svg": chart(book)}


def _prose(book: list[Chapter]) -> dict[Path, str]:
    """Pages of prose with their numbers, and the page of all those numbers."""
    known, more = quoted(), words(book)
    texts = {target(template): written(template, known, more) for template in templates()}
    names = {page.relative_to(ROOT).as_posix(): asked for page, (_, asked) in texts.items()}
    by_hand = {page: page.read_text(encoding="utf-8") for page in with_code()}
    pages = by_hand | {page: text for page, (text, _) in texts.items()}
    return {page: with_output(text) for page, text in pages.items()} | {DOCS / "numbers.md": numbers(known, names)}


def write() -> list[Path]:
    """Write the pages that differ from the results; returns their paths."""
    changed = []
    for path, text in rendered(chapters()).items():
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
            changed.append(path)
    return changed


def differences() -> Iterator[str]:
    """Pages that differ from the results, and missing figures, one sentence each."""
    book = chapters()
    for path, text in rendered(book).items():
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            yield f"{path.relative_to(ROOT)} differs from the results; run python -m book"
    for chapter in book:
        for figure in (figure for section in chapter.sections for figure in section.figures):
            path = DOCS / "figures" / figure.name
            if not path.exists():
                yield f"docs/figures/{figure.name} of '{chapter.title}' is not there; see python -m book --list"
            elif path.stat().st_size > LARGEST_FIGURE:
                yield f"docs/figures/{figure.name} has {path.stat().st_size} bytes, more than {LARGEST_FIGURE}"
