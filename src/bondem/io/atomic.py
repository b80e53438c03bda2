"""Atomic writing: a file is either complete or absent."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bondem.errors import InputError, RunFileError


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a temporary path beside `path`; at the end of the block it replaces `path` by one atomic move.

    A kill at any moment leaves the old file or none, never a partial one.

    Raises:
        RunFileError: the disk is full, or another failure to write.
    """
    aside = path.with_name(f".{path.name}.part")
    try:
        yield aside
        with open(aside, "rb") as written:
            os.fsync(written.fileno())
        os.replace(aside, path)
    except OSError as error:
        raise RunFileError(
            f"'{path}' could not be written ({error.strerror or error}); make room or choose another place"
        ) from error
    finally:
        aside.unlink(missing_ok=True)


def write_text(path: Path, text: str) -> None:
    """Write a text file to a temporary path and move it into place."""
    with replacing(path) as aside:
        aside.write_text(text, encoding="utf-8")


def require_writable(path: Path, what: str) -> None:
    """Check, before any work, that a file can be written at `path` in an existing folder.

    Args:
        path: the file.
        what: name of the file in messages.

    Raises:
        InputError: the file cannot be written; the message states the reason.
    """
    if path.is_dir():
        raise InputError(f"{what} '{path}' is a folder; give the name of a file")
    _probe(path.parent, f"{what} '{path}'")


def require_folder(path: Path, what: str) -> None:
    """Check, before any work, that a folder exists and can be written to, or can be created.

    The folder is not created yet, so that failed work leaves nothing behind.

    Raises:
        InputError: the folder cannot be used; the message states the reason.
    """
    if path.exists() and not path.is_dir():
        raise InputError(f"{what} '{path}' is a file; give the name of a folder")
    nearest = path
    while not nearest.exists() and nearest != nearest.parent:
        nearest = nearest.parent
    _probe(nearest, f"{what} '{path}'")


def _probe(folder: Path, whose: str) -> None:
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise InputError(f"{whose} cannot be written ({error.strerror}); choose a place you may write to") from None
