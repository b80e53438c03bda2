"""The changelog stays readable: one section per version, short sections, short entries."""

import re
from pathlib import Path

TEXT = (Path(__file__).resolve().parents[2] / "CHANGELOG.md").read_text(encoding="utf-8")
LINES, WORDS = 80, 25
SECTIONS = re.split(r"^## ", TEXT, flags=re.MULTILINE)[1:]


def _entries() -> list[str]:
    return re.findall(r"^- .*(?:\n {2,}\S.*)*", TEXT, flags=re.MULTILINE)


def _words(entry: str) -> int:
    return len(re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", entry.removeprefix("- ")).split())


def test_every_version_has_one_short_section():
    titles = [section.splitlines()[0] for section in SECTIONS]
    assert "[0.1.0]" in titles
    assert len(set(titles)) == len(titles)
    long = {title: n for title, section in zip(titles, SECTIONS, strict=True) if (n := _lines(section)) > LINES}
    assert not long, f"sections of more than {LINES} lines: {long}; combine entries of one subject"


def _lines(section: str) -> int:
    return len(section.rstrip().splitlines())


def test_every_entry_is_short():
    long = {entry: n for entry in _entries() if (n := _words(entry)) > WORDS}
    assert len(_entries()) > 20
    assert not long, f"entries of more than {WORDS} words: {long}; name the effect for the user and link a page"


def test_every_section_groups_its_entries_once():
    for section in SECTIONS:
        groups = re.findall(r"^### (.*)$", section, flags=re.MULTILINE)
        assert len(set(groups)) == len(groups)
        assert set(groups) <= {"Added", "Changed", "Fixed", "Removed"}
