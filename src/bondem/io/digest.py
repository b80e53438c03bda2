"""Digests of arrays and texts, by which a file knows that it is damaged; and texts as files of ours hold them.

Texts have a fixed length: those of any length are in a heap of HDF5 that has no checksum, and in which it may search
for ever where that is damaged.
"""

import hashlib
import hmac
from collections.abc import Iterable
from typing import Any

import numpy as np


def digest_of(items: Iterable[tuple[str, Any]]) -> str:
    """Of names with what stands for them: arrays with their types and shapes, or texts; 64 hexadecimal digits."""
    found = hashlib.blake2b(digest_size=32)
    for name, value in items:
        if isinstance(value, str):
            told, data = "text", value.encode()
        else:
            array = np.ascontiguousarray(value)
            told, data = f"{array.dtype.str} {np.shape(value)}", array.data if array.size else b""
        found.update(f"{name} {told} ".encode())
        found.update(data)
    return found.hexdigest()


def agree(found: str, told: object) -> bool:
    """Whether a digest is that which a file tells."""
    return hmac.compare_digest(found.encode(), text_of(told).encode(errors="replace"))


def fixed(text: str) -> np.bytes_:
    """A text as a file holds it."""
    return np.bytes_(text.encode())


def text_of(value: object) -> str:
    """A text of a file, also of one with texts of any length."""
    return value.decode() if isinstance(value, bytes) else str(value)


def arrays_of(group: Any, under: str = "") -> list[tuple[str, Any]]:
    """All arrays and texts of an HDF5 group and the groups in it, by their paths, in their order."""
    items: list[tuple[str, Any]] = []
    for name in sorted(group):
        item, path = group[name], f"{under}/{name}"
        if hasattr(item, "shape"):
            value = item[()]
            items.append((path, value.decode() if isinstance(value, bytes) else value))
        else:
            items += arrays_of(item, path)
    return items
