"""What a long call shows: lines elsewhere than on a terminal, and records of `logging`."""

import logging
import os
import subprocess
import sys
import time

import pytest

import bondem as bd
from bondem import _progress
from bondem._progress import Board, quiet, reported, staged, stages
from bondem.errors import InputError
from tests.models import torn_row


@pytest.fixture
def lines(monkeypatch, capsys):
    """Lines on stderr, shown soon."""
    monkeypatch.setattr(_progress, "_DELAY", 0.02)
    monkeypatch.setattr(_progress, "_EVERY", 0.05)
    monkeypatch.setattr(_progress._Chosen, "mode", "lines")
    return lambda: capsys.readouterr().err.splitlines()


def test_a_run_from_python_says_what_it_does(lines) -> None:
    model, seen = torn_row(), []
    bd.solve_explicit(model, duration=2e-4, every=20, imbalance=None, callback=lambda *_: time.sleep(0.005))
    seen = lines()
    assert seen[0].endswith("s  explicit run")
    assert any("explicit run: " in line and " %" in line for line in seen[1:])
    bd.solve_explicit(model, duration=2e-4, imbalance=None, progress=lambda share: time.sleep(0.05))
    assert lines() == []  # whoever asks for the share shows it


def test_the_outermost_call_is_shown_alone(lines) -> None:
    @staged("inner")
    def inner() -> None:
        time.sleep(0.05)

    @staged("outer")
    def outer() -> None:
        inner()

    outer()
    assert {line.split("  ")[-1].partition(":")[0] for line in lines()} == {"outer"}
    with quiet():
        outer()
    assert lines() == []


def test_stages_are_lines_and_records(lines, caplog) -> None:
    with caplog.at_level(logging.INFO, "bondem"), stages(at_once=True) as tell:
        for stage in ("pack", "test"):
            tell(stage, 0.0)
            tell(stage, 1.0)
    assert [line.split()[-1] for line in lines()] == ["pack", "test"]
    assert [record.getMessage().partition(":")[0] for record in caplog.records] == ["pack", "pack", "test", "test"]
    told = []
    with reported(lambda *word: told.append(word)) as tell:
        tell("pack", 0.5)
    assert (told, lines()) == ([("pack", 0.5)], [])


def test_programs_choose(monkeypatch) -> None:
    with pytest.raises(InputError, match="mode = 'loud' is unknown; give one of auto, bars, lines, off"):
        bd.show_progress("loud")
    monkeypatch.setattr(_progress._Chosen, "mode", "auto")
    assert Board(delay=100.0).kind == "lines"
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    assert Board(delay=100.0).kind == "bars"
    bd.show_progress("off")
    assert Board(delay=100.0).kind == "off"


def test_a_program_with_logging_gets_records_and_no_lines() -> None:
    code = """
import logging
logging.basicConfig(level=logging.INFO, format="%(name)s %(levelname)s %(message)s")
from bondem._progress import stages
with stages(at_once=True) as tell:
    tell("pack", 0.0)
"""
    asked = {key: value for key, value in os.environ.items() if key != "BONDEM_PROGRESS"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=asked, check=True)
    assert done.stderr.splitlines() == ["bondem INFO pack"]
