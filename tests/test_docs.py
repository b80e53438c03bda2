"""The documentation: Sphinx builds it without a warning, and the reference has every public name."""

import re
import subprocess
import sys
from pathlib import Path

import bondem as bd

DOCS = Path(__file__).parents[1] / "docs"


def test_the_reference_has_every_public_name():
    text = (DOCS / "api.md").read_text(encoding="utf-8")
    told = re.findall(r"auto(?:class|function|data):: bondem\.([\w.]+)", text)
    assert len(set(told)) == len(told)
    ours = set(bd.__all__) - {"__version__", "errors", "labtests", "materials"}
    assert {name for name in told if "." not in name} == ours
    assert {name for name in told if "." in name} >= {f"labtests.{name}" for name in bd.labtests.__all__}


def test_sphinx_builds_it_without_a_warning(tmp_path):
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-d", str(tmp_path / "trees")]
    done = subprocess.run(
        [*command, str(DOCS), str(tmp_path / "html")], capture_output=True, text=True, timeout=300, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "class bondem.CellBond" in re.sub("<[^>]*>", "", (tmp_path / "html" / "api.html").read_text("utf-8"))
