"""The first page: what is claimed, how it was measured, what failed."""

from collections.abc import Iterator, Sequence

from book.chapter import Chapter, Section
from book.claims import CLAIMS, Claim
from book.markdown import GENERATED, address, counts, mark, notes, required, sentence
from book.questions import QUESTIONS, by_question
from book.row import Row, Verdict, tally
from book.shown import shown

_INTRODUCTION = """# Validation

These pages compare numbers computed by bondem with published values, with theories and with required tolerances.
Every comparison that failed is listed on this page.
Verification (closed forms, conservation laws) is in `tests/`, in a folder per subject, and runs with the tests."""
_CHART = """![Error over tolerance of every comparison, by what it helps to decide](figures/tolerances.svg)

*Each mark is one comparison. At 1 the error is as large as the tolerance; marks at the ends lie there or beyond.*"""
_MEASURED = """## How it was measured

Every number of bondem in a table comes from a command: a study, a benchmark or the tests.
The command writes a file in `benchmarks/results` and is listed at the top of its page.
The last column of a table, #, is the number of the command.
`BUILD` in a command stands for a folder of your choice.

Each chapter states the inputs that a paper leaves open, and how they were chosen.
Times and speeds are medians on machines with 2 shared cores.
The result files have the commit of each row.
[Numbers](numbers.md) lists the numbers that other pages quote, with command, size and date.

A program computes each verdict from the number and the requirement in the same row:

- **met**: the number is within the requirement, and so is the number plus or minus one standard deviation;
  of several numbers the worst decides.
- **met by the mean**: the mean is within the requirement, but the mean plus or minus one standard deviation is not.
- **missed**: the number is outside the requirement.
- **missed, explained**: the number is outside, and the cause is stated. It counts as a miss.

± is one standard deviation over packings or runs.
"≤ published" requires an error no larger than the published one.
Comparisons that are met for the same published value and requirement share a row, which gives their range.
Numbers without a published value, a theory or a requirement are not on these pages.
They remain in `benchmarks/results` and in the figures.

- `python -m book` writes these pages; the tests fail if the pages differ from the results.
- `python -m book --measure NAME` repeats a measurement; `python -m book --list` lists all.
- `python -m book --rows` counts the rows, and checks that every miss is printed."""


def front(chapters: Sequence[Chapter], older: str = "") -> str:
    """`docs/validation.md`.

    Args:
        chapters: all chapters.
        older: the results that are older than a change of the code, as an item of a list; "" where there are none.
    """
    head = GENERATED + _INTRODUCTION
    parts = [head, _CHART, _claims(CLAIMS, chapters), _failed(chapters), _contents(chapters), _measured(older)]
    return "\n\n".join([*(part for part in parts if part), *_misses(chapters)]) + "\n"


def missed(chapter: Chapter) -> Iterator[tuple[Section, Row]]:
    """The missed rows of a chapter, each with its section."""
    for section in chapter.sections:
        yield from ((section, row) for row in section.rows if row.verdict.is_miss)


def _claims(claims: Sequence[Claim], chapters: Sequence[Chapter]) -> str:
    """The claims and their results; a claim of a chapter that is not there is left out."""
    known = {chapter.name: chapter for chapter in chapters}
    found = [(claim, known[claim.chapter], claim.rows(chapters)) for claim in claims if claim.chapter in known]
    if not found:
        return ""
    held = sum(not any(row.verdict.is_miss for row in rows) for _, _, rows in found)
    said = f"Of {len(found)} claims, {held} hold and {len(found) - held} fail in part or fully."
    lines = ["## What is claimed", said]
    for question in QUESTIONS:
        if mine := [_claim(*one) for one in found if one[0].question == question]:
            lines += [f"### {question}", "\n".join(mine)]
    return "\n\n".join(lines)


def _measured(older: str) -> str:
    return "\n".join([_MEASURED, *[older] * bool(older)])


def _claim(claim: Claim, chapter: Chapter, rows: Sequence[Row]) -> str:
    section = next(one for one in chapter.sections if rows[0] in one.rows)
    link = f"[{section.title}]({address(chapter, section)})"
    failed = any(row.verdict.is_miss for row in rows)
    verdict = "**Missed**" if failed else "Held"
    (row, *others) = rows
    why = f"\n  {sentence(row.reason)}" if row.verdict is Verdict.EXPLAINED and not others else ""
    return f"- {verdict}: {claim.says}.\n  Measured: {claim.measured}.\n  Result: {_result(rows)} ({link}).{why}"


def _result(rows: Sequence[Row]) -> str:
    if len(rows) > 1:
        return counts(rows)
    (row,) = rows
    asked = required(row)
    published = f", published {row.paper_text}" if row.paper_text else ""
    return f"{row.ours.text(row.form)}{published}, required {asked}: {row.verdict.value}"


def _failed(chapters: Sequence[Chapter]) -> str:
    """What failed, in plain words, by chapter."""
    rows = [row for chapter in chapters for row in chapter.rows]
    found = tally(rows)
    number = sum(row.verdict.is_miss for row in rows)
    if not number:
        return ""
    lines = [
        "## What failed",
        f"Of {len(rows)} comparisons {number} are missed; the cause of {found[Verdict.EXPLAINED]} is known and"
        " stated.\n[The list of all misses](#all-misses) links each of them.",
    ]
    lines.append("\n".join(
        f"- {_reference(chapter)}, {many} of {len(list(chapter.rows))}: {' '.join(chapter.misses.splitlines())}"
        for some in by_question(chapters).values() for chapter in some if (many := len(list(missed(chapter))))
    ))  # fmt: skip
    return "\n\n".join(lines)


def _contents(chapters: Sequence[Chapter]) -> str:
    head = "| chapter | comparisons | met | met by the mean | missed | of these explained |"
    lines = ["## Contents", "", head, "|---|--:|--:|--:|--:|--:|"]
    lines += [_line(_reference(chapter), list(chapter.rows)) for some in by_question(chapters).values()
              for chapter in some]  # fmt: skip
    rows = [row for chapter in chapters for row in chapter.rows]
    lines.append(_line("**all**", rows))
    printed = sum(len(shown(section.rows)) for chapter in chapters for section in chapter.sections)
    lines += ["", f"The pages print these comparisons in {printed} rows."]
    # the chapters, and pages of theory beside them, stand below this page in the contents
    names = [f"validation/{chapter.name}" for chapter in chapters]
    lines += ["", "```{toctree}", ":hidden:", ":glob:", "", *names, "validation/*", "```"]
    return "\n".join(lines)


def _line(title: str, rows: Sequence[Row]) -> str:
    found = tally(rows)
    number = sum(many for verdict, many in found.items() if verdict.is_miss)
    cells = [str(many or "") for many in (found[Verdict.MET], found[Verdict.BY_MEAN], number,
                                          found[Verdict.EXPLAINED])]  # fmt: skip
    if number:
        cells[2] = f"**{number}**"
    return f"| {title} | {len(rows)} | {' | '.join(cells)} |"


def _misses(chapters: Sequence[Chapter]) -> list[str]:
    """Every miss, with a link to its section."""
    parts = []
    for chapter in chapters:
        found = list(missed(chapter))
        if found:
            remarks = list(dict.fromkeys(remark for _, row in found for remark in row.remarks))
            parts += [f"### {chapter.title}", "\n".join(_miss(chapter, *one, remarks) for one in found)]
            parts += ["\n".join(notes(remarks))] * bool(remarks)
    return ["## All misses", *parts] if parts else []


def _miss(chapter: Chapter, section: Section, row: Row, remarks: Sequence[str]) -> str:
    published = f", published {row.paper_text}" if row.paper_text else ""
    marks = "".join(mark(remarks, remark) for remark in row.remarks)
    return (
        f"- [{row.case}]({address(chapter, section)}): **{row.ours.text(row.form)}**{published}, required"
        f" {required(row)}{marks}"
    )


def _reference(chapter: Chapter) -> str:
    return f"[{chapter.title}]({address(chapter)})"
