"""The number of threads on which solvers run."""

from contextlib import ExitStack

from bondem._checks import count as whole_number
from bondem._compile import most_threads, threads
from bondem.errors import InputError

_setting = ExitStack()


def set_threads(count: int) -> None:
    """Set the number of threads of all solvers that this process runs from now on.

    No result depends on it. Without a call solvers use BONDEM_NUM_THREADS threads, else all cores.

    Args:
        count: number of threads, from 1 to the number at the start of the process.

    Raises:
        InputError: no whole number, or more threads than there are.
    """
    most = most_threads()
    wanted = whole_number("set_threads", "count", count, least=1, advice=f"a whole number from 1 to {most}")
    if wanted > most:
        raise InputError(
            f"set_threads: count = {wanted}, but there are {most} threads; give at most {most}, or set"
            " BONDEM_NUM_THREADS before the start"
        )
    _setting.close()
    _setting.enter_context(threads(wanted))
