"""Numbers that tests measure on their way and the book quotes: `pytest --record=FILE` keeps them.

A test asks for the fixture `record` and calls `record("name", value, ...)`; of all values that a name is given, in
any test, the least and the largest are kept. Only tests that record are run then, in one process, and the file is
written when all of them passed. Without the option nothing is kept. Before this file is loaded pytest does not know
the option, and would take a FILE that stands apart for what it should run: hence the sign of equality.
"""

import datetime
import json
import math
import sys
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

from validation.frame.sources import commit

Record = Callable[..., None]
_FIXTURE = "record"
_VERSIONS = ("bondem", "numpy", "scipy")
_NUMBERS = pytest.StashKey[dict[str, dict[str, Any]]]()
_COMMIT = pytest.StashKey[str]()


def pytest_addoption(parser: pytest.Parser) -> None:
    said = "run the tests that record numbers, and keep these as JSON"
    parser.addoption("--record", type=Path, metavar="FILE", help=said)


def pytest_configure(config: pytest.Config) -> None:
    config.stash[_NUMBERS] = {}
    if not config.getoption("--record"):
        return
    config.stash[_COMMIT] = commit()
    if config.getoption("numprocesses", None) or hasattr(config, "workerinput"):
        raise pytest.UsageError("--record needs all tests in one process: leave out -n")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--record"):
        return
    kept, left_out = [], []
    for item in items:
        (kept if _FIXTURE in getattr(item, "fixturenames", ()) else left_out).append(item)
    config.hook.pytest_deselected(items=left_out)
    items[:] = kept


@pytest.fixture
def record(request: pytest.FixtureRequest) -> Record:
    """Keeps numbers, or what is so, under a name: `record("order", 2.01, 2.06)`, `record("same bits", True)`."""
    numbers = request.config.stash[_NUMBERS]

    def keep(name: str, *values: float) -> None:
        found = [bool(value) if isinstance(value, bool) else float(value) for value in values]
        if not found or not all(math.isfinite(value) for value in found):
            raise ValueError(f"'{name}' = {values}: finite numbers are recorded, one at least")
        known = numbers.setdefault(name, {"least": found[0], "largest": found[0], "values": 0, "tests": []})
        known["least"], known["largest"] = min(known["least"], *found), max(known["largest"], *found)
        known["values"] += len(found)
        test = request.node.nodeid.partition("[")[0]
        if test not in known["tests"]:
            known["tests"].append(test)

    return keep


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    path = session.config.getoption("--record")
    if path is None:
        return
    terminal = session.config.pluginmanager.get_plugin("terminalreporter")
    say = terminal.write_line if terminal else print
    if exitstatus != pytest.ExitCode.OK:
        say(f"\nnothing is kept in {path}: not all tests passed")
        return
    numbers = session.config.stash[_NUMBERS]
    kept = {**_origin(session.config), "numbers": dict(sorted(numbers.items()))}
    path.write_text(json.dumps(kept, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
    say(f"\n{len(numbers)} numbers in {path}")


def _origin(config: pytest.Config) -> dict[str, Any]:
    """Command, commit, date and versions."""
    python = ".".join(map(str, sys.version_info[:3]))
    return {
        "command": " ".join(["python -m pytest", *map(str, config.invocation_params.args)]),
        "commit": config.stash[_COMMIT],
        "date": datetime.datetime.now(datetime.UTC).date().isoformat(),
        "versions": {"python": python, **{name: version(name) for name in _VERSIONS}},
    }
