"""Tables in the memory layout of the core: each value is checked against its field and stored as 64-bit words."""

import math
import re
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np

from bondem._core_functions import address_of
from bondem._types import Ints
from bondem.errors import InputError

# Types of integers and of real numbers in Python and NumPy.
INTEGER = (int, np.integer, np.bool_)
REAL = (float, np.floating, *INTEGER)
# Formats of a word of a table, and of a real number in a word.
_WORD, _REAL = struct.Struct("=q"), struct.Struct("=d")


@dataclass(frozen=True)
class Field:
    """Declaration of a number or an array of a table in a header of the core.

    Attributes:
        name: name of the field.
        dtype: type of the number, or of the numbers of the array.
        written: True if passes write to the array, False if they only read it; None for a number.
        shape: for each axis the symbol of its length ("" for none, "*" for any), and the number added to it.
        offset: place in the table [bytes].
    """

    name: str
    dtype: np.dtype[Any]
    written: bool | None
    shape: tuple[tuple[str, int], ...]
    offset: int

    @classmethod
    def of(cls, description: Any) -> "Field":
        """Create a field from its description in the library."""
        dtype, _, use = description.type.decode().partition(" ")
        axes = []
        for axis in description.shape.decode().split():
            match = re.fullmatch(r"(\*|[a-z_]*)\+?(\d*)", axis)
            assert match is not None, axis
            axes.append((match[1], int(match[2] or 0)))
        written = {"": None, "read": False, "written": True}[use]
        return cls(description.name.decode(), np.dtype(dtype), written, tuple(axes), description.offset)

    @property
    def words(self) -> int:
        """Number of words of the field in the table: a pointer and the lengths of the axes, or its numbers."""
        return math.prod(length for _, length in self.shape) if self.written is None else 1 + len(self.shape)

    def __str__(self) -> str:
        if self.written is None:
            return f"a number, {self.dtype}"
        axes = (f"{symbol}{f'+{more}' if symbol and more else more or ''}" for symbol, more in self.shape)
        return f"a contiguous array of {self.dtype} of shape ({', '.join(axes)})"


def filled_table(
    name: str, fields: tuple[Field, ...], table: tuple[Any, ...], lengths: dict[str, tuple[int, str]]
) -> Ints:
    """Write a table in the layout of the core.

    Args:
        name: name of the table.
        fields: fields of the table as the header declares them.
        table: values of the fields.
        lengths: known lengths of axes by symbol, each with the array that set it; those of this table are added.

    Returns:
        Words of the table: numbers, and addresses and lengths of arrays, which must live as long as these words.

    Raises:
        InputError: a value that is not as its field declares it.
    """
    if len(table) != len(fields):
        raise InputError(f"{name}: {len(table)} values; pass {len(fields)}")
    words: list[int] = []
    for field, value in zip(fields, table, strict=True):
        if field.written is None:
            words.append(_number(name, field, value))
            continue
        words.append(_checked_address(name, field, value))
        for (symbol, more), length in zip(field.shape, value.shape, strict=True):
            words.append(length)
            if symbol == "*":
                continue
            known, source = lengths.get(symbol, (None, "")) if symbol else (0, field.name)
            if known is None:
                lengths[symbol] = length - more, f"{name}.{field.name}"
            elif length != known + more:
                raise InputError(
                    f"{name}.{field.name} = array of shape {value.shape}: an axis has to be {known + more} long"
                    f" ({symbol or 'fixed'}, as of {source if symbol else f'{name}.{field.name}'}); pass {field}"
                )
    return np.array(words, dtype=np.int64)


def _number(table: str, field: Field, value: Any) -> int:
    """Return the bits of a number as an integer; raise InputError for a value that the type of the field excludes."""
    real = field.dtype == np.float64
    if not isinstance(value, REAL if real else INTEGER) or value != value:
        raise InputError(f"{table}.{field.name} = {value!r}: not a number that the core can read; pass {field}")
    try:
        return _WORD.unpack(_REAL.pack(float(value)) if real else _WORD.pack(int(value)))[0]
    except (OverflowError, struct.error):
        raise InputError(f"{table}.{field.name} = {value!r}: too large a number; pass {field}") from None


def _checked_address(table: str, field: Field, value: Any) -> int:
    """Return the address of an array; InputError if its type, order or number of axes is not that of the field."""
    if not isinstance(value, np.ndarray):
        raise InputError(f"{table}.{field.name} = {value!r}: not an array; pass {field}")
    flags = value.flags
    fits = flags.c_contiguous and flags.aligned
    if value.dtype != field.dtype or value.ndim != len(field.shape) or not fits:
        what = f"{value.dtype} of shape {value.shape}{'' if fits else ', not contiguous or not aligned'}"
        raise InputError(f"{table}.{field.name} = array of {what}: the core cannot read it; pass {field}")
    if flags.writeable:
        return address_of(value)
    if field.written:
        raise InputError(f"{table}.{field.name} = read-only array: the core writes to it; pass a copy")
    return value.ctypes.data
