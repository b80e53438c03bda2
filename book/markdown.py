"""Chapters as Markdown."""

import posixpath
import re
from collections.abc import Iterable, Sequence

from book.chapter import Chapter, Figure, Section
from book.row import Origin, Row, Verdict, tally

_GENERATED = "<!-- Written by `python -m book`; edit book/, not this file. -->\n"
_INTRODUCTION = """# Validation

What the papers print, what bondem gives, and the command that measures it. This book is generated: every number of ours is read from
[`benchmarks/results`](../benchmarks/results) or, where a test or a long run leaves no file, from
[`book/recorded.toml`](../book/recorded.toml), with its command and date; every verdict is computed from the numbers and a tolerance that
stands beside it. `python -m book --measure NAME` measures a part again, `python -m book` writes these pages, and CI fails where they are
not what the results render to. Verification (closed forms, conservation laws) is in `tests/verification/` and runs with the tests.
Times are of a machine with 2 shared cores."""
_LEGEND = """**met**: within the tolerance, the worst number of several deciding. **missed**: outside, and nothing excuses it.
**differs**: outside a tolerance about the paper's number, for a reason that is known and given; what is asked of bondem itself cannot differ,
only be met or missed. **no paper value**: nothing is printed and nothing asked. ± is one standard deviation over packings or runs. The last
column is the number of the command in the chapter's list."""
_LINK = re.compile(r"(\]\()([^)#:\s]+)(\)|#)")


def front(chapters: Sequence[Chapter]) -> str:
    """`docs/validation.md`: contents with counts, what is missed and what differs, and the papers' tables."""
    lines = [_GENERATED + _INTRODUCTION, _contents(chapters), _LEGEND]
    for verdict, title, lead in (
        (Verdict.MISSED, "What is missed", "Every row that is outside its tolerance without excuse."),
        (Verdict.DIFFERS, "What differs from the papers", "Rows outside a tolerance about the paper's number, with the reason."),
    ):
        found = [(chapter, row) for chapter in chapters for row in chapter.rows if row.verdict is verdict]
        if found:
            lines += [f"## {title}", lead, _list(found)]
    lines += [_body(chapter, "##") for chapter in chapters if chapter.in_front]
    return "\n\n".join(lines) + "\n"


def page(chapter: Chapter) -> str:
    """`docs/validation/NAME.md`."""
    text = f"{_GENERATED}[Validation](validation.md)\n\n{_body(chapter, '#')}\n"
    return moved(text, "validation")


def moved(text: str, folder: str) -> str:
    """Links that hold in `docs`, for a page in a folder of it."""
    return _LINK.sub(lambda link: f"{link[1]}{posixpath.relpath(link[2], folder)}{link[3]}", text)


def table(rows: Sequence[Row], commands: Sequence[Origin]) -> str:
    """Rows as a table; columns in which nothing stands are left out."""
    columns = {
        "case": [row.case for row in rows],
        "source": [row.source for row in rows],
        "paper": [_paper(row) for row in rows],
        "bondem": [row.ours.text(row.form) for row in rows],
        "tolerance": [row.tolerance.words(row.form) if row.tolerance else "" for row in rows],
        "verdict": [_verdict(row.verdict) for row in rows],
        "note": [row.remark for row in rows],
        "by": [str(1 + commands.index(row.ours.origin)) for row in rows],
    }
    kept = {name: cells for name, cells in columns.items() if any(cells)}
    lines = [f"| {' | '.join(kept)} |", f"|{'---|' * len(kept)}"]
    lines += [f"| {' | '.join(cells)} |" for cells in zip(*kept.values(), strict=True)]
    return "\n".join(lines)


def address(chapter: Chapter) -> str:
    """Where a chapter stands, from `docs`."""
    if not chapter.in_front:
        return f"validation/{chapter.name}.md"
    kept = re.sub(r"[^\w\- ]", "", chapter.title.lower())
    return f"validation.md#{kept.replace(' ', '-')}"


def counts(rows: Iterable[Row]) -> str:
    """12 met, 1 missed."""
    found = tally(rows)
    return ", ".join(f"{found[verdict]} {verdict.value}" for verdict in Verdict if found[verdict])


def _contents(chapters: Sequence[Chapter]) -> str:
    lines = ["## Contents", "", "| chapter | rows | met | missed | differs | no paper value |", "|---|--:|--:|--:|--:|--:|"]
    for chapter in chapters:
        lines.append(_line(f"[{chapter.title}]({address(chapter).removeprefix('validation.md')})", list(chapter.rows)))
    lines.append(_line("**all**", [row for chapter in chapters for row in chapter.rows]))
    return "\n".join(lines)


def _line(title: str, rows: Sequence[Row]) -> str:
    found = tally(rows)
    cells = [str(found[verdict] or "") for verdict in Verdict]
    if found[Verdict.MISSED]:
        cells[1] = f"**{cells[1]}**"
    return f"| {title} | {len(rows)} | {' | '.join(cells)} |"


def _list(found: Sequence[tuple[Chapter, Row]]) -> str:
    lines = []
    for chapter, row in found:
        where = f"[{chapter.title}]({address(chapter).removeprefix('validation.md')})"
        against = f"paper {_paper(row)}, " if row.paper is not None else ""
        asked = row.tolerance.words(row.form) if row.tolerance else ""
        remark = f" {row.remark[0].upper()}{row.remark[1:].rstrip('.')}." if row.remark else ""
        lines.append(f"- {where}: {row.case}, **{row.ours.text(row.form)}** ({against}{asked}).{remark}")
    return "\n".join(lines)


def _body(chapter: Chapter, mark: str) -> str:
    rows = list(chapter.rows)
    commands = list(dict.fromkeys(row.ours.origin for row in rows))
    lines = [f"{mark} {chapter.title}", chapter.summary]
    if rows:
        lines += [f"*{len(rows)} rows: {counts(rows)}.*", _commands(commands)]
    for section in chapter.sections:
        lines += _section(section, f"{mark}#", commands)
    return "\n\n".join(line for line in lines if line)


def _section(section: Section, mark: str, commands: Sequence[Origin]) -> list[str]:
    lines = [f"{mark} {section.title}", section.before]
    if section.rows:
        lines.append(table(section.rows, commands))
    return [*lines, section.after, *map(_figure, section.figures)]


def _figure(figure: Figure) -> str:
    return f"![{figure.caption}](figures/{figure.name})\n\n*{figure.caption}*"


def _commands(commands: Sequence[Origin]) -> str:
    lines = []
    for k, origin in enumerate(commands):
        kept = f"[`{origin.kept}`](../{origin.kept})" + (f", measured {origin.when}" if origin.when else "")
        lines.append(f"{k + 1}. `{origin.command}` → {kept}")
    return "\n".join(lines)


def _paper(row: Row) -> str:
    if row.paper is None:
        return ""
    return row.paper if isinstance(row.paper, str) else row.form.text(row.paper)


def _verdict(verdict: Verdict) -> str:
    return f"**{verdict.value}**" if verdict is Verdict.MISSED else verdict.value
