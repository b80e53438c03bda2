"""What pages of prose may name beside numbers: days of records, and results that are older than a change."""

from collections.abc import Callable, Sequence

from book.chapter import Chapter
from book.chapters import FILES
from book.dates import CHANGES, date, older_results
from book.markdown import address
from book.measurements import MEASUREMENTS


def words(chapters: Sequence[Chapter]) -> dict[str, str | Callable[[str], str]]:
    """`date("peers")`, and `older`, the list of older results, "" where there are none."""
    named = {one.name: one for one in MEASUREMENTS}
    return {"date": lambda name: date(named[name]), "older": older(chapters)}


def older(chapters: Sequence[Chapter]) -> str:
    """The results with facets that fail which are older than a change of the code, as an item of a list."""
    files = zip(chapters, FILES, strict=True)
    linked = [(f"[{chapter.title}]({address(chapter)})", file.measurements) for chapter, file in files]
    lines = [
        f"  - Before [{change}](decisions/{CHANGES[change][1]}): {which}."
        for change, which in older_results(linked).items()
    ]
    head = "- **Older results.** Some results with facets that fail were measured, in part or all, before a change:"
    return "\n".join([head, *lines]) if lines else ""
