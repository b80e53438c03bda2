"""Declarations of the keys of a study file, from which values are checked and the JSON schema is created."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

Schema = dict[str, Any]


@dataclass(frozen=True)
class Key:
    """Key of a table; `words` describe its value."""

    words: str = ""

    def schema(self) -> Schema:
        """Return the JSON schema of the value."""
        return {"description": self.words} if self.words else {}


@dataclass(frozen=True)
class Number(Key):
    """Key of a number in SI units, or of a text with a unit.

    Attributes:
        unit: SI unit.
        above, below: limits, both excluded.
        closed: True if `above` itself is allowed.
        quantity: name in `bondem._plausibility`, by which a probable unit error gives a warning; "" for no check.
    """

    unit: str = "-"
    above: float = -math.inf
    below: float = math.inf
    quantity: str = ""
    closed: bool = False

    def schema(self) -> Schema:
        words = f"{self.words} [{self.unit}]; a text may have another unit"
        return {"type": ["number", "string"], "description": words}


@dataclass(frozen=True)
class Numbers(Key):
    """Key of a list of at least `least` numbers in the SI unit `unit`, each of which may be a text with a unit."""

    unit: str = "-"
    least: int = 1

    def schema(self) -> Schema:
        item = {"type": ["number", "string"]}
        return {"type": "array", "items": item, "description": f"{self.words} [{self.unit}]", "minItems": self.least}


@dataclass(frozen=True)
class Lengths(Key):
    """Key of a list of three lengths [m]."""

    def schema(self) -> Schema:
        return Numbers(self.words, "m", 3).schema() | {"maxItems": 3}


@dataclass(frozen=True)
class Count(Key):
    """Key of a whole number of at least `least`, and at most `most` unless it is None."""

    least: int = 1
    most: int | None = None

    def schema(self) -> Schema:
        most = {} if self.most is None else {"maximum": self.most}
        return {"type": "integer", "minimum": self.least, **most, "description": self.words}


@dataclass(frozen=True)
class Counts(Key):
    """Key of a count, or of a list of whole numbers such as seeds."""

    def schema(self) -> Schema:
        some = {"type": "array", "items": {"type": "integer", "minimum": 0}, "description": "which ones"}
        return {"description": self.words, "anyOf": [Count("how many").schema(), some]}


@dataclass(frozen=True)
class Text(Key):
    """Key of a text: one of `choices`, or any text if `choices` is empty."""

    choices: tuple[str, ...] = ()

    def schema(self) -> Schema:
        return {"type": "string", "description": self.words} | ({"enum": list(self.choices)} if self.choices else {})


@dataclass(frozen=True)
class Texts(Key):
    """Key of a list of different texts from `choices`, or of arbitrary lines without choices."""

    choices: tuple[str, ...] = ()

    def schema(self) -> Schema:
        found: Schema = {"type": "array", "items": Text(choices=self.choices).schema(), "description": self.words}
        return found | ({"uniqueItems": True} if self.choices else {})


@dataclass(frozen=True)
class Flag(Key):
    """Key of a Boolean value."""

    def schema(self) -> Schema:
        return {"type": "boolean", "description": self.words}


@dataclass(frozen=True)
class Unit(Key):
    """Key of a unit of length, by name or in metres."""

    def schema(self) -> Schema:
        return {"type": ["string", "number"], "description": self.words}


@dataclass(frozen=True)
class KeyTable(Key):
    """Key of a table of further keys.

    Attributes:
        keys: declared keys of the table, by name.
        needed: names of required keys.
        free: True for a table that may have any keys.
    """

    keys: Mapping[str, Key] = field(default_factory=dict)
    needed: tuple[str, ...] = ()
    free: bool = False

    def schema(self) -> Schema:
        found: Schema = {"type": "object"} | super().schema()
        if self.free:
            return found
        properties = {name: key.schema() for name, key in self.keys.items()}
        found |= {"properties": properties, "additionalProperties": False}
        return found | ({"required": list(self.needed)} if self.needed else {})


@dataclass(frozen=True)
class KeyTables(Key):
    """Key of a list of at least one table, each declared by `each`."""

    each: KeyTable = KeyTable()

    def schema(self) -> Schema:
        return {"type": "array", "minItems": 1, "items": self.each.schema()}
