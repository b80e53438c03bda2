"""`pytest --record=FILE`: the least and the largest of what tests record, and nothing where one failed."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from book.outcomes import TESTS as BOOK

ROOT = Path(__file__).parents[2]
TESTS = """
import pytest

@pytest.mark.parametrize("order", [2.0, 2.5, 1.5])
def test_of_an_order(order, record):
    record("order", order, order + 0.1)

def test_of_what_is_so(record):
    record("so", True)

def test_that_records_nothing():
    raise RuntimeError("is not run")
"""


def run(folder: Path, text: str, *options: str) -> subprocess.CompletedProcess[str]:
    (folder / "test_it.py").write_text(text)
    words = ["-m", "pytest", "-p", "tests.recording", "-c", "/dev/null", f"--rootdir={folder}", *options, str(folder)]
    return subprocess.run([sys.executable, *words], cwd=ROOT, capture_output=True, text=True, check=False)


def test_the_least_and_the_largest_are_kept_with_command_and_versions(tmp_path):
    done = run(tmp_path, TESTS, f"--record={tmp_path / 'kept.json'}")
    assert done.returncode == 0, done.stdout
    kept = json.loads((tmp_path / "kept.json").read_text())
    assert set(kept) == {"command", "commit", "date", "versions", "numbers"}
    assert "--record" in kept["command"]
    order, so = kept["numbers"]["order"], kept["numbers"]["so"]
    assert order == {"least": 1.5, "largest": 2.6, "values": 6, "tests": ["test_it.py::test_of_an_order"]}
    assert so["least"] is True


@pytest.mark.parametrize("broken", ["record('order', float('nan'))", "record('order')", "assert record is None"])
def test_nothing_is_kept_where_a_test_fails(tmp_path, broken):
    text = f"{TESTS}\ndef test_broken(record):\n    {broken}\n"
    done = run(tmp_path, text, f"--record={tmp_path / 'kept.json'}")
    assert done.returncode == 1
    assert "nothing is kept" in done.stdout
    assert not (tmp_path / "kept.json").exists()


def test_processes_side_by_side_are_refused(tmp_path):
    done = run(tmp_path, TESTS, f"--record={tmp_path / 'kept.json'}", "-n", "2")
    assert done.returncode == 4
    assert "leave out -n" in done.stderr


def test_without_the_option_all_tests_run_and_nothing_is_kept(tmp_path):
    done = run(tmp_path, TESTS)
    assert done.returncode == 1
    assert "is not run" in done.stdout
    assert "4 passed" in done.stdout


def test_the_command_of_the_book_finds_the_option_where_the_file_exists():
    words = BOOK.command.split()[1:]
    assert BOOK.path.exists()
    done = subprocess.run([sys.executable, *words, "--help"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "--record=FILE" in done.stdout
