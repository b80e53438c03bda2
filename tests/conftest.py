"""Options of the test suite: slow validation runs only when asked for, device tests only where there is one."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import bondem as bd
from bondem._threads import threads

# What tests pack is packed anew, here and in the processes they start; those of the cache turn it on.
os.environ["BONDEM_PACKING_CACHE"] = "off"

# Tests of progress turn it on.
os.environ.setdefault("BONDEM_PROGRESS", "off")

# Failing tests show where an error was raised; those of short tracebacks turn it off.
os.environ.setdefault("BONDEM_TRACEBACK", "full")

# Processes that tests start import the package as bytecode, which the first of them writes.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# Workers of pytest-xdist share the cores: libraries of linear algebra would start as many threads as cores in each.
for _library in ("OPENBLAS", "OMP", "MKL"):
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")

pytest_plugins = ("tests.recording",)

_OPTIONS = {"validate": "--validate", "gpu": "--gpu", "sanitize": "--sanitize"}


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--validate", action="store_true", help="run the slow tests too: published numbers, studies")
    parser.addoption("--gpu", action="store_true", help="run the tests that need a CUDA device too")
    parser.addoption("--sanitize", action="store_true", help="run the tests of the core with g++'s sanitizers too")


def pytest_configure(config: pytest.Config) -> None:
    # A device then agrees with the CPU except for functions such as cos: neither fuses products and sums.
    if config.getoption("--gpu"):
        os.environ |= {"BONDEM_ISA": "v2", "BONDEM_CUDA_FMA": "off"}
    # For the same reason solvers run on one thread there, unless a test sets another number.
    if hasattr(config, "workerinput"):
        bd.set_threads(1)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for marker, option in _OPTIONS.items():
        if config.getoption(option):
            continue
        skip = pytest.mark.skip(reason=f"needs {option}")
        for item in items:
            if item.get_closest_marker(marker):
                item.add_marker(skip)


@pytest.fixture
def write(tmp_path: Path) -> Callable[[str, str], Path]:
    """Writes a text into a file of the test's folder, and returns its path."""

    def to(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text)
        return path

    return to


@pytest.fixture
def one_thread() -> Iterator[None]:
    """Small models: threads would only wait for each other."""
    with threads(1):
        yield
