"""Spheres as read from a file, and common parts of the readers of text files."""

import math
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from bondem._checks import shown
from bondem._types import Floats, Pairs, PerElement, PerElement3
from bondem.errors import InputError
from bondem.io.text_file import encoding_of

#: Length of the unit systems of LAMMPS [m]; "lj" has none.
LAMMPS_UNITS = {
    "si": 1.0, "cgs": 1e-2, "micro": 1e-6, "nano": 1e-9, "real": 1e-10, "metal": 1e-10, "electron": 5.29177210903e-11,
}  # fmt: skip
# Most digits of a count; Python converts at most 4300.
_DIGITS = 18
_Frame = TypeVar("_Frame")


@dataclass(frozen=True, eq=False)
class RawSpheres:
    """Spheres of a file in its own unit of length.

    Attributes:
        position: centres, shape (n, 3).
        radius: radii, shape (n,).
        period: edge lengths of the periodic cell, shape (3,), or None.
        pairs: elements i, j of the bonds, shape (m, 2), or None for formats without bonds.
        unit: unit of length of the file [m], or None if the file does not state it.
        strained: reason why the bonds may be strained; empty if there is none.
        partly: names of the periodic axes if only some are periodic, else empty. Positions are then relative to the
            corner of the box.
    """

    position: PerElement3
    radius: PerElement
    period: Floats | None = None
    pairs: Pairs | None = None
    unit: float | None = None
    strained: str = ""
    partly: str = ""


def numbered_lines(path: Path) -> Iterator[tuple[int, str]]:
    """Yield the number, from 1, and the stripped text of each line that is not empty.

    Raises:
        InputError: the file is not text.
    """
    try:
        with open(path, encoding=encoding_of(path)) as file:
            for number, line in enumerate(file, start=1):
                if stripped := line.strip():
                    yield number, stripped
    except UnicodeDecodeError:
        raise InputError(f"'{path}' is not a text file; give spheres in a format its suffix stands for") from None


def floats(path: Path, line: int, words: Sequence[str]) -> list[float]:
    """Convert the words of a line to finite numbers.

    Raises:
        InputError: a word is not a finite number; the message states file and line.
    """
    found = []
    for word in words:
        try:
            found.append(float(word))
        except ValueError:
            raise InputError(
                f"'{path}', line {line}: {shown(word)} is not a number; correct or remove the line"
            ) from None
        if not math.isfinite(found[-1]):
            raise InputError(f"'{path}', line {line}: {shown(word)} is not finite; correct or remove the line")
    return found


def snapshot_number(path: Path, number: int, count: int, *, argument: str = "frame") -> int:
    """Convert the number of one of `count` snapshots, negative from the end, to an index from 0.

    Raises:
        InputError: the file has no such snapshot; the message names `argument`.
    """
    if not -count <= number < count:
        raise InputError(
            f"{argument} = {shown(number)}: '{path}' has {count} snapshots; give one from 0 to {count - 1}, or -1"
        )
    return number % count


def chosen_frame(path: Path, number: int, frames: Iterable[_Frame], empty: str = "") -> _Frame:
    """Return a snapshot by its number; -k is the k-th from the end, for which k snapshots are kept in memory.

    Raises:
        InputError: the file has no such snapshot; `empty`, if given, is the message for a file without snapshots.
    """
    last, count = deque[_Frame](maxlen=max(-number, 1)), 0
    for count, one in enumerate(frames, start=1):
        last.append(one)
        if count == number + 1:
            return one
    if empty and not count:
        raise InputError(empty)
    snapshot_number(path, number, count)
    return last[0]


def announced_count(path: Path, line: int, text: str, what: str) -> int:
    """Read a count of a header.

    Raises:
        InputError: The text is no count, or a count larger than any file can contain.
    """
    if not text.isascii() or not text.isdigit() or len(text) > _DIGITS:
        raise InputError(f"'{path}', line {line}: {shown(text)} where the number of {what} is due; correct it")
    return int(text)


def require_count(path: Path, line: int, what: str, announced: int | None, found: int) -> None:
    """Reject a file that contains more or fewer entries than its header announces; None skips the check.

    Raises:
        InputError: the numbers differ; the message states both.
    """
    if announced is not None and announced != found:
        raise InputError(f"'{path}', line {line}: {announced} {what} announced, {found} there; complete the file")


def some_axes(borders: Sequence[bool]) -> str:
    """Name the periodic axes, such as "x and y", if only some axes are periodic; else return an empty text."""
    return "" if all(borders) else " and ".join(axis for axis, one in zip("xyz", borders, strict=False) if one)


def listed(names: Iterable[str]) -> str:
    """Join the first 20 names for a message, each shortened to 40 characters; return "none" if there are no names."""
    known = list(names)
    short = [name if len(name) <= 40 else f"{name[:37]}..." for name in known[:20]]
    return ", ".join([*short, *(["..."] if len(known) > 20 else [])]) or "none"
