"""A row of a study: what is asked for, and what was measured, kept in a file as soon as it is there.

    DIR/rows/NAME.json, and what figures need beside it in DIR/kept/NAME.pickle

NAME ends in a hash of the request and of all the code that decides its numbers (`validation.frame.sources`): a row of
another request, or of another version, is never taken for this one. The row comes last and in one move, so that where
it is, all is.
"""

import hashlib
import json
import os
import pickle
import re
import time
from abc import ABC, abstractmethod
from dataclasses import fields
from pathlib import Path
from typing import Any, cast, final

from bondem._blas import one_blas_thread
from bondem.errors import BondemError, UnstableRunError
from bondem.io.atomic import write_text
from bondem.io.packing_cache import written
from validation.frame.sources import code_hash


class Request(ABC):
    """One row of a study. Equal requests are one; all are frozen dataclasses."""

    @final
    @property
    def readable(self) -> str:
        """What its files are called, before the hash: its class, and what was asked for."""
        words = [name if value is True else value if isinstance(value, str) else f"{name}{value:g}"
                 for name, value in self.asked.items() if value is not None and value is not False]  # fmt: skip
        return re.sub(r"[^\w.+-]+", "-", "_".join([type(self).__name__, *words]))

    @property
    def weight(self) -> float:
        """How much work it is, against others of its kind: its number of elements, where it has one."""
        return float(getattr(self, "count", 1))

    @property
    def needs(self) -> "Request | None":
        """What must have been made before, in an earlier stage."""
        return None

    @property
    def asked(self) -> dict[str, Any]:
        """The columns of the row that say what was asked for: numbers, words and flags, and the name of a case."""
        values = {field.name: getattr(self, field.name) for field in fields(cast(Any, self))}
        columns = {name: getattr(value, "name", value) for name, value in values.items()}
        return {name: value for name, value in columns.items() if isinstance(value, int | float | str)}

    def whole(self, folder: Path) -> bool:
        """Whether all that belongs to the row is there."""
        return True

    @abstractmethod
    def measured(self, folder: Path) -> dict[str, Any]:
        """Do the work.

        Returns:
            The columns of the row that say what came out, numbers finite or None; "seconds" where not all of the
            time counts.

        Raises:
            BondemError: why it cannot be done.
        """

    @final
    @property
    def name(self) -> str:
        """What its files are called: readable, and unlike that of any other request or version."""
        text = json.dumps(written(self, packages=("bondem", "validation")), sort_keys=True)
        digest = hashlib.sha256(f"{code_hash(type(self).__module__)}\n{text}".encode())
        return f"{self.readable}_{digest.hexdigest()[:16]}"

    @final
    def row_file(self, folder: Path) -> Path:
        """Where its row is kept."""
        return folder / "rows" / f"{self.name}.json"

    @final
    def kept_file(self, folder: Path) -> Path:
        """Where what figures need is kept, if there is any."""
        return folder / "kept" / f"{self.name}.pickle"

    @final
    def keep(self, folder: Path, what: object) -> None:
        """Keep an object for the figures; the name tells versions apart, so that it can be read as it was written."""
        path = self.kept_file(folder)
        path.parent.mkdir(exist_ok=True)
        aside = path.with_suffix(f".{os.getpid()}.new")
        aside.write_bytes(pickle.dumps(what))
        os.replace(aside, path)

    @final
    def kept(self, folder: Path) -> Any:
        """What was kept."""
        return pickle.loads(self.kept_file(folder).read_bytes())


def kept_row(request: Request, folder: Path) -> dict[str, Any] | None:
    """The row of a request that is there already, or None; one that failed has an `error`."""
    try:
        row = json.loads(request.row_file(folder).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    complete = isinstance(row, dict) and "error" in row
    return row if complete and (row["error"] or request.whole(folder)) else None


@one_blas_thread
def made_row(request: Request, folder: Path) -> dict[str, Any]:
    """Do the work of a request and keep its row.

    Returns:
        The row. What failed has a row, too, with the reason; to try it again, delete its file.
    """
    row: dict[str, Any] = request.asked | {"error": "", "unstable": False}
    start = time.perf_counter()
    try:
        row |= request.measured(folder)
    except BondemError as error:
        row |= {"error": str(error), "unstable": isinstance(error, UnstableRunError)}
    row.setdefault("seconds", round(time.perf_counter() - start, 3))
    write_text(request.row_file(folder), json.dumps(row, indent=1, allow_nan=False) + "\n")
    return row
