"""The script that follows README: lines in order, in one shell, until one fails."""

import os
import sys

import pytest

from tests.documentation.follow_readme import ROOT, follow, steps

PAGE = """
```sh
mkdir inside && cd inside && place=here
echo REPOSITORY > address
```
```python
print("printed")
```
```text
{printed}
```
```sh
test "$place" = here && test "$(basename "$PWD")" = inside && touch done
pytest -n auto
```
"""


@pytest.fixture(autouse=True)
def _python_on_path(monkeypatch, tmp_path):
    """Provide the command `python`, which some machines lack outside a virtual environment."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin/python").symlink_to(sys.executable)
    monkeypatch.setenv("PATH", os.pathsep.join((str(tmp_path / "bin"), os.environ["PATH"])))


def test_blocks_are_carried_out_in_one_shell_with_an_empty_home(tmp_path, capfd):
    assert follow(PAGE.format(printed="printed"), tmp_path / "new") == 0
    assert (tmp_path / "new/work/inside/done").exists()
    assert (tmp_path / "new/work/inside/address").read_text().strip() == str(ROOT)
    assert "every line works" in capfd.readouterr().out


def test_a_line_that_fails_or_prints_otherwise_ends_it(tmp_path, capfd):
    assert follow(PAGE.format(printed="other"), tmp_path / "new") == 1
    assert "failed with status 1: diff" in capfd.readouterr().out
    assert not (tmp_path / "new/work/inside/done").exists()


def test_the_tests_are_run_only_if_asked_for(tmp_path):
    page = (ROOT / "README.md").read_text(encoding="utf-8")
    assert not any("pytest -n" in line for line in steps(page, tmp_path))
    lines = list(steps(page, tmp_path, tests=True))
    assert any("pytest -n" in line for line in lines)
    assert lines[0].startswith("git clone /")
