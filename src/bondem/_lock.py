"""One process at a time: a lock on a file that processes of one machine share."""

import importlib
import os
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

_POSIX: Any = importlib.import_module("fcntl") if os.name == "posix" else None
# Between two looks at a lock that another process holds [s].
_LOOK = 0.02


@contextmanager
def alone(place: Path, *, patience: float) -> Iterator[None]:
    """Be the only process in a block of this place; after so many seconds of waiting, one of several.

    The system takes the lock from a process that dies. Where files cannot be locked nobody waits.

    Args:
        place: of the lock, a file that is made; what it holds does not matter.
        patience: [s].
    """
    with ExitStack() as held:
        with suppress(OSError):
            place.parent.mkdir(parents=True, exist_ok=True)
            lock = held.enter_context(place.open("w"))
            last = time.monotonic() + patience
            while _POSIX is not None and time.monotonic() < last:
                try:
                    _POSIX.flock(lock, _POSIX.LOCK_EX | _POSIX.LOCK_NB)
                except BlockingIOError:
                    time.sleep(_LOOK)
                else:
                    break
        yield
