"""Number of threads on which solvers run."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache

from bondem._checks import count as whole_number
from bondem.errors import InputError

# Number of threads within a block of `threads`, in the Python thread that runs the block.
_WITHIN: ContextVar[int | None] = ContextVar("bondem_threads", default=None)


class _Process:
    """Number of threads of this process, None for all."""

    threads: int | None = None


@cache
def most_threads() -> int:
    """Return the largest number of threads: BONDEM_NUM_THREADS, else that of the cores this process may use."""
    asked = os.environ.get("BONDEM_NUM_THREADS", "").strip()
    if asked:
        return int(asked)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def current_threads() -> int:
    """Return the number of threads on which solvers run now."""
    return _WITHIN.get() or _Process.threads or most_threads()


@contextmanager
def threads(count: int | None) -> Iterator[None]:
    """Run solvers on `count` threads within the block; None leaves the number as it is."""
    if count is None:
        yield
        return
    before = _WITHIN.set(count)
    try:
        yield
    finally:
        _WITHIN.reset(before)


def set_threads(count: int) -> None:
    """Set the number of threads of all solvers that this process runs from now on.

    No result depends on this number. Without a call solvers use BONDEM_NUM_THREADS threads, else all cores.

    Args:
        count: number of threads, from 1 to the number at the start of the process.

    Raises:
        InputError: not a whole number of at least 1, or more threads than that number.
    """
    most = most_threads()
    wanted = whole_number("set_threads", "count", count, least=1, advice=f"a whole number from 1 to {most}")
    if wanted > most:
        raise InputError(
            f"set_threads: count = {wanted}, but there are {most} threads; give at most {most}, or set"
            " BONDEM_NUM_THREADS before the start"
        )
    _Process.threads = wanted
