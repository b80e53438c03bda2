"""Pages of prose: every measured number is that of a record, and all others are marked as inputs."""

import re
from dataclasses import replace

import pytest

from book.dates import COMMITS, commit, date
from book.errors import BookError
from book.measure import measure
from book.prose import words
from book.quoted import quoted
from book.quoting import TEXTS, ceiling, target, templates, written
from book.results import ROOT

NUMBERS = quoted()
# What holds no numbers of a sentence: front matter, comments, code, addresses, and expressions, which are the marks.
NO_PROSE = re.compile(
    r"\A---\n.*?\n---\n|<!--.*?-->|^```.*?^```$|`[^`\n]*`|\]\([^)]*\)|\{\{.*?\}\}|https?://\S+",
    re.MULTILINE | re.DOTALL,
)
NUMBER = re.compile(r"(?<![\w.-])(?:[+−-](?=\d))?\d+(?:[.,]\d+)*")


def bare(text):
    """Numbers of a text that are neither of a record nor marked, and outside code, links and comments."""
    return NUMBER.findall(NO_PROSE.sub(" ", text))


@pytest.mark.parametrize("template", templates(), ids=lambda path: path.relative_to(TEXTS).as_posix())
def test_no_number_of_a_page_of_prose_is_typed_by_hand(template):
    assert bare(template.read_text(encoding="utf-8")) == []


def test_a_number_typed_by_hand_is_found():
    text = "it is 1.14 times, −3 % off and {{ 30 }} long, E of ν = 0.2; `x = 5` [a](b2.md) v2"
    assert bare(text) == ["1.14", "−3", "0.2"]


def test_pages_that_state_measured_numbers_are_written_from_records():
    names = {target(one).relative_to(ROOT).as_posix() for one in templates()}
    assert names >= {"README.md", "paper.md", "docs/index.md", "docs/limits.md", "docs/coming_from.md"}
    for template in templates():
        assert f"edit book/texts/{template.relative_to(TEXTS)}" in target(template).read_text(encoding="utf-8")


def test_every_quoted_number_is_quoted_and_every_record_names_day_and_commit():
    more = {"date": str, "older": ""}
    asked = set().union(*(written(one, NUMBERS, more)[1] for one in templates()))
    assert {one.name for one in NUMBERS} == asked
    listed = (ROOT / "docs/numbers.md").read_text(encoding="utf-8")
    for one in NUMBERS:
        assert re.fullmatch(r"\d{4}-\d\d-\d\d", date(one.record)), one.name
        assert re.fullmatch(r"[0-9a-f]{7,40}\+?", commit(one.record)), one.name
        assert f"| {one.text} | {one.says} | {one.size} |" in listed
    assert COMMITS.exists()


def test_a_page_follows_its_record_and_asks_for_no_number_that_is_not_there(monkeypatch, tmp_path):
    template = next(one for one in templates() if one.name == "README.md")
    other = [replace(one, values=(1.77,)) if one.name == "bars.largest_work" else one for one in NUMBERS]
    more = {"date": str, "older": ""}
    assert "1.77 at most" in written(template, other, more)[0]
    with pytest.raises(BookError, match="name it in book/quoted"):
        written(template, [one for one in NUMBERS if one.name != "bars.largest_work"], more)


def test_measuring_a_page_measures_all_that_it_quotes(monkeypatch):
    done = []
    monkeypatch.setattr("book.measure._run", lambda one, build: done.append(one.name))
    monkeypatch.setattr("book.measure._take_in", lambda one, build: None)
    monkeypatch.setattr("book.measure.sign", lambda one, made: None)
    monkeypatch.setattr("book.measure.keep_dates", lambda: None)
    measure(["README.md"])
    assert set(done) >= {"loading_paths", "uniform_stress", "peers", "silica_four", "printed"}
    assert len(set(done)) == len(done)
    with pytest.raises(BookError, match="no measurement 'READYOU"):
        measure(["READYOU.md"])


def test_several_numbers_are_a_range_and_a_bound_is_not_below_its_number():
    one = NUMBERS[0]
    assert replace(one, values=(0.91, 1.14), scatter=None, form=replace(one.form, style=".2f")).text == "0.91 to 1.14"
    assert ceiling(2.1e-7) == pytest.approx(3e-7)
    assert ceiling(3e-7) == pytest.approx(3e-7)


def test_older_results_are_listed_until_they_are_measured_again(monkeypatch):
    from book.pages import chapters

    book = chapters()
    monkeypatch.setattr("book.dates.is_older", lambda record, change: record.name == "strength")
    assert "(`strength`)" in words(book)["older"]
    monkeypatch.setattr("book.dates.is_older", lambda record, change: False)
    assert words(book)["older"] == ""
