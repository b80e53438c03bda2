"""Rules of the house that a machine can check."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import bondem
from bondem.interactions.law_catalogue import LAWS

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted((ROOT / "src").rglob("*.py"))
FOLDERS = ("tests", "examples", "benchmarks", "book", "validation")
ALL = SOURCES + [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")]


def test_no_file_is_longer_than_400_lines():
    long = {str(path.relative_to(ROOT)): n for path in ALL if (n := len(path.read_text().splitlines())) > 400}
    assert not long


def test_results_name_no_path_of_a_machine():
    named = re.compile(r'"command": "[^"]*[ =]/')
    results = (ROOT / "benchmarks/results").glob("*.json")
    assert not [path.name for path in results if named.search(path.read_text(encoding="utf-8"))]


def test_examples_fit_on_a_screen():
    long = [path.name for path in (ROOT / "examples").glob("*.py") if len(path.read_text().splitlines()) > 60]
    assert not long


def test_no_room_without_a_name():
    attic = re.compile(r"^(utils?|helpers?|common|misc|tools|manager)$", re.IGNORECASE)
    assert not [path for path in ALL if any(attic.match(part) for part in path.with_suffix("").parts[-3:])]


def test_no_import_is_hidden_in_a_function_or_under_type_checking():
    lazy = {ROOT / "src/bondem/__init__.py"}
    pattern = re.compile(r"^[ \t]+(import \w|from [\w.]+ import )", re.MULTILINE)
    suspects = [path for path in SOURCES if path not in lazy]
    hidden = [str(path.relative_to(ROOT)) for path in suspects if pattern.search(path.read_text())]
    assert not hidden


def test_importing_the_package_is_cheap_and_every_public_name_resolves():
    code = (
        "import sys, bondem; assert 'numpy' not in sys.modules and 'scipy' not in sys.modules;"
        "[getattr(bondem, name) for name in bondem.__all__]"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)


#: Modules that are for bonds of one law, and why.
OF_ONE_LAW = {
    "interactions/beams/contact_bond.py": ("ParallelBond", "it is made from them: the same bonds without moments"),
}
#: Laws that share their name with the beam theory that tests are held against: words may name it, code may not.
THEORIES = {"Timoshenko"}


@pytest.mark.parametrize("law", LAWS)
def test_a_law_is_named_in_its_own_file_the_catalogue_and_the_public_names_only(law):
    package = ROOT / "src/bondem"
    own = re.sub("(?<!^)(?=[A-Z])", "_", law).lower()
    assert LAWS[law].__module__ == f"bondem.interactions.beams.{own}"
    listed = {f"interactions/beams/{own}.py", "interactions/law_catalogue.py"}
    files = [path for ending in ("py", "html", "json") for path in package.rglob(f"*.{ending}")]
    naming = {str(path.relative_to(package)) for path in files if _names(path, law)}
    assert naming >= listed
    others = naming - listed - {"__init__.py"}
    assert others == {path for path, (one, _) in OF_ONE_LAW.items() if one == law}
    assert law in bondem.__all__


def _names(path: Path, law: str) -> bool:
    text = path.read_text()
    if law not in text:
        return False
    if law not in THEORIES:
        return re.search(rf"\b{law}\b", text) is not None
    nodes = ast.walk(ast.parse(text)) if path.suffix == ".py" else ()
    return any(getattr(node, kind, None) == law for node in nodes for kind in ("id", "attr", "name"))
