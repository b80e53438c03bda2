"""STL files, text and binary, with the names of their solids."""

import re

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.geometry.surface_files.contents import Contents, by_name, name_of

_HEAD, _RECORD = 84, 50  # bytes before the triangles of a binary file, and of each triangle
_SOLID = re.compile(rb"^[ \t]*solid\b(.*)$", re.IGNORECASE | re.MULTILINE)
_FACET = re.compile(rb"^[ \t]*facet\b", re.IGNORECASE | re.MULTILINE)
_CORNER = re.compile(rb"^[ \t]*vertex[ \t]+(\S+)[ \t]+(\S+)[ \t]+(\S+)", re.IGNORECASE | re.MULTILINE)


def read_stl(name: str, data: bytes) -> Contents:
    """Read the bytes of an STL file; the solids of a text file are its named parts.

    Raises:
        InputError: The file is no STL file, or was cut or damaged.
    """
    announced = int.from_bytes(data[80:84], "little")
    found = max(len(data) - _HEAD, 0) // _RECORD
    if len(data) != _HEAD + _RECORD * announced and data.lstrip()[:5].lower() == b"solid":
        return _text(name, data.replace(b"\r\n", b"\n").replace(b"\r", b"\n"))
    if len(data) < _HEAD or found != announced:
        raise InputError(
            f"{name} announces {announced} triangles and holds {found}: it is no STL file, or was cut or damaged;"
            " export it again"
        )
    record = np.dtype([("normal", "<f4", 3), ("corner", "<f4", (3, 3)), ("attribute", "<u2")])
    corner = np.frombuffer(data, record, count=announced, offset=_HEAD)["corner"]
    return Contents(*_separate(corner.astype(float)), {})


def _text(name: str, data: bytes) -> Contents:
    corners = list(_CORNER.finditer(data))
    facets = sum(1 for _ in _FACET.finditer(data))
    if not facets:
        raise InputError(f"{name} is empty: a text STL file without any facet; export it again")
    if len(corners) != 3 * facets:
        raise InputError(
            f"{name} has {facets} facets and {len(corners)} corners, not three for each: it was cut or damaged;"
            " export it again"
        )
    try:
        place = np.array([found.groups() for found in corners]).astype(float).reshape(-1, 3, 3)
    except ValueError as error:
        raise InputError(f"{name} has a coordinate that is no number ({error}); export it again") from error
    solids = list(_SOLID.finditer(data))
    of = np.searchsorted([one.start() for one in solids], [one.start() for one in corners[::3]]) - 1
    names = [name_of(one.group(1)) for one in solids]
    return Contents(*_separate(place), by_name([names[k] for k in of]))


def _separate(corner: Floats) -> tuple[Floats, np.ndarray]:
    """Return the corners (3 t, 3) of triangles (t, 3, 3), not merged as in STL files, and their numbers (t, 3)."""
    return corner.reshape(-1, 3), np.arange(3 * len(corner)).reshape(-1, 3)
