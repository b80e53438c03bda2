"""The documentation: Sphinx reads it without a warning, and the reference has every public name.

Sphinx parses the pages and resolves all references. It writes no HTML, which takes three times as long; theme and
search index are built by `.github/workflows/docs.yml`.
"""

import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest

import bondem as bd

DOCS = Path(__file__).parents[2] / "docs"


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Folder of the trees of the pages that Sphinx makes; the extra `docs` brings it."""
    for needed in ("sphinx", "myst_parser", "furo"):
        pytest.importorskip(needed)
    folder = tmp_path_factory.mktemp("pages")
    command = [sys.executable, "-m", "sphinx", "-b", "dummy", "-q", "-W", "--keep-going", "-d", str(folder / "trees")]
    done = subprocess.run(
        [*command, str(DOCS), str(folder / "out")], capture_output=True, text=True, timeout=600, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return folder / "trees"


def page(path):
    """The text of a page."""
    return pickle.loads(path.read_bytes()).astext()


def test_the_reference_has_every_public_name():
    text = (DOCS / "reference" / "index.md").read_text(encoding="utf-8")
    listed = re.findall(r"^   ~bondem\.([\w.]+)$", text, re.MULTILINE)
    assert len(set(listed)) == len(listed)
    ours = set(bd.__all__) - {"__version__", "errors", "labtests", "materials"}
    assert {name for name in listed if "." not in name} == ours
    assert {name for name in listed if "." in name} >= {f"labtests.{name}" for name in bd.labtests.__all__}


@pytest.mark.validate
def test_every_name_has_a_page_of_its_own_with_readable_types(pages):
    names = pages / "reference" / "names"
    assert {f"bondem.{name}" for name in bd.labtests.__all__} - {one.stem for one in names.iterdir()} != set()
    text = page(names / "bondem.CellBond.doctree")
    assert "class bondem.CellBond" in text
    assert "Example" in text
    assert "ndarray" not in page(names / "bondem.Particles.doctree")


@pytest.mark.validate
def test_most_names_of_use_have_an_example(pages):
    made = [page(one) for one in (pages / "reference" / "names").glob("bondem.*.doctree")]
    assert sum("Example" in one for one in made) >= 90


def test_the_pages_are_in_the_order_of_a_reader():
    text = (DOCS / "index.md").read_text(encoding="utf-8")
    order = re.findall(r"^:caption: (\w+)$", text, re.MULTILINE)
    assert order == ["Start", "Guides", "Theory", "Validation", "Reference", "More"]
