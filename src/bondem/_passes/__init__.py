"""Passes of the core with their tables, written by `python -m tests.core.passes` from the library."""

from typing import Any, NamedTuple


class StepEntry(NamedTuple):
    """An entry of a list of a step: a pass with its tables."""

    name: str
    tables: tuple[Any, ...]


class Kernel(NamedTuple):
    """A pass over an index with its tables: a thread of a device does one."""

    name: str
    tables: tuple[Any, ...]


class Call(NamedTuple):
    """A pass that Python calls, with its tables."""

    name: str
    tables: tuple[Any, ...]
