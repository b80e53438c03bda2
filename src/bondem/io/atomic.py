"""Writing of files: every file of bondem is either complete or absent.

A file is written beside its target under a temporary name, flushed to the disk, and moved into place. Symbolic links
stay, and the file behind them is replaced. If several processes write the same name, the complete file of one of them
remains. Only run files grow in place, see `bondem.io.journal`.
"""

import os
import secrets
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from bondem.errors import InputError, RunFileError

# Characters of the target name in that of a temporary file, which stays shorter than 255 bytes.
_STEM = 40


def target_of(path: Path) -> Path:
    """Return the file behind symbolic links, which may not exist yet."""
    return Path(os.path.realpath(path))


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a temporary path with the suffix of `path`, which replaces `path` by one move at the end of the block.

    A kill at any moment leaves the old file or the new one, never a partial one. Permissions of an old file remain.

    Raises:
        InputError: The path names something other than a file.
        RunFileError: the disk is full, or another failure to write.
    """
    target = target_of(path)
    _require_plain(target, f"'{path}'")
    aside = _beside(target)
    try:
        with open(aside, "xb"):
            pass
        yield aside
        with open(aside, "rb") as written:
            os.fsync(written.fileno())
        with suppress(FileNotFoundError):
            shutil.copymode(target, aside)
        os.replace(aside, target)
    except OSError as error:
        raise failed(path, error) from error
    finally:
        with suppress(OSError):
            aside.unlink(missing_ok=True)


def write_bytes(path: Path, content: bytes | memoryview) -> None:
    """Write a file to a temporary path and move it into place; errors as for `replacing`."""
    with replacing(path) as aside:
        aside.write_bytes(content)


def write_text(path: Path, text: str) -> None:
    """Write a text file in UTF-8, with escapes for surrogates of undecodable names; errors as for `replacing`."""
    write_bytes(path, text.encode(errors="backslashreplace"))


def failed(path: Path, error: OSError) -> RunFileError:
    """Return the error for a file that could not be written."""
    return RunFileError(
        f"'{path}' could not be written ({error.strerror or error}); make room or choose another place"
    )


def require_writable(path: Path, what: str) -> None:
    """Check, before any work, that a file can be written at `path` in an existing folder.

    Args:
        path: the file.
        what: name of the file in messages.

    Raises:
        InputError: the file cannot be written; the message states the reason.
    """
    target, whose = target_of(path), f"{what} '{path}'"
    _require_plain(target, whose)
    with _refused(whose):
        with suppress(FileNotFoundError):
            os.stat(target)
            if not os.access(target, os.W_OK):
                raise PermissionError(0, "the file is write-protected")
        with tempfile.TemporaryFile(dir=target.parent):
            pass


def require_folder(path: Path, what: str) -> None:
    """Check, before any work, that a folder, named `what` in messages, exists and is writable, or can be created.

    The folder is not created yet, so that failed work leaves nothing behind.

    Raises:
        InputError: the folder cannot be used; the message states the reason.
    """
    whose, nearest = f"{what} '{path}'", target_of(path)
    if os.path.exists(nearest) and not os.path.isdir(nearest):
        raise InputError(f"{whose} is a file; give the name of a folder")
    with _refused(whose):
        with suppress(FileNotFoundError):
            os.stat(nearest)
        while not os.path.lexists(nearest) and nearest != nearest.parent:
            nearest = nearest.parent
        with tempfile.TemporaryFile(dir=nearest):
            pass


def make_folder(path: Path) -> None:
    """Create a folder of results with all folders above it.

    Raises:
        RunFileError: The folder cannot be created.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise failed(path, error) from error


def _require_plain(target: Path, whose: str) -> None:
    if os.path.isdir(target):
        raise InputError(f"{whose} is a folder; give the name of a file")
    if os.path.exists(target) and not os.path.isfile(target):
        raise InputError(f"{whose} is a device or a pipe; give the name of a file")


@contextmanager
def _refused(whose: str) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise InputError(f"{whose} cannot be written ({error.strerror}); choose a place you may write to") from None


def _beside(target: Path) -> Path:
    """Return an unused name in the folder of a file, with its suffix, by which other libraries choose the format."""
    return target.with_name(f".{target.stem[:_STEM]}.{secrets.token_hex(4)}.part{target.suffix}")
