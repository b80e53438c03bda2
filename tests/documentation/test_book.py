"""The book: verdicts are computed, a missing number is an error, pages are what the results render to."""

import json
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

from book import pages
from book.__main__ import main
from book.chapter import Chapter, Section
from book.chapter_file import ChapterFile
from book.chart import chart
from book.counting import counted
from book.errors import BookError
from book.forms import PERCENT, SIGNED, Form, Said
from book.front import front
from book.markdown import moved, slug, table
from book.measure import _run as measure_one
from book.measure import sign
from book.measurements import MEASUREMENTS
from book.outcomes import TESTS
from book.results import RESULTS, ROOT, Measurement
from book.row import Measured, Origin, Row, Verdict
from book.shown import shown
from book.tolerances import AtLeast, AtMost, Near, So, Tolerance

ORIGIN = Origin("bondem measure", "benchmarks/results/it.json")


def ours(*values: float, scatter: float | None = None) -> Measured:
    return Measured(values, ORIGIN, scatter)


@pytest.mark.parametrize(
    ("values", "paper", "tolerance", "verdict"),
    [
        ((72.6,), 72.5, Near(relative=0.002), Verdict.MET),
        ((72.7,), 72.5, Near(relative=0.002), Verdict.MISSED),
        ((0.643,), 0.635, Near(absolute=0.008), Verdict.MET),  # at the limit, but for rounding
        ((2.01, 2.06), None, Near(target=2.0, absolute=0.05), Verdict.MISSED),  # the worst of several decides
        ((-0.0148,), 0.0120, AtMost(), Verdict.MISSED),
        ((-0.0119,), 0.0120, AtMost(), Verdict.MET),
        ((54.0, 66.0), None, AtLeast(60.0), Verdict.MISSED),
        ((1.0,), None, So(), Verdict.MET),
        ((1.0,), None, So(wanted=False), Verdict.MISSED),
    ],
)
def test_verdicts_follow_from_the_numbers(
    values: tuple[float, ...], paper: float | str | None, tolerance: Tolerance, verdict: Verdict
):
    row = Row(case="it", ours=ours(*values), paper=paper, tolerance=tolerance)
    assert row.verdict is verdict
    if paper is not None:
        excused = Row(case="it", ours=ours(*values), paper=paper, tolerance=tolerance, reason="known")
        assert excused.verdict is (Verdict.EXPLAINED if verdict is Verdict.MISSED else verdict)
        assert excused.remarks == ["known"] * (verdict is Verdict.MISSED)  # no excuse where none is needed


def test_a_row_is_met_with_its_scatter_or_says_that_it_is_not():
    def row(value: float, scatter: float | None) -> Row:
        return Row(case="it", ours=Measured((value,), ORIGIN, scatter), tolerance=AtMost(0.03))

    assert row(0.02, 0.005).verdict is Verdict.MET
    assert row(0.02, 0.015).verdict is Verdict.BY_MEAN
    assert row(0.02, None).verdict is Verdict.MET
    assert row(0.04, 0.02).verdict is Verdict.MISSED  # that some packings are within does not undo it
    assert not Verdict.BY_MEAN.is_miss
    assert Verdict.EXPLAINED.is_miss


def test_what_makes_no_verdict_is_an_error():
    with pytest.raises(TypeError, match="tolerance"):
        Row(case="it", ours=ours(1.0), paper=1.0)
    with pytest.raises(BookError, match="say it as a note"):
        Row(case="it", ours=ours(1.0), tolerance=AtMost(0.5), reason="we were tired")
    with pytest.raises(BookError, match="give the limit"):
        assert Row(case="it", ours=ours(1.0), tolerance=AtMost()).verdict
    with pytest.raises(BookError, match="one of them"):
        Near(relative=0.1, absolute=0.1)


def test_a_number_that_is_not_there_is_an_error(tmp_path):
    kept = tmp_path / "it.json"
    kept.write_text(json.dumps({"a": {"b": 1.5, "c": None, "d": "1.5"}, "rows": [{"n": 1, "y": 2.0}, {"n": 1}]}))
    it = Measurement("it", "bondem measure", file=kept)
    assert it.number("a", "b", factor=2.0).values == (3.0,)
    for steps in (("a", "x"), ("a", "c"), ("a", "d"), ("rows", 5, "y"), ("rows", {"n": 1}, "y"), ("rows", {"n": 2},
    "y")):
        with pytest.raises(BookError, match=re.escape("it.json")):
            it.number(*steps)
    with pytest.raises(BookError, match="a number is missing"):
        it.of(1.0, None)
    for value in (float("nan"), float("inf")):
        with pytest.raises(BookError, match="not finite"):
            ours(value)
    with pytest.raises(BookError, match="--measure gone"):
        assert Measurement("gone", "bondem measure", file=tmp_path / "gone.json").data


def test_numbers_are_printed_as_people_read_them():
    assert SIGNED.text(-0.0148) == "−1.48 %"
    assert Form("GPa", 1e9, ".1f").text(72.54e9) == "72.5 GPa"
    assert Form(style=",.0f").text(10_000) == "10 000"
    assert Form(style=".0e").text(-6e-13) == "−6e-13"
    assert SIGNED.text(-1e-9) == "0.00 %"
    assert Said("the same bits", "other bits").text(0.0) == "other bits"
    assert ours(-0.0148, scatter=0.0060).text(SIGNED) == "−1.48 ± 0.60 %"
    assert ours(54e6, 66e6).text(Form("M/s", 1e6, ".0f")) == "54–66 M/s"


def test_a_table_leaves_out_what_is_empty_and_says_remarks_once():
    rows = [
        Row(case="E", source="Table 1", paper=1.0, ours=ours(2.0), tolerance=Near(relative=0.1),
            reason="walls are soft"),
        Row(case="F", source="Table 1", paper=1.0, ours=ours(3.0), tolerance=Near(relative=0.1),
            reason="walls are soft"),
        Row(case="G", ours=ours(0.5), tolerance=AtMost(0.1), form=PERCENT),
    ]
    lines = table(rows, [ORIGIN]).splitlines()
    assert lines[0] == "| case | source | published | bondem | required | verdict | # |"
    whole = [line.replace("\N{NO-BREAK SPACE}", " ") for line in lines]
    assert whole[2] == "| E | Table 1 | 1 | 2 | ± 10 % | **missed, explained** <sup>a</sup> | 1 |"
    assert whole[4] == "| G |  |  | 50.00 % | ≤ 10.00 % | **missed** | 1 |"
    assert lines[-1] == "<sup>a</sup> Walls are soft."
    assert table(rows[2:], [ORIGIN]).startswith("| case | bondem |")


def test_rows_that_are_met_for_one_requirement_share_a_line_and_misses_never_do():
    def row(case: str, value: float, **more) -> Row:
        return Row(case=case, ours=ours(value), tolerance=AtMost(1.0), **more)

    lines = shown([
        row("bar, 300 cells: error", 0.1), row("bar, 1000 cells: error", 0.5), row("bar, 3000 cells: error", 2.0),
        row("bar, 10 000 cells: error", 3.0), row("bar: number of cells", 0.1),
        row("bar, 300 cells: error", 0.2, source="fig. 1"),
    ])  # fmt: skip
    assert [(line.case, line.ours, line.verdict) for line in lines] == [
        ("bar, 300 / 1000 cells: error (2 cases)", "0.1–0.5", Verdict.MET),
        ("bar, 3000 cells: error", "2", Verdict.MISSED),
        ("bar, 10 000 cells: error", "3", Verdict.MISSED),
        ("bar: number of cells", "0.1", Verdict.MET),
        ("bar, 300 cells: error", "0.2", Verdict.MET),  # of another source, so not the same requirement
    ]


@pytest.mark.parametrize(
    ("cases", "together"),
    [
        (("E: mean", "ν: mean"), "E / ν: mean (2 cases)"),
        (("cube, 8 thick: E", "plate: E"), "cube / plate, …: E (2 cases)"),
        (tuple(f"E: calibrated on {n}" for n in (2, 3, 4, 8)), "E: calibrated on 2 … 8 (4 cases)"),
        (("UCS, 9 cells, seeds 1, 2", "UCS, 9 cells, seeds 1"), "UCS, 9 cells, seeds 1, 2 / 1 (2 cases)"),
        (("off eqs (8), (9): E, σ = 1", "off eqs (8), (9): E, σ = 2"), "off eqs (8), (9): E, σ = 1 / 2 (2 cases)"),
    ],
)
def test_a_line_names_what_its_cases_have_in_common(cases: tuple[str, ...], together: str):
    (line,) = shown([Row(case=case, ours=ours(0.5), tolerance=AtMost(1.0)) for case in cases])
    assert line.case == together


def test_a_line_of_several_rows_states_the_largest_scatter_and_every_remark():
    rows = [
        Row(case=f"bar, seed {k}", ours=ours(0.1 * k, scatter=0.01 * k), tolerance=AtMost(1.0), note=f"note {k}")
        for k in (1, 2)
    ]
    (line,) = shown(rows)
    assert line.ours == "0.1–0.2 (each ± 0.02 or less)"
    assert line.remarks == ["note 1", "note 2"]


def test_the_pages_have_few_rows_and_lose_no_miss(capsys):
    chapters = pages.chapters()
    lines, lost = counted(chapters)
    assert not lost
    assert int(lines[-1].split()[-1]) <= 520  # more than anyone reads
    assert main(["--rows"]) == 0
    assert capsys.readouterr().out.splitlines()[:-1] == lines
    tables = [(ROOT / f"docs/validation/{chapter.name}.md").read_text(encoding="utf-8") for chapter in chapters]
    printed = sum(len(re.findall(r"^\| .*\*\*missed", text, re.MULTILINE)) for text in tables)
    listed = (ROOT / "docs/validation.md").read_text(encoding="utf-8").partition("## All misses")[2]
    missed = sum(row.verdict.is_miss for chapter in chapters for row in chapter.rows)
    assert printed == len(re.findall(r"^- \[", listed, re.MULTILINE)) == missed


def test_a_miss_that_no_page_prints_is_found(monkeypatch, tmp_path):
    row = Row(case="the one", ours=ours(2.0), tolerance=AtMost(1.0))
    one = Chapter(name="it", title="It", summary="", misses="it fails.", sections=(Section(title="A", rows=(row,)),))
    (tmp_path / "validation").mkdir()
    (tmp_path / "validation/it.md").write_text("| the one | 2 | ≤ 1 | met | 1 |")
    (tmp_path / "validation.md").write_text("- [another one](it.md)")
    monkeypatch.setattr("book.counting.DOCS", tmp_path)
    assert len(counted([one])[1]) == 2


def test_a_chapter_with_misses_says_in_words_what_failed(monkeypatch):
    row = Row(case="the one", ours=ours(2.0), tolerance=AtMost(1.0))
    one = Chapter(name="it", title="It", summary="", sections=(Section(title="A", rows=(row,)),))
    monkeypatch.setattr(pages, "FILES", [type("File", (), {"chapter": staticmethod(lambda: one)})])
    with pytest.raises(BookError, match="what failed"):
        pages.chapters()


def test_the_front_page_hides_no_missed_row():
    missed = Row(case="the one", ours=ours(2.0), tolerance=AtMost(1.0))
    rows = Section(title="Its rows", rows=(missed,))
    one = Chapter(name="surface", title="It", summary="", misses="It is too large.", sections=(rows,))
    text = front([one])
    assert "| [It](validation/surface.md) | 1 |  |  | **1** |  |" in text
    assert "- [It](validation/surface.md), 1 of 1: It is too large." in text
    assert "- [the one](validation/surface.md#its-rows): **2**, required ≤ 1" in text
    with pytest.raises(BookError, match="chapter of no question"):
        front([replace(one, name="it")])


def test_the_chart_has_a_mark_for_every_comparison_and_draws_misses_right_of_the_limit():
    rows = [
        Row(case="half", ours=ours(0.5), tolerance=AtMost(1.0)),
        Row(case="twice", ours=ours(2.0), tolerance=AtMost(1.0)),
        Row(case="tenth", ours=ours(10.1), paper=10.0, tolerance=Near(absolute=1.0)),
        Row(case="so", ours=ours(1.0), tolerance=So()),
        Row(case="three times", ours=ours(4.0), paper=1.0, tolerance=Near(relative=1.0), reason="known"),
    ]
    assert [row.used for row in rows] == [0.5, 2.0, pytest.approx(0.1), None, 3.0]
    section = Section(title="A", rows=tuple(rows))
    one = Chapter(name="surface", title="It", summary="", misses="x", sections=(section,))
    legend, drawn = chart([one]).split("Surface correction")
    marks = re.findall(r'class="(met|missed|explained)" (?:cx="|d="M)([\d.]+)', drawn)
    assert [kind for kind, _ in marks] == ["met", "met", "met", "missed", "explained"]
    limit = float(re.findall(r'class="l" d="M([\d.]+)', legend)[0])
    assert all((float(x) > limit) is (kind != "met") for kind, x in marks)
    for row in (row for chapter in pages.chapters() for row in chapter.rows if row.used is not None):
        assert (row.used > 1.0 + 1e-9) is row.verdict.is_miss, row.case


def test_a_text_of_a_chapter_that_names_what_its_module_lacks_is_an_error():
    with pytest.raises(BookError, match=r"cells.md: 'MODULI' is undefined"):
        ChapterFile(ModuleType("book.chapters.cells")).chapter()


def test_links_follow_a_page_into_its_folder():
    text = "[a](studies.md#b) ![c](figures/d.png) [e](https://f.org) [g](#h) [i](validation/chen.md)"
    there = "[a](../studies.md#b) ![c](../figures/d.png) [e](https://f.org) [g](#h) [i](chen.md)"
    assert moved(text, "validation") == there


def test_the_pages_are_what_the_results_render_to(monkeypatch, capsys):
    assert main(["--check"]) == 0, capsys.readouterr().out
    monkeypatch.setattr(pages, "front", lambda *_: "typed by hand")
    assert main(["--check"]) == 1
    assert "docs/validation.md differs from the results" in capsys.readouterr().out


def test_every_link_of_the_pages_leads_somewhere():
    lost = []
    for page in [ROOT / "docs/validation.md", *(ROOT / "docs/validation").glob("*.md")]:
        text = page.read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            path, _, anchor = target.partition("#")
            if target.startswith("http"):
                continue
            there = page.parent / path if path else page
            if not there.exists() or (anchor and anchor not in _slugs(there)):
                lost.append(f"{page.name}: {target}")
    assert not lost


@cache
def _slugs(page: Path) -> set[str]:
    return {slug(title) for title in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)}


def test_what_tests_record_stands_in_the_book_and_is_kept():
    kept = set(TESTS.at("numbers"))
    sources = {folder: "".join(path.read_text(encoding="utf-8") for path in (ROOT / folder).rglob("*.py"))
               for folder in ("book", "tests")}  # fmt: skip
    asked = re.findall(r'\b(?:largest|range_of|holds)\("([^"]+)"\)', sources["book"])
    assert set(asked) == kept
    assert not {name for name in kept if f'record("{name}"' not in sources["tests"]} - {
        "energy that comes back, plane wave", "energy that comes back, thin bar",  # of one test with two cases
    }  # fmt: skip


def test_every_row_of_the_papers_tables_is_there():
    rows = [row for chapter in pages.chapters() for row in chapter.rows]
    # Table 1 of André and Table 3 of Chen are inputs: tests/validation has tests of them
    for source, fewest in (("Table 2", 3), ("Table 3", 3), ("Table 4", 4 + 8), ("Table 5", 24)):
        found = [row for row in rows if row.source == source and row.paper is not None]
        assert len(found) >= fewest, source
    printed = {row.paper_text for row in rows}
    assert {"28 %", "16 %", "12 %", "10 %", "7 %", "5 %"} <= printed


def test_names_of_measurements_are_unique_and_their_commands_exist():
    assert len({one.name for one in MEASUREMENTS}) == len(MEASUREMENTS)
    for one in MEASUREMENTS:
        for script in re.findall(r"python (\S+\.py)", one.command):
            assert (ROOT / script).exists(), one.command
    assert main(["--measure", "of_this_name"]) == 2


def test_results_that_name_no_command_and_commit_get_those_of_the_measurement(tmp_path):
    kept = tmp_path / "it.json"
    it = Measurement("it", "python it.py", file=kept)
    kept.write_text('{"answer": 42}')
    sign(it, "abc")
    assert json.loads(kept.read_text()) == {"command": "python it.py", "commit": "abc", "answer": 42}
    sign(it, "def")
    assert json.loads(kept.read_text())["commit"] == "abc"


def test_a_record_that_a_command_adds_to_is_measured_anew_and_stays_where_the_command_fails(tmp_path):
    kept = tmp_path / "it.json"
    kept.write_text("old")
    ends = "import pathlib, sys; p = pathlib.Path(sys.argv[1]); "
    fails = Measurement("it", f'python -c "{ends}sys.exit(p.exists() or 3)" {kept}', file=kept, goes_on=True)
    with pytest.raises(BookError, match="status 3"):
        measure_one(fails, tmp_path)
    assert kept.read_text() == "old"
    works = replace(fails, command=f'python -c "{ends}p.write_text(str(p.exists()))" {kept}')
    measure_one(works, tmp_path)
    assert kept.read_text() == "False"


def test_every_kept_result_names_its_command_and_what_code_made_it():
    for path in sorted(RESULTS.glob("*.json")):
        entries = [found] if "command" in (found := json.loads(path.read_text(encoding="utf-8"))) else found.values()
        for entry in entries:
            assert entry["command"].startswith(("python ", "bondem ")), path.name
            assert re.fullmatch("[0-9a-f]{7,40}\\+?", entry.get("commit", entry.get("kept_with", ""))), path.name
