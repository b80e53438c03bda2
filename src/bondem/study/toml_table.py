"""Strict reading of TOML: every value is requested by name and checked, and an unrequested key is an error.

A number is in SI units; a text includes its unit: "72.5 GPa". Units, ranges and choices are those with which the key
is declared (`bondem.study.keys`).
"""

import difflib
import math
import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from bondem._checks import shown
from bondem._plausibility import question
from bondem._units import length_unit, quantity
from bondem.errors import InputError, StudyError
from bondem.study.declared import Count, Key, KeyTable, Number, Numbers, Text, Texts

_Kind = TypeVar("_Kind", bound=Key)
_Read = TypeVar("_Read")

#: Default of a key that must be given.
NEEDED = object()
# Largest number, and inverse of the smallest: beyond all physical values, while products remain finite.
_LARGEST = 1e60
# Limit of whole numbers, excluded.
_MOST = 1 << 62


class TomlTable:
    """Table of a study file with its declared keys.

    Methods that read a key raise StudyError for an invalid value, or a missing one without a default. Use the table
    as a context manager: at its end, a key of the file that was not requested raises StudyError.

    Args:
        data: contents of the table.
        keys: declared keys of the table.
        path: dotted name of the table, "" for the file itself.
    """

    def __init__(self, data: Mapping[str, Any], keys: KeyTable, path: str = "") -> None:
        self._data = data
        self._keys = keys.keys
        self._path = path
        self._asked: list[str] = []

    def __enter__(self) -> "TomlTable":
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        unknown = [key for key in self._data if key not in self._asked]
        if unknown and failed is None:
            near = difflib.get_close_matches(unknown[0], self._asked, n=1)
            known = ", ".join(dict.fromkeys(self._asked))
            hint = f"did you mean '{self.name(near[0])}'?" if near else f"known here: {known}"
            raise StudyError(f"unknown key '{self.name(unknown[0])}'; {hint}")

    def name(self, key: str) -> str:
        """Return the dotted name of a key, such as "specimen.radius"."""
        return f"{self._path}.{key}" if self._path else key

    def _get(self, key: str, default: Any, wanted: str) -> Any:
        self._asked.append(key)
        if key in self._data:
            return self._data[key]
        if default is NEEDED:
            misspelt = difflib.get_close_matches(key, [name for name in self._data if name not in self._keys], n=1)
            if misspelt:
                raise StudyError(f"unknown key '{self.name(misspelt[0])}'; did you mean '{self.name(key)}'?")
            raise StudyError(f"key '{self.name(key)}' is missing; give {wanted}")
        return default

    def _right(self, key: str, default: Any, wanted: str, right: Callable[[Any], bool]) -> Any:
        """Read a value for which `right` returns True, or its default; `wanted` describes it in messages."""
        value = self._get(key, default, wanted)
        if value is not default and not right(value):
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; give {wanted}")
        return value

    def _declared(self, key: str, kind: type[_Kind]) -> _Kind:
        """Return the declaration of a key, which must be of a given kind."""
        found = self._keys[key]
        assert isinstance(found, kind), key
        return found

    def has(self, key: str) -> bool:
        """Return True if the key is given; given or not, the key then counts as requested."""
        self._asked.append(key)
        return key in self._data

    def section(self, key: str) -> "TomlTable":
        """Read a subtable; an empty one if the key is not given."""
        value = self._get(key, {}, "a table")
        if not isinstance(value, Mapping):
            raise StudyError(
                f"'{self.name(key)}' = {shown(value)}: not a table; write it as a table [{self.name(key)}]"
            )
        return TomlTable(value, self._declared(key, KeyTable), self.name(key))

    def optional(self, key: str, read: Callable[["TomlTable"], _Read]) -> _Read | None:
        """Read a subtable by the function `read`; None if the key is not given."""
        return read(self.section(key)) if self.has(key) else None

    def number(self, key: str, *, default: Any = NEEDED, unit: str | None = None, below: float | None = None) -> Any:
        """Read a number or a text with a unit, as a float in SI; `unit` and `below` replace the declared ones."""
        known = self._declared(key, Number)
        below, unit = known.below if below is None else below, unit or known.unit
        above = math.nextafter(known.above, -math.inf) if known.closed else known.above
        wanted = f"a number {_range(known.above, below, closed=known.closed)}[{unit}]"
        value = self._get(key, default, wanted)
        if value is default:
            return value
        found = self._number(self.name(key), value, unit, wanted, above, below)
        if known.quantity:
            written = value.strip() if isinstance(value, str) else ""
            question("", f"'{self.name(key)}'", found, quantity=known.quantity, written=written)
        return found

    def _number(
        self, name: str, value: object, unit: str, wanted: str, above: float = -math.inf, below: float = math.inf
    ) -> float:
        found = value
        if isinstance(value, str):
            try:
                found = quantity(f"'{name}'", value, unit)
            except InputError as error:
                raise StudyError(str(error)) from None
        if isinstance(found, bool) or not isinstance(found, int | float):
            raise StudyError(f"'{name}' = {shown(value)}; give {wanted}, or a text with a unit")
        if not (above < found < below and abs(found) <= _LARGEST and (found == 0 or abs(found) >= 1.0 / _LARGEST)):
            hint = "" if unit != "rad" or isinstance(value, str) else f'; if degrees are meant, write "{found:g} deg"'
            raise StudyError(f"'{name}' = {shown(value)}; give {wanted}{hint}")
        return float(found)

    def has_text(self, *keys: str) -> bool:
        """Return True if the values of all given keys among `keys` are texts, which include units."""
        given = [self._data[key] for key in keys if key in self._data]
        return all(isinstance(one, str) for item in given for one in (item if isinstance(item, list) else [item]))

    def count(self, key: str, *, default: Any = NEEDED) -> int:
        """Read a whole number within the declared limits."""
        known = self._declared(key, Count)
        wanted = f"a whole number of at least {known.least}" + (f" and at most {known.most}" if known.most else "")
        return self._right(key, default, wanted, partial(_is_whole, least=known.least, most=known.most or _MOST - 1))

    def text(self, key: str, *, default: Any = NEEDED) -> Any:
        """Read a text, one of the declared choices if there are any."""
        choices = self._declared(key, Text).choices
        wanted = f"one of {', '.join(choices)}" if choices else "a text"
        value = self._get(key, default, wanted)
        if not isinstance(value, str) or (choices and value not in choices):
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; {_hint(value, choices, f'give {wanted}')}")
        return value

    def file(self, key: str, folder: Path) -> Path:
        """Read the path of an existing file, relative to `folder`."""
        name = self.text(key)
        file = folder / name
        if not name.isprintable() or not os.path.isfile(file):
            raise StudyError(f"'{self.name(key)}': the file {shown(str(file))} does not exist; check the path")
        return file

    def flag(self, key: str, *, default: bool) -> bool:
        """Read a Boolean value."""
        return self._right(key, default, "true or false", lambda value: isinstance(value, bool))

    def texts(self, key: str, *, default: tuple[str, ...]) -> tuple[str, ...]:
        """Read a list of different texts, all from the declared choices."""
        choices = self._declared(key, Texts).choices
        known = ", ".join(choices)
        values = self._right(key, default, f"a list of {known}", _is_list)
        for value in values:
            if value not in choices:
                hint = _hint(value, choices, f"choose from {known}")
                raise StudyError(f"'{self.name(key)}' contains {shown(value)}; {hint}")
        if len(set(values)) < len(values):
            raise StudyError(f"'{self.name(key)}' contains an entry twice; remove one")
        return tuple(values)

    def numbers(self, key: str) -> tuple[float, ...]:
        """Read a list of numbers in the declared SI unit, each of which may be a text with a unit."""
        unit = self._declared(key, Numbers).unit
        wanted = f"a list of numbers [{unit}]"
        values = self._right(key, NEEDED, wanted, _is_list)
        return tuple(self._number(f"{self.name(key)}[{k}]", one, unit, wanted) for k, one in enumerate(values))

    def whole_numbers(self, key: str) -> int | tuple[int, ...]:
        """Read a count of at least 1, or a list of whole numbers of zero or more."""
        wanted = "how many, or a list of whole numbers of zero or more"
        value = self._right(key, NEEDED, wanted, lambda value: (
            bool(value) and all(map(_is_whole, value)) if isinstance(value, list) else _is_whole(value, least=1)
        ))  # fmt: skip
        return tuple(value) if isinstance(value, list) else value

    def lines(self, key: str) -> tuple[str, ...]:
        """Read a list of texts of one line each; an empty one if the key is not given."""
        return tuple(self._right(key, [], "a list of texts of one line each", lambda values: (
            isinstance(values, list) and all(isinstance(one, str) and one.isprintable() for one in values)
        )))  # fmt: skip

    def all(self) -> Mapping[str, Any]:
        """Return all contents of a table with arbitrary keys, which then count as requested."""
        self._asked.extend(self._data)
        return self._data

    def lengths(self, key: str) -> tuple[float, float, float]:
        """Read a list of three positive lengths [m]."""
        wanted = 'three positive lengths [m], such as [0.01, 0.01, 0.04] or ["10 mm", "10 mm", "40 mm"]'
        values = self._right(key, NEEDED, wanted, lambda values: isinstance(values, list) and len(values) == 3)
        a, b, c = (
            self._number(f"{self.name(key)}[{k}]", value, "m", wanted, above=0.0) for k, value in enumerate(values)
        )
        return a, b, c

    def unit(self, key: str) -> float | None:
        """Read a unit of length, by name or as a number, in metres; None if the key is not given."""
        value = self._get(key, None, "a unit of length")
        if value is None:
            return None
        return made(self.name(key), lambda: length_unit(f"'{self._path}'", value))


def made(key: str, make: Callable[[], _Read]) -> _Read:
    """Return the result of `make`, and raise its InputError as a StudyError that names the key."""
    try:
        return make()
    except InputError as error:
        raise StudyError(f"'{key}': {error}") from error


def _is_list(value: object) -> bool:
    return isinstance(value, list | tuple)


def _is_whole(value: object, least: int = 0, most: int = _MOST - 1) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def _hint(value: object, choices: tuple[str, ...], otherwise: str) -> str:
    """Return a question with the choice that is similar to a value, or the text `otherwise` if there is none."""
    near = difflib.get_close_matches(str(value), choices, n=1)
    return f"did you mean '{near[0]}'?" if near else otherwise


def _range(above: float, below: float, *, closed: bool = False) -> str:
    if closed:
        return f"of at least {above:g} " + (f"and below {below:g} " if math.isfinite(below) else "")
    if math.isfinite(above) and math.isfinite(below):
        return f"between {above:g} and {below:g} (exclusive) "
    if math.isfinite(above):
        return f"above {above:g} "
    return f"below {below:g} " if math.isfinite(below) else ""
