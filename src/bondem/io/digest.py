"""Digests of arrays and texts, by which damaged files are detected, and texts in HDF5 files.

Texts have a fixed length. HDF5 stores texts of variable length in a heap without a checksum, in which it may search
endlessly if the heap is damaged.
"""

import hashlib
import hmac
from collections.abc import Iterable
from typing import Any

import numpy as np


def digest_of(items: Iterable[tuple[str, Any]]) -> str:
    """Compute a digest of named texts and arrays, including types and shapes, as 64 hexadecimal digits."""
    found = hashlib.blake2b(digest_size=32)
    for name, value in items:
        if isinstance(value, str):
            stored, data = "text", value.encode()
        else:
            array = np.ascontiguousarray(value)
            stored, data = f"{array.dtype.str} {np.shape(value)}", array.data if array.size else b""
        found.update(f"{name} {stored} ".encode())
        found.update(data)
    return found.hexdigest()


def agree(found: str, stored: object) -> bool:
    """Return True if a digest equals the one stored in a file."""
    return hmac.compare_digest(found.encode(), text_of(stored).encode(errors="replace"))


def fixed(text: str) -> np.bytes_:
    """Convert a text to the fixed-length type of a file."""
    return np.bytes_(text.encode())


def text_of(value: object) -> str:
    """Convert a text from an HDF5 file, of fixed or variable length, to `str`."""
    return value.decode() if isinstance(value, bytes) else str(value)


def arrays_of(group: Any, under: str = "") -> list[tuple[str, Any]]:
    """Collect all arrays and texts of an HDF5 group and its subgroups as (path, value), sorted by name."""
    items: list[tuple[str, Any]] = []
    for name in sorted(group):
        item, path = group[name], f"{under}/{name}"
        if hasattr(item, "shape"):
            value = item[()]
            items.append((path, value.decode() if isinstance(value, bytes) else value))
        else:
            items += arrays_of(item, path)
    return items
