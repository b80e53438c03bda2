"""Bondem with nothing but the packages that it declares: those of tests and extras are not there."""

import os
import subprocess
import sys
import tomllib
from collections.abc import Iterable
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement

import bondem

ROOT = Path(__file__).parents[2]


DECLARED = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"]


def add_needed(requirements: Iterable[str], found: dict[str, Distribution]) -> None:
    """Collect the packages of some requirements, and those that these ask for without extras, by name."""
    for asked in map(Requirement, requirements):
        if asked.name not in found and (asked.marker is None or asked.marker.evaluate({"extra": ""})):
            found[asked.name] = distribution(asked.name)
            add_needed(found[asked.name].requires or (), found)


def test_what_pip_installs_alone_is_enough(tmp_path: Path) -> None:
    packages = tmp_path / "packages"
    packages.mkdir()
    found: dict[str, Distribution] = {}
    add_needed(DECLARED, found)
    for one in found.values():
        for top in {file.parts[0] for file in one.files or () if file.parts[0] not in ("..", "__pycache__")}:
            if not top.endswith(".pth"):
                (packages / top).symlink_to(one.locate_file(top))
    path = os.pathsep.join([str(packages), str(Path(bondem.__file__).parents[1])])
    # -S leaves out the packages of this environment
    done = subprocess.run(
        [sys.executable, "-S", ROOT / "tests" / "clean_install.py"], capture_output=True, text=True, cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": path}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("works") == 3
    probe = [sys.executable, "-S", "-c", "import pytest"]
    assert subprocess.run(probe, capture_output=True, env=os.environ | {"PYTHONPATH": path}, check=False).returncode
