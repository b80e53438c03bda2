"""Signals that stop a run, after it has finished its present steps and saved its state."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

from bondem.errors import RunInterrupted

#: Function that returns the number of the signal that is to stop a run, or None.
Halt = Callable[[], int | None]


@contextmanager
def noticing() -> Iterator[Halt]:
    """Record SIGINT (Ctrl-C) and SIGTERM within the block; a second signal stops at once.

    Yields:
        A function that returns the number of the received signal, or None. In other threads than the main one no
        signal is recorded.
    """
    if threading.current_thread() is not threading.main_thread():
        yield lambda: None
        return
    come: list[int] = []

    def note(number: int, frame: FrameType | None) -> None:
        if come:
            raise KeyboardInterrupt
        come.append(number)

    before = {number: signal.signal(number, note) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield lambda: come[0] if come else None
    finally:
        for number, handler in before.items():
            signal.signal(number, handler if handler is not None else signal.SIG_DFL)


def stop_by(number: int, message: str, result: object) -> None:
    """Raise the exception of a signal: RunInterrupted for SIGINT, SystemExit with status 143 for SIGTERM.

    Args:
        number: number of the signal.
        message: text for the traceback of an interrupt.
        result: result of the run so far, an attribute of the interrupt.
    """
    if number == signal.SIGINT:
        raise RunInterrupted(message, result)
    raise SystemExit(128 + number)
