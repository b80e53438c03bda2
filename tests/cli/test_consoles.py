"""Consoles of other encodings, full disks behind a pipe, and pipes whose reader ends."""

import json
import os
import subprocess
import sys

import pytest

from bondem.cli.streams import in_ascii
from bondem.study.template_files import template
from tests.clean_install import STUDY


def bondem(command: str, encoding: str = "utf-8", **options) -> subprocess.CompletedProcess:
    """Run a command in a shell as `bondem`, with a console of this encoding."""
    program = f'bondem() {{ {sys.executable} -c "from bondem.cli import main; main()" "$@"; }}; {command}'
    return subprocess.run(
        ["bash", "-c", program], capture_output=True, timeout=100, check=False,
        env=os.environ | {"PYTHONIOENCODING": encoding, "PYTHONUNBUFFERED": ""}, **options,
    )  # fmt: skip


@pytest.mark.parametrize(("encoding", "told"), [("cp1252", "nu and rho"), ("ascii", ""), ("utf-8", "ν and ρ")])
def test_help_is_shown_on_every_console(encoding, told):
    done = bondem("bondem --help", encoding)
    assert done.returncode == 0
    assert done.stderr == b""
    assert f"Calibrate bonds to E, {told}" in done.stdout.decode("utf-8" if encoding == "ascii" else encoding)


def test_a_schema_is_json_whatever_the_console():
    done = bondem("bondem schema", "cp1252")
    assert json.loads(done.stdout.decode("utf-8"))["properties"]


def test_studies_are_checked_on_a_console_of_windows(tmp_path):
    (tmp_path / "s.toml").write_text(template("silica", "s.toml"), encoding="utf-8")
    done = bondem("bondem check s.toml", "cp1252", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "mm³" in done.stdout.decode("cp1252")


def test_output_on_a_full_disk_is_one_line():
    done = bondem("bondem --help > /dev/full")
    assert done.returncode == 2
    assert done.stderr == b"bondem: No space left on device; make room or choose another place\n"
    # where nobody can be told, the status is
    assert bondem("bondem --help > /dev/full 2> /dev/full").returncode == 2


def test_a_disk_that_is_full_at_the_first_figure_is_one_line_and_keeps_the_numbers(tmp_path):
    (tmp_path / "s.toml").write_text(STUDY.replace("false", "true"), encoding="utf-8")
    done = bondem("ulimit -f 20; PYTHONDONTWRITEBYTECODE=1 bondem run s.toml --out out", cwd=tmp_path)
    assert done.returncode == 2
    last = done.stderr.decode().splitlines()[-1]
    assert "figures/specimen.png' could not be written (File too large); make room" in last
    assert "Traceback" not in done.stderr.decode()
    assert json.loads((tmp_path / "out" / "results.json").read_text())["tests"]


def test_a_reader_that_has_seen_enough_is_no_error():
    done = bondem("set -o pipefail; bondem --help | true")
    assert (done.returncode, done.stderr) == (1, b"")


def test_characters_are_spelled_where_they_have_no_place():
    assert in_ascii("ν = 0.2, ρ ≤ 2 Mg/m³ ± 3 %, R̄ × 2 – Σ “Körper” ✓") == (
        "nu = 0.2, rho <= 2 Mg/m3 +- 3 %, R x 2 - Sigma 'Korper' ?"
    )
