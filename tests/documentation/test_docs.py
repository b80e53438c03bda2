"""The documentation: Sphinx reads it without a warning, and the reference has every public name.

Sphinx parses the pages and resolves all references. It writes no HTML, which takes three times as long; theme and
search index are built by `.github/workflows/docs.yml`.
"""

import importlib
import operator
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest

import bondem as bd

DOCS = Path(__file__).parents[2] / "docs"
CODE = re.compile(r"^```.*?^```$|`[^`\n]+`", re.MULTILINE | re.DOTALL)


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Folder of the trees of the pages that Sphinx makes; the extra `docs` brings it."""
    for needed in ("sphinx", "myst_parser", "furo"):
        pytest.importorskip(needed)
    folder = tmp_path_factory.mktemp("pages")
    command = [sys.executable, "-m", "sphinx", "-b", "dummy", "-q", "-W", "--keep-going", "-D", "plot_gallery=0"]
    places = ["-d", str(folder / "trees"), str(DOCS), str(folder / "out")]
    done = subprocess.run([*command, *places], capture_output=True, text=True, timeout=600, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return folder / "trees"


def page(path):
    """The text of a page."""
    return pickle.loads(path.read_bytes()).astext()


REFERENCE = {path.stem: path.read_text(encoding="utf-8") for path in sorted((DOCS / "reference").glob("*.md"))}


def listed(text):
    """Public names that a page of the reference lists."""
    return re.findall(r"^   ~bondem\.([\w.]+)$", text, re.MULTILINE)


def test_the_reference_has_every_public_name():
    names = [name for text in REFERENCE.values() for name in listed(text)]
    assert len(set(names)) == len(names)
    ours = set(bd.__all__) - {"__version__", "errors", "labtests", "materials"}
    assert {name for name in names if "." not in name} == ours
    assert {name for name in names if "." in name} >= {f"labtests.{name}" for name in bd.labtests.__all__}
    assert all(re.search(rf"^{page}$", REFERENCE["index"], re.MULTILINE) for page in REFERENCE if page != "index")


def test_the_reference_keeps_what_one_calls_apart_from_what_one_gets():
    """No page of the documentation makes a result by its class, and functions are not among results."""
    code = "".join(path.read_text(encoding="utf-8") for path in DOCS.rglob("*.md"))
    for text in REFERENCE.values():
        for name in listed(text.partition("## What you get")[2].partition("## Types")[0]):
            assert isinstance(operator.attrgetter(name)(bd), type), name
            assert f"bd.{name}(" not in code, name
        for name in listed(text.partition("## What you get")[0]):
            assert callable(operator.attrgetter(name)(bd)), name


def test_scripts_of_the_gallery_have_twenty_lines_of_code_in_eighty_columns():
    for script in (DOCS.parent / "examples" / "gallery").glob("*.py"):
        source = script.read_text(encoding="utf-8")
        code = source.split('"""')[2].splitlines()  # behind the title and its text
        assert len([line for line in code if line and not line.startswith(("import", "from"))]) <= 20, script.name
        assert max(map(len, source.splitlines())) <= 80, script.name


def test_code_of_the_pages_has_eighty_columns():
    pages = [page for page in sorted(DOCS.rglob("*.md")) if "decisions" not in page.parts]
    long = [
        f"{page.name}: {line}" for page in pages
        for code in re.findall(r"^```(?:python|sh|toml)\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S)
        for line in code.splitlines() if len(line) > 80
    ]  # fmt: skip
    assert not long


def test_a_notebook_has_the_code_of_its_page(monkeypatch):
    pytest.importorskip("jupytext")
    monkeypatch.syspath_prepend(str(DOCS))
    notebooks = importlib.import_module("notebooks")
    assert {"start/first_crack", "start/own_part", "guides/from_pfc", "guides/materials"} <= {*notebooks.pages()}
    for name in notebooks.pages():
        text = (DOCS / f"{name}.md").read_text(encoding="utf-8")
        code = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        cells = [cell.source for cell in notebooks.notebook(name).cells]
        assert [one.strip() for one in code] == [one for one in cells if one in {part.strip() for part in code}]
        assert not [one for one in cells if one.startswith("```text")]  # what the cell above prints
        assert not [one for one in cells if "](" in one.replace("](http", "")]  # links to other pages


@pytest.mark.validate
@pytest.mark.parametrize("name", ["start/first_crack", "guides/from_pfc"])
def test_a_notebook_runs_in_a_kernel(name, monkeypatch, tmp_path):
    pytest.importorskip("jupytext")
    client = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    monkeypatch.syspath_prepend(str(DOCS))
    made = importlib.import_module("notebooks").notebook(name)
    client.NotebookClient(made, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert any(output.get("text") for cell in made.cells for output in cell.get("outputs", ()))


def test_formulas_of_the_pages_become_mathml():
    convert = pytest.importorskip("latex2mathml.converter").convert
    formulas = [
        found.strip("$") for path in DOCS.rglob("*.md")
        for found in re.findall(r"\$\$.+?\$\$|\$[^$\n]+\$", CODE.sub("", path.read_text(encoding="utf-8")), re.DOTALL)
    ]  # fmt: skip
    assert len(formulas) > 60
    for formula in formulas:  # a command that is not known stays as it is written
        assert "\\" not in convert(formula), formula
    conf = (DOCS / "conf.py").read_text(encoding="utf-8")
    assert "mathjax" not in conf
    assert "intersphinx" not in conf  # pages are made and read without a network


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


def test_no_example_template_or_guide_speaks_of_compilation_at_run_time():
    root = DOCS.parent
    pages = [*(root / "examples").rglob("*.py"), *(root / "examples").glob("*.toml"), *(DOCS / "guides").glob("*.md"),
             *(root / "src/bondem/study/templates").glob("*.toml"), *(DOCS / "start").glob("*.md")]  # fmt: skip
    said = re.compile(r"once compiled|after compilation|(?:for|of) compilation")
    assert not [page.name for page in pages if said.search(page.read_text(encoding="utf-8"))]
