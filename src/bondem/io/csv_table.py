"""Tables of numbers as CSV files, with names and SI units in their first line."""

import csv
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from bondem._checks import place
from bondem._types import ArrayLike
from bondem.io.atomic import replacing, require_writable


def write_csv(path: str | Path, table: Mapping[str, ArrayLike], *, owner: str) -> None:
    """Write columns of one length with ten digits; the file is complete or absent.

    Args:
        path: file to write.
        table: columns by name and unit, such as "load [N]".
        owner: name of the calling function, for messages.

    Raises:
        InputError: The file cannot be written.
        RunFileError: The disk is full, or another failure to write.
    """
    path = place(f"{owner}: path", path)
    require_writable(path, "table")
    rows = np.column_stack([np.asarray(values, dtype=float) for values in table.values()])
    with replacing(path) as aside, open(aside, "w", newline="", encoding="utf-8") as stream:
        lines = csv.writer(stream, lineterminator="\n")
        lines.writerow(table)
        lines.writerows([f"{value:.10g}" for value in row] for row in rows)
