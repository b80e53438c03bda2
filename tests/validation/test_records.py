"""Studies that write one record: cases are measured once, and options are those of their function."""

import json
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from validation.__main__ import validation
from validation.frame.command import recording
from validation.frame.record import Record, command_line
from validation.frame.sources import REPOSITORY, commit


def squares(record: Record, *, counts: tuple[int, ...] = (1, 2), kinds: tuple[str, ...] = ("a", "b")) -> None:
    """Measure squares.

    Args:
        counts: numbers to square.
    """
    for count in counts:
        record.add(lambda count=count: {"square": count**2}, count=count, kind=kinds[0])
    record.keep(whole=len(record.rows()))


STUDY = SimpleNamespace(
    __doc__="Squares.", measure=squares, draw=lambda record, folder: (folder / "drawn").write_text(str(record.data))
)


def test_a_case_is_measured_once_and_the_file_is_written_after_each(tmp_path: Path) -> None:
    record = Record(tmp_path / "it.json", "a command")

    def fails() -> dict[str, int]:
        raise AssertionError

    record.add(lambda: [{"part": 1}, {"part": 2}], seed=1)
    again = Record(record.path, "another")
    again.add(fails, seed=1)
    assert again.rows() == [{"seed": 1, "part": part, "commit": commit()} for part in (1, 2)]
    with pytest.raises(AssertionError):
        again.add(fails, seed=2)
    again.keep(end=3)
    found = json.loads(record.path.read_text())
    assert (found["command"], found["end"], len(found["cases"])) == ("another", 3, 2)
    assert {"machine", "started", "version", "commit"} <= set(found)


def test_options_are_the_arguments_of_the_function(tmp_path: Path) -> None:
    out, made = tmp_path / "it.json", recording("validation", "it", STUDY)
    options = ["--counts", "3,4", "--kinds", "b", "--out", str(out)]
    assert CliRunner().invoke(made, options, catch_exceptions=False).exit_code == 0
    found = json.loads(out.read_text())
    assert [(one["count"], one["kind"], one["square"]) for one in found["cases"]] == [(3, "b", 9), (4, "b", 16)]
    assert found["whole"] == 2
    done = CliRunner().invoke(made, ["--out", str(out), "--figures", str(tmp_path / "new")], catch_exceptions=False)
    assert done.exit_code == 0
    assert "'whole': 2" in (tmp_path / "new" / "drawn").read_text()
    for wrong, said in ((["--counts", "x"], "commas"), (["--kinds", "a,c"], "choose from a, b")):
        assert said in CliRunner().invoke(made, wrong).output
    assert "numbers to square" in CliRunner().invoke(made, ["--help"]).output


def test_a_study_from_its_command(tmp_path: Path) -> None:
    out = tmp_path / "tables.json"
    done = CliRunner().invoke(validation, ["non_local_reach", "--failure", "Tresca", "--out", str(out)])
    assert done.exit_code == 2
    assert "Mohr-Coulomb" in done.output


def test_commands_name_no_path_of_a_machine() -> None:
    words = ["python", f"{REPOSITORY}/benchmarks/a.py", "--out", "/somewhere/else.json", "--bodies", "a, b"]
    assert command_line(words) == "python benchmarks/a.py --out BUILD/else.json --bodies 'a, b'"
