"""Folders of results, which one process at a time writes to."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bondem._lock import sole
from bondem.errors import InputError
from bondem.io.atomic import require_folder


@contextmanager
def only_writer(out: Path, what: str) -> Iterator[None]:
    """Be the only process that writes to a folder, which is there or can be made.

    Args:
        out: the folder.
        what: what messages call it.

    Raises:
        InputError: it cannot be written, or another process writes to it.
    """
    require_folder(out, what)
    out = out.absolute()
    beside = out if out.is_dir() else next(folder for folder in out.parents if folder.is_dir())
    place = beside.parent if beside == out else beside
    with sole(place / f".{out.name}.lock") as mine:
        if not mine:
            raise InputError(f"{what} '{out}' is being written by another process; give another one, or wait for it")
        yield
