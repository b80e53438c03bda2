"""Kinds of keys of a study file. The reader checks values by them, and the JSON schema follows from them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

Schema = dict[str, Any]


@dataclass(frozen=True)
class Key:
    """A key of a table.

    Attributes:
        words: meaning of the value.
    """

    words: str = ""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"description": self.words} if self.words else {}


@dataclass(frozen=True)
class Number(Key):
    """Number in SI, or a text with its unit.

    Attributes:
        unit: SI unit.
        above, below: limits, both excluded.
        quantity: name in the table of plausible values (`bondem._plausibility`), if the unit is to be questioned.
    """

    unit: str = "-"
    above: float = -math.inf
    below: float = math.inf
    quantity: str = ""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        words = f"{self.words} [{self.unit}]; a text may have another unit"
        return {"type": ["number", "string"], "description": words}


@dataclass(frozen=True)
class Numbers(Key):
    """List of numbers, each of which may be a text with its unit.

    Attributes:
        unit: SI unit.
        least: smallest number of entries.
    """

    unit: str = "-"
    least: int = 1

    def schema(self) -> Schema:
        """JSON schema of the value."""
        item = {"type": ["number", "string"]}
        return {"type": "array", "items": item, "description": f"{self.words} [{self.unit}]", "minItems": self.least}


@dataclass(frozen=True)
class Lengths(Key):
    """Three lengths [m]."""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return Numbers(self.words, "m", 3).schema() | {"maxItems": 3}


@dataclass(frozen=True)
class Count(Key):
    """Whole number.

    Attributes:
        least: smallest value.
    """

    least: int = 1

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"type": "integer", "minimum": self.least, "description": self.words}


@dataclass(frozen=True)
class Counts(Key):
    """Number of things, or a list of whole numbers."""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        some = {"type": "array", "items": {"type": "integer", "minimum": 0}, "description": "which ones"}
        return {"description": self.words, "anyOf": [Count("how many").schema(), some]}


@dataclass(frozen=True)
class Text(Key):
    """Text, which may be one of several choices.

    Attributes:
        choices: possible values; empty for any text.
    """

    choices: tuple[str, ...] = ()

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"type": "string", "description": self.words} | ({"enum": list(self.choices)} if self.choices else {})


@dataclass(frozen=True)
class Texts(Key):
    """List of different texts, each one of several choices, or of arbitrary lines without choices.

    Attributes:
        choices: possible values.
    """

    choices: tuple[str, ...] = ()

    def schema(self) -> Schema:
        """JSON schema of the value."""
        found: Schema = {"type": "array", "items": Text(choices=self.choices).schema(), "description": self.words}
        return found | ({"uniqueItems": True} if self.choices else {})


@dataclass(frozen=True)
class Flag(Key):
    """True or false."""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"type": "boolean", "description": self.words}


@dataclass(frozen=True)
class Unit(Key):
    """Unit of length, by name or in metres."""

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"type": ["string", "number"], "description": self.words}


@dataclass(frozen=True)
class KeyTable(Key):
    """Table of keys.

    Attributes:
        keys: declared keys, by name.
        needed: keys without which no table is possible.
        free: True if any key is possible.
    """

    keys: Mapping[str, Key] = field(default_factory=dict)
    needed: tuple[str, ...] = ()
    free: bool = False

    def schema(self) -> Schema:
        """JSON schema of the value."""
        found: Schema = {"type": "object"} | super().schema()
        if self.free:
            return found
        properties = {name: key.schema() for name, key in self.keys.items()}
        found |= {"properties": properties, "additionalProperties": False}
        return found | ({"required": list(self.needed)} if self.needed else {})


@dataclass(frozen=True)
class KeyTables(Key):
    """List of tables, at least one.

    Attributes:
        each: one of them.
    """

    each: KeyTable = KeyTable()

    def schema(self) -> Schema:
        """JSON schema of the value."""
        return {"type": "array", "minItems": 1, "items": self.each.schema()}
