"""Messages about optional extras name a command that works: bondem is on no package index."""

import re
import tomllib
from pathlib import Path

import pytest

from bondem._extras import install, needed
from bondem.errors import MissingDependencyError

ROOT = Path(__file__).parents[2]
EXTRAS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
# What asks an index for bondem, with an extra or without.
FROM_AN_INDEX = re.compile(r"pip install [\"'`]*bondem")
READ = [
    path for folder in ("src", "docs", "examples", "benchmarks", "tests", ".github", "conda")
    for path in (ROOT / folder).rglob("*") if path.suffix in {".py", ".md", ".toml", ".yml", ".yaml", ".html"}
    and path != Path(__file__)
] + [ROOT / "README.md", ROOT / "CONTRIBUTING.md"]  # fmt: skip


def test_nothing_recommends_an_index():
    found = [str(path.relative_to(ROOT)) for path in READ if FROM_AN_INDEX.search(path.read_text(encoding="utf-8"))]
    assert found == []


def test_extras_that_are_named_exist():
    asked = re.compile(r"install\(\"?'?(\w+)\"?'?\)|needed\([^)]*, \"(\w+)\"\)|pip install -e [\"']?\.\[(\w+)\]")
    named = {
        next(filter(None, found)) for path in READ if path.suffix == ".py" and "src" in path.parts
        for found in asked.findall(path.read_text(encoding="utf-8"))
    } - {"extra"}  # fmt: skip
    assert {"view", "gpu", "campaign", "exchange"} <= named
    assert named <= set(EXTRAS)


def test_a_missing_library_names_what_works_from_a_clone():
    with pytest.raises(MissingDependencyError) as caught:
        needed("no_such_library", "view")
    assert str(caught.value).endswith('in a clone of bondem, run pip install -e ".[view]"')
    assert install("gpu") == 'in a clone of bondem, run pip install -e ".[gpu]"'
