"""Files and commands that text and records name exist."""

import json
import re
import shlex
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path, PurePosixPath

import pytest

from book.measurements import MEASUREMENTS
from book.results import RESULTS
from validation.__main__ import NAMES, validation

ROOT = Path(__file__).parents[2]
ENDINGS = "py|md|json|toml|hpp|cpp|html|png|svg|stl"
#: A path with a folder, and the name of a source in a line of code of its own.
PATH = re.compile(rf"(?<![\w./<~}}-])((?:[\w-]+/)+[\w-]+\.(?:{ENDINGS}))(?![\w/]|\.\w)")
SOURCE = re.compile(r"`(\w+\.(?:py|hpp|cpp))`")
#: A command with options in a line of text.
INLINE = re.compile(r"`python -m validation (?!NAME)\w+ [^`…[\\\n]+`")
STUDY = re.compile(r"python -m validation (\w+)")
#: Folders in which paths begin, beside the repository and the folder of the text.
FROM = ("src/", "src/bondem/", "src/bondem/core/", "benchmarks/", "validation/", "docs/")
#: What stands for a name, what is written when a command runs, and a file that a build writes.
STANDS_FOR = re.compile(r"(?:NAME|DIR|BUILD|FILE|SEED|STUDY)|^(?:out|figures)/|_version\.py$")
#: Decisions that others have replaced: what they name is history.
HISTORY = "docs/decisions/archive/"
#: A link of a page to another file.
LINK = re.compile(r"\[[^]]*\]\((?!https?:|mailto:|#)([^)#\s]+)")


@cache
def files() -> frozenset[str]:
    """Files of the repository, with those that are to be added."""
    words = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    found = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    return frozenset(one for one in found if (ROOT / one).exists())


@cache
def texts() -> dict[str, str]:
    """What may name files: all text but tests, which make files of their own, and decisions that are history."""
    endings = {".py", ".md", ".toml", ".yml", ".hpp", ".cpp", ".json"}
    wanted = [one for one in sorted(files()) if PurePosixPath(one).suffix in endings]
    wanted = [one for one in wanted if not one.startswith(("tests/", HISTORY))]
    return {one: (ROOT / one).read_text(encoding="utf-8") for one in wanted}


def missing(place: str, text: str) -> Iterator[str]:
    """What a text names and the repository does not have."""
    names = {PurePosixPath(one).name for one in files()}
    for named in PATH.findall(text):
        beside = (PurePosixPath(place).parent / named).as_posix()
        if not STANDS_FOR.search(named) and not {named, beside, *(start + named for start in FROM)} & files():
            yield named
    yield from (one for one in SOURCE.findall(text) if one not in names)
    known = {*NAMES, "NAME", "STUDY"}
    yield from (f"python -m validation {one}" for one in STUDY.findall(text) if one not in known)


def test_files_and_studies_that_text_names_exist() -> None:
    found = {place: lost for place, text in texts().items() if (lost := list(missing(place, text)))}
    assert not found


def test_a_name_that_no_file_has_is_found() -> None:
    text = "`core/laws/beam.hpp`, `core/laws/beem.hpp`, `step_bond.py`, python -m validation rung, DIR/rows/NAME.json"
    assert list(missing("docs/x.md", text)) == ["core/laws/beem.hpp", "step_bond.py", "python -m validation rung"]


def broken_links(page: Path, text: str) -> list[str]:
    """Links of a page that lead to no file, code left out."""
    prose = re.sub(r"(?ms)^```.*?^```$|`[^`\n]+`", "", text)
    return [link for link in LINK.findall(prose) if not (page.parent / link).exists()]


def test_links_of_pages_lead_to_files() -> None:
    pages = [ROOT / one for one in sorted(files()) if one.endswith(".md") and not one.startswith("book/")]
    found = {page.name: lost for page in pages if (lost := broken_links(page, page.read_text(encoding="utf-8")))}
    assert not found


def test_a_link_that_leads_nowhere_is_found() -> None:
    text = "[here](index.md), [there](../docs/gone.md#part), [code](https://x.org/y), `[a](b.md)`"
    assert broken_links(ROOT / "docs/x.md", text) == ["../docs/gone.md"]


def commands() -> dict[str, str]:
    """Commands of studies that the book, records and pages name, and where."""
    named = {one.command: one.name for one in MEASUREMENTS}
    for path in RESULTS.glob("*.json"):
        found = json.loads(path.read_text(encoding="utf-8"))
        if isinstance(found, dict) and isinstance(found.get("command"), str):
            named.setdefault(found["command"], path.stem)
    for place, text in texts().items():
        named |= {one.strip("`"): place for one in INLINE.findall(text)} if place.endswith(".md") else {}
    parts = {part: where for command, where in named.items() for part in command.split(" && ")}
    return {part: where for part, where in parts.items() if part.startswith("python -m validation ")}


@pytest.mark.parametrize("command", sorted(commands()))
def test_studies_accept_the_options_of_recorded_commands(command: str) -> None:
    name, *options = shlex.split(command)[3:]
    with validation.make_context("validation", []) as context:
        study = validation.get_command(context, name)
        assert study is not None
        study.make_context(name, options)


def test_the_table_of_studies_has_each_of_them_and_who_shows_it() -> None:
    listed = re.findall(r"^\| `(\w+)` \| .* \| (.+) \|$", (ROOT / "validation/README.md").read_text(), re.MULTILINE)
    assert set(NAMES) <= {name for name, _ in listed}
    assert not [name for name, shown in listed if "](../" not in shown]
