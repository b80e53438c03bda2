"""Strict reading of TOML: every value is asked for by name, checked, and what nobody asked for is an error."""

import difflib
import math
from collections.abc import Mapping, Sequence
from typing import Any

from bondem.errors import StudyError

_NEEDED = object()


class TomlTable:
    """One table of a study file.

    Args:
        data: the table.
        path: its dotted name, "" for the file itself.

    Use as a context: on leaving, a key that was not asked for raises.
    """

    def __init__(self, data: Mapping[str, Any], path: str = "") -> None:
        self._data = data
        self._path = path
        self._asked: list[str] = []

    def __enter__(self) -> "TomlTable":
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        unknown = [key for key in self._data if key not in self._asked]
        if unknown and failed is None:
            near = difflib.get_close_matches(unknown[0], self._asked, n=1)
            hint = f"did you mean '{self.name(near[0])}'?" if near else f"known here: {', '.join(self._asked)}"
            raise StudyError(f"unknown key '{self.name(unknown[0])}'; {hint}")

    def name(self, key: str) -> str:
        """Dotted name of a key."""
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

    def has(self, key: str) -> bool:
        """Whether the key is given (asking makes it known)."""
        self._asked.append(key)
        return key in self._data

    def section(self, key: str) -> "TomlTable":
        """A table within; an empty one where it is not given."""
        value = self._get(key, {}, "a table")
        if not isinstance(value, Mapping):
            raise StudyError(f"'{self.name(key)}' is {value!r}; make it a table [{self.name(key)}]")
        return TomlTable(value, self.name(key))

    def number(
        self, key: str, unit: str, *, default: Any = _NEEDED, above: float = -math.inf, below: float = math.inf
    ) -> Any:
        """A finite number strictly between `above` and `below`."""
        wanted = f"a number {_range(above, below)}[{unit}]"
        value = self._get(key, default, wanted)
        if value is default:
            return value
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise StudyError(f"'{self.name(key)}' is {value!r}; give {wanted}")
        if not (math.isfinite(value) and above < value < below):
            raise StudyError(f"'{self.name(key)}' = {value!r}; give {wanted}")
        return float(value)

    def count(self, key: str, *, default: Any = _NEEDED, least: int = 1) -> int:
        """A whole number, at least `least`."""
        wanted = f"a whole number of at least {least}"
        value = self._get(key, default, wanted)
        if isinstance(value, bool) or not isinstance(value, int) or value < least:
            raise StudyError(f"'{self.name(key)}' = {value!r}; give {wanted}")
        return value

    def text(self, key: str, *, default: Any = _NEEDED, choices: Sequence[str] = ()) -> str:
        """A text, one of `choices` where there are any."""
        wanted = f"one of {', '.join(choices)}" if choices else "a text"
        value = self._get(key, default, wanted)
        if not isinstance(value, str) or (choices and value not in choices):
            near = difflib.get_close_matches(str(value), choices, n=1)
            hint = f"did you mean '{near[0]}'?" if near else f"give {wanted}"
            raise StudyError(f"'{self.name(key)}' = {value!r}; {hint}")
        return value

    def flag(self, key: str, *, default: bool) -> bool:
        """True or false."""
        value = self._get(key, default, "true or false")
        if not isinstance(value, bool):
            raise StudyError(f"'{self.name(key)}' = {value!r}; give true or false")
        return value

    def texts(self, key: str, *, choices: Sequence[str], default: tuple[str, ...]) -> tuple[str, ...]:
        """A list of different choices."""
        values = self._get(key, default, "a list")
        if not isinstance(values, list | tuple):
            raise StudyError(f"'{self.name(key)}' = {values!r}; give a list of {', '.join(choices)}")
        for value in values:
            if value not in choices:
                near = difflib.get_close_matches(str(value), choices, n=1)
                hint = f"did you mean '{near[0]}'?" if near else f"choose from {', '.join(choices)}"
                raise StudyError(f"'{self.name(key)}' names {value!r}; {hint}")
        if len(set(values)) < len(values):
            raise StudyError(f"'{self.name(key)}' names one thing twice; take one out")
        return tuple(values)

    def numbers(self, key: str) -> tuple[float, ...]:
        """A list of finite numbers."""
        wanted = "a list of numbers"
        values = self._get(key, _NEEDED, wanted)
        good = isinstance(values, list | tuple) and not any(isinstance(v, bool) for v in values)
        if not good or not all(isinstance(v, int | float) and math.isfinite(v) for v in values):
            raise StudyError(f"'{self.name(key)}' = {values!r}; give {wanted}")
        return tuple(float(v) for v in values)

    def lengths(self, key: str) -> tuple[float, float, float]:
        """Three positive lengths [m]."""
        wanted = "three positive lengths [m], such as [0.01, 0.01, 0.04]"
        values = self._get(key, _NEEDED, wanted)
        good = isinstance(values, list) and len(values) == 3
        if not good or not all(isinstance(v, int | float) and 0.0 < v < math.inf for v in values):
            raise StudyError(f"'{self.name(key)}' = {values!r}; give {wanted}")
        return (float(values[0]), float(values[1]), float(values[2]))


def _range(above: float, below: float) -> str:
    if math.isfinite(above) and math.isfinite(below):
        return f"between {above:g} and {below:g} (exclusive) "
    if math.isfinite(above):
        return f"above {above:g} "
    return f"below {below:g} " if math.isfinite(below) else ""
