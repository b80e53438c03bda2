"""Every snippet of README and docs does as printed: code and studies run, commands are ones there are."""

import os
import re
import shlex
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import click
import pytest

from bondem.cli import bondem
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from book.measurements import MEASUREMENTS
from book.printed import PRINTED, blocks, pages, run
from validation.__main__ import command as study_command

ROOT = Path(__file__).parents[2]
# What Sphinx writes or includes by its own directives.
DIRECTIVES = re.compile(r"^```\{\w[\w-]*\}\n.*?^```$\n", re.MULTILINE | re.DOTALL)
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
LANGUAGES = {"python", "toml", "sh", "text"}
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PROGRAMS = ("bondem", "python", "python3", "pytest", "pip", "git", "cd", "export", "dask", ".")
# Commands of seconds; all others take minutes to hours and are read only.
QUICK = ("bondem calibrate",)


@dataclass(frozen=True)
class Snippet:
    """A block of a page."""

    page: Path
    line: int
    language: str
    text: str

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT)}:{self.line}"


def read(page):
    """The text of a page, with directives of Sphinx blanked line by line."""
    return DIRECTIVES.sub(lambda found: "\n" * found.group().count("\n"), page.read_text(encoding="utf-8"))


def fenced(page):
    text = read(page)
    return [Snippet(page, text[: one.start()].count("\n") + 1, *one.groups()) for one in FENCE.finditer(text)]


def commands():
    """Every command of a shell block, or indented by four blanks, with what is behind # taken off."""
    found = []
    for page in PAGES:
        lines = [(one.line, line) for one in fenced(page) if one.language == "sh"
                 for line in one.text.replace("\\\n", "").splitlines()]  # fmt: skip
        outside = FENCE.sub("", read(page))
        lines += [(0, line.strip()) for line in re.findall(r"^    (\S.*)$", outside, re.MULTILINE)
                  if line.split()[0] in PROGRAMS]  # fmt: skip
        found += [pytest.param(part.strip(), id=f"{page.relative_to(ROOT)}:{number}: {part.strip()}")
                  for number, line in lines if not line.startswith("#") for part in line.split("&&")]  # fmt: skip
    return found


def shown():
    """What a page shows below a block of quick commands, for the first of them."""
    pairs = ((one, other) for page in PAGES for one, other in pairwise(fenced(page)))
    blocks = [(one.text, other.text) for one, other in pairs if (one.language, other.language) == ("sh", "text")]
    return {commands.splitlines()[0]: text for commands, text in blocks if commands.startswith(QUICK)}


SHOWN = shown()
BLOCKS = [block for page in PAGES for block in fenced(page)]
WITH_CODE = [page for page in PAGES if any(block.language == "python" for block in fenced(page))]
COMMANDS = commands()


def test_snippets_are_found_and_say_what_they_are():
    assert not [str(block) for block in BLOCKS if block.language not in LANGUAGES]
    assert {page.name for page in WITH_CODE} >= {"README.md", "calibration.md"}
    assert len(COMMANDS) >= 15
    assert SHOWN
    for page in PAGES:  # a fence that is not closed would hide what follows
        assert len(re.findall(r"^```", read(page), re.MULTILINE)) == 2 * len(fenced(page))


@pytest.fixture
def clone(tmp_path, monkeypatch):
    """Where a reader types: a clone, as far as snippets name its files."""
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    return tmp_path


# Pages whose code calibrates or breaks bodies of real sizes and takes 5 to 30 seconds.
LONG = {"calibration.md", "fracture.md", "laws.md", "own_part.md"}


@pytest.mark.parametrize("page", [
    pytest.param(page, id=str(page.relative_to(ROOT)), marks=[pytest.mark.validate] if page.name in LONG else [])
    for page in WITH_CODE
])  # fmt: skip
def test_code_runs_and_prints_what_the_page_prints(page, clone):
    done = list(run(page, read(page)))
    assert done
    for _, printed, expected in done:
        assert expected in (None, printed)  # every digit: results are the same bits on all levels of instructions


def test_the_record_of_what_is_printed_has_every_block_and_no_other():
    found = {key for page in pages() for key, _, output in blocks(page.read_text(encoding="utf-8")) if output}
    assert set(PRINTED.at("printed")) == found


@pytest.mark.parametrize("block", [block for block in BLOCKS if block.language == "toml"], ids=str)
def test_studies_run_as_printed(block, clone):
    results = run_study(parse_study(tomllib.loads(block.text), folder=clone), clone / "out")
    assert (clone / "out" / "report.html").is_file()
    assert all(abs(row["error"]) < 0.25 for row in results["tests"].values())


def words_of(command):
    words = shlex.split(command, comments=True)
    return [Path(words[0]).name or words[0], *words[1:]]


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_are_ones_there_are(command, clone):
    program, *rest = words_of(command)
    assert program in PROGRAMS
    if program == "bondem":
        node = bondem
        while isinstance(node, click.Group):
            name, *rest = rest
            node = node.get_command(click.Context(node), name)
            assert node is not None, name
        assert node.make_context(name, rest).params is not None
        named = [word for word in rest if word.endswith((".toml", ".h5"))]
    elif program in ("git", "cd"):
        assert rest[0] in ("clone", "bondem")
        named = []
    elif program == ".":
        assert rest == [".venv/bin/activate"]
        named = []
    elif program == "dask":
        assert rest[0] in ("scheduler", "worker")
        named = []
    elif program == "export":
        assert all("=" in word for word in rest)
        named = []
    elif rest[:2] == ["-m", "book"]:
        assert rest[2] == "--measure"
        assert set(rest[3:]) <= {one.name for one in MEASUREMENTS}
        named = []
    elif rest[:2] == ["-m", "validation"]:
        assert study_command(rest[2]).make_context(rest[2], rest[3:]).params is not None
        named = []
    else:
        assert rest[:2] in ([], ["-n", "auto"], ["-m", "venv"]) or not rest[0].startswith("-")
        named = [word for word in rest if word.endswith(".py")]
    assert all((ROOT / name).is_file() for name in named)


@pytest.mark.validate
@pytest.mark.parametrize("command", [one for one in COMMANDS if " ".join(words_of(one.values[0])).startswith(QUICK)])
def test_quick_commands_run(command, clone):
    folder = Path(sys.executable).parent
    environment = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"}
    done = subprocess.run(words_of(command), env=environment, cwd=clone, capture_output=True, text=True, timeout=600)
    assert (done.returncode, done.stderr) == (0, "")
    printed = {line.rstrip() for line in done.stdout.splitlines()}
    assert set(SHOWN.get(command, "").splitlines()) <= printed
