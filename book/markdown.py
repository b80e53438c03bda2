"""Chapters as Markdown."""

import posixpath
import re
from collections.abc import Iterable, Mapping, Sequence

from book.chapter import Chapter, Figure, Section
from book.forms import grid
from book.results import Measurement
from book.row import Origin, Row, Verdict, tally
from book.shown import Line, shown

GENERATED = "<!-- Written by `python -m book`; edit book/, not this file. -->\n"
_LINK = re.compile(r"(\]\()([^)#:\s]+)(\)|#)")


def page(chapter: Chapter, measurements: Sequence[Measurement] = ()) -> str:
    """`docs/validation/NAME.md`: the chapter, and the commands of its rows and of all its measurements."""
    text = f"{GENERATED}[Validation](validation.md)\n\n{_body(chapter, measurements, '#')}\n"
    return moved(text, "validation")


def moved(text: str, folder: str) -> str:
    """Links that hold in `docs`, for a page in a folder of it."""
    return _LINK.sub(lambda link: f"{link[1]}{posixpath.relpath(link[2], folder)}{link[3]}", text)


def table(rows: Sequence[Row], commands: Sequence[Origin]) -> str:
    """The rows as a table, with remarks below it."""
    lines = shown(rows)
    remarks = list(dict.fromkeys(remark for line in lines for remark in line.remarks))
    columns = {
        "case": [line.case for line in lines],
        "source": [line.first.source for line in lines],
        "published": [line.first.paper_text for line in lines],
        "bondem": [line.ours for line in lines],
        "required": [required(line.first).replace(" ", "\N{NO-BREAK SPACE}") for line in lines],
        "verdict": [_verdict(line, remarks) for line in lines],
        "#": [str(1 + commands.index(line.first.ours.origin)) for line in lines],
    }
    text = [_grid(columns), ""] if remarks else [_grid(columns)]
    return "\n".join([*text, *notes(remarks)])


def notes(remarks: Sequence[str]) -> list[str]:
    """Remarks below a table or a list, each behind its letter."""
    lines = [f"<sup>{_letter(k)}</sup> {sentence(remark)}<br>" for k, remark in enumerate(remarks)]
    return [*lines[:-1], *(line.removesuffix("<br>") for line in lines[-1:])]


def mark(remarks: Sequence[str], remark: str) -> str:
    """The letter of a remark, behind what it belongs to."""
    return f" <sup>{_letter(remarks.index(remark))}</sup>"


def _grid(columns: Mapping[str, Sequence[str]]) -> str:
    """Columns in which nothing stands are left out."""
    kept = {name: cells for name, cells in columns.items() if any(cells)}
    return grid(list(kept), zip(*kept.values(), strict=True))


def required(row: Row) -> str:
    """What is required of a number, in words."""
    return row.tolerance.words(row.form)


def address(chapter: Chapter, section: Section | None = None) -> str:
    """The address of a chapter, or of one of its sections, from `docs`."""
    return f"validation/{chapter.name}.md" + (f"#{slug(section.title)}" if section else "")


def slug(title: str) -> str:
    """The anchor of a title, as Sphinx and GitHub derive it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def counts(rows: Iterable[Row]) -> str:
    """16 comparisons: 12 met, 4 missed, 1 of them explained."""
    found = tally(rows)
    compared = found.total()
    missed = sum(number for verdict, number in found.items() if verdict.is_miss)
    parts = [f"{found[verdict]} {verdict.value}" for verdict in (Verdict.MET, Verdict.BY_MEAN) if found[verdict]]
    if missed:
        why = f", {found[Verdict.EXPLAINED]} of them explained" if found[Verdict.EXPLAINED] else ""
        parts.append(f"{missed} missed{why}")
    return f"{compared} comparison{'s' * (compared != 1)}" + (f": {', '.join(parts)}" if parts else "")


def sentence(remark: str) -> str:
    """A remark with a full stop and with a capital, unless it begins with a symbol of one letter."""
    symbol = len(remark.split()[0].strip(",:")) == 1
    return f"{remark if symbol else remark[0].upper() + remark[1:]}".rstrip(".") + "."


def _letter(k: int) -> str:
    return chr(ord("a") + k)


def _body(chapter: Chapter, measurements: Sequence[Measurement], level: str) -> str:
    rows = list(chapter.rows)
    origins = [*(row.ours.origin for row in rows), *(one.origin for one in measurements)]
    commands = list(dict.fromkeys(origins))
    lines = [f"{level} {chapter.title}", chapter.summary]
    if rows:
        lines.append(f"*{sentence(counts(rows))}*")
        lines += [f"What failed: {chapter.misses}"] * any(row.verdict.is_miss for row in rows)
        lines.append(_commands(commands))
    for section in chapter.sections:
        lines += _section(section, f"{level}#", commands)
    return "\n\n".join(line for line in lines if line)


def _section(section: Section, level: str, commands: Sequence[Origin]) -> list[str]:
    """Nothing, if the section has neither text nor figures nor comparisons."""
    parts = [
        section.before,
        table(section.rows, commands) if shown(section.rows) else "",
        section.after,
        *map(_figure, section.figures),
    ]
    return [f"{level} {section.title}", *parts] if any(parts) else []


def _figure(figure: Figure) -> str:
    return f"![{figure.caption}](figures/{figure.name})\n\n*{figure.caption}*"


def _commands(commands: Sequence[Origin]) -> str:
    lines = []
    for k, origin in enumerate(commands):
        kept = f"[`{origin.kept}`](../{origin.kept})" if "/" in origin.kept else f"`{origin.kept}`"
        takes = f" ({origin.takes})" if origin.takes else ""
        lines.append(f"{k + 1}. `{origin.command}`{takes} → {kept}")
    return "\n".join(lines)


def _verdict(line: Line, remarks: Sequence[str]) -> str:
    word = f"**{line.verdict.value}**" if line.verdict.is_miss else line.verdict.value
    return word + "".join(mark(remarks, remark) for remark in line.remarks)
