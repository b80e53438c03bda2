"""Import of spheres from text tables: CSV and files of Yade."""

import csv
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.io.raw_spheres import RawSpheres, floats, numbered_lines
from bondem.io.table_header import Chosen, Column, choose, is_header

_DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?")
# Gap between columns separated by blanks; a unit in brackets belongs to the name before it.
_BLANKS = re.compile(r"\s+(?![\[(])")


def read_csv(
    path: Path, columns: Sequence[str | int] | None = None, *, diameters: bool = False, unit_given: bool = False
) -> RawSpheres:
    """Read spheres from columns separated by comma, semicolon, tab or blanks; `#` starts a comment.

    Decimals may have commas where these do not separate columns. The header may be a comment.

    Args:
        path: the file.
        columns: columns of x, y, z and radius, by name in the header or by number from 0. None selects the columns of
            the header with these names (x, y, z and r, radius, d or diameter in any case, with units such as "x [mm]"
            or "x_mm"); a file without a header has these four only.
        diameters: True if the column of radii contains diameters; a header may state it too.
        unit_given: True if the caller knows the unit of length.

    Raises:
        InputError: a missing column, more columns than are known, or a value that is not a number; the message states
            file and line.
    """
    comment: tuple[int, str] | None = None
    lines = numbered_lines(path)
    for number, text in lines:
        if not text.startswith("#"):
            break
        comment = number, text.lstrip("# ")
    else:
        raise InputError(f"'{path}' has no spheres; give one line x, y, z, radius for each")
    separator = _separator(text)
    words = _words(text, separator)
    header, place = None, number
    rows: list[tuple[int, list[str]]] = []
    if all(_is_number(word) for word in words):
        rows.append((number, words))
        if comment is not None:
            place, text = comment
            named = [Column.of(word) for word in _words(text, _separator(text))]
            header = named if is_header(named) and len(named) == len(words) else None
    else:
        header = [Column.of(word) for word in words]
    rows.extend((number, _words(text, separator)) for number, text in lines if not text.startswith("#"))
    chosen = choose(path, place, header, columns, unit_given=unit_given)
    most = len(header) if header is not None else 4 if columns is None else None
    spheres = _spheres(path, [_row(path, k, row, chosen, most) for k, row in rows], chosen, diameters)
    marks = {mark for _, row in rows for k in chosen.columns for mark in ".," if mark in row[k]}
    if len(marks) > 1:
        raise InputError(f"'{path}' has numbers with commas and with points; write all decimals with a point")
    return spheres


def read_yade(path: Path, *, diameters: bool = False) -> RawSpheres:
    """Read spheres of Yade: `export.text`, `export.textExt` (x y z r first) or `SpherePack.save`, periodic or not.

    Raises:
        InputError: a line that is not x y z r; the message states file and line.
    """
    rows, period, said = [], None, False
    chosen = Chosen((0, 1, 2, 3))
    for number, text in numbered_lines(path):
        words = text.split()
        if words[0] == "##PERIODIC::":
            period = np.array(_row(path, number, words[1:], Chosen((0, 1, 2))))
        elif words[0] == "#format":
            said = True
            if not "_".join(words[1:]).startswith("x_y_z_r"):
                raise InputError(
                    f"'{path}', line {number}: the format does not begin with x_y_z_r; export it with this format"
                )
        elif not text.startswith("#"):
            if not said and len(words) > 4 and not re.fullmatch(r"-?\d+", words[4]):
                raise InputError(
                    f"'{path}', line {number}: {len(words)} columns without a line #format, and the fifth,"
                    f" {words[4]}, is no number of a clump; write x y z r only, or give .csv with a header"
                )
            rows.append(_row(path, number, words, chosen))
    return _spheres(path, rows, chosen, diameters, period)


def _separator(text: str) -> str | None:
    """Return the separator of the columns of a line; None for blanks."""
    plain = text.split("#")[0].strip()
    for mark in (";", "\t"):
        if mark in plain:
            return mark
    words = plain.split()
    if len(words) >= 4 and all(_DECIMAL_COMMA.fullmatch(word) for word in words if "," in word):
        return None
    return "," if "," in plain else None


def _words(text: str, separator: str | None) -> list[str]:
    plain = text.split("#")[0].strip()
    words = _BLANKS.split(plain) if separator is None else next(csv.reader([plain], delimiter=separator))
    while words and not words[-1].strip():  # a separator at the end of the line
        words.pop()
    return [word.strip().strip("\"'") for word in words]


def _with_point(word: str) -> str:
    return word.replace(",", ".") if _DECIMAL_COMMA.fullmatch(word) else word


def _is_number(word: str) -> bool:
    try:
        float(_with_point(word))
    except ValueError:
        return False
    return True


def _row(
    path: Path, line: int, words: Sequence[str], chosen: Chosen, most: int | None = None
) -> list[float]:
    """Return the selected numbers of a line; the last is a size.

    Args:
        path: the file, for messages.
        line: number of the line.
        words: words of the line.
        chosen: selected columns.
        most: largest number of columns of a line; None for no limit.

    Raises:
        InputError: too few or too many columns, a word that is no number, or a size that is not positive.
    """
    if len(words) <= max(chosen.columns):
        raise InputError(
            f"'{path}', line {line}: {len(words)} columns where at least {max(chosen.columns) + 1} are needed;"
            " complete the line, or give columns= with those of x, y, z and radius"
        )
    if most is not None and len(words) > most:
        raise InputError(
            f"'{path}', line {line}: {len(words)} columns where {most} are known; name all of them in a header, give"
            " columns= with the numbers of x, y, z and radius, and write decimals with a point"
        )
    row = floats(path, line, [_with_point(words[k]) for k in chosen.columns])
    if row[-1] <= 0.0:
        raise InputError(f"'{path}', line {line}: {row[-1]:g} is not a size; give a positive size or remove the line")
    return row


def _spheres(
    path: Path, rows: Iterable[list[float]], chosen: Chosen, diameters: bool, period: Floats | None = None
) -> RawSpheres:
    table = np.array(list(rows))
    if not table.size:
        raise InputError(f"'{path}' has no spheres; give one line x, y, z, radius for each")
    table = table * chosen.factor
    half = 0.5 if chosen.halve or diameters else 1.0
    return RawSpheres(table[:, :3], table[:, 3] * half, period, unit=chosen.unit)
