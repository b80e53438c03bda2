"""Files that are either whole or not there."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bondem.errors import InputError, RunFileError


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A path beside `path` to write to; after the block it takes the place of `path`, in one move.

    A kill at any moment leaves the old file, or none, never half of one.

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
    """Write a text file aside and move it into place."""
    with replacing(path) as aside:
        aside.write_text(text, encoding="utf-8")


def require_writable(path: Path, what: str) -> None:
    """Make sure, before any work is done, that a file can be written at `path`.

    Args:
        path: the file; its folder must exist.
        what: what the message calls it.

    Raises:
        InputError: it cannot, and why.
    """
    probe = path.with_name(f".{path.name}.part")
    try:
        if path.is_dir():
            raise IsADirectoryError(21, "it is a folder")
        with open(probe, "wb"):
            pass
        probe.unlink()
    except OSError as error:
        raise InputError(
            f"{what} '{path}' cannot be written ({error.strerror}); choose a place you may write to"
        ) from None


def require_folder(path: Path, what: str) -> None:
    """Make a folder, with its parents, and make sure that files can be written in it.

    Raises:
        InputError: it cannot be made or written to, and why.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"{what} '{path}' cannot be made ({error.strerror}); choose a place you may write to"
        ) from None
    require_writable(path / "probe", what)
