"""Chapters as Markdown."""

import posixpath
import re
from collections.abc import Iterable, Mapping, Sequence

from book.chapter import Chapter, Figure, Section
from book.claims import CLAIMS, Claim
from book.row import Origin, Row, Verdict, tally

_GENERATED = "<!-- Written by `python -m book`; edit book/, not this file. -->\n"
_INTRODUCTION = """# Validation

What the papers print, what bondem gives, and the command that measures it. This book is generated: every number of
ours is read from [`benchmarks/results`](../benchmarks/results), where the command beside it left it, a study, a
benchmark or the tests; every verdict is computed from the numbers and a tolerance beside it. `python -m book
--measure NAME` measures a part again, `python -m book` writes these pages, and CI fails where they are not what the
results render to. Verification (closed forms, conservation laws) is in `tests/verification/` and runs with the
tests. Times and speeds are medians, of machines with 2 shared cores."""
_LEGEND = """\
- **met**: within the tolerance, and so one standard deviation to either side; the worst of several decides.
- **met by the mean**: the mean is within the tolerance, single packings or runs are not all: it less or more one
  standard deviation lies outside.
- **missed**: outside.
- **missed, explained**: outside a tolerance about the paper's number; the reason is given, and it is a miss all the
  same.
- **no paper value**: nothing is printed and nothing asked.

± is one standard deviation over packings or runs. The last column is the number of the command in the list of its
chapter; BUILD is a folder of one's own."""
_LINK = re.compile(r"(\]\()([^)#:\s]+)(\)|#)")


def front(chapters: Sequence[Chapter]) -> str:
    """`docs/validation.md`: contents with counts, what is missed, what of it is explained."""
    lines = [_GENERATED + _INTRODUCTION, _claims(CLAIMS, chapters), _contents(chapters), _LEGEND]
    missed, differing = (
        [(chapter, row) for chapter in chapters for row in chapter.rows if row.verdict is verdict]
        for verdict in (Verdict.MISSED, Verdict.EXPLAINED)
    )
    if missed:
        lines += ["## What is missed", _missed(missed)]
    if differing:
        lines += ["## What misses the papers' numbers, and why", _differing(differing)]
    return "\n\n".join(lines) + "\n"


def page(chapter: Chapter) -> str:
    """`docs/validation/NAME.md`."""
    text = f"{_GENERATED}[Validation](validation.md)\n\n{_body(chapter, '#')}\n"
    return moved(text, "validation")


def moved(text: str, folder: str) -> str:
    """Links that hold in `docs`, for a page in a folder of it."""
    return _LINK.sub(lambda link: f"{link[1]}{posixpath.relpath(link[2], folder)}{link[3]}", text)


def table(rows: Sequence[Row], commands: Sequence[Origin]) -> str:
    """Rows as a table, with remarks below it."""
    remarks = list(dict.fromkeys(remark for row in rows for remark in row.remarks))
    columns = {
        "case": [row.case for row in rows],
        "source": [row.source for row in rows],
        "paper": [row.paper_text for row in rows],
        "bondem": [row.ours.text(row.form) for row in rows],
        "tolerance": [_asked(row) for row in rows],
        "verdict": [_verdict(row, remarks) for row in rows],
        "command": [str(1 + commands.index(row.ours.origin)) for row in rows],
    }
    lines = [_grid(columns), ""] if remarks else [_grid(columns)]
    lines += [f"<sup>{_letter(k)}</sup> {_sentence(remark)}<br>" for k, remark in enumerate(remarks)]
    return "\n".join(lines).removesuffix("<br>")


def _grid(columns: Mapping[str, Sequence[str]]) -> str:
    """Columns in which nothing stands are left out."""
    kept = {name: cells for name, cells in columns.items() if any(cells)}
    lines = [f"| {' | '.join(kept)} |", f"|{'---|' * len(kept)}"]
    return "\n".join(lines + [f"| {' | '.join(cells)} |" for cells in zip(*kept.values(), strict=True)])


def _asked(row: Row) -> str:
    return row.tolerance.words(row.form) if row.tolerance else ""


def address(chapter: Chapter) -> str:
    """Where a chapter stands, from `docs`."""
    return f"validation/{chapter.name}.md"


def counts(rows: Iterable[Row]) -> str:
    """12 met, 2 missed, 1 of them explained."""
    found = tally(rows)
    missed = sum(number for verdict, number in found.items() if verdict.is_miss)
    parts = [f"{found[verdict]} {verdict.value}" for verdict in (Verdict.MET, Verdict.BY_MEAN) if found[verdict]]
    if missed:
        why = f", {found[Verdict.EXPLAINED]} of them explained" if found[Verdict.EXPLAINED] else ""
        parts.append(f"{missed} missed{why}")
    return ", ".join([*parts, *[f"{found[Verdict.NO_PAPER]} no paper value"] * bool(found[Verdict.NO_PAPER])])


def _claims(claims: Sequence[Claim], chapters: Sequence[Chapter]) -> str:
    """The claims as a table; a claim of a chapter that is not in the book is left out."""
    known = {chapter.name: chapter for chapter in chapters}
    pairs = [(claim, claim.row(chapters)) for claim in claims if claim.chapter in known]
    if not pairs:
        return ""
    rows = [row for _, row in pairs]
    held = [row for row in rows if not row.verdict.is_miss]
    commands = list(dict.fromkeys(row.ours.origin for row in rows))
    remarks = list(dict.fromkeys(remark for row in rows for remark in row.remarks))
    grid = _grid({
        "claim": [f"[{claim.says}]({address(known[claim.chapter])})" for claim, _ in pairs],
        "the paper's way": [claim.theirs for claim, _ in pairs],
        "ours": [claim.ours for claim, _ in pairs],
        "unseen packings": [claim.unseen for claim, _ in pairs],
        "paper": [row.paper_text for row in rows],
        "bondem": [row.ours.text(row.form) for row in rows],
        "tolerance": [_asked(row) for row in rows],
        "verdict": [_verdict(row, remarks) for row in rows],
        "command": [str(1 + commands.index(row.ours.origin)) for row in rows],
    })  # fmt: skip
    said = f"{len(rows)} claims: {len(held)} held, {len(rows) - len(held)} did not. The rest is behind each of them."
    lines = [f"<sup>{_letter(k)}</sup> {_sentence(remark)}<br>" for k, remark in enumerate(remarks)]
    below = "\n".join(lines).removesuffix("<br>")
    return "\n\n".join(["## What is claimed", said, _commands(commands), grid, below])


def _contents(chapters: Sequence[Chapter]) -> str:
    head = "| chapter | rows | met | met by the mean | missed | of these explained | no paper value |"
    lines = ["## Contents", "", head, "|---|--:|--:|--:|--:|--:|--:|"]
    for chapter in chapters:
        lines.append(_line(f"[{chapter.title}]({address(chapter)})",
            list(chapter.rows)))
    lines.append(_line("**all**", [row for chapter in chapters for row in chapter.rows]))
    return "\n".join(lines)


def _line(title: str, rows: Sequence[Row]) -> str:
    found = tally(rows)
    missed = sum(number for verdict, number in found.items() if verdict.is_miss)
    numbers = found[Verdict.MET], found[Verdict.BY_MEAN], missed, found[Verdict.EXPLAINED], found[Verdict.NO_PAPER]
    cells = [str(number or "") for number in numbers]
    if missed:
        cells[2] = f"**{missed}**"
    return f"| {title} | {len(rows)} | {' | '.join(cells)} |"


def _missed(found: Sequence[tuple[Chapter, Row]]) -> str:
    return _grid({
        "chapter": [_reference(chapter) for chapter, _ in found],
        "case": [f"{row.case} ({'; '.join(row.remarks)})" if row.remarks else row.case for _, row in found],
        "paper": [row.paper_text for _, row in found],
        "bondem": [f"**{row.ours.text(row.form)}**" for _, row in found],
        "tolerance": [_asked(row) for _, row in found],
    })  # fmt: skip


def _differing(found: Sequence[tuple[Chapter, Row]]) -> str:
    """By chapter; rows of one reason together."""
    lines = []
    for chapter in dict.fromkeys(chapter.title for chapter, _ in found):
        members = [(one, row) for one, row in found if one.title == chapter]
        lines.append(f"- {_reference(members[0][0])}")
        for reason in dict.fromkeys(row.reason for _, row in members):
            cases = "; ".join(
                f"{row.case}: {row.ours.text(row.form)}, paper {row.paper_text}" for _,
                row in members if row.reason == reason
            )
            lines.append(f"  - *{_sentence(reason)}* {cases}.")
    return "\n".join(lines)


def _reference(chapter: Chapter) -> str:
    return f"[{chapter.title}]({address(chapter)})"


def _sentence(remark: str) -> str:
    """With a capital, unless it begins with a symbol of one letter."""
    symbol = len(remark.split()[0].strip(",:")) == 1
    return f"{remark if symbol else remark[0].upper() + remark[1:]}".rstrip(".") + "."


def _letter(k: int) -> str:
    return chr(ord("a") + k)


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
        kept = f"[`{origin.kept}`](../{origin.kept})" if "/" in origin.kept else f"`{origin.kept}`"
        takes = f" ({origin.takes})" if origin.takes else ""
        lines.append(f"{k + 1}. `{origin.command}`{takes} → {kept}")
    return "\n".join(lines)


def _verdict(row: Row, remarks: Sequence[str]) -> str:
    word = f"**{row.verdict.value}**" if row.verdict.is_miss else row.verdict.value
    return word + "".join(f" <sup>{_letter(remarks.index(remark))}</sup>" for remark in row.remarks)
