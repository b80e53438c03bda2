"""One process at a time: a lock on a file that processes of one machine share."""

import errno
import importlib
import os
import struct
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

_POSIX: Any = importlib.import_module("fcntl") if os.name == "posix" else None
# Between two looks at a lock that another process holds [s].
_LOOK = 0.02
# Where the byte is that a claimed file is known by.
_FAR = 1 << 62


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


def claim(descriptor: int) -> bool:
    """Claim an open file for writing, until it is closed; False where another process, or another open file, has it.

    Readers are not kept out, as by HDF5's own locks. Where such claims are not known nobody is refused.
    """
    if _POSIX is None or not hasattr(_POSIX, "F_OFD_SETLK"):
        return True
    # one byte far beyond the end: struct flock of 64-bit systems
    asked = struct.pack("hhqqi4x", _POSIX.F_WRLCK, os.SEEK_SET, _FAR, 1, 0)
    try:
        _POSIX.fcntl(descriptor, _POSIX.F_OFD_SETLK, asked)
    except OSError as error:
        return error.errno not in (errno.EACCES, errno.EAGAIN)
    return True


@contextmanager
def sole(place: Path) -> Iterator[bool]:
    """Claim a place for the block, by a file that goes with it; False where another process has it.

    Args:
        place: of the file, in a folder that is there and can be written to; elsewhere nobody is refused.
    """
    with ExitStack() as held:
        file = None
        with suppress(OSError):
            while True:
                file = held.enter_context(place.open("a"))
                if not claim(file.fileno()):
                    yield False
                    return
                with suppress(OSError):
                    if os.fstat(file.fileno()).st_ino == place.stat().st_ino:
                        break  # and not one that its owner has just taken away
        try:
            yield True
        finally:
            if file is not None:
                place.unlink(missing_ok=True)
