"""Columns of a table of spheres: their names in various programs, and their units of length."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from bondem._checks import shown
from bondem._units import length_unit
from bondem.errors import InputError
from bondem.io.raw_spheres import listed

_WANTED = ("x", "y", "z", "r")
# Names of these columns in other programs, in lower case and without units; d is a diameter.
_ALIASES = {
    "x": ("x", "pos_x", "position_x", "x_center", "centre_x", "center_x", "points:0", "coordinates:0"),
    "y": ("y", "pos_y", "position_y", "y_center", "centre_y", "center_y", "points:1", "coordinates:1"),
    "z": ("z", "pos_z", "position_z", "z_center", "centre_z", "center_z", "points:2", "coordinates:2"),
    "r": ("r", "rad", "radius", "radii"),
    "d": ("d", "dia", "diam", "diameter", "diameters"),
}
_KNOWN = {alias for aliases in _ALIASES.values() for alias in aliases}
_BRACKETS = re.compile(r"^(?P<name>[^\[(]*)[\[(](?P<unit>[^\])]*)[\])]?.*$")
# Least number that is not accepted for a column.
_MOST = 100_000
# Texts in brackets that mean no unit.
_NO_UNIT = ("", "-", "1")


@dataclass(frozen=True)
class Column:
    """Name and unit of length of a column of a table.

    Attributes:
        name: name in lower case, without the unit.
        unit: size of the unit [m], or None if the header does not state it.
        unknown: text in brackets that is not a unit of length.
    """

    name: str
    unit: float | None = None
    unknown: str = ""

    @classmethod
    def of(cls, word: str) -> "Column":
        """Parse a word of a header, such as "x", "x [mm]", "x (mm)" or "x_mm"."""
        plain = word.strip()
        if found := _BRACKETS.match(plain):
            name, unit = found["name"].strip().lower(), found["unit"].strip()
            if unit in _NO_UNIT:
                return cls(name)
            size = _length(unit)
            return cls(name, size, "" if size is not None else unit)
        name, _, unit = plain.rpartition("_")
        if name.lower() in _KNOWN and plain.lower() not in _KNOWN and (size := _length(unit)) is not None:
            return cls(name.lower(), size)
        return cls(plain.lower())


@dataclass(frozen=True)
class Chosen:
    """Columns of x, y, z and radius in a table.

    Attributes:
        columns: numbers of the columns from 0.
        halve: True if the column of radii contains diameters.
        unit: common unit of length [m], or None if the header does not state it.
        factor: factor of each of the four to convert it to that unit.
    """

    columns: tuple[int, ...]
    halve: bool = False
    unit: float | None = None
    factor: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0)


def choose(
    path: Path, line: int, header: list[Column] | None, columns: Sequence[str | int] | None, *, unit_given: bool
) -> Chosen:
    """Find the columns of x, y, z and radius.

    Args:
        path: the file, for messages.
        line: line of the header.
        header: columns of the header; None for a table without a header.
        columns: names or numbers of the four columns; None to find them by the names of the header.
        unit_given: True if the caller gives the unit, so that the header may lack it.

    Raises:
        InputError: `columns` are not four, a column is missing or not unique, or units are unknown or incomplete.
    """
    if columns is not None and len(columns) != 4:
        raise InputError(f"columns = {shown(columns)}: not four columns; give those of x, y, z and radius")
    if header is None:
        return Chosen((0, 1, 2, 3) if columns is None else tuple(_number(path, line, None, one) for one in columns))
    names = [column.name for column in header]
    if columns is not None:
        numbers = tuple(_number(path, line, names, one) for one in columns)
    else:
        numbers = tuple(_named(path, line, names, name) for name in _WANTED)
    used = [header[k] for k in numbers if k < len(header)]
    halve = numbers[3] < len(header) and names[numbers[3]] in _ALIASES["d"]
    unknown = next((column for column in used if column.unknown), None)
    if unknown is not None and not unit_given:
        raise InputError(
            f"'{path}', line {line}: [{unknown.unknown}] of column '{unknown.name}' is no known unit of length; give"
            " unit=, such as 'mm'"
        )
    units = {column.unit for column in used}
    if len(units - {None}) <= 1:
        return Chosen(numbers, halve, next(iter(units - {None}), None))
    if None in units or len(used) < 4:
        raise InputError(f"'{path}', line {line}: columns of two units, and one without; give each its unit")
    return Chosen(numbers, halve, 1.0, tuple(column.unit or 1.0 for column in used))


def is_header(header: Sequence[Column]) -> bool:
    """Return True if a line names all of x, y, z and a radius or diameter."""
    names = {column.name for column in header}
    return all(names & {*_ALIASES[name]} for name in "xyz") and bool(names & {*_ALIASES["r"], *_ALIASES["d"]})


def _named(path: Path, line: int, names: list[str], wanted: str) -> int:
    for aliases in (_ALIASES[wanted], _ALIASES["d"] if wanted == "r" else ()):
        place = [k for k, name in enumerate(names) if name in aliases]
        if place:
            return _single(path, line, names, names[place[0]])
    raise InputError(
        f"'{path}', line {line}: no column '{wanted}' among {listed(names)}; rename one, or give columns="
        " with those of x, y, z and radius"
    )


def _number(path: Path, line: int, names: list[str] | None, one: str | int) -> int:
    if isinstance(one, bool) or not isinstance(one, int | str) or (isinstance(one, int) and not 0 <= one < _MOST):
        raise InputError(f"columns = {shown(one)}: not a column; give names in the header or numbers from 0")
    if isinstance(one, int):
        return one
    if names is None:
        raise InputError(f"'{path}' has no header; give columns= as numbers from 0")
    for name in (one.strip().lower(), Column.of(one).name):
        if name in names:
            return _single(path, line, names, name)
    raise InputError(f"'{path}', line {line}: no column '{one}' among {listed(names)}; correct columns=")


def _single(path: Path, line: int, names: list[str], name: str) -> int:
    """Return the number of the column of a name, which no other column may have."""
    if names.count(name) > 1:
        raise InputError(f"'{path}', line {line}: two columns '{name}'; rename one, or give columns= as numbers")
    return names.index(name)


def _length(text: str) -> float | None:
    """Return a unit of length [m], or None if the text is not one."""
    try:
        return length_unit("", text)
    except InputError:
        return None
