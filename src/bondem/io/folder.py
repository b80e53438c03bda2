"""Folders of results, each with a single writing process."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bondem._lock import sole
from bondem.errors import InputError
from bondem.io.atomic import require_folder


@contextmanager
def only_writer(out: Path, what: str) -> Iterator[None]:
    """Lock a folder, existing or new, for writing by this process only.

    Args:
        out: the folder.
        what: name of the folder in messages.

    Raises:
        InputError: the folder cannot be written, or another process writes to it.
    """
    require_folder(out, what)
    out = out.absolute()
    beside = out if out.is_dir() else next(folder for folder in out.parents if folder.is_dir())
    place = beside.parent if beside == out else beside
    with sole(place / f".{out.name}.lock") as mine:
        if not mine:
            raise InputError(
                f"{what} '{out}' is being written by another process; give another folder, or try again later"
            )
        yield
