"""The page of all quoted numbers: each with its size, and command, date and commit of the record that holds it."""

import posixpath
from collections.abc import Mapping, Sequence

from book.dates import commit, date
from book.forms import grid
from book.markdown import GENERATED, sentence
from book.quoting import Quoted
from book.results import ROOT, Measurement

_HEAD = """# Numbers

Every number of bondem on the pages listed here comes from a record in `benchmarks/results`.
The table states what each number is and the size of what was measured.
The last column, #, is the number of the record in the list below it.
`python -m book --measure NAME` repeats a record and writes all pages again."""


def numbers(quoted: Sequence[Quoted], pages: Mapping[str, set[str]]) -> str:
    """`docs/numbers.md`.

    Args:
        quoted: all quoted numbers.
        pages: names of the numbers that each page quotes, by its path in the repository.
    """
    records = list(dict.fromkeys(one.record.name for one in quoted))
    lines = []
    for one in quoted:
        where = ", ".join(_link(page) for page, names in pages.items() if one.name in names)
        lines.append((one.text, one.says, one.size, where, str(1 + records.index(one.record.name))))
    by_name = {one.record.name: one.record for one in quoted}
    listed = [f"{k + 1}. {_record(by_name[name])}" for k, name in enumerate(records)]
    table = grid(("number", "quantity", "size", "quoted in", "#"), lines)
    return "\n\n".join([GENERATED + _HEAD, table, "## Records", "\n".join(listed)]) + "\n"


def _link(page: str) -> str:
    name = posixpath.basename(page)
    return f"[{name}]({posixpath.relpath(page, 'docs')})"


def _record(one: Measurement) -> str:
    kept = one.path.relative_to(ROOT).as_posix()
    made = one.made.get("command", one.command)
    return sentence(f"`{made}` → [`{kept}`](../{kept}), `{one.name}`, {date(one)}, commit {commit(one)}")
