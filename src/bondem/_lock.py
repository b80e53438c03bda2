"""Locks on files, by which processes of one machine exclude each other."""

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
# Time between two attempts to lock a file [s].
_POLL = 0.02
# Position of the byte that a claim locks.
_FAR = 1 << 62


@contextmanager
def alone(place: Path, *, patience: float) -> Iterator[None]:
    """Run a block under an exclusive lock; after `patience` without the lock, run it without exclusion.

    The system releases the lock of a process that ends. On systems without such locks the block starts at once.

    Args:
        place: path of the lock, a file that is created and stays empty.
        patience: longest time until the block starts [s].
    """
    with ExitStack() as stack:
        with suppress(OSError):
            place.parent.mkdir(parents=True, exist_ok=True)
            lock = stack.enter_context(place.open("w"))
            last = time.monotonic() + patience
            while _POSIX is not None and time.monotonic() < last:
                try:
                    _POSIX.flock(lock, _POSIX.LOCK_EX | _POSIX.LOCK_NB)
                except BlockingIOError:
                    time.sleep(_POLL)
                else:
                    break
        yield


def claim(descriptor: int) -> bool:
    """Claim an open file for writing until it is closed; False if another process or open file has a claim.

    Readers are not excluded, unlike by HDF5's own locks. On systems without such locks every claim succeeds.
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
    """Claim a lock file for the block, and remove it at the end; yield False if another process has a claim.

    Args:
        place: path of the file; in a folder that is missing or read-only every claim succeeds.
    """
    with ExitStack() as stack:
        file = None
        with suppress(OSError):
            while True:
                file = stack.enter_context(place.open("a"))
                if not claim(file.fileno()):
                    yield False
                    return
                with suppress(OSError):
                    if os.fstat(file.fileno()).st_ino == place.stat().st_ino:
                        break  # unlike a file that its last owner has just removed
        try:
            yield True
        finally:
            if file is not None:
                place.unlink(missing_ok=True)
