"""What is said of rows that failed."""

import itertools
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from bondem.errors import PackingError, UnstableRunError


def complain(rows: Sequence[dict[str, Any]], folder: Path, *, what: str = "packings") -> None:
    """Raise if rows failed; all that could be made has been kept by then.

    Raises:
        UnstableRunError: a run that packs became unstable.
        PackingError: one failed for another reason.
    """
    failed = [row for row in rows if row["error"]]
    if not failed:
        return
    kind = UnstableRunError if any(row["unstable"] for row in failed) else PackingError
    first = failed[0]
    asked = ", ".join(f"{name} {first[name]}" for name in itertools.takewhile("error".__ne__, first))
    raise kind(f"{len(failed)} of {len(rows)} {what} failed, the others are in '{folder}'; first {asked}:"
               f" {first['error']}")  # fmt: skip
