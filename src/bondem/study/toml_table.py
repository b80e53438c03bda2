"""Strict reading of TOML: every value is requested by name and checked, and an unrequested key is an error.

A number is in SI units; a text includes its unit: "72.5 GPa". Units, ranges and choices are those with which the key
is declared (`bondem.study.keys`).
"""

import difflib
import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from bondem._checks import shown
from bondem._plausibility import question
from bondem._units import length_unit, quantity
from bondem.errors import InputError, StudyError
from bondem.study.declared import Count, Key, KeyTable, Number, Numbers, Text, Texts

_Kind = TypeVar("_Kind", bound=Key)

_NEEDED = object()
# Largest number, and inverse of the smallest: beyond all physical values, while products remain finite.
_LARGEST = 1e60
# Largest whole number.
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
        if default is _NEEDED:
            misspelt = difflib.get_close_matches(key, [name for name in self._data if name not in self._asked], n=1)
            if misspelt:
                raise StudyError(f"unknown key '{self.name(misspelt[0])}'; did you mean '{self.name(key)}'?")
            raise StudyError(f"key '{self.name(key)}' is missing; give {wanted}")
        return default

    def _declared(self, key: str, kind: type[_Kind]) -> _Kind:
        """Return the declaration of a key, which must be of a given kind."""
        found = self._keys[key]
        assert isinstance(found, kind), key
        return found

    def has(self, key: str) -> bool:
        """Return True if the key is given; the key then counts as requested."""
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

    def number(
        self, key: str, *, default: Any = _NEEDED, unit: str | None = None, below: float | None = None
    ) -> Any:
        """Read a number or a text with a unit, as a float in SI; `unit` and `below` replace those declared."""
        known = self._declared(key, Number)
        above, below, unit = known.above, known.below if below is None else below, unit or known.unit
        wanted = f"a number {_range(above, below)}[{unit}]"
        value = self._get(key, default, wanted)
        if value is default:
            return value
        found = self._number(self.name(key), value, unit, wanted, above, below)
        if known.quantity:
            question("", f"'{self.name(key)}'", found, quantity=known.quantity)
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
            raise StudyError(f"'{name}' = {shown(value)}; give {wanted}")
        return float(found)

    def has_text(self, *keys: str) -> bool:
        """Return True if all given keys among `keys` have texts as values, and thus units."""
        given = [self._data[key] for key in keys if key in self._data]
        return all(isinstance(one, str) for item in given for one in (item if isinstance(item, list) else [item]))

    def count(self, key: str, *, default: Any = _NEEDED) -> int:
        """Read a whole number that is not below the declared minimum."""
        least = self._declared(key, Count).least
        wanted = f"a whole number of at least {least}"
        value = self._get(key, default, wanted)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= _MOST:
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; give {wanted}")
        return value

    def text(self, key: str, *, default: Any = _NEEDED) -> Any:
        """Read a text, one of the declared choices if there are any."""
        choices = self._declared(key, Text).choices
        wanted = f"one of {', '.join(choices)}" if choices else "a text"
        value = self._get(key, default, wanted)
        if not isinstance(value, str) or (choices and value not in choices):
            near = difflib.get_close_matches(str(value), choices, n=1)
            hint = f"did you mean '{near[0]}'?" if near else f"give {wanted}"
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; {hint}")
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
        value = self._get(key, default, "true or false")
        if not isinstance(value, bool):
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; give true or false")
        return value

    def texts(self, key: str, *, default: tuple[str, ...]) -> tuple[str, ...]:
        """Read a list of different texts, all from the declared choices."""
        choices = self._declared(key, Texts).choices
        values = self._get(key, default, "a list")
        if not isinstance(values, list | tuple):
            raise StudyError(f"'{self.name(key)}' = {shown(values)}; give a list of {', '.join(choices)}")
        for value in values:
            if value not in choices:
                near = difflib.get_close_matches(str(value), choices, n=1)
                hint = f"did you mean '{near[0]}'?" if near else f"choose from {', '.join(choices)}"
                raise StudyError(f"'{self.name(key)}' contains {shown(value)}; {hint}")
        if len(set(values)) < len(values):
            raise StudyError(f"'{self.name(key)}' contains an entry twice; remove one")
        return tuple(values)

    def numbers(self, key: str) -> tuple[float, ...]:
        """Read a list of numbers in the declared SI unit, each of which may be a text with a unit."""
        unit = self._declared(key, Numbers).unit
        wanted = f"a list of numbers [{unit}]"
        values = self._get(key, _NEEDED, wanted)
        if not isinstance(values, list | tuple):
            raise StudyError(f"'{self.name(key)}' = {shown(values)}; give {wanted}")
        return tuple(
            self._number(f"{self.name(key)}[{k}]", value, unit, wanted) for k, value in enumerate(values)
        )

    def whole_numbers(self, key: str) -> int | tuple[int, ...]:
        """Read a count of at least 1, or a list of whole numbers of zero or more."""
        wanted = "how many, or a list of whole numbers of zero or more"
        value = self._get(key, _NEEDED, wanted)
        values = value if isinstance(value, list) else [value]
        least = 0 if isinstance(value, list) else 1
        right = [isinstance(one, int) and not isinstance(one, bool) and least <= one < 1 << 62 for one in values]
        if not values or not all(right):
            raise StudyError(f"'{self.name(key)}' = {shown(value)}; give {wanted}")
        return tuple(values) if isinstance(value, list) else value

    def lines(self, key: str) -> tuple[str, ...]:
        """Read a list of texts of one line each; an empty one if the key is not given."""
        values = self._get(key, [], "a list of texts")
        if not isinstance(values, list) or not all(isinstance(one, str) and one.isprintable() for one in values):
            raise StudyError(f"'{self.name(key)}' = {shown(values)}; give a list of texts of one line each")
        return tuple(values)

    def all(self) -> Mapping[str, Any]:
        """Return all contents of a table with arbitrary keys; they count as requested."""
        self._asked.extend(self._data)
        return self._data

    def lengths(self, key: str) -> tuple[float, float, float]:
        """Read a list of three positive lengths [m]."""
        wanted = 'three positive lengths [m], such as [0.01, 0.01, 0.04] or ["10 mm", "10 mm", "40 mm"]'
        values = self._get(key, _NEEDED, wanted)
        if not isinstance(values, list) or len(values) != 3:
            raise StudyError(f"'{self.name(key)}' = {shown(values)}; give {wanted}")
        a, b, c = (
            self._number(f"{self.name(key)}[{k}]", value, "m", wanted, above=0.0) for k, value in enumerate(values)
        )
        return a, b, c

    def unit(self, key: str) -> float | None:
        """Read a unit of length, by name or as a number, in metres; None if the key is not given."""
        value = self._get(key, None, "a unit of length")
        if value is None:
            return None
        try:
            return length_unit(f"'{self._path}'", value)
        except InputError as error:
            raise StudyError(f"'{self.name(key)}': {error}") from None


def _range(above: float, below: float) -> str:
    if math.isfinite(above) and math.isfinite(below):
        return f"between {above:g} and {below:g} (exclusive) "
    if math.isfinite(above):
        return f"above {above:g} "
    return f"below {below:g} " if math.isfinite(below) else ""
