"""Spheres from tables of text: CSV, and what Yade writes."""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bondem._checks import shown
from bondem._types import Floats, Pairs, PerElement, PerElement3
from bondem.errors import InputError
from bondem.io.text_file import read_text

_WANTED = ("x", "y", "z", "r")
# Names others give these columns, in small letters and without units in brackets; d is halved.
_ALIASES = {
    "x": ("x", "pos_x", "position_x", "x_center", "centre_x", "center_x", "points:0", "coordinates:0"),
    "y": ("y", "pos_y", "position_y", "y_center", "centre_y", "center_y", "points:1", "coordinates:1"),
    "z": ("z", "pos_z", "position_z", "z_center", "centre_z", "center_z", "points:2", "coordinates:2"),
    "r": ("r", "rad", "radius", "radii"),
    "d": ("d", "diameter"),
}
_SEPARATOR = re.compile(r"[,;\t]")


@dataclass(frozen=True, eq=False)
class RawSpheres:
    """What a file says, in its own unit of length.

    Attributes:
        position: centres, shape (n, 3).
        radius: radii, shape (n,).
        period: edge lengths of its periodic cell, or None.
        pairs: elements i, j of its bonds, shape (m, 2), or None where the format has none.
    """

    position: PerElement3
    radius: PerElement
    period: Floats | None = None
    pairs: Pairs | None = None


def numbered_lines(path: Path) -> Iterator[tuple[int, str]]:
    """The lines of a text file that are not empty, stripped, with their numbers from 1."""
    try:
        text = read_text(path)
    except UnicodeDecodeError:
        raise InputError(f"'{path}' is not a text file; give spheres in a format its suffix stands for") from None
    for number, line in enumerate(text.split("\n"), start=1):
        if stripped := line.strip():
            yield number, stripped


def floats(path: Path, line: int, words: Sequence[str]) -> list[float]:
    """Words of a line as finite numbers.

    Raises:
        InputError: one is not, naming file and line.
    """
    found = []
    for word in words:
        try:
            found.append(float(word))
        except ValueError:
            raise InputError(f"'{path}', line {line}: '{word}' is not a number; correct or remove the line") from None
        if not math.isfinite(found[-1]):
            raise InputError(f"'{path}', line {line}: {word} is not finite; correct or remove the line")
    return found


def read_csv(path: Path, columns: Sequence[str | int] | None = None) -> RawSpheres:
    """Spheres from columns separated by comma, semicolon, tab or blanks; `#` starts a comment.

    Args:
        path: the file.
        columns: which columns hold x, y, z and radius, by name in the header or by number from 0. Default: what
            the header calls so (x, y, z and r, radius, d or diameter, case and units in brackets ignored), or the
            first four where there is no header.

    Raises:
        InputError: a column missing or a value that is not a number, naming file and line.
    """
    lines = ((number, text) for number, text in numbered_lines(path) if not text.startswith("#"))
    first = next(lines, None)
    if first is None:
        raise InputError(f"'{path}' holds no spheres; give one line x, y, z, radius for each")
    number, text = first
    words = _words(text)
    header = None if _all_numbers(words) else [_plain(word) for word in words]
    chosen, halve = _columns(path, number, header, columns)
    rows = [] if header is not None else [_row(path, number, words, chosen)]
    rows.extend(_row(path, number, _words(text), chosen) for number, text in lines)
    return _spheres(path, rows, halve)


def read_yade(path: Path) -> RawSpheres:
    """Spheres from Yade: `export.text`, `export.textExt` (x y z r first) or `SpherePack.save`, periodic or not.

    Raises:
        InputError: a line that is not x y z r, naming file and line.
    """
    rows, period = [], None
    for number, text in numbered_lines(path):
        words = text.split()
        if words[0] == "##PERIODIC::":
            period = np.array(_row(path, number, words[1:], range(3)))
        elif words[0] == "#format" and not "_".join(words[1:]).startswith("x_y_z_r"):
            raise InputError(f"'{path}', line {number}: the format does not begin with x_y_z_r; export it so")
        elif not text.startswith("#"):
            rows.append(_row(path, number, words, range(4)))
    return _spheres(path, rows, False, period)


def _words(text: str) -> list[str]:
    plain = text.split("#")[0].strip()
    # Blanks separate only where nothing else does: names in a header may hold them.
    words = _SEPARATOR.split(plain) if _SEPARATOR.search(plain) else plain.split()
    return [word.strip().strip("\"'") for word in words]


def _plain(word: str) -> str:
    return re.sub(r"[\[(].*", "", word).strip().lower()


def _all_numbers(words: Sequence[str]) -> bool:
    try:
        for word in words:
            float(word)
    except ValueError:
        return False
    return True


def _columns(
    path: Path, line: int, header: list[str] | None, columns: Sequence[str | int] | None
) -> tuple[list[int], bool]:
    """Numbers of the columns x, y, z and r, and whether the last holds a diameter."""
    if columns is not None:
        if len(columns) != 4:
            raise InputError(f"columns = {columns!r}; name four, those of x, y, z and radius")
        return [_column(path, line, header, one) for one in columns], False
    if header is None:
        return [0, 1, 2, 3], False
    found: dict[str, int] = {}
    for name, aliases in _ALIASES.items():
        place = [k for k, word in enumerate(header) if word in aliases]
        if place:
            found[name] = place[0]
    if "r" not in found and "d" in found:
        return [*_xyz(path, line, header, found), found["d"]], True
    return [*_xyz(path, line, header, found), _named(path, line, header, found, "r")], False


def _xyz(path: Path, line: int, header: list[str], found: dict[str, int]) -> list[int]:
    return [_named(path, line, header, found, name) for name in _WANTED[:3]]


def _named(path: Path, line: int, header: list[str], found: dict[str, int], name: str) -> int:
    if name not in found:
        raise InputError(
            f"'{path}', line {line}: no column '{name}' among {', '.join(header)}; rename one, or pass columns="
            " with those of x, y, z and radius"
        )
    return found[name]


def _column(path: Path, line: int, header: list[str] | None, one: str | int) -> int:
    if isinstance(one, bool) or not isinstance(one, int | str) or (isinstance(one, int) and one < 0):
        raise InputError(f"columns: {shown(one)} is no column; give names in the header or numbers from 0")
    if isinstance(one, int):
        return one
    if header is None:
        raise InputError(f"'{path}' has no header; give columns= as numbers from 0")
    if _plain(one) not in header:
        raise InputError(f"'{path}', line {line}: no column '{one}' among {', '.join(header)}; correct columns=")
    return header.index(_plain(one))


def _row(path: Path, line: int, words: Sequence[str], chosen: Sequence[int]) -> list[float]:
    if len(words) <= max(chosen):
        raise InputError(
            f"'{path}', line {line}: {len(words)} columns where at least {max(chosen) + 1} are needed; complete the"
            " line, or pass columns= with those of x, y, z and radius"
        )
    row = floats(path, line, [words[k] for k in chosen])
    if row[-1] <= 0.0:
        raise InputError(f"'{path}', line {line}: {row[-1]:g} is no size; give a positive one or remove the line")
    return row


def _spheres(path: Path, rows: list[list[float]], halve: bool, period: Floats | None = None) -> RawSpheres:
    if not rows:
        raise InputError(f"'{path}' holds no spheres; give one line x, y, z, radius for each")
    table = np.array(rows)
    return RawSpheres(table[:, :3], table[:, 3] * (0.5 if halve else 1.0), period)
